// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "check/context.h"
#include "check/region.h"

// One function a kind of obligation. Each returns true if the proof shows that the
// obligation holds, false if it shows that it fails, and throws `Open` if it shows neither.
namespace seam::check {

bool decide(Context&, const certificate::Zero&, const certificate::Proof&);
bool decide(Context&, const certificate::Sign&, const certificate::Proof&);
bool decide(Context&, const certificate::Solutions&, const certificate::Proof&);
bool decide(Context&, const certificate::OnlySolutions&, const certificate::Proof&);
bool decide(Context&, const certificate::OneSolution&, const certificate::Proof&);
bool decide(Context&, const certificate::Gluing&, const certificate::Proof&);
bool decide(Context&, const certificate::Distinct&, const certificate::Proof&);
bool decide(Context&, const certificate::Mesh&, const certificate::Proof&);

/// Returns only if the proof shows `formula relation 0` on the region; else throws `Open`.
/// Requires that the formula holds no variables but the region's.
void verify(Context&, const Region&, const Polynomial& formula, certificate::Relation,
            const certificate::SignProof&);

}  // namespace seam::check
