// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "claims/latex.h"
#include "claims/typeset.h"

namespace seam::claims {
namespace {

using Kind = Expression::Kind;
using Children = std::vector<Expression>;

Level tighter(Level level) {
  return static_cast<Level>(static_cast<int>(level) + 1);
}

std::string binary_macro(Kind kind) {
  switch (kind) {
    case Kind::conjunction:
      return " \\land ";
    case Kind::disjunction:
      return " \\lor ";
    case Kind::implication:
      return " \\implies ";
    default:
      return " \\iff ";
  }
}

Typeset connective(const Expression& e) {
  const Level own = level(e);
  // A chain of equivalences would read as one that all are equivalent.
  const bool left = e.kind == Kind::conjunction || e.kind == Kind::disjunction;
  const bool right = e.kind == Kind::implication;
  return {typeset(e.children[0], left ? own : tighter(own)) + binary_macro(e.kind) +
              typeset(e.children[1], right ? own : tighter(own)),
          own};
}

std::string relation_macro(const std::string& operation) {
  if (operation == "!=") return "\\ne";
  if (operation == "<=") return "\\le";
  if (operation == ">=") return "\\ge";
  return operation == "~" ? "\\approx" : operation;
}

Typeset relation(const Expression& e) {
  std::istringstream operations(e.text);
  std::string tex = typeset(e.children[0], Level::range), operation;
  for (std::size_t i = 1; i < e.children.size(); ++i) {
    operations >> operation;
    tex += " " + relation_macro(operation) + " " + typeset(e.children[i], Level::range);
  }
  return {tex, Level::relation};
}

std::string bindings(const Children& children, std::size_t begin, std::size_t end) {
  std::string tex;
  for (std::size_t i = begin; i < end; ++i)
    tex += (i > begin ? ",\\ " : "") + typeset_binding(children[i]);
  return tex;
}

Typeset quantified(const Expression& e) {
  const std::string sign = e.kind == Kind::for_all ? "\\forall " : "\\exists ";
  return {sign + bindings(e.children, 0, e.children.size() - 1) + R"(\colon\ \allowbreak )" +
              typeset(e.children.back(), Level::statement),
          Level::statement};
}

Typeset solve(const Expression& e) {
  const Children& unknowns = e.children[0].children;
  std::string tex = "\\text{solve }";
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    tex += (i > 0 ? ", " : "") + (unknowns[i].kind == Kind::binding
                                      ? typeset_binding(unknowns[i])
                                      : latex_name(unknowns[i].text));
  tex += R"(\colon\ \allowbreak )" + typeset(e.children[1], Level::equivalence);
  for (const Expression& condition : e.children[2].children)
    tex += "\\text{ where }" + typeset(condition, Level::equivalence);
  tex += R"(\ \allowbreak \text{gives })";
  const Children& solutions = e.children[3].children;
  if (!e.text.empty()) tex += "\\text{" + e.text + (e.text == "one" ? " solution}" : "}");
  if (e.text == "one" && !solutions.empty()) tex += " \\approx ";
  const std::string list = typeset_list(solutions, 0, true);
  // Behind a text, TeX would take a minus for the operator between two values.
  return {tex + (list.starts_with('-') ? "{-}" + list.substr(1) : list), Level::statement};
}

Typeset each(const Expression& e) {
  if (e.kind == Kind::limit)
    return {typeset(e.children[0], Level::equivalence, true) + " \\mid " + latex_name(e.text) +
                " \\to " + typeset(e.children[1], Level::range),
            Level::statement};
  return {typeset(e.children[0], Level::equivalence, true) + " \\mid " +
              bindings(e.children, 1, e.children.size()),
          Level::statement};
}

}  // namespace

Typeset typeset_statement(const Expression& e) {
  switch (e.kind) {
    case Kind::relation:
      return relation(e);
    case Kind::truncated:
      return {relation(e.children[0]).tex + "\\text{ (truncated)}", Level::relation};
    case Kind::for_all:
    case Kind::for_some:
      return quantified(e);
    case Kind::negation:
      return {"\\lnot " + typeset(e.children[0], Level::callable), Level::negation};
    case Kind::solve:
      return solve(e);
    case Kind::each:
    case Kind::limit:
      return each(e);
    case Kind::binding:
      return {typeset_binding(e), Level::statement};
    default:
      return connective(e);
  }
}

std::string typeset_binding(const Expression& b) {
  const Children& names = b.children[0].children;
  const bool bare_names = b.text == "all";
  std::string tex;
  for (const Expression& name : names) tex += (tex.empty() ? "" : ", ") + latex_name(name.text);
  if (!bare_names && names.size() > 1) tex = "(" + tex + ")";
  std::size_t next = 1;
  if (!bare_names) tex += " \\in " + typeset(b.children[next++], Level::range, true);
  if (next < b.children.size())
    tex += "\\text{ where }" + typeset(b.children[next], Level::equivalence);
  return tex;
}

}  // namespace seam::claims
