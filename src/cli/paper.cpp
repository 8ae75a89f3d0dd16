// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/paper.h"

#include <algorithm>
#include <optional>
#include <set>

#include "cli/files.h"
#include "cli/tex_words.h"

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

// Reads one file, and through `Files` those that it inputs. Where it is not certain that TeX
// skips a text, the text is read: better a mention too many is checked than one too few. So
// \endinput ends nothing, and what stands in a definition skips nothing.
class Files;

class Scanner {
 public:
  Scanner(std::shared_ptr<const text::Source> source, Files& files, bool is_part)
      : source_(std::move(source)), text_(source_->bytes), files_(files), is_part_(is_part) {}

  void run();

 private:
  void word(std::size_t begin);
  void mention(Mention::Kind kind, std::size_t begin);
  bool continues(std::size_t begin) const;
  void begin_environment();
  void skip_verb();
  void skip_literal();
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
  bool is_let_ = false;    // the word before was the one that \let gives a meaning
  int depth_ = 0;          // of braces
  bool is_done_ = false;
  bool is_part_ = false;  // of a document: its own \end{document} ends nothing

  // A text between braces may be a definition, or never be set.
  bool is_outside() const { return depth_ == 0; }
};

class Files {
 public:
  std::set<std::string> conditionals;  // made by \newif
  std::vector<fs::path> folders;       // of \import, the innermost last

  explicit Files(const fs::path& main)
      : open_(opener_beside(main)), folder_(main.parent_path()) {}

  // The file that TeX would read, below the folder of the paper; each once.
  void input(const std::string& name, const text::Span& where) {
    const fs::path path(name);
    if (among(path.extension().string(), {".sty", ".cls", ".clo", ".def", ".cfg"})) return;
    const fs::path below = folders.empty() ? fs::path() : folders.back();
    for (const std::string& file :
         {(below / (name + ".tex")).string(), (below / name).string()}) {
      if (seen_.contains(fs::path(file).lexically_normal())) return;
      const auto source = open_(file);
      if (!source) continue;
      seen_.insert(fs::path(file).lexically_normal());
      Scanner(std::make_shared<const text::Source>(
                  text::Source{(folder_ / file).string(), with_line_ends(source->bytes)}),
              *this, true)
          .run();
      return;
    }
    paper.unread.push_back({where, name});
  }

  Paper paper;

 private:
  claims::Opener open_;
  fs::path folder_;
  std::set<fs::path> seen_;
};

void Scanner::run() {
  while (at_ < text_.size() && !is_done_) {
    const char c = text_[at_];
    if (c == '%') {
      skip_comment();
    } else if (c == '\\') {
      word(at_++);
    } else {
      if (c != '{' && c != '*' && c != '=' && !is_blank(c)) last_word_.clear();
      if (c == '{') ++depth_;
      if (c == '}') depth_ = std::max(0, depth_ - 1);
      ++at_;
    }
  }
}

void Scanner::word(std::size_t begin) {
  const std::string word = name();
  const bool is_defined_here = defines(last_word_);
  const bool is_made = last_word_ == "newif",
             is_compared = among(last_word_, {"ifx", "string", "noexpand"});
  const bool is_target = is_let_ || is_compared;
  if (is_made && word.starts_with("if")) files_.conditionals.insert(word);
  is_let_ = is_defined_here && last_word_ == "let";
  last_word_ = word;
  if (is_defined_here || is_made) return;
  if (word == "spval") return mention(Mention::Kind::value, begin);
  if (word == "spstatus") return mention(Mention::Kind::status, begin);
  if (word == "SeamStatus") return mention(Mention::Kind::known_status, begin);
  if (among(word, {"url", "href", "path", "nolinkurl"})) return skip_literal();
  if (word == "begin" && is_outside()) return begin_environment();
  if (word == "end" && is_outside() && argument() == "document" && !is_part_) is_done_ = true;
  if (word == "iffalse" && !is_target && is_outside()) skip_false();
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
  if (kind == Mention::Kind::value && continues(begin)) {
    files_.paper.errors.push_back({span(begin), "the number goes on outside the braces",
                                   "write all of it, with its sign, inside"});
    return;
  }
  std::string plain = *id;  // `\_` is the underscore of an id
  std::erase(plain, '\\');
  files_.paper.mentions.push_back({kind, plain, second.value_or(""), span(begin)});
}

// Whether a digit, a power of ten or a sign that is no difference stands at a printed number.
bool Scanner::continues(std::size_t begin) const {
  const std::string_view all(text_);
  const std::string_view after = all.substr(at_), before = all.substr(0, begin);
  if (!after.empty() &&
      (is_digit(after[0]) || (after[0] == '.' && after.size() > 1 && is_digit(after[1]))))
    return true;
  for (const char* power : {"\\times10", "\\times 10", "\\cdot10", "\\cdot 10"})
    if (after.starts_with(power)) return true;
  if (before.empty()) return false;
  if (is_digit(before.back()) || before.back() == '.') return true;
  if (before.back() != '-') return false;
  const std::size_t left = before.find_last_not_of(" \t\n", before.size() - 2);
  return before.size() < 2 || left == before.npos ||
         std::string_view("=$(,<>~[{&").find(before[left]) != before.npos;
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
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  if (last_word_ != "verb" && at_ < text_.size() && text_[at_] == '[')
    at_ = std::min(text_.find(']', at_), text_.size() - 1) + 1;
  if (at_ >= text_.size()) return;
  if (last_word_ != "verb" && text_[at_] == '{') return skip_literal();
  const std::size_t line = std::min(text_.find('\n', at_), text_.size());
  const std::size_t end = text_.find(text_[at_], at_ + 1);
  at_ = end == std::string::npos || end > line ? line : end + 1;
}

// What stands between braces as it is, such as the address in \url{…}: a % begins no comment.
void Scanner::skip_literal() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  if (at_ >= text_.size() || text_[at_] != '{') return;
  int depth = 0;
  for (std::size_t end = at_; end < text_.size() && text_[end] != '\n'; ++end) {
    if (text_[end] == '{') ++depth;
    if (text_[end] == '}' && --depth == 0) {
      at_ = end + 1;
      return;
    }
  }
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
      if (is_conditional(word, files_.conditionals)) ++depth;
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
  if (!file) return;
  const fs::path below = files_.folders.empty() ? fs::path() : files_.folders.back();
  files_.folders.push_back(below / *folder);
  files_.input(*file, span(begin));
  files_.folders.pop_back();
}

}  // namespace

Paper read_paper(const fs::path& path) {
  Files files(path);
  const auto source = open(path);
  Scanner(std::make_shared<const text::Source>(
              text::Source{source->name, with_line_ends(source->bytes)}),
          files, false)
      .run();
  return std::move(files.paper);
}

}  // namespace seam::cli
