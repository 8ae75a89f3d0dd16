// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/interval.h"
#include "check/ring.h"

namespace seam::check {

/// Real algebraic numbers, each the root of a polynomial over those before it; number i is
/// symbol i. A *number* is a polynomial in these symbols alone, and stands for one real value.
class Tower {
 public:
  explicit Tower(Ring& ring) : ring_(&ring) {}

  int size() const { return static_cast<int>(generators_.size()); }

  /// Adds the one root in [low, high] of a polynomial in the symbol `size()` and those
  /// before. Throws `Open` unless there is exactly one and it is simple.
  void extend(const Polynomial& polynomial, const Polynomial& low, const Polynomial& high);

  /// -1, 0 or 1, or nothing where neither normal form nor enclosure decides.
  std::optional<int> find_sign(const Polynomial& number);
  /// As `find_sign`; throws `Open` where that finds nothing.
  int sign(const Polynomial& number);

 private:
  using Powers = std::vector<Interval>;  // of one number, from the power 0 on
  struct Generator {
    std::map<int, Polynomial> coefficients;  // of the defining polynomial, by exponent
    Interval start;                          // holds that root and no other
    int start_bits;
  };
  using Coefficients = std::map<int, Interval>;

  Interval enclose(const Polynomial& number, int bits);
  Coefficients enclose(const std::map<int, Polynomial>& numbers, int bits);
  Interval value(const Coefficients& polynomial, const Interval& x, int bits);
  std::optional<Interval> isolate(const Coefficients& polynomial, const Interval& within,
                                  int bits);
  Interval refined(const Generator& generator, int bits);
  const Interval& generator_power(int index, int e, int bits);

  Ring* ring_;
  std::vector<Generator> generators_;
  std::map<int, std::vector<Powers>> enclosures_;  // by bits, then by generator
};

}  // namespace seam::check
