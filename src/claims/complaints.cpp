// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>

#include "claims/builder.h"
#include "claims/greek.h"
#include "claims/words.h"
#include "text/utf8.h"

// What is said when the text is not as the grammar wants it. A place is the token
// that does not fit; if that stands on a later line, then the end of the token before it,
// for there something is missing.

namespace seam::claims {
namespace {

constexpr std::size_t shown = 40;  // bytes of a token in a message

bool ascii_word_part(unsigned char c) {
  return std::isalnum(c) || c == '_' || c == '\'';
}

bool begins_word(std::string_view bytes, std::size_t at) {
  if (at >= bytes.size()) return false;
  const char32_t c = text::decode(bytes, at).value;
  return c < 0x80 ? std::isalpha(static_cast<int>(c)) != 0 : !greek_name(c).empty();
}

std::size_t word_end(std::string_view bytes, std::size_t at) {
  while (at < bytes.size()) {
    const auto c = static_cast<unsigned char>(bytes[at]);
    const text::CodePoint point = text::decode(bytes, at);
    const bool inner_dot = c == '.' && at + 1 < bytes.size() &&
                           ascii_word_part(static_cast<unsigned char>(bytes[at + 1]));
    if (c < 0x80 ? !ascii_word_part(c) && !inner_dot : greek_name(point.value).empty()) break;
    at += point.length;
  }
  return at;
}

std::string quoted(std::string_view token) {
  const char* quote = token.find('\'') == std::string_view::npos ? "'" : "`";
  if (token.size() > shown) {
    std::size_t end = shown;
    while (end > 0 && (static_cast<unsigned char>(token[end]) & 0xC0) == 0x80) --end;
    return quote + std::string(token.substr(0, end)) + "…" + quote;
  }
  return quote + std::string(token) + quote;
}

bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool first_on_line(std::string_view bytes, std::size_t at) {
  while (at > 0 && (bytes[at - 1] == ' ' || bytes[at - 1] == '\t')) --at;
  return at == 0 || bytes[at - 1] == '\n' || bytes[at - 1] == '\xBF';
}

// What may follow a statement.
std::vector<std::string> inner_words() {
  std::vector<std::string> all = operator_words();
  all.insert(all.end(), clause_words().begin(), clause_words().end());
  return all;
}

// Characters that look like ones of the language, and what to write instead.
struct Lookalike {
  std::string_view text, instead;
};
constexpr std::array lookalikes = {
    Lookalike{"==", "'='"},
    Lookalike{"<>", "'!='"},
    Lookalike{"=<", "'<='"},
    Lookalike{"=>", "'>=' or 'implies'"},
    Lookalike{"&&", "'and'"},
    Lookalike{"||", "'or'"},
    Lookalike{"**", "'^'"},
    Lookalike{"−", "'-'"},
    Lookalike{"–", "'-'"},
    Lookalike{"×", "'*', or cross(a, b)"},
    Lookalike{"÷", "'/'"},
    Lookalike{"²", "'^2'"},
    Lookalike{"³", "'^3'"},
    Lookalike{"⁴", "'^4'"},
    Lookalike{"∞", "'infinity'"},
    Lookalike{"→", "'->'"},
    Lookalike{"⇒", "'implies'"},
    Lookalike{"⇔", "'iff'"},
    Lookalike{"“", "'\"'"},
    Lookalike{"”", "'\"'"},
    Lookalike{"„", "'\"'"},
    Lookalike{"’", "`'`"},
    Lookalike{"′", "`'`"},
    Lookalike{"…", "'..', or write all out"},
    Lookalike{"!", "'not'"},
    Lookalike{"∂", "diff(E, u)"},
    Lookalike{"∑", "sum(E for i in 1..n)"},
    Lookalike{".", "0.5, with a digit before the point"},
};

std::string instead(std::string_view rest) {
  for (const Lookalike& l : lookalikes)
    if (rest.starts_with(l.text)) return "write " + std::string(l.instead);
  if (!rest.empty() && text::decode(rest, 0).value >= 0x80)
    return "names are made of the letters a to z, Greek letters, digits, '_', `'` and '.'";
  return {};
}

}  // namespace

text::Span Builder::token_at(std::size_t place) const {
  const std::string_view all = bytes();
  if (place >= all.size()) return span(place, place);
  std::size_t end =
      begins_word(all, place) || std::isdigit(static_cast<unsigned char>(all[place]))
          ? word_end(all, place)
          : place;
  if (all[place] == '"')
    end = std::min(all.find_first_of("\"\n", place + 1), all.size() - 1) + 1;
  if (end == place) end = place + std::max<std::size_t>(text::decode(all, place).length, 1);
  return span(place, end);
}

void Builder::fail(std::string message, text::Span where, std::string hint) const {
  throw SyntaxError{{std::move(where), std::move(message), std::move(hint)}};
}

void Builder::expected(std::string_view what) const {
  std::string message = "expected " + std::string(what);
  if (token_end > token_begin && token_end > item_begin_)
    message += " after " + quoted(bytes().substr(token_begin, token_end - token_begin));
  complain(std::move(message), {});
}

// At the next token, or where the last one ends.
void Builder::complain(std::string message, std::string hint) const {
  const std::string_view all = bytes();
  const std::string_view between = all.substr(token_end, gap_end - token_end);
  if (gap_end == all.size() || between.find('\n') != std::string_view::npos)
    fail(std::move(message), span(token_end, token_end), std::move(hint));
  const text::Span token = token_at(gap_end);
  const std::string_view found = all.substr(token.begin, token.end - token.begin);
  if (hint.empty()) hint = instead(all.substr(gap_end));
  if (hint.empty() && reserved(found) && message.find("in quotes") == std::string::npos)
    hint = quoted(found) + " is a word of the language";
  fail(std::move(message), token, std::move(hint));
}

void Builder::missing_colon() const {
  const bool inside = nodes.empty() && item.name.find(':') != std::string::npos;
  complain("expected ':' before the statement",
           inside ? "a ':' that touches the next word belongs to the id: put a blank behind it"
                  : "");
}

void Builder::expected_close(std::string_view what) const {
  const std::string_view last = bytes().substr(token_begin, token_end - token_begin);
  if (last == "(" || last == "[") expected("an expression");
  const std::size_t opened = marks.empty() ? bytes().size() : marks.back().begin;
  const std::string_view bracket = bytes().substr(opened, 1);
  std::string hint;
  if (bracket == "(" || bracket == "[") {
    const text::Position place = text::position(*source_, opened);
    hint = quoted(bracket) + " was opened at " + std::to_string(place.line) + ":" +
           std::to_string(place.column);
  }
  complain("expected " + std::string(what) + " after " + quoted(last), std::move(hint));
}

void Builder::missing_statement() const {
  const text::Span token = token_at(gap_end);
  const std::string_view found = bytes().substr(token.begin, token.end - token.begin);
  if (found.empty() || contains(item_words(), found) || contains(clause_words(), found))
    fail("this claim has no statement", item.name_span, "a statement stands after ':'");
  expected("a statement");
}

void Builder::once(std::size_t at) {
  const std::string clause = last_token();
  const auto [known, is_new] = clauses_.emplace(clause, at);
  if (is_new) return;
  const text::Position first = text::position(*source_, known->second);
  fail("this item has '" + clause + "' twice", token_at(at),
       "the first is at " + std::to_string(first.line) + ":" + std::to_string(first.column));
}

void Builder::draw_with() {
  if (!contains(figure_parts(), word)) {
    const std::string near = text::nearest(word, figure_parts());
    fail("a figure cannot be drawn with " + quoted(word), token_at(word_begin),
         near.empty() ? "it can with 'net', 'curvature_lines', 'contours'"
                      : "did you mean '" + near + "'?");
  }
  item.names.push_back(word);
}

void Builder::unknown_item() const {
  const text::Span token = token_at(gap_end);
  const std::string_view found = bytes().substr(token.begin, token.end - token.begin);
  if (!begins_word(bytes(), gap_end))
    fail("expected an item, such as 'let' or 'claim'", token, instead(bytes().substr(gap_end)));
  std::string near = text::nearest(found, item_words());
  fail("unknown item " + quoted(found), token,
       near.empty() ? "" : "did you mean '" + near + "'?");
}

void Builder::invisible_product(std::size_t left, std::size_t right) const {
  const text::Span second = token_at(right);
  std::string_view first = bytes().substr(left, right - left);
  first = first.substr(0, first.find_last_not_of(" \t") + 1);
  fail("expected an operator between " + quoted(first) + " and " +
           quoted(bytes().substr(second.begin, second.end - second.begin)),
       second, "there is no invisible product: write '*'");
}

void Builder::unexpected_rest() const {
  const std::string_view all = bytes();
  const text::Span token = token_at(gap_end);
  const std::string_view found = all.substr(token.begin, token.end - token.begin);
  const char next = gap_end < all.size() ? all[gap_end] : ' ';
  const bool is_word = begins_word(all, gap_end);

  if (next == ')' || next == ']' || next == '}') fail(quoted(found) + " closes nothing", token);
  if (found == "for")
    fail("a quantifier stands in front of its statement", token, "write 'for u in [0, 1]: S'");
  if (contains(item_words(), found)) fail("an item begins on a line of its own", token);
  if (reserved(found)) fail(quoted(found) + " cannot stand here", token);
  if (is_word && item.kind == Item::Kind::figure && !item.expressions.empty())
    if (const std::string near = text::nearest(found, figure_clauses()); !near.empty())
      fail("unknown clause " + quoted(found), token, "did you mean '" + near + "'?");
  if (is_word && first_on_line(all, gap_end)) unknown_clause(token);
  if (is_word)
    if (const std::string near = text::nearest(found, inner_words()); !near.empty())
      fail("expected an operator before " + quoted(found), token,
           "did you mean '" + near + "'?");
  if (is_word || std::isdigit(static_cast<unsigned char>(next)) != 0 || next == '(' ||
      next == '[')
    invisible_product(token_begin, gap_end);
  fail("unexpected " + (next == '"' ? "text" : quoted(found)), token,
       instead(all.substr(gap_end)));
}

// A word at the beginning of a line, where a clause or the next item may stand.
void Builder::unknown_clause(const text::Span& token) const {
  const std::string_view found = bytes().substr(token.begin, token.end - token.begin);
  if (item.kind != Item::Kind::claim || !text::nearest(found, item_words()).empty())
    unknown_item();
  const std::string near = text::nearest(found, clause_words());
  fail("unknown clause " + quoted(found), token,
       near.empty() ? "" : "did you mean '" + near + "'?");
}

}  // namespace seam::claims
