// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/mesh_words.h"

namespace seam::claims {
namespace {

using Property = symbolic::Mesh::Property;

std::string multiset(const std::vector<int>& values, const char* what, const char* before,
                     const char* after) {
  std::string result;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2)
    result += (i == 0 ? what : ", ") + std::to_string(values[i + 1]) + " of " + before +
              std::to_string(values[i]) + after;
  return result;
}

std::string property(const symbolic::Mesh& mesh) {
  const std::vector<int>& values = mesh.values;
  switch (mesh.property) {
    case Property::counts:
      return std::to_string(values.at(0)) + " vertices, " + std::to_string(values.at(1)) +
             " edges, " + std::to_string(values.at(2)) + " faces";
    case Property::face_sizes:
      return multiset(values, "faces: ", "", " sides");
    case Property::valences:
      return multiset(values, "vertices: ", "valence ", "");
    case Property::valence:
      return "vertex " + std::to_string(values.at(0) + 1) + " has valence " +
             std::to_string(values.at(1));
    case Property::connected:
      return "connected";
    case Property::closed:
      return "closed";
    case Property::manifold:
      return "a manifold";
    case Property::orientable:
      return "orientable";
    case Property::oriented:
      return "oriented";
    case Property::planar: {
      if (values.empty()) return "all faces are planar";
      std::string faces;
      for (const int f : values) faces += (faces.empty() ? "" : ", ") + std::to_string(f + 1);
      return "planar: face " + faces;
    }
    case Property::convex:
      return "convex";
  }
  return {};
}

}  // namespace

std::string describe_mesh(const symbolic::Mesh& mesh) {
  const std::size_t times = mesh.ratios.size();
  if (times == 0) return property(mesh);
  return property(mesh) + " (truncated " +
         (times == 1 ? "once" : std::to_string(times) + " times") + ")";
}

}  // namespace seam::claims
