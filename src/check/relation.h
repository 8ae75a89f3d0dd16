// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "certificate/statement.h"

namespace seam::check {

/// Whether a number of this sign meets `relation 0`.
bool holds(certificate::Relation, int sign);

/// What is true of a number exactly when `relation 0` is not.
certificate::Relation complement(certificate::Relation);

}  // namespace seam::check
