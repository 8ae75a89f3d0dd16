// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/evaluate.h"

namespace seam::claims {

/// A new parameter that stands for any closed mesh whose faces are turned alike.
AnyMesh any_mesh(Evaluator&, const std::string& name);

/// Takes up the condition of a parameter: planar(M), trivalent(M), or both joined by `and`.
void suppose(Evaluator&, const Item& param);

/// Each edge cut at both ends.
AnyMesh truncated(const AnyMesh&);

/// A statement about the numbers of any mesh, as one that holds only if it holds for all
/// numbers, and that fails only if it fails for some mesh.
symbolic::Proposition of_meshes(const Evaluator&, symbolic::Proposition);

}  // namespace seam::claims
