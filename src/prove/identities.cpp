// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/identities.h"

#include <algorithm>
#include <array>
#include <utility>

#include "exact/factors.h"
#include "prove/divide.h"
#include "prove/sign.h"

// f is first divided by the equations among the conditions; the rest is factored. Even powers
// are squares; of each other factor it is asked that it is a condition, or divides one, or is a
// sum of squares. Whatever is asked next is a factor, of lower degree, or a rest; the depth is
// bounded besides.

namespace seam::prove {

using certificate::Computation;
using certificate::Reduction;
using certificate::Relation;
using certificate::SignProof;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;
using Kind = Reduction::Kind;

namespace {

constexpr int most_depth = 10;
constexpr std::size_t most_terms = 20'000;

std::vector<int> all_variables(const Polynomial& f) {
  std::vector<int> all;
  for (int v = 0; v < std::ssize(f.ring().variables()); ++v) all.push_back(v);
  return all;
}

std::size_t size(const Polynomial& f) {
  return f.numerators().terms.size();
}

bool is_strict(Relation relation) {
  return !holds(relation, Sign::zero);
}

// p = number * q, if so.
std::optional<Polynomial> ratio(Workshop& workshop, const Polynomial& p, const Polynomial& q) {
  const auto of_p = p.coefficients(all_variables(p)), of_q = q.coefficients(all_variables(q));
  if (of_p.empty() || of_p.size() != of_q.size() ||
      of_p.rbegin()->first != of_q.rbegin()->first)
    return std::nullopt;
  const auto numbers = workshop.numbers();
  const Polynomial number =
      p.ring().embed(numbers->embed(of_p.rbegin()->second) *
                     exact::inverse(numbers->embed(of_q.rbegin()->second)));
  if (!(p == number * q)) return std::nullopt;
  return number;
}

}  // namespace

Identities::Identities(Workshop& workshop, Factors factors, std::vector<std::string> names,
                       std::vector<Condition> where)
    : workshop_(workshop),
      factors_(std::move(factors)),
      names_(std::move(names)),
      where_(std::move(where)),
      ideal_(workshop) {
  for (std::size_t i = 0; i < where_.size(); ++i) {
    const Polynomial& f = where_[i].formula;
    products_.push_back(f.is_zero() ? Product{f, {}} : factored(f));
    if (where_[i].relation != Relation::zero) continue;
    equations_.push_back(static_cast<int>(i));
    ideal_.add(f);
  }
}

Polynomial Identities::now(const Polynomial& f) const {
  return workshop_.ring(names_)->embed(f);
}

Identities::Product Identities::factored(const Polynomial& f) const {
  if (f.is_number()) return {f, {}};
  if (size(f) > most_terms) return {f.ring().constant(1), {{f, 1}}};
  const exact::Factors found = exact::factors(f);
  return {found.number, found.factors};
}

std::optional<SignProof> Identities::show(const Polynomial& f, Relation relation) {
  return show(f, relation, 0);
}

Identities::Shown Identities::show(Polynomial f, Relation relation, int depth) {
  if (workshop_.late() || depth > most_depth) return std::nullopt;
  f = now(f);
  if (f.is_number()) {
    if (!holds(relation, exact::sign(workshop_.numbers()->embed(f)))) return std::nullopt;
    return Computation{};
  }
  if (auto shown = by_condition(f, relation)) return shown;
  if (relation == Relation::zero) return show_zero(f, depth);
  const LinearIdeal::Division division = ideal_.divide(f);
  if (!division.cofactors.empty()) {
    auto rest = show(division.rest, relation, depth + 1);
    if (rest) return combined(division.cofactors, std::move(*rest));
  }
  if (auto shown = by_factors(f, relation, depth)) return shown;
  if (auto shown = by_squares(f, relation, depth)) return shown;
  if (auto shown = by_sum(f, relation, depth)) return shown;
  return by_pieces(f, relation);
}

SignProof Identities::combined(const std::map<std::size_t, Polynomial>& cofactors,
                               SignProof rest) {
  Reduction result{Kind::combination, {}, {}, {std::move(rest)}};
  for (const auto& [generator, cofactor] : cofactors) {
    if (cofactor.is_zero()) continue;
    result.conditions.push_back(equations_[generator]);
    result.terms.push_back(workshop_.write(cofactor));
  }
  return result;
}

Identities::Shown Identities::show_zero(const Polynomial& f, int depth) {
  const LinearIdeal::Division division = ideal_.divide(f);
  const auto with = [&](std::map<std::size_t, Polynomial> cofactors, SignProof rest) -> Shown {
    for (const auto& [i, cofactor] : division.cofactors) {
      const auto [place, is_new] = cofactors.emplace(i, now(cofactor));
      if (!is_new) place->second = place->second + now(cofactor);
    }
    return combined(cofactors, std::move(rest));
  };
  if (division.rest.is_zero()) return with({}, Computation{});
  std::vector<Polynomial> equations;
  for (const auto& unsolved : ideal_.unsolved()) equations.push_back(now(unsolved.rest));
  for (const auto& found : divisions(workshop_, now(division.rest), equations)) {
    if (!found.rest.is_zero()) continue;
    std::map<std::size_t, Polynomial> cofactors;
    for (std::size_t k = 0; k < equations.size(); ++k)
      for (const auto& [i, cofactor] : ideal_.unsolved()[k].cofactors) {
        const Polynomial more = found.cofactors[k] * now(cofactor);
        const auto [place, is_new] = cofactors.emplace(i, more);
        if (!is_new) place->second = place->second + more;
      }
    return with(std::move(cofactors), Computation{});
  }
  for (const auto& unsolved : ideal_.unsolved())
    if (auto shown =
            by_multiple(now(division.rest), now(unsolved.rest), unsolved.cofactors, depth)) {
      if (division.cofactors.empty()) return shown;
      return with({}, std::move(*shown));
    }
  for (std::size_t i = 0; i < where_.size(); ++i) {
    if (!is_strict(where_[i].relation)) continue;
    const Polynomial c = now(where_[i].formula);
    const bool is_positive = where_[i].relation == Relation::positive;
    const Polynomial h = is_positive ? c : c * c;
    if (size(h) * size(f) > most_terms) continue;
    const LinearIdeal::Division multiple = ideal_.divide(h * f);
    if (!multiple.rest.is_zero()) continue;
    auto positive = show(h, Relation::positive, depth + 1);
    if (!positive) continue;
    return Reduction{Kind::multiplier,
                     {workshop_.write(h)},
                     {},
                     {std::move(*positive), combined(multiple.cofactors, Computation{})}};
  }
  // An equation may divide f before it is divided by others.
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    const Polynomial e = now(where_[equations_[i]].formula);
    if (auto shown = by_multiple(f, e, {{i, e.ring().constant(1)}}, depth)) return shown;
  }
  return std::nullopt;
}

