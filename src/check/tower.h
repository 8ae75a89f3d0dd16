// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certificate/statement.h"
#include "check/interval.h"
#include "check/ring.h"

namespace seam::check {

/// Real numbers, each the root of a polynomial over those before it, or the value of an
/// elementary function at such a number; number i is symbol i. A *number* is a polynomial in
/// these symbols alone, and stands for one real value.
class Tower {
 public:
  explicit Tower(Ring& ring) : ring_(&ring) {}

  int size() const { return static_cast<int>(generators_.size()); }

  /// Adds the one root in [low, high] of a polynomial in the symbol `size()` and those
  /// before. Throws `Open` unless there is exactly one and it is simple.
  void extend(const Polynomial& polynomial, const Polynomial& low, const Polynomial& high);

  /// Adds the value of the function there; of pi nothing is asked but the number itself. Throws
  /// `Open` unless it is seen to have one.
  void extend(certificate::Elementary, const Polynomial& argument);

  /// Whether the value is seen to be that of the function at the argument: exp 0 = 1, cos 0 =
  /// 1, sin 0 = 0, log 1 = 0, or one of these numbers.
  bool is_value(certificate::Elementary, const Polynomial& argument, const Polynomial& value);

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
    // Or else: the function, which can be evaluated from `start_bits` on.
    certificate::Elementary function = certificate::Elementary::none;
    Polynomial argument = {};
  };
  using Coefficients = std::map<int, Interval>;

  Interval enclose(const Polynomial& number, int bits);
  Coefficients enclose(const std::map<int, Polynomial>& numbers, int bits);
  Interval value(const Coefficients& polynomial, const Interval& x, int bits);
  std::optional<Interval> isolate(const Coefficients& polynomial, const Interval& within,
                                  int bits);
  Interval refined(const Generator& generator, int bits);
  Interval value(certificate::Elementary, const Polynomial& argument, int bits);
  const Interval& generator_power(int index, int e, int bits);

  Ring* ring_;
  std::vector<Generator> generators_;
  std::map<int, std::vector<Powers>> enclosures_;  // by bits, then by generator
};

}  // namespace seam::check
