// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "certificate/evidence.h"
#include "coq/obligation.h"

namespace seam::coq {

/// A certificate as a file for Coq: a theorem for each obligation that can be one, a comment
/// for each other.
struct Exported {
  std::string text;
  std::vector<Theorem> obligations;  ///< without their texts
};

/// `shown`: what is known of each obligation; none for `open`. `says`: the claim in words, for
/// a comment.
Exported write_file(const certificate::Certificate&, const std::vector<Shown>& shown,
                    const std::string& says);

/// The files that these rest on, name and text, in the order in which Coq compiles them.
std::vector<std::pair<std::string, std::string>> library();

}  // namespace seam::coq
