// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "claims/parameters.h"
#include "symbolic/coefficients.h"

// A variable that ranges over all reals takes, for any values of the others, the value that an
// equation x = E gives it; so E may stand for it everywhere. And a bound of one such variable
// alone is its range. What is said of the points is the same.

namespace seam::claims {
namespace {

using symbolic::Constraint;

// a x + b with rational numbers a, not 0, and any b without x.
struct Linear {
  exact::Rational factor;
  Formula rest = 0;
};

std::optional<Linear> linear(const Formula& f, const std::string& x, const Numbers& numbers) {
  if (!f.is_polynomial() || !symbolic::variables(f).contains(x)) return std::nullopt;
  Linear result;
  for (const auto& [exponents, coefficient] : symbolic::coefficients(f, {x}, numbers)) {
    if (exponents[0] > 1) return std::nullopt;
    if (exponents[0] == 0) {
      result.rest = coefficient;
      continue;
    }
    const auto value = symbolic::is_number(coefficient) ? numbers.rational(coefficient)
                                                        : std::optional<exact::Rational>();
    if (!value) return std::nullopt;
    result.factor = *value;
  }
  return result.factor == 0 ? std::nullopt : std::optional(result);
}

// Conditions that became ones about numbers hold, or nothing is left to speak of.
void drop_numbers(std::vector<Constraint>& where, const Numbers& numbers) {
  std::erase_if(where, [&](const Constraint& c) {
    if (!c.formula.is_polynomial() || !symbolic::is_number(c.formula)) return false;
    if (!meets(numbers.sign(c.formula), c.relation))
      throw Unsupported("conditions that no point meets");
    return true;
  });
}

bool put_in_one(Formula& f, symbolic::Domain& domain, std::vector<std::string>& lines,
                const Numbers& numbers) {
  for (std::size_t i = 0; i < domain.where.size(); ++i) {
    if (domain.where[i].relation != Relation::zero) continue;
    for (const std::string& x : lines) {
      const auto parts = linear(domain.where[i].formula, x, numbers);
      if (!parts) continue;
      const exact::Rational scale = -1 / parts->factor;
      const std::map<std::string, Formula> value = {{x, Formula(scale) * parts->rest}};
      domain.where.erase(domain.where.begin() + static_cast<long>(i));
      for (Constraint& c : domain.where) {
        c.formula = symbolic::subst(c.formula, value);
        if (c.formula.is_polynomial() && symbolic::vanishes(c.formula, numbers)) c.formula = 0;
      }
      f = symbolic::subst(f, value);
      std::erase(lines, x);
      return true;
    }
  }
  return false;
}

// The range of x, without the conditions that gave it.
std::optional<symbolic::Simplex> take_range(const std::string& x,
                                            std::vector<Constraint>& where,
                                            const Numbers& numbers) {
  struct End {
    exact::Rational at;
    bool open = false;
  };
  std::optional<End> low, high;
  std::vector<Constraint> left;
  for (const Constraint& c : where) {
    const auto parts = linear(c.formula, x, numbers);
    const auto rest = parts && symbolic::is_number(parts->rest)
                          ? numbers.rational(parts->rest)
                          : std::optional<exact::Rational>();
    if (!rest || c.relation == Relation::zero || c.relation == Relation::nonzero) {
      left.push_back(c);
      continue;
    }
    const exact::Rational at = -*rest / parts->factor;
    const bool is_low = meets(exact::Sign::positive, c.relation) == (parts->factor > 0);
    const bool open = !meets(exact::Sign::zero, c.relation);
    std::optional<End>& end = is_low ? low : high;
    const bool sharper =
        !end || (is_low ? at > end->at : at < end->at) || (at == end->at && open);
    if (sharper) end = End{at, open};
  }
  if ((!low && !high) || (low && high && low->at >= high->at)) return std::nullopt;
  where = std::move(left);
  if (!high) return symbolic::whole_line_right(x, Formula(low->at), low->open);
  if (!low) return symbolic::whole_line_left(x, Formula(high->at), high->open);
  return symbolic::interval(x, Formula(low->at), Formula(high->at), low->open, high->open);
}

}  // namespace

void Stating::simplify(Formula& f, Range& range) const {
  auto& [domain, lines] = range;
  while (put_in_one(f, domain, lines, evaluator.numbers)) {
  }
  std::erase_if(lines, [&](const std::string& x) {
    const auto set = take_range(x, domain.where, evaluator.numbers);
    if (set) domain.factors.push_back(*set);
    return set.has_value();
  });
  drop_numbers(domain.where, evaluator.numbers);
  // What no condition and no formula holds any more says nothing.
  std::set<std::string> held = symbolic::variables(f);
  for (const Constraint& c : domain.where) held.merge(symbolic::variables(c.formula));
  std::erase_if(lines, [&](const std::string& x) { return !held.contains(x); });
}

std::optional<Proposition> Stating::take_numbers(Context& context) {
  std::optional<Proposition> broken;
  std::erase_if(context.where, [&](const Constraint& c) {
    if (broken || !c.formula.is_polynomial() || !symbolic::is_number(c.formula)) return false;
    Proposition met =
        symbolic::atom(symbolic::Sign{c.formula, c.relation, {}}, "the condition");
    if (!meets(evaluator.numbers.sign(c.formula), c.relation))
      broken = symbolic::negation(std::move(met));
    else
      guards.push_back(std::move(met));
    return true;
  });
  return broken;
}

}  // namespace seam::claims