// f * m = g * e with m != 0, e an equation: m^2 f = m g e.
Identities::Shown Identities::by_multiple(const Polynomial& f, const Polynomial& equation,
                                          const std::map<std::size_t, Polynomial>& cofactors,
                                          int depth) {
  const Product of_f = factored(f), of_e = factored(equation);
  const auto numbers = workshop_.numbers();
  Polynomial m = f.ring().constant(1);
  Polynomial g = f.ring().embed(exact::inverse(numbers->embed(of_e.number))) * of_f.number;
  std::vector<std::pair<Polynomial, int>> left = of_f.powers;
  for (const auto& [base, exponent] : of_e.powers) {
    int missing = exponent;
    for (auto& [other, times] : left) {
      const auto number = ratio(workshop_, other, base);
      if (!number) continue;
      const int common = std::min(missing, times);
      missing -= common;
      times -= common;
      g = g * number->pow(common);
    }
    m = m * base.pow(missing);
  }
  for (const auto& [base, exponent] : left) g = g * base.pow(exponent);
  if (!(f * m == g * equation)) return std::nullopt;
  std::map<std::size_t, Polynomial> scaled;
  for (const auto& [i, cofactor] : cofactors) scaled.emplace(i, m * g * now(cofactor));
  if (m.is_number()) return combined(scaled, Computation{});
  auto positive = show(m * m, Relation::positive, depth + 1);
  if (!positive) return std::nullopt;
  return Reduction{Kind::multiplier,
                   {workshop_.write(m * m)},
                   {},
                   {std::move(*positive), combined(scaled, Computation{})}};
}

Identities::Shown Identities::by_condition(const Polynomial& f, Relation relation) {
  for (std::size_t i = 0; i < where_.size(); ++i) {
    const auto number = ratio(workshop_, f, now(where_[i].formula));
    if (!number) continue;
    const Sign scale = exact::sign(workshop_.numbers()->embed(*number));
    const bool says_so = std::ranges::all_of(
        std::array{Sign::negative, Sign::zero, Sign::positive}, [&](Sign s) {
          const Sign image = scale == Sign::positive ? s
                             : s == Sign::zero       ? s
                             : s == Sign::positive   ? Sign::negative
                                                     : Sign::positive;
          return !holds(where_[i].relation, s) || holds(relation, image);
        });
    if (says_so)
      return Reduction{Kind::condition, {workshop_.write(*number)}, {static_cast<int>(i)}, {}};
  }
  return std::nullopt;
}

