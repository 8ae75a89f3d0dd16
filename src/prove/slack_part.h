// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "prove/fixed_form.h"

namespace seam::prove {

/// A condition of a domain over a part of it.
struct FixedCondition {
  FixedForm form;
  certificate::Relation relation;
};

/// No point of the part meets it.
bool is_broken(const FixedCondition&);
/// A value so enclosed meets the relation.
bool is_met(const FixedForm::Interval& value, certificate::Relation);

/// Coordinates of a point in a factor of the domain, none below 0.
using Barycentre = std::vector<exact::Rational>;

/// A part of a domain in the search for a least value.
struct SlackPart {
  FixedForm f, scale;
  std::vector<FixedCondition> where;
  std::vector<std::vector<Barycentre>> corners;  ///< by factor
  exact::Rational bound;  ///< of f / scale from below; < 0: none is known
  int number = 0;
};

/// Which of two is looked at later: a strict order.
struct Later {
  bool operator()(const SlackPart&, const SlackPart&) const;
};

/// Some c >= 0 with f >= c * scale wherever scale > 0; below 0 where none was found.
exact::Rational bound_below(const FixedForm& f, const FixedForm& scale);

}  // namespace seam::prove
