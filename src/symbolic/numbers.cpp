// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/numbers.h"

#include <algorithm>
#include <utility>

#include "exact/contract.h"
#include "exact/roots.h"
#include "symbolic/expand.h"

// A root is looked for in three places: among the rationals (perfect powers are taken out of
// the radicand's rational content), in the field so far (a linear factor), and, where its
// irreducible factor is of higher degree, in the field extended by it.

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RootInterval;
using exact::Sign;
using exact::Univariate;

struct Numbers::Tower {
  exact::RingPtr ring = exact::Ring::make(nullptr, {});
  Expansion expansion{ring};
  std::vector<Generator> generators;
  struct Known {
    int n;
    Polynomial radicand, root;  ///< in the rings of their times
  };
  std::vector<Known> roots;

  Polynomial number(const Formula& f) { return expansion(f); }
  Polynomial root_of(const Univariate& squarefree, RootInterval where);
  Polynomial adjoined(const Univariate& irreducible, RootInterval where);
  Polynomial quadratic(const Univariate& irreducible, RootInterval where);
  Polynomial power_root(const Polynomial& radicand, int n);
  std::string unused(const std::string& name) const;
};

namespace {

// "3.2", "about" being said by the caller.
std::string roughly(const Polynomial& number) {
  std::string text = std::to_string(exact::ball(number).middle);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

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

std::string Numbers::Tower::unused(const std::string& name) const {
  const auto taken = [&](const std::string& n) {
    return std::ranges::any_of(generators, [&](const Generator& g) { return g.name == n; });
  };
  std::string result = name;
  for (int i = 2; taken(result); ++i) result = name + "(" + std::to_string(i) + ")";
  return result;
}

// The irreducible factor of a polynomial, where the field can take it.
Univariate factor_at(const exact::TowerPtr& tower, const Univariate& squarefree,
                     const RootInterval& where) {
  constexpr int max_degree = 64;
  if (exact::dimension(tower) * exact::degree(squarefree) > max_degree)
    throw NumberLimit("numbers of a field of degree over 64 are not covered");
  return exact::irreducible_factor(squarefree, where);
}

Polynomial Numbers::Tower::root_of(const Univariate& squarefree, RootInterval where) {
  const Univariate f = factor_at(ring->tower(), squarefree, where);
  return exact::degree(f) == 2 ? quadratic(f, where) : adjoined(f, where);
}

// x^2 + 2 p x + q: the roots are -p - r and -p + r with r^2 = p^2 - q.
Polynomial Numbers::Tower::quadratic(const Univariate& f, RootInterval where) {
  const Polynomial middle = Rational(-1, 2) * f[1];
  const auto side = [&](const Rational& end) {
    return exact::sign(ring->constant(end) - middle);
  };
  while (side(where.low) != side(where.high)) where = exact::halved(f, where);
  const bool is_upper = side(where.low) == Sign::positive;
  const Polynomial r = power_root(middle * middle - f[0], 2), centre = ring->embed(middle);
  return is_upper ? centre + r : centre - r;
}

Polynomial Numbers::Tower::adjoined(const Univariate& f, RootInterval where) {
  if (exact::degree(f) == 1) return -f[0];
  const Univariate cleared = ring->constant(common_denominator(f)) * f;
  const auto bracket = exact::bracket(f, where);
  const std::string name = unused(name_of(cleared));
  generators.push_back({name, in_symbol(cleared, name), bracket.low, bracket.high});
  ring = exact::Ring::make(exact::adjoin(f, name, bracket), {});
  expansion = Expansion(ring);
  return *ring->symbol(name);
}

// radicand = (a / b) e > 0 with e primitive: its root is t / b times the root of (a b^(n-1) /
// t^n) e.
Polynomial Numbers::Tower::power_root(const Polynomial& radicand, int n) {
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

  for (const Known& known : roots)
    if (known.n == n && ring->embed(known.radicand) == inside)
      return factor * ring->embed(known.root);
  Univariate f(n + 1, ring->constant(0));
  f[0] = -inside;
  f[n] = ring->constant(1);
  const Rational bound = exact::enclosure(inside, 4).high + 1;
  const Polynomial root = inside == ring->constant(1)
                              ? inside
                              : adjoined(factor_at(ring->tower(), f, {0, bound}), {0, bound});
  roots.push_back({n, inside, root});
  return factor * ring->embed(root);
}

Numbers::Numbers() : tower_(std::make_unique<Tower>()) {}
Numbers::~Numbers() = default;
Numbers::Numbers(Numbers&&) noexcept = default;
Numbers& Numbers::operator=(Numbers&&) noexcept = default;

Formula Numbers::nth_root(const Formula& radicand, int n) {
  exact::require(n >= 2, "nth_root: n < 2");
  const Polynomial x = tower_->number(radicand);
  const Sign s = exact::sign(x);
  if (s == Sign::negative && n % 2 == 0)
    throw NumberError(std::string(n == 2 ? "square root" : "even root") +
                      " of a negative number (about " + roughly(x) + ")");
  Formula value = 0;
  if (s == Sign::positive) value = formula(tower_->power_root(x, n));
  if (s == Sign::negative) value = formula(-tower_->power_root(-x, n));
  std::vector<Fact> facts = {{power(value, n) - radicand, Fact::Relation::zero}};
  if (n % 2 == 0) facts.push_back({value, Fact::Relation::nonnegative});
  return Formula::known(value, std::move(facts));
}

Formula Numbers::root(const Formula& polynomial, const std::string& unknown,
                      const Rational& low, const Rational& high) {
  const std::string where = "[" + low.get_str() + ", " + high.get_str() + "]";
  Expansion expansion(exact::Ring::make(tower_->ring->tower(), {unknown}));
  const Univariate coefficients = exact::univariate(expansion(polynomial), 0);
  if (coefficients.empty()) throw NumberError("every number is a root of 0");
  Univariate f;
  for (const Polynomial& c : coefficients) f.push_back(tower_->ring->embed(c));
  f = exact::squarefree(f);
  const auto roots = exact::real_roots(f, low, high);
  if (roots.empty()) throw NumberError("no root in " + where);
  if (roots.size() > 1) throw NumberError(std::to_string(roots.size()) + " roots in " + where);
  const Formula value = formula(tower_->root_of(f, roots.front()));
  return Formula::known(value, {{subst(polynomial, {{unknown, value}}), Fact::Relation::zero},
                                {value - Formula(low), Fact::Relation::nonnegative},
                                {Formula(high) - value, Fact::Relation::nonnegative}});
}

Formula Numbers::inverse(const Formula& x) {
  const Polynomial number = tower_->number(x);
  if (number.is_zero()) throw NumberError("division by 0");
  const Formula value = formula(exact::inverse(number));
  return Formula::known(value, {{x * value - Formula(1), Fact::Relation::zero}});
}

Sign Numbers::sign(const Formula& number) const {
  return exact::sign(tower_->number(number));
}

bool Numbers::equal(const Formula& a, const Formula& b) const {
  return tower_->number(a) == tower_->number(b);
}

bool Numbers::equal(const Point& a, const Point& b) const {
  return std::ranges::equal(a, b,
                            [&](const Formula& x, const Formula& y) { return equal(x, y); });
}

std::optional<Rational> Numbers::rational(const Formula& number) const {
  return tower_->number(number).rational();
}

Formula Numbers::normal_form(const Formula& number) const {
  return formula(tower_->number(number));
}

double Numbers::approximate(const Formula& number) const {
  return exact::ball(tower_->number(number)).middle;
}

std::pair<Rational, Rational> Numbers::enclosure(const Formula& number,
                                                 const Rational& width) const {
  exact::require(width > 0, "enclosure: width <= 0");
  const Polynomial x = tower_->number(number);
  for (long bits = 32;; bits *= 2) {
    const auto e = exact::enclosure(x, bits);
    if (e.high - e.low <= width) return {e.low, e.high};
  }
}

// Halves are rounded away from 0. Only a rational number can be an exact half, and it is
// enclosed by itself.
std::string Numbers::decimal(const Formula& number, int digits) const {
  exact::require(digits >= 0, "decimal: a negative number of digits");
  const Polynomial x = tower_->number(number);
  const bool negative = exact::sign(x) == Sign::negative;
  const Polynomial scaled = Rational(pow(10, digits)) * (negative ? -x : x);
  const auto rounded = [](const Rational& r) {
    const Rational shifted = r + Rational(1, 2);
    Integer result;
    mpz_fdiv_q(result.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
    return result;
  };
  Integer result;
  if (const auto exact_value = scaled.rational()) {
    result = rounded(*exact_value);
  } else {
    for (long bits = 32;; bits *= 2) {
      const auto e = exact::enclosure(scaled, bits);
      result = rounded(e.low);
      if (result == rounded(e.high)) break;
    }
  }
  std::string text = result.get_str();
  if (std::ssize(text) <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - digits, ".");
  return (negative && result != 0 ? "-" : "") + text;
}

struct Numbers::Mark {
  exact::RingPtr ring;
  std::size_t generators, roots;
};

std::shared_ptr<const Numbers::Mark> Numbers::mark() const {
  return std::make_shared<const Mark>(
      Mark{tower_->ring, tower_->generators.size(), tower_->roots.size()});
}

void Numbers::restore(const Mark& mark) {
  if (mark.ring == tower_->ring) return;
  tower_->ring = mark.ring;
  tower_->expansion = Expansion(mark.ring);
  tower_->generators.erase(tower_->generators.begin() + mark.generators,
                           tower_->generators.end());
  tower_->roots.erase(tower_->roots.begin() + mark.roots, tower_->roots.end());
}

const std::vector<Numbers::Generator>& Numbers::generators() const {
  return tower_->generators;
}

std::shared_ptr<const exact::Tower> Numbers::tower() const {
  return tower_->ring->tower();
}

}  // namespace seam::symbolic
