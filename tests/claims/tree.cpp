// SPDX-License-Identifier: GPL-3.0-or-later
#include "tree.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace seam::claims {
namespace {

constexpr std::array names = {
    "number",   "name",     "string",      "negate",      "binary",      "call",
    "named",    "index",    "tuple",       "list",        "matrix",      "each",
    "range",    "limit",    "infinity",    "plane",       "patch",       "indexed",
    "control",  "weighted", "from",        "read",        "relation",    "truncated",
    "for_all",  "for_some", "conjunction", "disjunction", "implication", "equivalence",
    "negation", "solve",    "binding",     "half_open"};

bool same(const std::vector<Expression>& a, const std::vector<Expression>& b) {
  return std::ranges::equal(a, b, [](auto& x, auto& y) { return claims::same(x, y); });
}

bool same(const std::optional<Expression>& a, const std::optional<Expression>& b) {
  return a.has_value() == b.has_value() && (!a || claims::same(*a, *b));
}

bool same(const Item::Row& a, const Item::Row& b) {
  return a.label == b.label && claims::same(a.value, b.value) && same(a.printed, b.printed) &&
         a.truncated == b.truncated &&
         std::ranges::equal(a.corrected, b.corrected, [](const auto& x, const auto& y) {
           return x.first == y.first && claims::same(x.second, y.second);
         });
}

bool same(const Claim& a, const Claim& b) {
  return std::tie(a.id, a.title, a.at, a.expect, a.using_claims) ==
             std::tie(b.id, b.title, b.at, b.expect, b.using_claims) &&
         claims::same(a.statement, b.statement) && same(a.corrected, b.corrected) &&
         same(a.hints, b.hints);
}

}  // namespace

std::string tree(const Expression& e) {
  const bool leaf = e.children.empty();
  if (leaf && (e.kind == Expression::Kind::number || e.kind == Expression::Kind::name))
    return e.text;
  std::string text = std::string("(") + names.at(static_cast<std::size_t>(e.kind));
  if (!e.text.empty()) text += " " + e.text;
  for (const Expression& child : e.children) text += " " + tree(child);
  return text + ")";
}

std::string tree(const std::string& bytes) {
  const ParsedExpression parsed = parse_expression(source(bytes));
  return parsed.errors.empty() ? tree(parsed.expression) : text::render(parsed.errors.front());
}

std::shared_ptr<const text::Source> source(std::string bytes) {
  return std::make_shared<const text::Source>(text::Source{"a.seam", std::move(bytes)});
}

std::string messages(const Parsed& parsed) {
  std::string all;
  for (const text::Diagnostic& error : parsed.errors) all += text::render(error);
  return all;
}

bool same(const Item& a, const Item& b) {
  return std::tie(a.kind, a.comments, a.name, a.parameters, a.names, a.by, a.source, a.year,
                  a.type, a.option, a.labels) == std::tie(b.kind, b.comments, b.name,
                                                          b.parameters, b.names, b.by, b.source,
                                                          b.year, b.type, b.option, b.labels) &&
         same(a.expressions, b.expressions) && same(a.where, b.where) &&
         same(a.claim, b.claim) && same(a.columns, b.columns) &&
         std::ranges::equal(a.rows, b.rows, [](auto& x, auto& y) { return same(x, y); });
}

bool same(const File& a, const File& b) {
  return a.closing_comments == b.closing_comments &&
         std::ranges::equal(a.items, b.items, [](auto& x, auto& y) { return same(x, y); });
}

}  // namespace seam::claims
