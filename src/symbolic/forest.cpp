// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/forest.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "exact/contract.h"

// A root is looked for in three places: among the rationals (perfect powers are taken out of
// the radicand's rational content), in the field of the radicand (a linear factor), and, where
// its irreducible factor is of higher degree, in the field extended by it: it becomes a
// generator. Generators that were made apart may depend on each other; the field of both shows
// it, for there the polynomial of the later one is factored again.
//
// Transcendental numbers are variables of a ring over that field. No generator is a root over
// them.

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RootInterval;
using exact::Sign;
using exact::Univariate;

namespace {

// The largest t found with t^n a divisor; all prime factors below the bound are found, and a
// power that is left.
Integer power_part(Integer x, int n) {
  constexpr long bound = 100'000;
  Integer result = 1;
  const auto take = [&](const Integer& p) {
    int count = 0;
    for (; x % p == 0; ++count) x /= p;
    for (; count >= n; count -= n) result *= p;
  };
  for (long p = 2; p < bound && p * p <= x; p += p == 2 ? 1 : 2)
    if (x % p == 0) take(p);
  Integer root;
  if (x > 1 && mpz_root(root.get_mpz_t(), x.get_mpz_t(), n) != 0) result *= root;
  return result;
}

Integer pow(const Integer& base, int exponent) {
  Integer result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

// x^n - a
bool is_binomial(const Univariate& f) {
  return f.back().rational() == Rational(1) &&
         std::all_of(f.begin() + 1, f.end() - 1,
                     [](const Polynomial& c) { return c.is_zero(); });
}

Integer common_denominator(const Univariate& f) {
  Integer result = 1;
  for (const Polynomial& c : f) result = lcm(result, c.numerators().denominator);
  return result;
}

Formula in_symbol(const Univariate& f, const std::string& name) {
  std::vector<Formula> terms;
  for (int i = exact::degree(f); i >= 0; --i)
    terms.push_back(formula(f[i]) * power(Formula::symbol(name), i));
  return sum(std::move(terms));
}

std::string name_of(const Univariate& f) {
  if (!is_binomial(f)) return "root(" + text(in_symbol(f, "x")) + ")";
  const std::string radicand = "(" + text(formula(-f[0])) + ")";
  switch (exact::degree(f)) {
    case 2:
      return "sqrt" + radicand;
    case 3:
      return "cbrt" + radicand;
    default:
      return "root_" + std::to_string(exact::degree(f)) + radicand;
  }
}

}  // namespace

std::vector<std::size_t> united(const std::vector<std::size_t>& a,
                                const std::vector<std::size_t>& b) {
  std::vector<std::size_t> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

namespace {

void add_rules(Expansion& expansion, const std::vector<exact::Applied>& values) {
  for (std::size_t sine = 0; sine < values.size(); ++sine)
    for (std::size_t cosine = 0; cosine < sine; ++cosine)
      if (values[sine].function == "sin" && values[cosine].function == "cos" &&
          values[sine].argument == values[cosine].argument)
        expansion.add_circle(static_cast<int>(sine), static_cast<int>(cosine));
}

}  // namespace

void require_small(const exact::RingPtr& ring, int degree, int most) {
  if (exact::dimension(ring->tower()) * degree > most)
    throw NumberLimit("numbers of a field of degree over 64 are not covered");
}

const Numbers::Forest::Support& Numbers::Forest::support(const Formula& f) {
  if (const auto known = known_supports.find(f.identity()); known != known_supports.end())
    return known->second.second;
  Support result;
  if (f.kind() == Formula::Kind::symbol)
    if (const auto found = index.find(f.name()); found != index.end())
      result = supports[found->second];
  for (const Formula& operand : f.operands()) result = united(result, support(operand));
  return known_supports.try_emplace(f.identity(), f, std::move(result)).first->second.second;
}

// The generators one after the other; fields that begin alike share their beginning.
const Numbers::Forest::Grown& Numbers::Forest::grown(const Support& names) {
  if (const auto known = fields.find(names); known != fields.end()) return known->second;
  Grown result;
  if (names.empty()) {
    result.field.ring = exact::Ring::make(nullptr, {});
  } else {
    result.field = grown({names.begin(), names.end() - 1}).field;
    extend(result, generators[names.back()]);
  }
  std::vector<std::string> variables;
  for (const Generator& number : result.field.transcendental) variables.push_back(number.name);
  const auto ring = exact::Ring::make(result.field.ring->tower(), variables);
  result.expansion = std::make_unique<Expansion>(ring, Atoms{}, result.field.values);
  for (const Generator& number : result.field.transcendental)
    result.values.push_back({number.function, (*result.expansion)(number.argument)});
  result.expansion = std::make_unique<Expansion>(ring, Atoms{}, result.field.values);
  add_rules(*result.expansion, result.values);
  return fields.emplace(names, std::move(result)).first->second;
}

void Numbers::Forest::extend(Grown& to, const Generator& generator) {
  Field& field = to.field;
  const std::string& name = generator.name;
  if (!generator.function.empty()) {
    field.transcendental.push_back(generator);
    return;
  }
  const auto over = exact::Ring::make(field.ring->tower(), {name});
  const Polynomial polynomial = Expansion(over, {}, field.values)(generator.polynomial);
  Univariate f;
  for (const Polynomial& c : exact::univariate(polynomial, 0))
    f.push_back(field.ring->embed(c));
  const RootInterval where{generator.low, generator.high};
  const Univariate factor = exact::irreducible_factor(f, where);
  const auto facts = [&](const Formula& value) -> std::vector<Fact> {
    return {{subst(generator.polynomial, {{name, value}}), Fact::Relation::zero},
            {value - Formula(generator.low), Fact::Relation::nonnegative},
            {Formula(generator.high) - value, Fact::Relation::nonnegative}};
  };
  if (exact::degree(factor) == 1) {
    const Formula value = formula(-factor[0]);
    field.dependent.emplace(name, Formula::known(value, facts(value)));
    field.values.emplace(name, -factor[0]);
    return;
  }
  require_small(field.ring, exact::degree(factor));
  const Univariate cleared = field.ring->constant(common_denominator(factor)) * factor;
  const auto bracket = exact::bracket(factor, where);
  field.generators.push_back(
      {name, in_symbol(cleared, name), bracket.low, bracket.high, {}, 0});
  field.ring = exact::Ring::make(exact::adjoin(factor, name, bracket), {});
  for (auto& value : field.values) value.second = field.ring->embed(value.second);
  field.values.emplace(name, *field.ring->symbol(name));
}

std::string Numbers::Forest::unused(const std::string& name) const {
  std::string result = name;
  for (int i = 2; index.contains(result); ++i) result = name + "(" + std::to_string(i) + ")";
  return result;
}

Formula Numbers::Forest::root_of(const Grown& in, const Univariate& squarefree,
                                 RootInterval where) {
  const exact::RingPtr ring = in.field.ring;
  require_small(ring, exact::degree(squarefree), max_search);
  const Univariate f = exact::irreducible_factor(squarefree, where);
  if (exact::degree(f) == 1) return formula(-f[0]);
  require_small(ring, exact::degree(f));
  const Univariate cleared = ring->constant(common_denominator(f)) * f;
  const auto bracket = exact::bracket(f, where);
  const std::string name = unused(name_of(cleared));
  const Formula polynomial = in_symbol(cleared, name);
  return add({name, polynomial, bracket.low, bracket.high, {}, 0}, polynomial);
}

Formula Numbers::Forest::add(Generator generator, const Formula& over) {
  Support own = support(over);
  own.push_back(generators.size());
  known_supports.clear();  // the new symbol was not known as a generator
  index.emplace(generator.name, generators.size());
  const Formula symbol = Formula::symbol(generator.name);
  generators.push_back(std::move(generator));
  supports.push_back(std::move(own));
  return symbol;
}

// radicand = (a / b) e > 0 with e primitive: its root is t / b times the root of (a b^(n-1) /
// t^n) e.
Formula Numbers::Forest::power_root(const Grown& in, const Polynomial& radicand, int n) {
  const exact::RingPtr ring = in.field.ring;
  const auto [terms, denominator] = radicand.numerators();
  Integer content = 0;
  for (const Integer& c : terms.begin()->second) content = gcd(content, c);
  const Integer whole = content * pow(denominator, n - 1);
  const Integer outside = power_part(whole, n);
  Rational factor(outside, denominator),
      primitive(whole / pow(outside, n) * denominator, content);
  factor.canonicalize();
  primitive.canonicalize();
  const Polynomial inside = primitive * radicand;
  if (inside == ring->constant(1)) return Formula(factor);

  const std::pair<int, std::string> key = {n, text(formula(inside))};
  if (const auto known = roots.find(key); known != roots.end())
    return Formula(factor) * known->second;
  Univariate f(n + 1, ring->constant(0));
  f[0] = -inside;
  f[n] = ring->constant(1);
  const Rational bound = exact::enclosure(inside, 4).high + 1;
  const Formula root = root_of(in, f, {0, bound});
  roots.emplace(key, root);
  return Formula(factor) * root;
}

// x^2 + 2 p x + q: the roots are -p - r and -p + r with r^2 = p^2 - q.
Formula Numbers::Forest::quadratic_root(const Grown& in, const Univariate& f,
                                        RootInterval where) {
  const exact::RingPtr ring = in.field.ring;
  const Polynomial middle = Rational(-1, 2) * f[1];
  const auto side = [&](const Rational& end) {
    return exact::sign(ring->constant(end) - middle);
  };
  while (side(where.low) != side(where.high)) where = exact::halved(f, where);
  const Formula r = power_root(in, middle * middle - f[0], 2), centre = formula(middle);
  return side(where.low) == Sign::positive ? centre + r : centre - r;
}

Polynomial Numbers::Forest::algebraic(const Formula& f) {
  const Polynomial value = number(f);
  if (!value.is_number())
    throw NumberLimit("roots of numbers that are not algebraic are not covered");
  return field_of(f).field.ring->embed(value);
}

std::optional<exact::Enclosure> Numbers::Forest::enclosure(const Formula& f, long bits) {
  const Polynomial value = number(f);
  if (value.is_number()) return exact::enclosure(field_of(f).field.ring->embed(value), bits);
  return exact::enclosure(value, field_of(f).values, bits);
}

Sign Numbers::Forest::sign(const Formula& f) {
  const Polynomial value = number(f);
  if (value.is_number()) return exact::sign(field_of(f).field.ring->embed(value));
  for (long bits = 64; bits <= max_precision; bits *= 4)
    if (const auto e = enclosure(f, bits); e && (e->low > 0 || e->high < 0))
      return e->low > 0 ? Sign::positive : Sign::negative;
  throw NumberLimit("a number that is not told from 0: " + text(f, 60));
}

}  // namespace seam::symbolic
