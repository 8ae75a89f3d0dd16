// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_tree.h"

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

Expression node(Kind kind, std::string text, std::vector<Expression> children) {
  return {kind, std::move(text), std::move(children), {}};
}

}  // namespace

std::string RandomTree::pick(const std::vector<std::string>& of) {
  return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
}

std::string RandomTree::name() {
  return pick({"x", "y", "x'", "gamma_f1", "icosoid.p", "alpha", "sqrt", "at", "all", "digits",
               "x_1''"});
}

std::string RandomTree::id() {
  return pick({"a.b-c:", "d", "K_max.", "42-"}) + std::to_string(++ids_);
}

std::string RandomTree::quoted() {
  return pick({"", "a title", "§6 with γ, 'quotes' and #", "2  blanks ", "\\"});
}

std::vector<Expression> RandomTree::several(int least, int most,
                                            Expression (RandomTree::*make)(int), int depth) {
  std::vector<Expression> all;
  for (int left = least + below(most - least + 1); left > 0; --left)
    all.push_back((this->*make)(depth));
  return all;
}

Expression RandomTree::number(int) {
  return node(Kind::number, pick({"0", "17", "0.25", "1.50", "007"}), {});
}

Expression RandomTree::name_leaf(int) {
  return node(Kind::name, name(), {});
}

Expression RandomTree::value(int depth) {
  if (depth <= 0) return maybe() ? number() : name_leaf();
  const int d = depth - 1;
  switch (below(22)) {
    case 0:
      return number();
    case 1:
      return name_leaf();
    case 2:
      return node(Kind::string, quoted(), {});
    case 3:
    case 4:
      return node(Kind::negate, "", {any(d)});
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
      return node(Kind::binary, pick({"+", "-", "*", "/", "^"}), {any(d), any(d)});
    case 10:
    case 11:
      return call(d);
    case 12:
      return index(d);
    case 13:
      return node(Kind::tuple, "", several(2, 4, &RandomTree::any, d));
    case 14:
      return node(Kind::list, "", several(0, 3, &RandomTree::element, d));
    case 15:
      return matrix(d);
    case 16:
      return node(Kind::range, "", {any(d), any(d)});
    case 17:
      return node(Kind::plane, "", {any(d), any(d)});
    case 18:
      return net(d);
    case 19:
      return indexed(d);
    case 20:
      return node(Kind::from, pick({"triangle_patch", "quad_patch", "curve"}), {any(d)});
    default:
      return maybe() ? node(Kind::infinity, "", {}) : node(Kind::read, quoted(), {});
  }
}

Expression RandomTree::list(int depth) {
  return node(Kind::list, "", several(1, 4, &RandomTree::element, depth));
}

Expression RandomTree::element(int depth) {
  if (below(6) != 0) return any(depth);
  if (maybe()) return node(Kind::limit, name(), {any(depth), any(depth)});
  Expression each = node(Kind::each, "", {any(depth)});
  for (int left = 1 + below(2); left > 0; --left) each.children.push_back(ranged(depth));
  return each;
}

Expression RandomTree::argument(int depth) {
  return below(5) == 0 ? node(Kind::named, name(), {any(depth)}) : element(depth);
}

Expression RandomTree::call(int depth) {
  Expression call = node(Kind::call, "", several(0, 3, &RandomTree::argument, depth));
  call.children.insert(call.children.begin(), maybe() ? name_leaf() : any(depth));
  return call;
}

Expression RandomTree::index(int depth) {
  return node(Kind::index, "", several(2, 3, &RandomTree::any, depth));
}

Expression RandomTree::matrix(int depth) {
  return node(Kind::matrix, "", several(2, 3, &RandomTree::list, depth));
}

Expression RandomTree::entry(bool rational, int depth) {
  if (rational && maybe()) return node(Kind::weighted, "", {any(depth), any(depth)});
  return any(depth);
}

Expression RandomTree::net(int depth) {
  const bool rational = maybe();
  Expression net =
      node(Kind::patch, (rational ? "rational " : "") + pick({"triangle_patch", "curve"}), {});
  for (int rows = 1 + below(3); rows > 0; --rows) {
    net.children.push_back(node(Kind::list, "", {}));
    for (int left = 1 + below(3); left > 0; --left)
      net.children.back().children.push_back(entry(rational, depth));
  }
  return net;
}

Expression RandomTree::indexed(int depth) {
  const bool rational = maybe();
  Expression net =
      node(Kind::indexed, rational ? "rational quad_patch" : "triangle_patch", {any(depth)});
  for (int left = 1 + below(4); left > 0; --left)
    net.children.push_back(
        node(Kind::control, pick({"300", "0", "10,2"}), {entry(rational, depth)}));
  return net;
}

Expression RandomTree::names() {
  return node(Kind::list, "", several(1, 3, &RandomTree::name_leaf, 0));
}

Expression RandomTree::set(int depth) {
  if (below(3) == 0) return node(Kind::half_open, pick({"[)", "(]"}), {any(depth), any(depth)});
  return any(depth);
}

Expression RandomTree::ranged(int depth) {
  Expression names_first = names();
  for (Expression& n : names_first.children)
    if (n.text == "all") n.text = "u";
  Expression binding = node(Kind::binding, "in", {std::move(names_first), set(depth)});
  if (below(3) == 0) binding.children.push_back(any(depth));
  return binding;
}

Expression RandomTree::quantified(int depth) {
  Expression all = node(maybe() ? Kind::for_all : Kind::for_some, "", {});
  if (maybe()) {
    all.children.push_back(node(Kind::binding, "all", {names()}));
    if (maybe()) all.children.back().children.push_back(any(depth));
  } else {
    all.children = several(1, 2, &RandomTree::ranged, depth);
  }
  all.children.push_back(any(depth));
  return all;
}

