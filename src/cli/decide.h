// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/outcome.h"
#include "cli/verify.h"

namespace seam::cli {

/// A statement to be decided, and what it was turned into.
struct Question {
  std::string id;
  const claims::Lowered* lowered = nullptr;
  const claims::Expression* statement = nullptr;
};

/// Each statement with the checker's verdict. Evidence comes from the store, or is searched for
/// and put there; which of the two changes nothing but the time. Equal questions have equal
/// answers for any number of jobs, except those that run out of time or memory.
std::vector<Decided> decide(const std::vector<Question>&, const VerifyOptions&,
                            const NormalForm&, const Progress& = {});

}  // namespace seam::cli
