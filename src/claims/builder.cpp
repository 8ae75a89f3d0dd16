// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builder.h"

#include <algorithm>
#include <utility>

#include "claims/greek.h"
#include "claims/words.h"

// Everything that walks a tree recurses, its destructor included. `make` bounds the
// height of every tree, so that no chain of a hundred thousand terms ends a program.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

constexpr int max_height = 1000;
constexpr std::string_view root_sign = "√";

}  // namespace

Builder::Builder(std::shared_ptr<const text::Source> source) : source_(std::move(source)) {}

void Builder::begin_item(std::size_t at) {
  token_begin = token_end = gap_end = item_begin_ = at;
  depth = 0;
  set_begin = bytes().size() + 1;
  nodes.clear();
  marks.clear();
  clauses_.clear();
  item = {};
  item.span = span(at, at);
  item.name_span = item.span;
}

void Builder::gap(std::size_t begin, std::size_t end) {
  token_begin = gap_end;
  token_end = begin;
  gap_end = end;
}

bool Builder::at_line_begin() const {
  const std::string_view before = bytes().substr(0, gap_end);
  const std::size_t last = before.find_last_not_of(" \t");
  return last == std::string_view::npos || before[last] == '\n' || before[last] == '\xBF';
}

void Builder::read_word(std::size_t begin, std::string_view text) {
  word = text;
  word_begin = begin;
}

bool Builder::read_name(std::size_t begin, std::string_view text) {
  if (reserved(text)) return false;
  read_word(begin, spelled_out(text));
  return true;
}

