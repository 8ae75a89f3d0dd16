// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/field.h"

#include <utility>

#include "exact/contract.h"
#include "exact/flint.h"

// The inverse of x is the solution of a linear system: multiplication by x is a matrix in
// the basis of the tower, invertible because the tower is a field.

namespace seam::exact {

namespace {

Coordinates coordinates(const Polynomial& number) {
  require(number.is_number(), "a number was expected");
  if (number.is_zero()) return Coordinates(dimension(number.ring().tower()));
  return number.numerators().terms.begin()->second;
}

Polynomial zero_like(const Univariate& f) {
  return f.front().ring().constant(0);
}

}  // namespace

Sign sign(const Polynomial& number) {
  return sign(number.ring().tower(), coordinates(number));
}

Ball ball(const Polynomial& number) {
  const Ball b = ball(number.ring().tower(), coordinates(number));
  const double denominator = number.is_zero() ? 1 : number.numerators().denominator.get_d();
  return {b.middle / denominator,
          b.radius / denominator * (1 + 1e-14) + 1e-14 * std::abs(b.middle / denominator)};
}

Enclosure enclosure(const Polynomial& number, long bits) {
  if (number.is_zero()) return {0, 0};
  const Integer denominator = number.numerators().denominator;
  const auto extra = static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  const Enclosure e = enclosure(number.ring().tower(), coordinates(number), bits + extra);
  return {e.low / denominator, e.high / denominator};
}

Polynomial inverse(const Polynomial& number) {
  require(!number.is_zero(), "inverse: of 0");
  const Ring& ring = number.ring();
  if (const auto q = number.rational()) return ring.constant(1 / *q);
  const auto [terms, denominator] = number.numerators();
  const Polynomial scaled = ring.number(terms.begin()->second);
  const int size = dimension(ring.tower());
  fmpz_mat_t matrix, right, solution;
  fmpz_mat_init(matrix, size, size);
  fmpz_mat_init(right, size, 1);
  fmpz_mat_init(solution, size, 1);
  for (int j = 0; j < size; ++j) {
    Coordinates unit(size);
    unit[j] = 1;
    const Coordinates column = coordinates(scaled * ring.number(unit));
    for (int i = 0; i < size; ++i)
      fmpz_set_mpz(fmpz_mat_entry(matrix, i, j), column[i].get_mpz_t());
  }
  fmpz_one(fmpz_mat_entry(right, 0, 0));
  flint::Fmpz common;
  const bool solved = fmpz_mat_solve(solution, common.it, matrix, right) != 0;
  Coordinates result(size);
  for (int i = 0; i < size; ++i) result[i] = flint::integer(fmpz_mat_entry(solution, i, 0));
  fmpz_mat_clear(matrix);
  fmpz_mat_clear(right);
  fmpz_mat_clear(solution);
  require(solved, "inverse: the tower is not a field");
  Rational factor(denominator, flint::integer(common.it));
  factor.canonicalize();
  return factor * ring.number(result);
}

int degree(const Univariate& f) {
  return static_cast<int>(f.size()) - 1;
}

Univariate univariate(const Polynomial& f, int variable) {
  Univariate result(f.degree(variable) + 1, f.ring().constant(0));
  for (const auto& [exponents, c] : f.coefficients({variable})) {
    require(c.is_number(), "univariate: another variable");
    result[exponents[0]] = c;
  }
  return result;
}

Univariate trimmed(Univariate f) {
  while (!f.empty() && f.back().is_zero()) f.pop_back();
  return f;
}

Univariate operator+(const Univariate& a, const Univariate& b) {
  if (a.size() < b.size()) return b + a;
  Univariate result = a;
  for (std::size_t i = 0; i < b.size(); ++i) result[i] = result[i] + b[i];
  return trimmed(std::move(result));
}

Univariate operator-(const Univariate& a, const Univariate& b) {
  if (b.empty()) return a;
  return a + b.front().ring().constant(-1) * b;
}

Univariate operator*(const Univariate& a, const Univariate& b) {
  if (a.empty() || b.empty()) return {};
  Univariate result(a.size() + b.size() - 1, zero_like(a));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
  return result;
}

Univariate operator*(const Polynomial& a, const Univariate& b) {
  if (a.is_zero()) return {};
  Univariate result;
  for (const Polynomial& c : b) result.push_back(a * c);
  return result;
}

Univariate derivative(const Univariate& f) {
  Univariate result;
  for (int i = 1; i <= degree(f); ++i) result.push_back(Rational(i) * f[i]);
  return result;
}

Univariate monic(const Univariate& f) {
  require(!f.empty(), "monic: of 0");
  return inverse(f.back()) * f;
}

Polynomial value(const Univariate& f, const Polynomial& at) {
  require(!f.empty(), "value: of 0");
  Polynomial result = f.back();
  for (int i = degree(f) - 1; i >= 0; --i) result = result * at + f[i];
  return result;
}

Division divide(const Univariate& f, const Univariate& by) {
  require(!by.empty(), "divide: by 0");
  Division result{{}, f};
  auto& [quotient, rest] = result;
  if (degree(f) < degree(by)) return result;
  const Polynomial inverse_lead = inverse(by.back());
  quotient.assign(degree(f) - degree(by) + 1, zero_like(by));
  for (int i = degree(f) - degree(by); i >= 0; --i) {
    const Polynomial c = rest[i + degree(by)] * inverse_lead;
    quotient[i] = c;
    if (c.is_zero()) continue;
    for (int j = 0; j <= degree(by); ++j) rest[i + j] = rest[i + j] - c * by[j];
  }
  rest = trimmed(std::move(rest));
  return result;
}

Gcd extended_gcd(const Univariate& a, const Univariate& b) {
  require(!a.empty() || !b.empty(), "extended_gcd: both 0");
  const Univariate one = {(a.empty() ? b : a).front().ring().constant(1)};
  Gcd now{a, one, {}}, next{b, {}, one};
  while (!next.gcd.empty()) {
    auto [quotient, rest] = divide(now.gcd, next.gcd);
    Gcd after{std::move(rest), now.cofactor_a - quotient * next.cofactor_a,
              now.cofactor_b - quotient * next.cofactor_b};
    now = std::exchange(next, std::move(after));
  }
  const Polynomial lead = inverse(now.gcd.back());
  return {lead * now.gcd, lead * now.cofactor_a, lead * now.cofactor_b};
}

Univariate gcd(const Univariate& a, const Univariate& b) {
  if (b.empty()) return a.empty() ? a : monic(a);
  Univariate now = a, next = monic(b);
  while (!next.empty()) {
    Univariate rest = divide(now, next).remainder;
    now = std::exchange(next, rest.empty() ? rest : monic(rest));
  }
  return now;
}

}  // namespace seam::exact
