// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <utility>

#include "claims/control.h"
#include "claims/item_actions.h"
#include "claims/syntax.h"
#include "claims/words.h"
#include "text/utf8.h"

// Items are read one by one. One that cannot be read is given up, and reading goes on at
// the next line that begins with the first word of an item.

namespace seam::claims {
namespace {

using text::Diagnostic;
using text::Source;

constexpr std::size_t max_errors = 100;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy>;

template <typename Rule>
void match(const Source& source, std::size_t at, Builder& builder) {
  const char* bytes = source.bytes.data();
  Input in(bytes + at, bytes + source.bytes.size(), "");
  if (!tao::pegtl::parse<Rule, grammar::action, grammar::control>(in, builder))
    builder.unexpected_rest();
}

// The first byte that no text may hold.
std::optional<Diagnostic> unreadable(const std::shared_ptr<const Source>& source) {
  const std::string_view bytes = source->bytes;
  for (std::size_t at = 0; at < bytes.size();) {
    const text::CodePoint point = text::decode(bytes, at);
    if (point.length == 0)
      return Diagnostic{
          {source, at, at + 1}, "this byte is not UTF-8", "save the file as UTF-8"};
    if (text::invisible(point.value))
      return Diagnostic{
          {source, at, at + point.length},
          "the invisible character " + text::code_name(point.value) + " cannot stand here",
          {}};
    at += point.length;
  }
  return std::nullopt;
}

std::size_t text_begin(const Source& source) {
  return source.bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

bool item_begins(std::string_view rest) {
  for (const std::string& word : item_words())
    if (rest.starts_with(word) &&
        (rest.size() == word.size() ||
         std::string_view(" \t\r\n\"#").find(rest[word.size()]) != std::string_view::npos))
      return true;
  return false;
}

// Where the first line from `at` on begins an item.
std::size_t next_item(std::string_view bytes, std::size_t at) {
  if (at > 0) at = std::min(bytes.find('\n', at - 1), bytes.size() - 1) + 1;
  while (at < bytes.size() && !item_begins(bytes.substr(at)))
    at = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
  return at;
}

// Ids of claims, tables, figures and questions name their results; a second one is refused.
class Ids {
 public:
  std::optional<Diagnostic> add(const Item& item) {
    const bool has_id = item.kind == Item::Kind::claim || item.kind == Item::Kind::table ||
                        item.kind == Item::Kind::ask ||
                        (item.kind == Item::Kind::figure && !item.name.empty());
    if (!has_id) return std::nullopt;
    const auto [known, is_new] = known_.emplace(item.name, item.name_span.begin);
    if (is_new) return std::nullopt;
    const text::Position first = text::position(*item.span.source, known->second);
    return Diagnostic{
        item.name_span, "the id '" + item.name + "' is used twice",
        "the first is at " + std::to_string(first.line) + ":" + std::to_string(first.column)};
  }

 private:
  std::map<std::string, std::size_t> known_;
};

std::size_t line_end(std::string_view bytes, std::size_t at) {
  return std::min(bytes.find('\n', at), bytes.size());
}

}  // namespace

Parsed parse(std::shared_ptr<const Source> source) {
  Parsed parsed;
  parsed.file.source = std::move(source);
  const Source& text = *parsed.file.source;
  if (auto error = unreadable(parsed.file.source)) {
    parsed.errors.push_back(std::move(*error));
    return parsed;
  }

  const std::string_view bytes = text.bytes;
  Builder builder(parsed.file.source);
  Ids ids;
  std::size_t at = text_begin(text);
  builder.begin_item(at);
  match<grammar::gap>(text, at, builder);
  at = builder.gap_end;

  while (at < bytes.size() && parsed.errors.size() < max_errors) {
    builder.begin_item(at);
    try {
      match<grammar::whole_item>(text, at, builder);
      builder.item.comments = builder.take_comments(line_end(bytes, builder.item.span.end));
      if (auto error = ids.add(builder.item)) parsed.errors.push_back(std::move(*error));
      parsed.file.items.push_back(std::move(builder.item));
      at = builder.gap_end;
    } catch (SyntaxError& error) {
      parsed.errors.push_back(std::move(error.diagnostic));
      at = next_item(bytes, std::max(builder.gap_end, at + 1));
    }
  }
  parsed.file.closing_comments = builder.take_comments(bytes.size());
  return parsed;
}

ParsedExpression parse_expression(std::shared_ptr<const Source> source) {
  ParsedExpression parsed;
  if (auto error = unreadable(source)) {
    parsed.errors.push_back(std::move(*error));
    return parsed;
  }
  const Source& text = *source;
  Builder builder(std::move(source));
  const std::size_t at = text_begin(text);
  builder.begin_item(at);
  try {
    match<grammar::whole_expression>(text, at, builder);
    parsed.expression = builder.take();
  } catch (SyntaxError& error) {
    parsed.errors.push_back(std::move(error.diagnostic));
  }
  return parsed;
}

}  // namespace seam::claims
