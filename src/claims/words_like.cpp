// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/mutants_of_node.h"

namespace seam::claims {

std::vector<std::string> words_like(const std::string& word) {
  static const std::vector<std::vector<std::string>> families = {
      {"sin", "cos", "exp"},
      {"sqrt", "cbrt", "abs"},
      {"floor", "ceil"},
      {"max", "min"},
      {"argmax", "argmin"},
      {"sum", "product"},
      {"norm", "norm2"},
      {"transpose", "inverse"},
      {"rows", "columns"},
      {"numerator", "denominator"},
      {"D1", "D2"},
      {"G0", "G1", "G2"},
      {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"},
      {"rotations", "symmetries"},
      {"vertices", "edges", "faces"},
      {"patches", "seams", "corners"},
      {"face_sizes", "valences"},
      {"elevate", "swap"},
      {"triangle", "square"},
      {"ruled", "cylindrical", "developable", "regular"},
      {"similar", "congruent"},
      {"planar", "trivalent", "convex", "closed"},
      {"manifold", "orientable", "oriented"},
  };
  for (const auto& family : families) {
    if (std::ranges::find(family, word) == family.end()) continue;
    std::vector<std::string> others;
    std::ranges::copy_if(family, std::back_inserter(others),
                         [&](const std::string& other) { return other != word; });
    return others;
  }
  return {};
}

}  // namespace seam::claims
