// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/stated.h"

namespace seam::coq {

using certificate::Relation;
using certificate::Sign;

const char* relation_code(Relation relation) {
  switch (relation) {
    case Relation::positive:
      return "Positive";
    case Relation::nonnegative:
      return "Nonnegative";
    case Relation::zero:
      return "Zero";
    case Relation::nonzero:
      return "Nonzero";
    case Relation::nonpositive:
      return "Nonpositive";
    case Relation::negative:
      break;
  }
  return "Negative";
}

std::string relation_text(const Written& formula, Relation relation) {
  switch (relation) {
    case Relation::positive:
      return formula.text + " > 0";
    case Relation::nonnegative:
      return formula.text + " >= 0";
    case Relation::zero:
      return formula.text + " = 0";
    case Relation::nonzero:
      return formula.text + " <> 0";
    case Relation::nonpositive:
      return formula.text + " <= 0";
    case Relation::negative:
      break;
  }
  return formula.text + " < 0";
}

Stated place_domain(Draft& draft, const Sign& sign, const std::set<std::string>& variables,
                    bool with_coordinates) {
  Stated stated;
  Formulas& formulas = draft.formulas();
  for (const auto& simplex : sign.domain.factors)
    stated.factors.push_back(read_factor(simplex, formulas, draft.names()));
  if (with_coordinates)
    for (const Factor& factor : stated.factors)
      for (const std::string& name : factor.coordinates) formulas.place_coordinate(name);
  std::set<std::string> free = variables;
  for (const Factor& factor : stated.factors)
    for (std::size_t i = 0; i < factor.variables.size(); ++i) {
      free.erase(factor.simplex->variables[i]);
      formulas.place(factor.simplex->variables[i], factor.variables[i]);
      stated.variables.push_back(factor.variables[i]);
    }
  for (const std::string& symbol : free) {
    stated.variables.push_back(draft.names().of(symbol));
    formulas.place(symbol, stated.variables.back());
  }
  if (!with_coordinates)
    for (const Factor& factor : stated.factors)
      if (factor.shape == Factor::Shape::general)
        for (const std::string& name : factor.coordinates) formulas.place_coordinate(name);
  for (const Factor& factor : stated.factors)
    stated.inequalities.push_back(inequalities(factor, formulas, draft.names()));
  return stated;
}

namespace {

void say_coordinates(Draft& draft, const Factor& factor) {
  std::string line = "forall";
  for (const std::string& name : factor.coordinates) {
    line += " " + name;
    draft.intro(name);
  }
  line += " : R,";
  for (std::size_t i = 0; i < factor.coordinates.size(); ++i) {
    const bool is_open = factor.simplex->open[i];
    line += std::string(" 0 ") + (is_open ? "<" : "<=") + " " + factor.coordinates[i] + " ->";
    draft.intro(is_open ? factor.strict[i] : factor.signs[i]);
  }
  draft.say(line);
  draft.say(weighted_sum(factor, draft.formulas()).text + " = 1 ->");
  draft.intro(factor.sum);
}

void say_variables(Draft& draft, const std::vector<std::string>& variables) {
  if (variables.empty()) return;
  std::string line = "forall";
  for (const std::string& name : variables) {
    line += " " + name;
    draft.intro(name);
  }
  draft.say(line + " : R,");
}

}  // namespace

void say_for_all(Draft& draft, Stated& stated, const Sign& sign) {
  for (const Factor& factor : stated.factors)
    if (factor.shape == Factor::Shape::general) say_coordinates(draft, factor);
  say_variables(draft, stated.variables);
  for (std::size_t i = 0; i < stated.factors.size(); ++i) {
    const Factor& factor = stated.factors[i];
    for (const Inequality& inequality : stated.inequalities[i]) {
      draft.say(inequality.text + " ->");
      draft.intro(inequality.name);
    }
    if (factor.shape != Factor::Shape::general) continue;
    for (std::size_t j = 0; j < factor.variables.size(); ++j) {
      draft.say(factor.variables[j] + " = " +
                variable_by_coordinates(factor, j, draft.formulas()).text + " ->");
      draft.intro(factor.equations[j]);
    }
  }
  draft.say_shared();
  for (const auto& condition : sign.domain.where) {
    draft.say(relation_text(draft.formulas().write(condition.formula), condition.relation) +
              " ->");
    stated.conditions.push_back(draft.names().fresh("condition"));
    draft.intro(stated.conditions.back());
  }
  draft.say(relation_text(draft.formulas().write(sign.formula), sign.relation));
  draft.prove_intros();
}

std::string condition_codes(const Draft& draft, const Sign& sign) {
  std::vector<std::string> codes;
  for (const auto& condition : sign.domain.where)
    codes.push_back("(" + draft.formulas().write(condition.formula).code + ", " +
                    relation_code(condition.relation) + ")");
  return list(codes);
}

}  // namespace seam::coq