Expression RandomTree::relation(int depth) {
  Expression relation = node(Kind::relation, "", several(2, 4, &RandomTree::any, depth));
  for (std::size_t i = 1; i < relation.children.size(); ++i)
    relation.text += (i > 1 ? " " : "") + pick({"=", "!=", "<", "<=", ">", ">=", "~"});
  if (relation.text.ends_with('~') && maybe()) return node(Kind::truncated, "", {relation});
  return relation;
}

Expression RandomTree::solve(int depth) {
  Expression unknowns = names();
  if (maybe()) unknowns.children = several(1, 2, &RandomTree::ranged, depth);
  const Expression conditions = node(Kind::list, "", several(0, 1, &RandomTree::any, depth));
  const std::string text = pick({"", "none", "one"});
  const int least = text.empty() ? 1 : 0, most = text.empty() ? 3 : text == "one" ? 1 : 0;
  return node(Kind::solve, text,
              {unknowns, any(depth), conditions,
               node(Kind::list, "", several(least, most, &RandomTree::any, depth))});
}

Expression RandomTree::statement(int depth) {
  if (depth <= 0) return node(Kind::relation, "=", {name_leaf(), number()});
  const int d = depth - 1;
  switch (below(9)) {
    case 0:
    case 1:
      return relation(d);
    case 2:
    case 3:
      return quantified(d);
    case 4:
      return node(Kind::conjunction, "", {any(d), any(d)});
    case 5:
      return node(Kind::disjunction, "", {any(d), any(d)});
    case 6:
      return node(maybe() ? Kind::implication : Kind::equivalence, "", {any(d), any(d)});
    case 7:
      return node(Kind::negation, "", {any(d)});
    default:
      return solve(d);
  }
}

// ---- items

Expression RandomTree::hint(int depth) {
  Expression word = node(Kind::name, pick({"bernstein", "subdivide"}), {});
  if (maybe()) return word;
  Expression call = node(Kind::call, "", several(1, 2, &RandomTree::argument, depth));
  call.children.insert(call.children.begin(), std::move(word));
  return call;
}

void RandomTree::fill_claim(Item& item) {
  item.claim.id = item.name;
  item.claim.statement = any(5);
  if (maybe()) item.claim.corrected = any(4);
  item.claim.expect = pick({"", "refuted", "undecided"});
  for (int left = below(3); left > 0; --left) item.claim.using_claims.push_back(id());
  item.claim.hints = several(0, 2, &RandomTree::hint, 2);
}

void RandomTree::fill_table(Item& item) {
  item.columns = several(0, 1, &RandomTree::ranged, 2);
  for (int left = below(3); left > 0; --left) item.labels.push_back(quoted());
  for (int left = 1 + below(3); left > 0; --left) {
    item.rows.push_back({quoted(), any(3), several(1, 3, &RandomTree::any, 2), {}, maybe()});
    if (maybe()) item.rows.back().corrected.emplace(0, any(2));
  }
}

void RandomTree::fill_param(Item& item) {
  for (int left = 1 + below(3); left > 0; --left) item.names.push_back(name());
  item.name = item.names.front();
  item.type = pick(
      {"", "integer", "vector 3", "function", "vector 3 function", "vector 2 function of 2"});
  item.expressions = several(0, 1, &RandomTree::set, 3);
  if (maybe()) item.where = any(3);
}

Item RandomTree::item(Item::Kind kind) {
  Item item;
  item.kind = kind;
  item.name = name();
  for (int left = below(3); left > 0; --left)
    item.comments.push_back(pick({"", "a remark", "  # γ"}));
  switch (kind) {
    case Item::Kind::paper:
      item.by = quoted();
      item.source = quoted();
      item.year = pick({"", "1998"});
      [[fallthrough]];
    case Item::Kind::section:
    case Item::Kind::include:
      item.name = quoted();
      break;
    case Item::Kind::let:
    case Item::Kind::define:
      for (int left = below(3); left > 0; --left) item.parameters.push_back(name());
      item.expressions = {any(6)};
      break;
    case Item::Kind::sequence:
      item.parameters = {name()};
      item.expressions = {any(4), any(4)};
      break;
    case Item::Kind::param:
      fill_param(item);
      break;
    case Item::Kind::root:
      item.expressions = {any(4), set(2)};
      break;
    case Item::Kind::figure:
      item.name = maybe() ? id() : "";
      item.claim.title = quoted();
      item.claim.at = quoted();
      item.expressions = several(1, 2, &RandomTree::any, 3);
      if (Expression shown = element(3); shown.kind == Kind::each)
        item.expressions[0] = std::move(shown);
      for (int left = below(3); left > 0; --left)
        item.names.push_back(pick({"net", "curvature_lines", "contours"}));
      break;
    case Item::Kind::ask:
      item.name = id();
      item.expressions = {any(4)};
      item.option = pick({"", "30"});
      break;
    case Item::Kind::claim:
    case Item::Kind::table:
      item.name = id();
      item.claim.title = quoted();
      item.claim.at = quoted();
      kind == Item::Kind::claim ? fill_claim(item) : fill_table(item);
      break;
  }
  return item;
}

File RandomTree::file(int items) {
  File file;
  constexpr int kinds = static_cast<int>(Item::Kind::ask) + 1;
  for (int i = 0; i < items; ++i)
    file.items.push_back(item(static_cast<Item::Kind>(below(kinds))));
  if (maybe()) file.closing_comments = {"the end"};
  return file;
}

}  // namespace seam::claims
