// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "symbolic/proposition.h"

namespace seam::claims {

// What a statement says, in a few words.
std::string describe(const symbolic::Zero&);
std::string describe(const symbolic::Sign&);
std::string describe(const symbolic::Solutions&);
std::string describe(const symbolic::OnlySolutions&);
std::string describe(const symbolic::OneSolution&);
std::string describe(const certificate::Gluing&);
std::string describe(const symbolic::Distinct&);
std::string describe(const symbolic::Mesh&);

}  // namespace seam::claims
