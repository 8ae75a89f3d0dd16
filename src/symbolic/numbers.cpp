// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/numbers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "exact/contract.h"
#include "symbolic/forest.h"

// Which numbers there are, and that questions about them have an answer: see forest.cpp. Of a
// transcendental number it is not known whether it is 0 if its normal form is not; so precision
// grows up to a bound only.

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;
using exact::Univariate;

namespace {

// "3.2", "about" being said by the caller.
std::string roughly(const Polynomial& number) {
  std::string text = std::to_string(exact::ball(number).middle);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

Integer pow(const Integer& base, int exponent) {
  Integer result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

}  // namespace

Numbers::Numbers() : forest_(std::make_unique<Forest>()) {}
Numbers::~Numbers() = default;
Numbers::Numbers(Numbers&&) noexcept = default;
Numbers& Numbers::operator=(Numbers&&) noexcept = default;

Formula Numbers::nth_root(const Formula& radicand, int n) {
  exact::require(n >= 2, "nth_root: n < 2");
  const Forest::Grown& in = forest_->field_of(radicand);
  const Polynomial x = forest_->algebraic(radicand);
  const Sign s = exact::sign(x);
  if (s == Sign::negative && n % 2 == 0)
    throw NumberError(std::string(n == 2 ? "square root" : "even root") +
                      " of a negative number (about " + roughly(x) + ")");
  Formula value = 0;
  if (s == Sign::positive) value = forest_->power_root(in, x, n);
  if (s == Sign::negative) value = -forest_->power_root(in, -x, n);
  std::vector<Fact> facts = {{power(value, n) - radicand, Fact::Relation::zero}};
  if (n % 2 == 0) facts.push_back({value, Fact::Relation::nonnegative});
  return Formula::known(value, std::move(facts));
}

Formula Numbers::root(const Formula& polynomial, const std::string& unknown,
                      const Rational& low, const Rational& high) {
  const std::string where = "[" + low.get_str() + ", " + high.get_str() + "]";
  const Forest::Grown& in = forest_->field_of(polynomial);
  if (!in.field.transcendental.empty())
    throw NumberLimit("roots over numbers that are not algebraic are not covered");
  Expansion expansion(exact::Ring::make(in.field.ring->tower(), {unknown}), {},
                      in.field.values);
  const Univariate coefficients = exact::univariate(expansion(polynomial), 0);
  if (coefficients.empty()) throw NumberError("every number is a root of 0");
  Univariate f;
  for (const Polynomial& c : coefficients) f.push_back(in.field.ring->embed(c));
  f = exact::squarefree(f);
  const auto roots = exact::real_roots(f, low, high);
  if (roots.empty()) throw NumberError("no root in " + where);
  if (roots.size() > 1) throw NumberError(std::to_string(roots.size()) + " roots in " + where);
  require_small(in.field.ring, exact::degree(f));
  f = exact::irreducible_factor(f, roots.front());
  const Formula value = exact::degree(f) == 2 ? forest_->quadratic_root(in, f, roots.front())
                                              : forest_->root_of(in, f, roots.front());
  return Formula::known(value, {{subst(polynomial, {{unknown, value}}), Fact::Relation::zero},
                                {value - Formula(low), Fact::Relation::nonnegative},
                                {Formula(high) - value, Fact::Relation::nonnegative}});
}

Formula Numbers::inverse(const Formula& x) {
  const Polynomial number = forest_->number(x);
  if (number.is_zero()) throw NumberError("division by 0");
  if (!number.is_number()) return transcendental_inverse(x);
  const Formula value = formula(exact::inverse(forest_->algebraic(x)));
  return Formula::known(value, {{x * value - Formula(1), Fact::Relation::zero}});
}

Sign Numbers::sign(const Formula& number) const {
  return forest_->sign(number);
}

bool Numbers::is_algebraic(const Formula& number) const {
  return forest_->number(number).is_number();
}

bool Numbers::equal(const Formula& a, const Formula& b) const {
  const Polynomial difference = forest_->number(a - b);
  return difference.is_number() ? difference.is_zero() : sign(a - b) == Sign::zero;
}

bool Numbers::equal(const Point& a, const Point& b) const {
  return std::ranges::equal(a, b,
                            [&](const Formula& x, const Formula& y) { return equal(x, y); });
}

std::optional<Rational> Numbers::rational(const Formula& number) const {
  return forest_->number(number).rational();
}

Formula Numbers::normal_form(const Formula& number) const {
  return formula(forest_->number(number));
}

double Numbers::approximate(const Formula& number) const {
  if (is_algebraic(number)) return exact::ball(forest_->number(number)).middle;
  const auto e = forest_->enclosure(number, 256);
  if (!e) return std::numeric_limits<double>::quiet_NaN();
  return Rational((e->low + e->high) / 2).get_d();
}

std::pair<Rational, Rational> Numbers::enclosure(const Formula& number,
                                                 const Rational& width) const {
  exact::require(width > 0, "enclosure: width <= 0");
  const bool ends = is_algebraic(number);
  for (long bits = 32; ends || bits <= max_precision; bits *= 2) {
    const auto e = forest_->enclosure(number, bits);
    if (e && e->high - e->low <= width) return {e->low, e->high};
  }
  throw NumberLimit("a number that is not enclosed closely enough: " + text(number, 60));
}

// Halves are rounded away from 0. Only a rational number can be an exact half, and an algebraic
// one is enclosed by itself.
std::string Numbers::decimal(const Formula& number, int digits) const {
  exact::require(digits >= 0, "decimal: a negative number of digits");
  const bool negative = sign(number) == Sign::negative;
  const Formula scaled = Formula(Rational(pow(10, digits))) * (negative ? -number : number);
  const auto rounded = [](const Rational& r) {
    const Rational shifted = r + Rational(1, 2);
    Integer result;
    mpz_fdiv_q(result.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
    return result;
  };
  std::optional<Integer> result;
  if (const auto exact_value = rational(scaled)) result = rounded(*exact_value);
  const bool ends = is_algebraic(number);
  for (long bits = 32; !result && (ends || bits <= max_precision); bits *= 2)
    if (const auto e = forest_->enclosure(scaled, bits);
        e && rounded(e->low) == rounded(e->high))
      result = rounded(e->low);
  if (!result)
    throw NumberLimit("a number that may be half-way between two decimals: " +
                      text(number, 60));
  std::string text = result->get_str();
  if (std::ssize(text) <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - digits, ".");
  return (negative && *result != 0 ? "-" : "") + text;
}

const std::vector<Numbers::Generator>& Numbers::generators() const {
  return forest_->generators;
}

const Numbers::Field& Numbers::field(const std::set<std::string>& symbols) const {
  Forest::Support all;
  for (const std::string& symbol : symbols)
    if (const auto found = forest_->index.find(symbol); found != forest_->index.end())
      all = united(all, forest_->supports[found->second]);
  return forest_->grown(all).field;
}

const Numbers::Generator* Numbers::find(const std::string& name) const {
  const auto found = forest_->index.find(name);
  return found == forest_->index.end() ? nullptr : &forest_->generators[found->second];
}

const Numbers::Field& Numbers::field(const Formula& number) const {
  return forest_->field_of(number).field;
}

}  // namespace seam::symbolic
