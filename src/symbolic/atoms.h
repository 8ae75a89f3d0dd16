// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "symbolic/formula.h"

namespace seam::symbolic {

/// The roots, inverses and applied functions that stand in some formulas, each once and after
/// those in its own operand, under names that are all different: `sqrt(1 - c^2)`. With them as
/// further symbols every formula is a polynomial. Keeps the formulas alive.
class Atoms {
 public:
  struct Entry {
    std::string name;
    Formula formula;  ///< of kind `root`, `inverse` or `applied`
  };

  /// Adds those in a formula.
  void add(const Formula&);

  const std::vector<Entry>& entries() const { return entries_; }
  /// The entry of one that was added, or that is the same as a tree.
  const Entry& operator[](const Formula&) const;

 private:
  std::vector<Entry> entries_;
  std::unordered_map<const void*, std::size_t> seen_;
  std::vector<Formula> kept_;
};

}  // namespace seam::symbolic