std::optional<Identities::Excluded> Identities::excluded(const Polynomial& base) const {
  for (std::size_t i = 0; i < where_.size(); ++i) {
    if (!is_strict(where_[i].relation)) continue;
    const auto& powers = products_[i].powers;
    for (std::size_t k = 0; k < powers.size(); ++k) {
      const auto number = ratio(workshop_, now(powers[k].first), base);
      if (!number) continue;
      Polynomial cofactor = *number * now(products_[i].number);
      for (std::size_t j = 0; j < powers.size(); ++j)
        cofactor = cofactor * now(powers[j].first).pow(powers[j].second - (j == k ? 1 : 0));
      return Excluded{{static_cast<int>(i)}, cofactor};
    }
  }
  return std::nullopt;
}

// base^2 >= 0, or > 0.
Identities::Shown Identities::square(const Polynomial& base, bool is_strict) {
  const auto one = workshop_.write(Rational(1)), q = workshop_.write(base);
  if (!is_strict) return Reduction{Kind::squares, {one, q}, {}, {}};
  const auto why = excluded(base);
  if (!why) return std::nullopt;
  return Reduction{Kind::squares,
                   {one, q, workshop_.write(why->cofactor)},
                   why->conditions,
                   {Computation{}}};
}

Identities::Shown Identities::show_nonzero(const Polynomial& base, int depth) {
  if (auto shown = by_condition(base, Relation::nonzero)) return shown;
  if (const auto why = excluded(base))
    return Reduction{
        Kind::multiplier,
        {workshop_.write(why->cofactor)},
        {},
        {Computation{},
         Reduction{Kind::condition, {workshop_.write(Rational(1))}, why->conditions, {}}}};
  if (auto shown = by_squares(base, Relation::nonzero, depth)) return shown;
  return by_pieces(base, Relation::nonzero);
}

Identities::Shown Identities::by_factors(const Polynomial& f, Relation relation, int depth) {
  const Product product = factored(f);
  const bool is_one = product.powers.size() == 1 && product.powers.front().second == 1;
  Reduction result{Kind::factors, {}, {}, {}};
  const auto add = [&](const Polynomial& term, SignProof proof) {
    result.terms.push_back(workshop_.write(term));
    result.parts.push_back(std::move(proof));
  };
  if (relation == Relation::nonzero) {
    if (is_one) return show_nonzero(f, depth);
    add(product.number, Computation{});
    for (const auto& [base, exponent] : product.powers) {
      const auto shown = show_nonzero(now(base), depth);
      if (!shown) return std::nullopt;
      for (int k = 0; k < exponent; ++k) add(now(base), *shown);
    }
    return result;
  }
  if (is_one) return std::nullopt;
  const bool strict = is_strict(relation), upward = holds(relation, Sign::positive);
  const Relation wanted = strict ? Relation::positive : Relation::nonnegative;
  Polynomial number = upward ? now(product.number) : -now(product.number);
  for (const auto& [base, exponent] : product.powers) {
    const Polynomial p = now(base);
    auto as_square = exponent > 1 ? square(p, strict) : std::nullopt;
    int left = exponent;
    if (as_square)
      for (; left > 1; left -= 2) add(p * p, *as_square);
    if (left == 0) continue;
    Polynomial signed_base = p;
    auto shown = show(p, wanted, depth + 1);
    if (!shown) {
      signed_base = -p;
      shown = show(signed_base, wanted, depth + 1);
      if (left % 2 == 1) number = -number;
    }
    if (!shown) return std::nullopt;
    for (int k = 0; k < left; ++k) add(now(signed_base), *shown);
  }
  if (exact::sign(workshop_.numbers()->embed(number)) != Sign::positive) return std::nullopt;
  add(number, Computation{});
  return result;
}

// A formula in variables of factors alone.
Identities::Shown Identities::by_pieces(const Polynomial& f, Relation relation) {
  const auto bounded = variables(factors_);
  const auto is_bounded = [&](const Polynomial& p) {
    for (std::size_t v = bounded.size(); v < names_.size(); ++v)
      if (p.degree(static_cast<int>(v)) > 0) return false;
    return true;
  };
  if (bounded.empty() || relation == Relation::zero || !is_bounded(f)) return std::nullopt;
  const auto ring = workshop_.ring(bounded);
  for (const int side : {1, -1}) {
    if (!holds(relation, side > 0 ? Sign::positive : Sign::negative)) continue;
    Question question{factors_, Rational(side) * ring->embed(f), is_strict(relation), {}};
    for (const Condition& condition : where_)
      if (is_bounded(condition.formula))
        question.where.push_back({ring->embed(condition.formula), condition.relation});
    Answer answer = decide(workshop_, std::move(question));
    if (answer.kind != Answer::Kind::yes) continue;
    answer.pieces.side = side > 0 ? Relation::positive : Relation::negative;
    if (side < 0 && answer.pieces.cofactor >= 0)
      answer.pieces.cofactor = workshop_.negated(answer.pieces.cofactor);
    return answer.pieces;
  }
  return std::nullopt;
}

}  // namespace seam::prove
