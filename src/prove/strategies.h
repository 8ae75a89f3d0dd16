// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "prove/workshop.h"

// One strategy for each kind of obligation.
namespace seam::prove {

certificate::Proof prove_zero(Workshop&, const certificate::Zero&);
certificate::Proof prove_sign(Workshop&, const certificate::Sign&);
certificate::Proof prove_solutions(Workshop&, const certificate::Solutions&);

/// A finite count: the checker does it.
certificate::Proof prove_by_computation();

}  // namespace seam::prove
