// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <stdexcept>

namespace seam::check {

/// Thrown where the evidence shows nothing. Says why.
struct Open : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void demand(bool condition, const char* otherwise) {
  if (!condition) throw Open(otherwise);
}

/// What keeps every input finite: elementary steps are counted down, and no
/// single value may grow beyond these sizes.
class Meter {
 public:
  static constexpr std::size_t max_words = std::size_t{1} << 24;  ///< 64-bit words a polynomial
  static constexpr std::size_t max_bits = std::size_t{1} << 18;   ///< a coefficient
  static constexpr int max_exponent = 32767;

  explicit Meter(long effort) : left_(effort) {}

  /// Takes so many steps off, or throws `Open`. One call is worth a few steps of its own.
  void charge(std::size_t steps) {
    const std::size_t cost = steps + 4;
    if (left_ < 0 || cost > static_cast<std::size_t>(left_)) {
      left_ = -1;
      throw Open("effort");
    }
    left_ -= static_cast<long>(cost);
  }

 private:
  long left_;
};

}  // namespace seam::check
