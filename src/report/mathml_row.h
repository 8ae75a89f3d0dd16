// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace seam::report {

/// A sign or an element of a formula.
struct MathmlAtom {
  /// What decides on the blanks around it.
  enum class Space { blank, ordinary, function, sign, relation, open, close, punctuation };
  std::string xml = {};
  Space space = Space::ordinary;
  bool limits = false;   ///< scripts stand below and above
  bool may_end = false;  ///< a line may end behind it
};

/// Atoms in a row, with the blanks that TeX would leave: none between a sign like − and the
/// number it belongs to, a thin one beside the name of a function. What a browser would do by
/// itself depends on where an element begins and ends, and these have other reasons here.
class MathmlRow {
 public:
  void add(const MathmlAtom&);

  /// What has come so far; what is added then begins a new row, but goes on from it.
  std::string take();
  bool empty() const { return xml_.empty(); }

 private:
  std::string xml_;
  MathmlAtom::Space last_ = MathmlAtom::Space::open;
};

}  // namespace seam::report
