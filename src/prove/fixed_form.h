// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "prove/region.h"

namespace seam::prove {

/// The Bernstein coefficients of a polynomial over a product of simplices, enclosed by integers
/// times 2^-`bits`. Every operation rounds outward.
class FixedForm {
 public:
  static constexpr unsigned bits = 256;

  explicit FixedForm(const Barycentric&);

  struct Interval {
    exact::Integer low, high;
  };
  const bernstein::Shape& shape() const { return *shape_; }
  const Interval& operator[](int index) const { return coefficients_[index]; }

  /// Over the part in which the middle of the edge between two corners of a factor takes the
  /// place of the first.
  FixedForm half(int factor, int replaced, int kept) const;

 private:
  std::shared_ptr<const bernstein::Shape> shape_;
  std::vector<Interval> coefficients_;
};

}  // namespace seam::prove
