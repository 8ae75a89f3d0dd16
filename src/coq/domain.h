// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "coq/draft.h"

namespace seam::coq {

/// `formula = 0` for all real values of the variables.
void write_identity(Draft&, const certificate::Sign&, const std::set<std::string>& variables);

/// `formula relation 0`, a number in normal form, all over the domain.
void write_number(Draft&, const certificate::Sign&, const std::set<std::string>& variables);

/// `formula relation 0` all over the domain, by pieces. False: a variable is of no factor.
bool write_pieces(Draft&, const certificate::Sign&, const std::set<std::string>& variables,
                  const certificate::Pieces&);

/// That there is a point of the domain at which the relation fails. False: the domain is not
/// written by inequalities, or a variable has no value.
bool write_witness(Draft&, const certificate::Sign&, const std::set<std::string>& variables,
                   const certificate::Point&);

}  // namespace seam::coq
