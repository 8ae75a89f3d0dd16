// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "prove/workshop.h"

namespace seam::prove {

/// f = rest + sum cofactors[i] * equations[i], in normal form with respect to functions.
struct Division {
  exact::Polynomial rest;
  std::vector<exact::Polynomial> cofactors;
};

/// Divisions that lower the degree of f in variables in which the equations are monic, up to a
/// number; a few choices of these. All are elements of one ring over the present tower.
std::vector<Division> divisions(Workshop&, const exact::Polynomial& f,
                                const std::vector<exact::Polynomial>& equations);

}  // namespace seam::prove
