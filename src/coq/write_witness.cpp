// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "coq/domain.h"
#include "coq/stated.h"

// The point is named in the proof; that it meets each inequality and each condition, and that
// the relation fails there, are signs of numbers.

namespace seam::coq {
namespace {

using certificate::Relation;

/// `number_holds Positive ...`, for a formula at the point.
std::string sign_at_point(const Draft& draft, const char* theorem, Relation relation,
                          const Written& formula) {
  return std::string("compute_by (") + theorem + " " + relation_code(relation) + " " +
         draft.generators() + " [] " + draft.definitions() + " " + draft.named() + " " +
         formula.code + " " + draft.roots() + " " + draft.defined() + ")";
}

/// The value that the point gives each variable, in the order of their places; -1: none.
std::vector<certificate::Term> values_at(const certificate::Point& point,
                                         const certificate::Sign& sign,
                                         std::set<std::string> free) {
  std::vector<certificate::Term> values;
  const auto add = [&](const std::string& symbol) {
    const auto found = std::ranges::find(point.variables, symbol);
    values.push_back(
        found == point.variables.end()
            ? -1
            : point.values[static_cast<std::size_t>(found - point.variables.begin())]);
  };
  for (const auto& factor : sign.domain.factors)
    for (const std::string& symbol : factor.variables) {
      add(symbol);
      free.erase(symbol);
    }
  for (const std::string& symbol : free) add(symbol);
  return values;
}

}  // namespace

bool write_witness(Draft& draft, const certificate::Sign& sign,
                   const std::set<std::string>& variables, const certificate::Point& point) {
  const std::vector<certificate::Term> values = values_at(point, sign, variables);
  if (std::ranges::find(values, -1) != values.end()) return false;
  std::vector<Written> written;
  for (const certificate::Term value : values) written.push_back(draft.formulas().write(value));

  const Stated stated = place_domain(draft, sign, variables, false);
  for (const Factor& factor : stated.factors)
    if (factor.shape == Factor::Shape::general) return false;
  draft.prove_intros();
  std::string line;
  for (std::size_t i = 0; i < written.size(); ++i) {
    const std::string& name = stated.variables[i];
    draft.prove("pose (" + name + " := " + written[i].text + ").");
    draft.define(name, written[i], "eq_refl");
    line += (line.empty() ? "" : " ") + name;
  }
  if (!line.empty()) {
    draft.say("exists " + line + " : R,");
    for (const std::string& name : stated.variables) draft.prove("exists " + name + ".");
  }
  for (const auto& bounds : stated.inequalities)
    for (const Inequality& bound : bounds) {
      draft.say(bound.text + " /\\");
      draft.prove(std::string("split; [apply ") + (bound.is_strict ? "lt_of" : "le_of") + "; " +
                  sign_at_point(draft, "number_holds",
                                bound.is_strict ? Relation::positive : Relation::nonnegative,
                                bound.gap) +
                  " |].");
    }
  draft.say_shared();
  draft.prove_intros();
  for (const auto& condition : sign.domain.where) {
    const Written formula = draft.formulas().write(condition.formula);
    draft.say(relation_text(formula, condition.relation) + " /\\");
    draft.prove("split; [" + sign_at_point(draft, "number_holds", condition.relation, formula) +
                " |].");
  }
  const Written formula = draft.formulas().write(sign.formula);
  draft.say("~ (" + relation_text(formula, sign.relation) + ")");
  draft.prove(sign_at_point(draft, "number_fails", sign.relation, formula) + ".");
  return true;
}

}  // namespace seam::coq
