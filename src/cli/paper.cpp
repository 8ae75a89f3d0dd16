// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/paper.h"

#include <algorithm>
#include <optional>
#include <set>

#include "cli/files.h"

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '@';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool among(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool is_verbatim(const std::string& environment) {
  return among(environment,
               {"verbatim", "verbatim*", "Verbatim", "Verbatim*", "BVerbatim", "lstlisting",
                "minted", "comment", "filecontents", "filecontents*"});
}

bool defines(const std::string& word) {
  return among(word, {"newcommand", "renewcommand", "providecommand", "DeclareRobustCommand",
                      "def", "gdef", "edef", "xdef", "let", "protected@edef"});
}

std::string trimmed(std::string text) {
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

// Reads one file, and through `Files` those that it inputs.
class Files;

class Scanner {
 public:
  Scanner(std::shared_ptr<const text::Source> source, Files& files)
      : source_(std::move(source)), text_(source_->bytes), files_(files) {}

  void run();

 private:
  void word(std::size_t begin);
  void mention(Mention::Kind kind, std::size_t begin);
  void begin_environment();
  void skip_verb();
  void skip_false();
  void input();
  void import();

  // The name after a backslash that has been read: letters, or one other character.
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    if (at_ == begin && at_ < text_.size()) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  // Past blanks and comments, to where an argument may begin.
  void skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '%') skip_comment();
      if (at_ >= text_.size() || !is_blank(text_[at_])) return;
    }
  }

  // The text between braces, without comments; nothing if no argument follows or it never ends.
  std::optional<std::string> argument() {
    const std::size_t before = at_;
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '{') {
      std::string result;
      int depth = 0;
      for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == '%') {
          skip_comment();
          continue;
        }
        if (c == '{') ++depth;
        if (c == '}' && --depth == 0) {
          ++at_;
          return trimmed(result.substr(1));
        }
        result += c;
        if (c == '\\' && at_ + 1 < text_.size()) result += text_[++at_];
      }
    }
    at_ = before;
    return std::nullopt;
  }

  text::Span span(std::size_t begin) const { return {source_, begin, at_}; }

  std::shared_ptr<const text::Source> source_;
  const std::string& text_;
  Files& files_;
  std::size_t at_ = 0;
  std::string last_word_;  // the control word before
  bool is_done_ = false;
};

class Files {
 public:
  explicit Files(const fs::path& main)
      : open_(opener_beside(main)), folder_(main.parent_path()) {}

  // The file that TeX would read, below the folder of the paper; each once.
  void input(const std::string& name, const text::Span& where) {
    const fs::path path(name);
    if (among(path.extension().string(), {".sty", ".cls", ".clo", ".def", ".cfg"})) return;
    for (const std::string& file : {name + ".tex", name}) {
      if (seen_.contains(fs::path(file).lexically_normal())) return;
      const auto source = open_(file);
      if (!source) continue;
      seen_.insert(fs::path(file).lexically_normal());
      Scanner(std::make_shared<const text::Source>(
                  text::Source{(folder_ / file).string(), source->bytes}),
              *this)
          .run();
      return;
    }
    paper.unread.push_back({where, name});
  }

  Paper paper;
  bool is_document_over = false;

 private:
  claims::Opener open_;
  fs::path folder_;
  std::set<fs::path> seen_;
};

void Scanner::run() {
  while (at_ < text_.size() && !is_done_ && !files_.is_document_over) {
    const char c = text_[at_];
    if (c == '%') {
      skip_comment();
    } else if (c == '\\') {
      word(at_++);
    } else {
      if (c != '{' && c != '*' && !is_blank(c)) last_word_.clear();
      ++at_;
    }
  }
}

void Scanner::word(std::size_t begin) {
  const std::string word = name();
  const bool is_defined_here = defines(last_word_);
  last_word_ = word;
  if (is_defined_here) return;
  if (word == "spval") return mention(Mention::Kind::value, begin);
  if (word == "spstatus") return mention(Mention::Kind::status, begin);
  if (word == "SeamStatus") return mention(Mention::Kind::known_status, begin);
  if (word == "begin") return begin_environment();
  if (word == "end") files_.is_document_over = argument() == "document";
  if (word == "endinput") is_done_ = true;
  if (word == "iffalse") skip_false();
  if (among(word, {"verb", "lstinline", "mintinline"})) skip_verb();
  if (among(word, {"input", "include", "subfile", "InputIfFileExists"})) input();
  if (among(word, {"import", "subimport"})) import();
}

void Scanner::mention(Mention::Kind kind, std::size_t begin) {
  const auto id = argument();
  const auto second = id ? argument() : std::nullopt;
  const bool needs_second = kind != Mention::Kind::status;
  if (!id || id->empty() || (needs_second && !second)) {
    static const char* const forms[] = {"\\spval{id}{number}", "\\spstatus{id}",
                                        "\\SeamStatus{id}{verdict}"};
    files_.paper.errors.push_back(
        {span(begin), std::string("expected ") + forms[static_cast<int>(kind)], {}});
    return;
  }
  if ((*id + second.value_or("")).find('#') != std::string::npos) {
    files_.paper.errors.push_back({span(begin), "a parameter of a macro stands here",
                                   "macros are not expanded; write the id and the number"});
    return;
  }
  std::string plain = *id;  // `\_` is the underscore of an id
  std::erase(plain, '\\');
  files_.paper.mentions.push_back({kind, plain, second.value_or(""), span(begin)});
}

void Scanner::begin_environment() {
  const auto environment = argument();
  if (!environment || !is_verbatim(*environment)) return;
  const std::string end = "\\end{" + *environment + "}";
  const std::size_t found = text_.find(end, at_);
  at_ = found == std::string::npos ? text_.size() : found + end.size();
}

// \verb|text|, \lstinline[options]|text|, \lstinline{text}, \mintinline{language}|text|
void Scanner::skip_verb() {
  if (last_word_ == "mintinline") argument();
  if (at_ < text_.size() && text_[at_] == '*') ++at_;
  if (last_word_ != "verb" && at_ < text_.size() && text_[at_] == '[')
    at_ = std::min(text_.find(']', at_), text_.size() - 1) + 1;
  if (at_ >= text_.size() || (last_word_ != "verb" && argument())) return;
  const std::size_t line = std::min(text_.find('\n', at_), text_.size());
  const std::size_t end = text_.find(text_[at_], at_ + 1);
  at_ = end == std::string::npos || end > line ? line : end + 1;
}

// To the \fi that belongs to an \iffalse.
void Scanner::skip_false() {
  for (int depth = 1; at_ < text_.size() && depth > 0;) {
    if (text_[at_] == '%') {
      skip_comment();
    } else if (text_[at_++] == '\\') {
      const std::string word = name();
      if (word == "fi") --depth;
      if (word == "else" && depth == 1) return;
      if (word.starts_with("if") && word != "iff") ++depth;
    }
  }
}

// \input{file}, \input file
void Scanner::input() {
  const std::size_t begin = at_;
  auto file = argument();
  if (!file) {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n%\\{}", at_), text_.size());
    file = text_.substr(at_, end - at_);
    at_ = end;
  }
  if (!file->empty()) files_.input(*file, span(begin));
}

// \import{folder/}{file}
void Scanner::import() {
  const std::size_t begin = at_;
  const auto folder = argument(), file = folder ? argument() : std::nullopt;
  if (file) files_.input((fs::path(*folder) / *file).string(), span(begin));
}

}  // namespace

Paper read_paper(const fs::path& path) {
  Files files(path);
  Scanner(open(path), files).run();
  return std::move(files.paper);
}

}  // namespace seam::cli
