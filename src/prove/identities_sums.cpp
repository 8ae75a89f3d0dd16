// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "prove/identities.h"
#include "prove/subdivide.h"

// A formula as a sum of squares, or of conditions times what has a sign.

namespace seam::prove {

using certificate::Computation;
using certificate::Reduction;
using certificate::Relation;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;
using Kind = Reduction::Kind;

namespace {

constexpr int most_summands = 60;

std::vector<int> all_variables(const Polynomial& f) {
  std::vector<int> all;
  for (int v = 0; v < std::ssize(f.ring().variables()); ++v) all.push_back(v);
  return all;
}

bool is_strict(Relation relation) {
  return !holds(relation, Sign::zero);
}

}  // namespace

// Squares are completed, variable by variable; what is left over are numbers times squares of
// monomials.
std::optional<Identities::Squares> Identities::squares(const Polynomial& f) const {
  Squares result;
  Polynomial rest = now(f);
  const Polynomial one = rest.ring().constant(1);
  for (int v = 0; v < std::ssize(names_); ++v) {
    if (rest.degree(v) != 2) continue;
    const auto in_v = rest.coefficients({v});
    const Polynomial& lead = in_v.rbegin()->second;
    if (!lead.is_number()) continue;
    const auto linear = in_v.find({1});
    Polynomial base = rest.ring().variable(v);
    if (linear != in_v.end())
      base = base + Rational(1, 2) * (now(exact::inverse(workshop_.numbers()->embed(lead))) *
                                      linear->second);
    rest = rest - lead * base * base;
    result.weights.push_back(lead);
    result.bases.push_back(base);
  }
  for (const auto& [exponents, coefficient] : rest.coefficients(all_variables(rest))) {
    Polynomial base = one;
    for (int v = 0; v < std::ssize(exponents); ++v) {
      if (exponents[v] % 2 != 0) return std::nullopt;
      base = base * rest.ring().variable(v).pow(exponents[v] / 2);
    }
    result.weights.push_back(coefficient);
    result.bases.push_back(base);
  }
  return result;
}

Identities::Shown Identities::by_squares(const Polynomial& f, Relation relation, int depth) {
  const auto sum = squares(f);
  if (!sum) return std::nullopt;
  for (const Polynomial& weight : sum->weights) {
    const Sign sign = exact::sign(workshop_.numbers()->embed(weight));
    if (!holds(relation, sign) ||
        sign != exact::sign(workshop_.numbers()->embed(sum->weights.front())))
      return std::nullopt;
  }
  Reduction result{Kind::squares, {}, {}, {}};
  for (const auto* list : {&sum->weights, &sum->bases})
    for (const Polynomial& p : *list) result.terms.push_back(workshop_.write(p));
  if (!is_strict(relation)) return result;

  LinearIdeal ideal(workshop_);
  for (const Polynomial& base : sum->bases) ideal.add(base);
  std::vector<std::vector<int>> choices = {{}};
  for (std::size_t i = 0; i < where_.size(); ++i)
    if (is_strict(where_[i].relation)) choices.push_back({static_cast<int>(i)});
  for (const auto& choice : choices) {
    Polynomial product = now(f).ring().constant(1);
    for (const int i : choice) product = product * now(where_[i].formula);
    const LinearIdeal::Division division = ideal.divide(product);
    auto rest = division.rest.is_zero() ? Shown(Computation{})
                                        : show(division.rest, Relation::zero, depth + 1);
    if (!rest) continue;
    for (std::size_t k = 0; k < sum->bases.size(); ++k) {
      const auto found = division.cofactors.find(k);
      result.terms.push_back(found == division.cofactors.end()
                                 ? workshop_.write(Rational(0))
                                 : workshop_.write(found->second));
    }
    result.conditions = choice;
    result.parts.push_back(std::move(*rest));
    return result;
  }
  return std::nullopt;
}

// A sum of conditions times what has a sign: the leading monomial of what is left is that of
// one of them, times a monomial.
Identities::Shown Identities::by_sum(const Polynomial& f, Relation relation, int depth) {
  if (relation == Relation::nonzero) return std::nullopt;
  const bool upward = holds(relation, Sign::positive);
  Reduction result{Kind::combination, {}, {}, {Computation{}}};
  Polynomial rest = f;
  const auto step = [&]() {
    const auto [exponents, coefficient] = *rest.coefficients(all_variables(rest)).rbegin();
    for (std::size_t i = 0; i < where_.size(); ++i) {
      const Polynomial condition = now(where_[i].formula);
      const Relation known = where_[i].relation;
      if (known == Relation::zero || known == Relation::nonzero || condition.is_number())
        continue;
      const auto [lead, number] = *condition.coefficients(all_variables(condition)).rbegin();
      Polynomial cofactor =
          coefficient * now(exact::inverse(workshop_.numbers()->embed(number)));
      bool divides = true;
      for (std::size_t v = 0; divides && v < lead.size(); ++v) {
        divides = lead[v] <= exponents[v];
        if (divides)
          cofactor =
              cofactor * rest.ring().variable(static_cast<int>(v)).pow(exponents[v] - lead[v]);
      }
      if (!divides) continue;
      const bool is_alike = upward == holds(known, Sign::positive);
      auto sign =
          show(cofactor, is_alike ? Relation::nonnegative : Relation::nonpositive, depth + 1);
      if (!sign) continue;
      result.conditions.push_back(static_cast<int>(i));
      result.terms.push_back(workshop_.write(cofactor));
      result.parts.push_back(std::move(*sign));
      rest = now(rest) - now(cofactor) * condition;
      return true;
    }
    return false;
  };
  for (int n = 0; n < most_summands && !rest.is_number(); ++n) {
    if (auto shown = by_condition(rest, relation)) {
      if (result.conditions.empty()) return shown;
      result.parts.front() = std::move(*shown);
      return result;
    }
    if (!step()) return std::nullopt;
  }
  if (!rest.is_number() || !holds(relation, exact::sign(workshop_.numbers()->embed(rest))))
    return std::nullopt;
  return result;
}

}  // namespace seam::prove
