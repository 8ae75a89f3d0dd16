// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "exact/contract.h"
#include "exact/roots.h"

// The interval chosen has ends n / 2^k and (n+1) / 2^k: the first k that will do. It ends
// because the root is simple: the derivative is not 0 at it, and interval values of the
// derivative shrink to that number.

namespace seam::exact {

namespace {

struct Interval {
  Rational low, high;
};

Interval operator*(const Interval& a, const Interval& b) {
  const Rational ends[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {*std::ranges::min_element(ends), *std::ranges::max_element(ends)};
}

Interval operator+(const Interval& a, const Interval& b) {
  return {a.low + b.low, a.high + b.high};
}

Interval horner(const std::vector<Interval>& coefficients, const Interval& at) {
  Interval result{0, 0};
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) result = result * at + *c;
  return result;
}

Integer floored(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

}  // namespace

Bracket bracket(const Univariate& f, RootInterval root) {
  std::vector<Interval> slope;
  for (const Polynomial& c : derivative(f)) {
    const Enclosure e = enclosure(c, 128);
    slope.push_back({e.low, e.high});
  }
  const Ring& ring = f.front().ring();
  Rational unit = 1;
  for (int k = 0;; ++k, unit /= 2) {
    while (root.low != root.high && floored(root.low / unit) != floored(root.high / unit))
      root = halved(f, root);
    const Bracket result{floored(root.low / unit) * unit,
                         (floored(root.low / unit) + 1) * unit};
    const Interval value = horner(slope, {result.low, result.high});
    if (value.low <= 0 && value.high >= 0) continue;
    const Sign low = sign(exact::value(f, ring.constant(result.low)));
    const Sign high = sign(exact::value(f, ring.constant(result.high)));
    if (low != Sign::zero && high != Sign::zero && low != high) return result;
  }
}

TowerPtr adjoin(const Univariate& f, const std::string& name, const Bracket& bracket) {
  require(degree(f) >= 2 && f.back() == f.back().ring().constant(1), "adjoin: not monic");
  Integer scale = 1;
  for (const Polynomial& c : f) scale = lcm(scale, c.numerators().denominator);
  // h = scale * x satisfies h^d = -sum scale^(d-j) c_j h^j.
  std::vector<Coordinates> tail;
  const TowerPtr& below = f.front().ring().tower();
  Integer power = 1;
  for (int j = degree(f) - 1; j >= 0; --j) {
    power *= scale;
    const auto [terms, denominator] = f[j].numerators();
    Coordinates c = terms.empty() ? Coordinates(dimension(below)) : terms.begin()->second;
    for (Integer& entry : c) entry = -entry * (power / denominator);
    tail.push_back(std::move(c));
  }
  std::ranges::reverse(tail);
  return std::make_shared<const Tower>(below, name, scale, std::move(tail), bracket.low,
                                       bracket.high);
}

}  // namespace seam::exact
