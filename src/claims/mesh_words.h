// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "symbolic/proposition.h"

namespace seam::claims {

/// What is stated of a mesh, in words: `12 vertices, 18 edges, 8 faces`.
std::string describe_mesh(const symbolic::Mesh&);

}  // namespace seam::claims
