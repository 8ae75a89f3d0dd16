// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/mesh.h"

#include <algorithm>
#include <array>
#include <utility>

// Truncation keeps an oriented manifold one. The side i from a to b gives the cut i near a, its
// mate the cut near b. A new face of an old one passes the edges (cut i, cut mate(i)), in the
// sense of side i, and (cut mate(i), cut next(i)); the face at a vertex passes the latter the
// other way: from cut j it goes to cut mate(previous(j)). So each new edge is passed once in
// either sense. Points are multiplied by the denominator of the ratio, all of them alike.

namespace seam::check {

constexpr std::size_t most_sides = 1'000'000;

std::string numbered(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index + 1);
}

Sides::Sides(const Mesh& mesh, Meter& meter) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& corners = mesh.faces[f];
    meter.charge(corners.size());
    const std::size_t first = start.size();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      start.push_back(corners[k]);
      end.push_back(corners[(k + 1) % corners.size()]);
      face.push_back(f);
      next.push_back(first + (k + 1) % corners.size());
      previous.push_back(first + (k + corners.size() - 1) % corners.size());
    }
  }
  struct OfEdge {
    std::size_t low, high, side;
    auto operator<=>(const OfEdge&) const = default;
  };
  std::vector<OfEdge> by_edge;
  for (std::size_t s = 0; s < count(); ++s)
    by_edge.push_back({std::min(start[s], end[s]), std::max(start[s], end[s]), s});
  meter.charge(16 * by_edge.size());
  std::ranges::sort(by_edge);
  mate.assign(count(), none);
  for (std::size_t i = 0; i < by_edge.size(); ++edges) {
    std::size_t j = i;
    while (j < by_edge.size() && by_edge[j].low == by_edge[i].low &&
           by_edge[j].high == by_edge[i].high)
      ++j;
    most_of_an_edge = std::max(most_of_an_edge, j - i);
    if (j - i == 2) {
      mate[by_edge[i].side] = by_edge[i + 1].side;
      mate[by_edge[i + 1].side] = by_edge[i].side;
    }
    i = j;
  }
}

std::vector<std::size_t> valences(const Mesh& mesh, const Sides& sides) {
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t s = 0; s < sides.count(); ++s) {
    ends.push_back({sides.start[s], sides.end[s]});
    ends.push_back({sides.end[s], sides.start[s]});
  }
  std::ranges::sort(ends);
  const auto repeated = std::ranges::unique(ends);
  ends.erase(repeated.begin(), repeated.end());
  std::vector<std::size_t> result(mesh.vertices, 0);
  for (const auto& edge : ends) ++result[edge[0]];
  return result;
}

Coordinates difference(Ring& ring, const Coordinates& a, const Coordinates& b) {
  Coordinates result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(ring.difference(a[i], b[i]));
  return result;
}

Coordinates cross(Ring& ring, const Coordinates& a, const Coordinates& b) {
  Coordinates result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result.push_back(ring.difference(ring.product(a[j], b[k]), ring.product(a[k], b[j])));
  }
  return result;
}

Polynomial dot(Ring& ring, const Coordinates& a, const Coordinates& b) {
  Polynomial total;
  for (std::size_t i = 0; i < a.size(); ++i)
    total = ring.sum(std::move(total), ring.product(a[i], b[i]));
  return total;
}

namespace {

// (1 - ratio) a + ratio b, times the denominator of the ratio.
Coordinates cut(Ring& ring, const Polynomial& near, const Polynomial& far, const Coordinates& a,
                const Coordinates& b) {
  Coordinates result;
  for (std::size_t i = 0; i < a.size(); ++i)
    result.push_back(ring.sum(ring.product(near, a[i]), ring.product(far, b[i])));
  return result;
}

Mesh truncated(Context& context, const Mesh& mesh, Polynomial ratio) {
  Ring& ring = context.ring();
  const Polynomial half = constant(1, 2);
  demand(
      context.tower().sign(ratio) > 0 && context.tower().sign(ring.difference(half, ratio)) > 0,
      "degenerate: a ratio of truncation is not between 0 and 1/2");
  const Sides sides(mesh, context.meter());
  demand(not_oriented(sides).empty() && not_manifold(mesh, sides, context.meter()).empty(),
         "degenerate: what is truncated is no oriented manifold");

  demand(sides.count() <= most_sides, "effort");
  Mesh result{sides.count(), {}, {}, mesh.faces.size()};
  context.meter().charge(8 * sides.count());
  if (!mesh.points.empty()) {
    const Polynomial whole = constant(std::exchange(ratio.denominator, 1));
    const Polynomial near = ring.difference(whole, ratio);
    for (std::size_t s = 0; s < sides.count(); ++s)
      result.points.push_back(
          cut(ring, near, ratio, mesh.points[sides.start[s]], mesh.points[sides.end[s]]));
  }
  std::size_t s = 0;
  for (const auto& corners : mesh.faces) {
    auto& face = result.faces.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k, ++s) {
      face.push_back(s);
      face.push_back(sides.mate[s]);
    }
  }
  std::vector<std::size_t> leaving(mesh.vertices, Sides::none);
  for (std::size_t i = sides.count(); i-- > 0;) leaving[sides.start[i]] = i;
  for (const std::size_t first : leaving) {
    auto& face = result.faces.emplace_back();
    std::size_t i = first;
    do {
      face.push_back(i);
      i = sides.mate[sides.previous[i]];
    } while (i != first);
    demand(face.size() >= 3, "degenerate: a vertex that is cut off is on two faces only");
  }
  return result;
}

}  // namespace

Mesh make_mesh(Context& context, const certificate::Mesh& stated) {
  demand(!stated.faces.empty(), "degenerate: a mesh without faces");
  demand(std::cmp_less_equal(stated.vertices, most_sides), "effort");
  context.meter().charge(static_cast<std::size_t>(stated.vertices));
  Mesh mesh;
  mesh.vertices = static_cast<std::size_t>(stated.vertices);
  Integer common = 1;
  using Property = certificate::Mesh::Property;
  const bool has_points =
      stated.property == Property::planar || stated.property == Property::convex;
  for (const auto& terms : has_points ? stated.points : decltype(stated.points)()) {
    Coordinates& point = mesh.points.emplace_back();
    for (const certificate::Term term : terms) {
      point.push_back(context.number(term));
      common = lcm(common, point.back().denominator);
    }
  }
  for (Coordinates& point : mesh.points)
    for (Polynomial& x : point) x = context.ring().product(x, constant(common));
  for (const auto& corners : stated.faces)
    mesh.faces.emplace_back(corners.begin(), corners.end());
  for (const certificate::Term ratio : stated.ratios)
    mesh = truncated(context, mesh, context.number(ratio));
  return mesh;
}

}  // namespace seam::check
