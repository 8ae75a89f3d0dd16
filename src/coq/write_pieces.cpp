// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "coq/domain.h"
#include "coq/stated.h"

// Points of factors that are written by inequalities get barycentric coordinates by a lemma of
// the library. A split of one factor is one of all coordinates, with the weight 0 elsewhere.

namespace seam::coq {
namespace {

using certificate::Step;
using Shape = Factor::Shape;

std::string weakly(const Inequality& inequality) {
  return inequality.is_strict ? "(Rlt_le _ _ " + inequality.name + ")" : inequality.name;
}

std::string pattern(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : " & ") + name;
  return "(" + result + ")";
}

/// Coordinates of the point in this factor, and what is known of them.
void prove_coordinates(Draft& draft, const Factor& factor,
                       const std::vector<Inequality>& bounds) {
  const auto corner = [&](std::size_t i) {
    return draft.formulas().write(factor.simplex->corners[i][1]);
  };
  std::vector<std::string> names = factor.coordinates;
  names.insert(names.end(), factor.signs.begin(), factor.signs.end());
  names.push_back(factor.sum);
  names.insert(names.end(), factor.equations.begin(), factor.equations.end());
  const auto destruct = [&](const std::string& lemma, std::size_t first_strict) {
    names.insert(names.end(), factor.strict.begin() + static_cast<long>(first_strict),
                 factor.strict.end());
    draft.prove("destruct (" + lemma + ") as " + pattern(names) + ".");
  };
  const std::string x = factor.variables.front();
  switch (factor.shape) {
    case Shape::segment: {
      const Written a = corner(0), b = corner(1), length = difference(b, a);
      const std::string order = draft.names().fresh(x + "_ends");
      draft.prove("assert (" + order + " : " +
                  relation_text(length, certificate::Relation::positive) + ").");
      draft.prove("{ compute_by (number_holds Positive " + draft.generators() + " [] [] [] " +
                  length.code + " " + draft.roots() + " I). }");
      destruct("in_segment " + in_brackets(a) + " " + in_brackets(b) + " " + x + " " + order +
                   " " + weakly(bounds[0]) + " " + weakly(bounds[1]),
               0);
      break;
    }
    case Shape::ray_up:
    case Shape::ray_down:
      destruct(std::string(factor.shape == Shape::ray_up ? "in_ray_up " : "in_ray_down ") +
                   in_brackets(corner(0)) + " " + x + " " + weakly(bounds[0]),
               1);
      break;
    case Shape::triangle:
      destruct("in_triangle " + x + " " + factor.variables.back() + " " + weakly(bounds[0]) +
                   " " + weakly(bounds[1]) + " " + weakly(bounds[2]),
               0);
      break;
    case Shape::general:
      break;
  }
}

/// That the coordinate of an open facet is positive.
std::string positive(const Factor& factor, std::size_t i,
                     const std::vector<Inequality>& bounds) {
  switch (factor.shape) {
    case Shape::segment:
      return "(" + factor.strict[i] + " " + bounds[1 - i].name + ")";
    case Shape::ray_up:
    case Shape::ray_down:
      return "(" + factor.strict[1] + " " + bounds[0].name + ")";
    case Shape::triangle:
      return "(" + factor.strict[i] + " " + bounds[(i + 2) % 3].name + ")";
    case Shape::general:
      break;
  }
  return factor.strict[i];
}

std::string step_code(const Step& step, const std::vector<Factor>& factors,
                      const Formulas& formulas) {
  if (step.kind == Step::Kind::plain) return "Plain";
  if (step.kind == Step::Kind::outside) return "Outside " + std::to_string(step.index);
  std::vector<std::string> weights;
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (std::size_t i = 0; i < factors[f].coordinates.size(); ++i)
      weights.push_back(static_cast<int>(f) == step.index && i < step.weights.size()
                            ? formulas.write(step.weights[i]).code
                            : "(Num 0)");
  return "Split " + list(weights);
}

/// `(conj a (conj b I))`.
std::string conjunction(const std::vector<std::string>& proofs) {
  std::string result = "I";
  for (auto it = proofs.rbegin(); it != proofs.rend(); ++it)
    result = "(conj " + *it + " " + result + ")";
  return result;
}

}  // namespace

bool write_pieces(Draft& draft, const certificate::Sign& sign,
                  const std::set<std::string>& variables, const certificate::Pieces& pieces) {
  std::set<std::string> free = variables;
  for (const auto& factor : sign.domain.factors)
    for (const std::string& name : factor.variables) free.erase(name);
  if (!free.empty()) return false;

  Stated stated = place_domain(draft, sign, variables, true);
  for (const Factor& factor : stated.factors)
    for (std::size_t i = 0; i < factor.variables.size(); ++i)
      draft.define(factor.variables[i], variable_by_coordinates(factor, i, draft.formulas()),
                   factor.equations[i]);
  say_for_all(draft, stated, sign);

  std::vector<std::string> coordinates, sums, factors, signs, open, strict, steps;
  for (std::size_t f = 0; f < stated.factors.size(); ++f) {
    const Factor& factor = stated.factors[f];
    prove_coordinates(draft, factor, stated.inequalities[f]);
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < factor.coordinates.size(); ++i) {
      numbers.push_back(std::to_string(coordinates.size()));
      coordinates.push_back(factor.coordinates[i]);
      const bool is_infinite =
          i == 0 && (factor.shape == Shape::ray_up || factor.shape == Shape::ray_down);
      const bool is_open = factor.simplex->open[i] && !is_infinite;
      if (is_open) {
        open.push_back(numbers.back());
        strict.push_back(positive(factor, i, stated.inequalities[f]));
      }
      signs.push_back(is_open && factor.shape == Shape::general
                          ? "(Rlt_le _ _ " + factor.strict[i] + ")"
                          : factor.signs[i]);
    }
    sums.push_back(factor.sum);
    factors.push_back("(" + list(numbers) + "%nat, " +
                      weighted_sum(factor, draft.formulas()).code + ")");
  }
  for (const Step& step : pieces.steps)
    steps.push_back(step_code(step, stated.factors, draft.formulas()));
  draft.prove(std::string("compute_by (sign_holds ") + relation_code(sign.relation) + " " +
              draft.generators() + " " + list(coordinates) + " " + list(factors) + " " +
              list(open) + "%nat " + draft.definitions() + " " + draft.named() + " " +
              condition_codes(draft, sign) + " " + draft.formulas().write(sign.formula).code +
              " " + list(steps) + " " + draft.roots() + " " + conjunction(signs) + " " +
              conjunction(sums) + " " + conjunction(strict) + " " + draft.defined() + " " +
              conjunction(stated.conditions) + ").");
  return true;
}

}  // namespace seam::coq
