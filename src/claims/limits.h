// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace seam::claims {

/// Why something was left undone: the reason of an undecided claim (`time`, `memory`, or
/// `unsupported` where it broke off), and a sentence.
struct Refusal {
  std::string reason, detail;
};

/// Does a step of reading, or says why it is left undone. Each step of a file has a name of its
/// own, which is the same in every run.
using Limits = std::function<std::optional<Refusal>(const std::string& name,
                                                    const std::function<void()>& step)>;

/// Every step is done, whatever it takes.
inline std::optional<Refusal> no_limits(const std::string&, const std::function<void()>& step) {
  step();
  return std::nullopt;
}

}  // namespace seam::claims
