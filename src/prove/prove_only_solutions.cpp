// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "exact/field.h"
#include "exact/roots.h"
#include "prove/eliminate.h"
#include "prove/linear.h"
#include "prove/strategies.h"

// What an elimination leaves over is looked at point by point: variables that no equation gives
// take some values, the others are solved for, the last one first. A point that lies in the
// domain, meets the conditions, solves the system and is none of the solutions refutes.

namespace seam::prove {

using certificate::Nothing;
using certificate::OnlySolutions;
using certificate::Proof;
using certificate::Term;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

constexpr int most_tries = 60;
constexpr int most_adjoined = 3;  // values of functions

Equations read(Workshop& workshop, const OnlySolutions& stated) {
  Equations result;
  for (const auto& simplex : stated.domain.factors)
    result.factors.push_back(make_factor(workshop, simplex));
  std::vector<std::string> names = variables(result.factors);
  for (const std::string& unknown : stated.unknowns) {
    const auto at = std::ranges::find(names, unknown);
    result.unknowns.push_back(static_cast<int>(at - names.begin()));
    if (at != names.end()) continue;
    names.push_back(unknown);
    result.unbounded.push_back(unknown);
  }
  std::vector<Term> terms = stated.system;
  for (const auto& condition : stated.domain.where) terms.push_back(condition.formula);
  for (const auto& [numerators, denominators] : stated.solutions)
    for (const auto* held : {&numerators, &denominators})
      terms.insert(terms.end(), held->begin(), held->end());
  result.functions = workshop.functions(terms);
  for (const auto* function : result.functions) names.push_back(function->name);
  for (const auto* function : result.functions)
    result.radicands.push_back(workshop.expand(function->operand, names));
  const exact::RingPtr ring = workshop.ring(names);
  std::vector<std::string> all = stated.for_all;
  std::vector<int> bound;
  for (std::size_t i = 0; i < all.size(); ++i) bound.push_back(static_cast<int>(i));
  all.insert(all.end(), names.begin(), names.end());
  for (const Term term : stated.system)
    for (const auto& [exponents, f] : workshop.expand(term, all).coefficients(bound))
      result.system.push_back(ring->embed(f));
  for (const auto& condition : stated.domain.where)
    result.conditions.push_back(
        {workshop.expand(condition.formula, names), condition.relation});
  for (const auto& [numerators, denominators] : stated.solutions) {
    auto& solution = result.solutions.emplace_back();
    for (std::size_t j = 0; j < numerators.size(); ++j)
      solution.push_back(workshop.expand(denominators[j], names) *
                             ring->variable(result.unknowns[j]) -
                         workshop.expand(numerators[j], names));
  }
  return result;
}

class Search {
 public:
  Search(Workshop& workshop, const Equations& stated) : workshop_(workshop), stated_(stated) {
    for (const Factor& factor : stated.factors)
      names_.insert(names_.end(), factor.variables.begin(), factor.variables.end());
    names_.insert(names_.end(), stated.unbounded.begin(), stated.unbounded.end());
    for (const auto* function : stated.functions) names_.push_back(function->name);
  }

  // Whether a point of these facts refutes.
  bool operator()(const Facts& facts) {
    for (int attempt = 0; attempt < most_tries && !workshop_.late(); ++attempt) {
      values_ = chosen(attempt);
      if (add_roots() && solve(facts, facts.solved.size())) return true;
    }
    return false;
  }

  certificate::Point point() const {
    certificate::Point result{names_, {}};
    for (const Polynomial& value : values_) result.values.push_back(workshop_.write(value));
    return result;
  }

 private:
  // Points of the factors with small weights, small fractions on the lines.
  std::vector<Polynomial> chosen(int attempt) const {
    const exact::RingPtr numbers = workshop_.numbers();
    std::vector<Polynomial> values;
    int place = attempt;
    for (const Factor& factor : stated_.factors) {
      std::vector<Polynomial> l;
      for (std::size_t i = 0; i < factor.corners.size(); ++i, place = (5 * place + 3) % 61)
        l.push_back(numbers->constant(attempt == 0 ? 1 : 1 + place % 7));
      for (const Polynomial& x : prove::point(factor, l)) values.push_back(x);
    }
    for (std::size_t i = 0; i < stated_.unbounded.size(); ++i, place = (5 * place + 3) % 61)
      values.push_back(numbers->constant(Rational(place % 13 - 6, 1 + place % 3)));
    return values;
  }

