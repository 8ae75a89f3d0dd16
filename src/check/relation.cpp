// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/relation.h"

#include "check/meter.h"

namespace seam::check {

using certificate::Relation;

bool holds(Relation relation, int sign) {
  switch (relation) {
    case Relation::positive:
      return sign > 0;
    case Relation::nonnegative:
      return sign >= 0;
    case Relation::zero:
      return sign == 0;
    case Relation::nonzero:
      return sign != 0;
    case Relation::nonpositive:
      return sign <= 0;
    case Relation::negative:
      return sign < 0;
  }
  throw Open("malformed: an unknown relation");
}

Relation complement(Relation relation) {
  switch (relation) {
    case Relation::positive:
      return Relation::nonpositive;
    case Relation::nonnegative:
      return Relation::negative;
    case Relation::zero:
      return Relation::nonzero;
    case Relation::nonzero:
      return Relation::zero;
    case Relation::nonpositive:
      return Relation::positive;
    case Relation::negative:
      return Relation::nonnegative;
  }
  throw Open("malformed: an unknown relation");
}

}  // namespace seam::check
