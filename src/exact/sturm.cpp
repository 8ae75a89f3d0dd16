// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/contract.h"
#include "exact/roots.h"

// Sturm: the number of roots in (a, b] is the drop, from a to b, of the changes of sign in the
// chain f, f', and negated remainders. Halving ends because roots are distinct.

namespace seam::exact {

namespace {

using Chain = std::vector<Univariate>;

Chain sturm_chain(const Univariate& f) {
  Chain chain = {f, derivative(f)};
  while (!chain.back().empty()) {
    const Univariate rest = divide(chain[chain.size() - 2], chain.back()).remainder;
    if (rest.empty()) break;
    // Only the sign of the factor matters; a positive one keeps the numbers small.
    Polynomial scale = inverse(rest.back());
    if (sign(rest.back()) == Sign::positive) scale = -scale;
    chain.push_back(scale * rest);
  }
  if (chain.back().empty()) chain.pop_back();
  return chain;
}

Sign sign_at(const Univariate& f, const Rational& x) {
  return sign(value(f, f.front().ring().constant(x)));
}

int changes(const Chain& chain, const Rational& x) {
  int count = 0;
  Sign last = Sign::zero;
  for (const Univariate& f : chain) {
    const Sign s = sign_at(f, x);
    if (s == Sign::zero) continue;
    if (last != Sign::zero && s != last) ++count;
    last = s;
  }
  return count;
}

// All real roots lie strictly between -bound and bound.
Integer root_bound(const Univariate& f) {
  const Univariate m = monic(f);
  Integer bound = 1;
  for (int i = 0; i < degree(m); ++i) {
    const Enclosure e = enclosure(m[i], 8);
    const Rational size = std::max<Rational>(abs(e.low), abs(e.high));
    bound = std::max<Integer>(bound, size.get_num() / size.get_den() + 2);
  }
  Integer power = 1;
  while (power <= bound) power *= 2;
  return power;
}

void isolate(const Chain& chain, const Rational& low, const Rational& high, int at_low,
             int at_high,
             std::vector<RootInterval>& roots) {  // in (low, high]
  const int count = at_low - at_high;
  if (count == 0) return;
  if (count == 1) {
    const Sign end = sign_at(chain[0], high);
    if (end == Sign::zero) {
      roots.push_back({high, high});
      return;
    }
    if (sign_at(chain[0], low) != Sign::zero) {
      roots.push_back({low, high});
      return;
    }
  }
  const Rational middle = (low + high) / 2;
  const int at_middle = changes(chain, middle);
  isolate(chain, low, middle, at_low, at_middle, roots);
  isolate(chain, middle, high, at_middle, at_high, roots);
}

}  // namespace

Univariate squarefree(const Univariate& f) {
  require(!f.empty(), "squarefree: of 0");
  if (degree(f) < 2) return f;
  const Univariate common = gcd(f, derivative(f));
  return degree(common) == 0 ? f : divide(f, common).quotient;
}

std::vector<RootInterval> real_roots(const Univariate& f, const Rational& low,
                                     const Rational& high) {
  std::vector<RootInterval> roots;
  if (degree(f) < 1 || low > high) return roots;
  if (sign_at(f, low) == Sign::zero) roots.push_back({low, low});
  const Chain chain = sturm_chain(f);
  isolate(chain, low, high, changes(chain, low), changes(chain, high), roots);
  // Neighbours may share an end that is no root; what must not be shared is a root.
  return roots;
}

std::vector<RootInterval> real_roots(const Univariate& f) {
  if (degree(f) < 1) return {};
  const Rational bound(root_bound(f));
  return real_roots(f, -bound, bound);
}

RootInterval halved(const Univariate& f, const RootInterval& root) {
  if (root.low == root.high) return root;
  const Rational middle = (root.low + root.high) / 2;
  const Sign s = sign_at(f, middle);
  if (s == Sign::zero) return {middle, middle};
  if (s == sign_at(f, root.low)) return {middle, root.high};
  return {root.low, middle};
}

}  // namespace seam::exact
