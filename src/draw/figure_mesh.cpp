// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "draw/figure_parts.h"

// A face is cut into triangles by taking ears off: corners that turn the way the face does and
// whose triangle holds no other corner. A plane face without self-intersections always has one;
// of any other the next corner is taken.

namespace seam::draw {
namespace {

using report::FigureRun;
using Line = FigureRun::Line;

// Newell's: of any polygon, plane or not.
Vector area(const std::vector<Vector>& polygon) {
  Vector result{};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    result = result + cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return result;
}

bool is_ear(const std::vector<Vector>& polygon, std::size_t at, const Vector& normal) {
  const std::size_t n = polygon.size();
  const Vector &a = polygon[(at + n - 1) % n], &b = polygon[at], &c = polygon[(at + 1) % n];
  const auto left_of = [&](const Vector& from, const Vector& to, const Vector& x) {
    return dot(cross(to - from, x - from), normal) > 0;
  };
  if (!left_of(a, b, c)) return false;
  for (const Vector& x : polygon)
    if (x != a && x != b && x != c && left_of(a, b, x) && left_of(b, c, x) && left_of(c, a, x))
      return false;
  return true;
}

std::vector<std::array<int, 3>> triangulated(std::vector<Vector> polygon,
                                             const Vector& normal) {
  std::vector<int> corners(polygon.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<int>(i);
  std::vector<std::array<int, 3>> result;
  while (corners.size() >= 3) {
    const std::size_t n = corners.size();
    std::size_t ear = 0;
    while (ear < n && !is_ear(polygon, ear, normal)) ++ear;
    if (ear == n) ear = 0;
    result.push_back({corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(ear));
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return result;
}

}  // namespace

void add_mesh(FigureRun& figure, const geometry::Mesh& mesh, const symbolic::Numbers& numbers) {
  std::vector<Vector> vertices;
  for (const geometry::Point& vertex : mesh.vertices) {
    vertices.emplace_back();
    for (std::size_t i = 0; i < vertex.size() && i < 3; ++i)
      vertices.back()[i] = numbers.approximate(vertex[i]);
  }

  Facets facets(figure);
  struct Side {
    int face;
    bool rising;  ///< from the vertex of the lower number to the other
  };
  std::map<std::pair<int, int>, std::vector<Side>> sides;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    std::vector<Vector> polygon;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[(i + 1) % face.size()];
      polygon.push_back(vertices[from]);
      sides[std::minmax(from, to)].push_back({static_cast<int>(f), from < to});
    }
    facets.begin_face();
    const Vector normal = area(polygon);
    std::vector<int> points;
    for (const Vector& corner : polygon) points.push_back(facets.point(corner, normal));
    if (figure.coloured_by == "corners")
      figure.values.insert(figure.values.end(), polygon.size(),
                           static_cast<double>(polygon.size()));
    for (const auto& [a, b, c] : triangulated(polygon, normal))
      facets.triangle(points[a], points[b], points[c]);
  }

  std::vector<Neighbours> neighbours;
  std::vector<bool> has_free_edge(mesh.faces.size());
  for (const auto& [ends, at] : sides) {
    figure.lines.push_back({Line::Kind::edge, {vertices[ends.first], vertices[ends.second]}});
    if (at.size() == 1) has_free_edge[at[0].face] = true;
    for (std::size_t i = 1; i < at.size(); ++i)
      neighbours.push_back({at[0].face, at[i].face, at[0].rising != at[i].rising});
  }
  facets.turn(neighbours, has_free_edge);
}

}  // namespace seam::draw
