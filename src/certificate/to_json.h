// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "certificate/evidence.h"
#include "certificate/layout.h"

namespace seam::certificate {

Json to_json(const Statement&);
Json to_json(const Certificate&);

/// The spelling of a relation: > >= = != <= <.
const char* spelling(Relation);
/// The spelling of a property of a mesh: its name.
const char* spelling(Mesh::Property);
/// The spelling of a function: its name.
const char* spelling(Elementary);
/// The spelling of a verdict: its name.
const char* spelling(Verdict);

}  // namespace seam::certificate
