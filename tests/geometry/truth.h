// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/contact.h"

// What propositions come to, decided for tests only: identities and numbers exactly, signs on a
// domain at the points of a grid (so a truth here is no proof, a falsehood is one).
namespace seam::geometry::testing {

bool holds(const symbolic::Proposition&, const symbolic::Numbers&);

bool vanishes(const Formula&, const symbolic::Numbers&);
bool vanishes(const Point&, const symbolic::Numbers&);

}  // namespace seam::geometry::testing
