// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <array>

#include "certificate/json.h"
#include "certificate/to_json.h"

namespace seam::certificate {

const char* spelling(Relation relation) {
  switch (relation) {
    case Relation::positive:
      return ">";
    case Relation::nonnegative:
      return ">=";
    case Relation::zero:
      return "=";
    case Relation::nonzero:
      return "!=";
    case Relation::nonpositive:
      return "<=";
    case Relation::negative:
      return "<";
  }
  throw FormatError("a relation of no kind");
}

const char* spelling(Mesh::Property property) {
  static constexpr std::array names = {"counts",    "face_sizes", "valences", "valence",
                                       "connected", "closed",     "manifold", "orientable",
                                       "oriented",  "planar",     "convex"};
  return names.at(static_cast<std::size_t>(property));
}

const char* spelling(Verdict verdict) {
  switch (verdict) {
    case Verdict::proven:
      return "proven";
    case Verdict::refuted:
      return "refuted";
    case Verdict::conditional:
      return "conditional";
    case Verdict::undecided:
      return "undecided";
  }
  throw FormatError("a verdict of no kind");
}

const char* spelling(Elementary function) {
  switch (function) {
    case Elementary::exp:
      return "exp";
    case Elementary::log:
      return "log";
    case Elementary::sin:
      return "sin";
    case Elementary::cos:
      return "cos";
    case Elementary::pi:
      return "pi";
    case Elementary::none:
      break;
  }
  throw FormatError("a function of no kind");
}

}  // namespace seam::certificate
