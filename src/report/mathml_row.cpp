// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml_row.h"

#include <utility>

namespace seam::report {
namespace {

using Space = MathmlAtom::Space;

constexpr const char* thin = "<mspace width=\"0.17em\"/>";

bool ends_operand(Space space) {
  return space == Space::ordinary || space == Space::close || space == Space::function ||
         space == Space::blank;
}

bool is_thin_between(Space left, Space right) {
  if (right == Space::function)
    return left == Space::ordinary || left == Space::close || left == Space::function;
  return left == Space::function && right == Space::ordinary;
}

}  // namespace

void MathmlRow::add(const MathmlAtom& atom) {
  if (atom.xml.empty()) return;
  std::string xml = atom.xml;
  if (is_thin_between(last_, atom.space)) xml_ += thin;
  if (atom.space == Space::sign) {
    const bool is_between = ends_operand(last_);
    if (!is_between && !xml_.empty()) xml.insert(3, " form=\"prefix\"");
    if (is_between && xml_.empty()) xml.insert(3, " form=\"infix\"");
  }
  xml_ += xml;
  last_ = atom.space;
}

std::string MathmlRow::take() {
  return std::exchange(xml_, {});
}

}  // namespace seam::report
