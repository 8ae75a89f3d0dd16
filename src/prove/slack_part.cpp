// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/slack_part.h"

#include <algorithm>
#include <optional>

// With b_i >= 0 let f = sum F_i b_i and scale = sum G_i b_i, both times one power of the
// weights. If F_i - c G_i >= 0 for all i then f >= c * scale. For c >= 0 that is so once F_i,
// rounded down, is not below c times G_i, rounded up: c = min F_i / G_i over the G_i > 0, if no
// F_i is negative.

namespace seam::prove {

using certificate::Relation;
using exact::Integer;
using exact::Rational;

bool is_broken(const FixedCondition& c) {
  for (int i = 0; i < c.form.shape().count(); ++i) {
    const int above = sgn(c.form[i].high), below = sgn(c.form[i].low);
    const bool is_negative = above<0, is_positive = below> 0;
    if (c.relation == Relation::positive || c.relation == Relation::nonnegative) {
      if (!is_negative) return false;
    } else if (!is_positive) {
      return false;
    }
  }
  return true;
}

bool is_met(const FixedForm::Interval& value, Relation relation) {
  switch (relation) {
    case Relation::positive:
      return value.low > 0;
    case Relation::nonnegative:
      return value.low >= 0;
    case Relation::negative:
      return value.high < 0;
    case Relation::nonpositive:
      return value.high <= 0;
    default:
      return false;
  }
}

bool Later::operator()(const SlackPart& a, const SlackPart& b) const {
  return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
}

Rational bound_below(const FixedForm& f, const FixedForm& scale) {
  std::optional<Rational> least;
  Integer lowest = 0;
  for (int i = 0; i < f.shape().count(); ++i) {
    lowest = std::min(lowest, f[i].low);
    if (scale[i].high <= 0) continue;
    Rational quotient(f[i].low, scale[i].high);
    quotient.canonicalize();
    if (!least || quotient < *least) least = quotient;
  }
  return lowest < 0 ? Rational(lowest) : least.value_or(Rational(0));
}

}  // namespace seam::prove