void Builder::comment(std::size_t begin, std::string_view text) {
  text.remove_prefix(1);
  if (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t') || text.ends_with('\r'))
    text.remove_suffix(1);
  comments_.push_back({begin, std::string(text)});
}

std::vector<std::string> Builder::take_comments(std::size_t before) {
  const auto end =
      std::ranges::find_if(comments_, [&](const Comment& c) { return c.begin >= before; });
  std::vector<std::string> taken;
  for (auto it = comments_.begin(); it != end; ++it) taken.push_back(std::move(it->text));
  comments_.erase(comments_.begin(), end);
  return taken;
}

void Builder::mark(std::size_t begin, std::size_t back) {
  const std::size_t first = nodes.size() - back;
  marks.push_back({first, first, 0, begin, begin == set_begin, {}});
}

Builder::Mark Builder::unmark() {
  Mark last = std::move(marks.back());
  marks.pop_back();
  return last;
}

void Builder::make(Kind kind, std::string text, std::size_t children, std::size_t begin) {
  Node node;
  node.tree.kind = kind;
  node.tree.text = std::move(text);
  node.tree.span = span(begin, std::max(begin, token_end));
  node.tree.children.reserve(children);
  for (auto it = nodes.end() - children; it != nodes.end(); ++it) {
    if (it->tree.kind == Kind::half_open && kind != Kind::binding)
      fail("a half-open interval is a set and no value", it->tree.span);
    node.height = std::max(node.height, it->height + 1);
    node.tree.children.push_back(std::move(it->tree));
  }
  nodes.resize(nodes.size() - children);
  if (node.height > max_height)
    fail("this is chained or nested more than " + std::to_string(max_height) +
             " operations deep",
         span(token_begin, token_end), "give a name to a part of it with 'let'");
  nodes.push_back(std::move(node));
}

void Builder::binary(Kind kind, std::string_view text) {
  make(kind, std::string(text), 2, nodes[nodes.size() - 2].tree.span.begin);
}

void Builder::compare(std::string_view operation) {
  Node& left = nodes[nodes.size() - 2];
  if (!left.open) {
    binary(Kind::relation, operation);
    nodes.back().open = true;
    return;
  }
  left.tree.text.append(" ").append(operation);
  left.height = std::max(left.height, nodes.back().height + 1);
  left.tree.children.push_back(std::move(nodes.back().tree));
  left.tree.span.end = token_end;
  nodes.pop_back();
}

void Builder::truncate(std::size_t at) {
  const Expression& relation = nodes.back().tree;
  if (!nodes.back().open || !relation.text.ends_with('~'))
    fail("'truncated' stands only after a printed decimal", token_at(at),
         "as in 'E ~ 1.5849 truncated'");
  make(Kind::truncated, {}, 1, relation.span.begin);
}

void Builder::end_group(Kind kind, std::string text, std::size_t begin) {
  make(kind, std::move(text), count(unmark()), begin);
}

void Builder::end_call(Kind kind) {
  const Mark begun = unmark();
  make(kind, {}, count(begun), nodes[begun.first].tree.span.begin);
}

void Builder::end_row() {
  Mark& bracket = marks.back();
  if (bracket.row == nodes.size()) return;
  make(Kind::list, {}, nodes.size() - bracket.row, nodes[bracket.row].tree.span.begin);
  bracket.row = nodes.size();
  ++bracket.rows;
}

bool Builder::at_half_open() const {
  const Mark& bracket = marks.back();
  return bracket.is_set && bracket.rows == 0 && count(bracket) == 2;
}

void Builder::end_parenthesis(std::size_t begin) {
  const std::size_t entries = count(unmark());
  if (bytes()[token_end - 1] == ']')
    make(Kind::half_open, "(]", entries, begin);
  else if (entries > 1)
    make(Kind::tuple, {}, entries, begin);
  else
    nodes.back().tree.span = span(begin, token_end);
}

void Builder::end_bracket(std::size_t begin) {
  if (bytes()[token_end - 1] == ')') return end_group(Kind::half_open, "[)", begin);
  if (marks.back().rows == 0) return end_group(Kind::list, {}, begin);
  end_row();
  if (marks.back().rows < 2)
    fail("a matrix has two rows or more", span(begin, token_end),
         "a list is written without ';'");
  end_group(Kind::matrix, {}, begin);
}

void Builder::end_named() {
  const Expression name = take_name();
  make(Kind::named, name.text, 1, name.span.begin);
}

void Builder::end_limit() {
  unmark();
  const Expression name = take_name();
  make(Kind::limit, name.text, 2, nodes[nodes.size() - 2].tree.span.begin);
}

// The node below the topmost.
Expression Builder::take_name() {
  Expression name = std::move(nodes[nodes.size() - 2].tree);
  nodes.erase(nodes.end() - 2);
  return name;
}

void Builder::end_root(std::size_t begin) {
  Node callee;
  callee.tree = {Kind::name, "sqrt", {}, span(begin, begin + root_sign.size())};
  nodes.insert(nodes.end() - 1, std::move(callee));
  make(Kind::call, {}, 2, begin);
}

void Builder::end_weight(std::size_t begin) {
  if (!marks.back().text.starts_with("rational"))
    fail("a weight stands only in a rational patch", span(begin, token_end),
         "write 'rational " + marks.back().text + "'");
  binary(Kind::weighted, {});
}

void Builder::end_net() {
  end_row();
  end_patch(Kind::patch);
}

void Builder::end_patch(Kind kind) {
  const Mark begun = unmark();
  if (kind == Kind::from && begun.text.starts_with("rational"))
    fail("a patch from a formula has no weights", span(begun.begin, token_end),
         "leave out 'rational'");
  make(kind, begun.text, count(begun), begun.begin);
}

void Builder::end_bare_binding(std::size_t begin) {
  end_group(Kind::binding, "all", begin);
  if (!marks.back().text.empty()) return;
  const text::Span names = nodes.back().tree.children.front().span;
  const std::string written(bytes().substr(names.begin, names.end - names.begin));
  fail("expected 'in' and a set after '" + written + "'", span(names.end, names.end),
       "for every real number write 'for all " + written + "'");
}

void Builder::end_quantified() {
  const Mark begun = unmark();
  make(begun.text == "some" ? Kind::for_some : Kind::for_all, {}, count(begun), begun.begin);
}

void Builder::end_solve() {
  const Mark begun = unmark();
  constexpr std::size_t before_solutions = 3;  // unknowns, statement, condition
  make(Kind::list, {}, count(begun) - before_solutions, token_begin);
  make(Kind::solve, begun.text, count(begun), begun.begin);
}

void Builder::end_hint() {
  binary(Kind::call, {});
}

Expression Builder::take() {
  Expression last = std::move(nodes.back().tree);
  nodes.pop_back();
  return last;
}

void Builder::name_item() {
  item.name = word;
  item.name_span = span(word_begin, token_end);
}

void Builder::end_title(std::size_t begin) {
  const bool is_figure = item.kind == Item::Kind::figure;
  const bool has_id = item.kind == Item::Kind::claim || item.kind == Item::Kind::table;
  std::string& title = has_id || is_figure ? item.claim.title : item.name;
  if (has_id) {
    if (!title.empty())
      fail("this item has two titles", span(begin, token_end), "a place stands after 'at'");
  } else if (!is_figure || item.name.empty()) {
    item.name_span = span(begin, token_end);
  }
  title = word;
}

void Builder::end_item() {
  item.span = span(item_begin_, token_end);
  if (item.kind == Item::Kind::claim) item.claim.id = item.name;
  for (Node& node : nodes) item.expressions.push_back(std::move(node.tree));
  nodes.clear();
}

}  // namespace seam::claims