  // The values of the functions, where they have one. A few may be new numbers.
  bool add_roots() {
    values_.resize(names_.size(), workshop_.numbers()->constant(0));
    for (std::size_t k = 0; k < stated_.functions.size(); ++k) {
      const Polynomial radicand = value(stated_.radicands[k]);
      Polynomial& root = values_[static_cast<std::size_t>(stated_.first_function()) + k];
      if (exact::sign(radicand) == Sign::negative) return false;
      if (radicand.is_zero()) continue;
      exact::Univariate power(stated_.functions[k]->degree + 1,
                              workshop_.numbers()->constant(0));
      power.front() = -radicand;
      power.back() = workshop_.numbers()->constant(1);
      const auto before = workshop_.tower();
      if (adjoined_ == most_adjoined) return false;
      root = workshop_.adjoin(power, exact::real_roots(power).back());
      if (workshop_.tower() != before) ++adjoined_;
    }
    return true;
  }

  Polynomial value(const Polynomial& f) const {
    const exact::RingPtr numbers = workshop_.numbers();
    std::vector<Polynomial> values;
    for (const Polynomial& v : values_) values.push_back(numbers->embed(v));
    return workshop_.ring(names_)->embed(f).substitute(numbers, values);
  }
  Sign sign(const Polynomial& f) const { return exact::sign(value(f)); }

  // Gives a value to the variable of solved equation `count` - 1, then to those before.
  bool solve(const Facts& facts, std::size_t count) {
    if (count == 0) return refutes();
    const auto [variable, equation] = facts.solved[count - 1];
    const auto place = static_cast<std::size_t>(variable);
    exact::Univariate f;
    for (const auto& [exponents, coefficient] :
         facts.equations[equation].coefficients({variable})) {
      f.resize(exponents[0] + 1, workshop_.numbers()->constant(0));
      f[exponents[0]] = value(coefficient);
    }
    f = exact::trimmed(f);
    if (exact::degree(f) < 1) return false;
    if (exact::degree(f) == 1) {
      values_[place] = -(f[0] * exact::inverse(f[1]));
      return solve(facts, count - 1);
    }
    const exact::Univariate simple = exact::squarefree(f);
    for (const auto& root : exact::real_roots(simple)) {
      exact::Univariate lifted;
      for (const Polynomial& c : simple) lifted.push_back(workshop_.numbers()->embed(c));
      values_[place] = workshop_.adjoin(lifted, root);
      if (solve(facts, count - 1)) return true;
    }
    return false;
  }

  bool refutes() const {
    for (std::size_t k = 0; k < stated_.functions.size(); ++k) {
      const Polynomial root = workshop_.numbers()->embed(
          values_[static_cast<std::size_t>(stated_.first_function()) + k]);
      if (!(root.pow(stated_.functions[k]->degree) - value(stated_.radicands[k])).is_zero())
        return false;
    }
    std::size_t next = 0;
    for (const Factor& factor : stated_.factors)
      if (!lies_in(factor, next)) return false;
    return std::ranges::all_of(stated_.system,
                               [&](const Polynomial& f) { return value(f).is_zero(); }) &&
           std::ranges::all_of(
               stated_.conditions,
               [&](const Condition& c) { return holds(c.relation, sign(c.formula)); }) &&
           std::ranges::all_of(stated_.solutions, [&](const auto& solution) {
             return std::ranges::any_of(
                 solution, [&](const Polynomial& f) { return !value(f).is_zero(); });
           });
  }

  // Whether the values from place `next` on lie in the factor; `next` goes on behind them.
  bool lies_in(const Factor& factor, std::size_t& next) const {
    const exact::RingPtr numbers = workshop_.numbers();
    std::vector<Polynomial> at = {numbers->constant(1)};
    for (std::size_t i = 0; i < factor.variables.size(); ++i)
      at.push_back(numbers->embed(values_[next++]));
    std::vector<std::vector<Polynomial>> corners;
    for (const auto& corner : factor.corners) {
      corners.emplace_back();
      for (const Polynomial& c : corner) corners.back().push_back(numbers->embed(c));
    }
    const auto l = barycentric(corners, at);
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Sign s = exact::sign(l[i]);
      if (s == Sign::negative || (s == Sign::zero && factor.open[i])) return false;
    }
    return true;
  }

  Workshop& workshop_;
  const Equations& stated_;
  std::vector<std::string> names_;
  std::vector<Polynomial> values_;  // by place in the ring
  int adjoined_ = 0;
};

}  // namespace

Proof prove_only_solutions(Workshop& workshop, const OnlySolutions& stated) {
  const Equations equations = read(workshop, stated);
  if (!std::ranges::all_of(equations.functions, [](const auto* f) { return f->is_root(); }))
    return Nothing{"unsupported", "a system that holds elementary functions"};
  Search search(workshop, equations);
  bool refuted = false;
  Eliminator eliminator(workshop, equations,
                        [&](const Facts& facts) { return refuted = search(facts); });
  if (auto elimination = eliminator.run()) return std::move(*elimination);
  if (refuted) return certificate::Witness{search.point(), {}};
  return eliminator.reason();
}

}  // namespace seam::prove
