// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>

#include "check/mesh.h"

// The corners of a face are in one plane if all differences from one of them are at right
// angles to the cross product, not 0, of two of them; or if no two have such a product: then
// they are on one line.
//
// Convexity. Let c be the mean of the vertices; what follows looks at the mesh from c. The mesh
// is a connected oriented manifold with plane faces. Divide each face into triangles from its
// first corner. It is verified that
//   1. c is strictly below each triangle: det(p, q, r) > 0 for its corners;
//   2. across each edge of the mesh the triangle on the other side has its third corner
//      strictly below the plane of this one;
//   3. the ray from c through the centre of the first triangle meets no other triangle;
//   4. each vertex is on three faces at least.
// By 1 the projection from c to a sphere is one-to-one and keeps the orientation on each
// triangle. So it is a branched covering of the sphere, of as many sheets as triangles meet a
// ray in general position, by 3 one; hence one-to-one, and the mesh bounds a body that is
// star-shaped about c. Let g be the function that is 1 on the mesh and linear on each ray from
// c; it is linear on the cone over each triangle. By 2, and since triangles of one face agree,
// g is convex across each wall between two cones; so it is convex along each line that meets no
// cone over a vertex, and by continuity along each line. The body is g <= 1: convex. By 2 its
// facets are the faces. A point on three facets is a vertex, by 4.
// A mesh that is seen clockwise is turned over first: points x become -x.
// Conversely, of a convex polyhedron with these faces and vertices 1 to 4 are true: c is
// inside.

namespace seam::check {
namespace {

bool is_zero(Context& context, const Polynomial& x) {
  return x.is_zero() || context.tower().sign(x) == 0;
}

bool is_zero(Context& context, const Coordinates& v) {
  for (const Polynomial& x : v)
    if (!is_zero(context, x)) return false;
  return true;
}

struct Triangle {
  Coordinates p, q, r, normal;  // (q - p) x (r - p)
};

class SeenFromInside {
 public:
  SeenFromInside(Context& context, const Mesh& mesh) : context_(context), mesh_(mesh) {
    Ring& ring = context_.ring();
    Coordinates sum(3);
    for (const Coordinates& point : mesh.points)
      for (std::size_t i = 0; i < 3; ++i) sum[i] = ring.sum(std::move(sum[i]), point[i]);
    const Polynomial count = constant(Integer(mesh.vertices));
    for (const Coordinates& point : mesh.points) {
      Coordinates& seen = points_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        seen.push_back(ring.difference(ring.product(count, point[i]), sum[i]));
    }
    const auto& first = mesh.faces[0];
    if (sign(points_[first[0]], cross(ring, points_[first[1]], points_[first[2]])) < 0)
      for (Coordinates& seen : points_)
        for (Polynomial& x : seen) x = negated(std::move(x));
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      first_.push_back(triangles_.size());
      const auto& corners = mesh.faces[f];
      for (std::size_t k = 2; k < corners.size(); ++k) {
        Triangle t{points_[corners[0]], points_[corners[k - 1]], points_[corners[k]], {}};
        t.normal = cross(ring, difference(ring, t.q, t.p), difference(ring, t.r, t.p));
        triangles_.push_back(std::move(t));
        face_.push_back(f);
      }
    }
  }

  std::string not_outward() {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (sign(triangles_[t].normal, triangles_[t].p) <= 0)
        return numbered("face", face_[t]) +
               " is not turned as face 1 is, seen from the mean of the vertices";
    return {};
  }

  std::string not_locally_convex(const Sides& sides) {
    std::size_t s = 0;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      for (std::size_t k = 0; k < mesh_.faces[f].size(); ++k, ++s) {
        const std::size_t other = sides.mate[s];
        const Triangle& t = triangles_[at_side(f, k)];
        const Coordinates& beyond = points_[third_corner(sides, other)];
        if (sign(t.normal, difference(context_.ring(), beyond, t.p)) >= 0)
          return "at the edge from " + numbered("vertex", sides.start[s]) + " to " +
                 numbered("vertex", sides.end[s]);
      }
    return {};
  }

  std::string not_once_around() {
    Ring& ring = context_.ring();
    Coordinates ray = triangles_[0].p;
    for (const Coordinates* corner : {&triangles_[0].q, &triangles_[0].r})
      for (std::size_t i = 0; i < 3; ++i) ray[i] = ring.sum(std::move(ray[i]), (*corner)[i]);
    const auto is_left = [&](const Coordinates& a, const Coordinates& b) {
      return sign(cross(ring, a, b), ray) >= 0;
    };
    for (std::size_t t = 1; t < triangles_.size(); ++t) {
      const auto& [p, q, r, normal] = triangles_[t];
      if (is_left(p, q) && is_left(q, r) && is_left(r, p))
        return numbered("face", face_[t]) +
               " covers face 1, seen from the mean of the vertices";
    }
    return {};
  }

 private:
  int sign(const Coordinates& a, const Coordinates& b) {
    return context_.tower().sign(dot(context_.ring(), a, b));
  }
  // The triangle at side k of a face, and the corner of that triangle that is not on the side.
  std::size_t at_side(std::size_t face, std::size_t k) const {
    const std::size_t last = mesh_.faces[face].size() - 3;
    return first_[face] + std::min(k == 0 ? 0 : k - 1, last);
  }
  std::size_t third_corner(const Sides& sides, std::size_t side) const {
    const std::size_t first = mesh_.faces[sides.face[side]][0];
    if (sides.start[side] == first) return sides.end[sides.next[side]];
    if (sides.end[side] == first) return sides.start[sides.previous[side]];
    return first;
  }

  Context& context_;
  const Mesh& mesh_;
  std::vector<Coordinates> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> first_, face_;  // triangle of a face, face of a triangle
};

}  // namespace

std::string not_planar(Context& context, const Mesh& mesh, std::size_t face) {
  demand(!mesh.points.empty(), "degenerate: vertices without coordinates");
  Ring& ring = context.ring();
  std::vector<Coordinates> from_first;
  for (const std::size_t corner : mesh.faces[face])
    from_first.push_back(
        difference(ring, mesh.points[corner], mesh.points[mesh.faces[face][0]]));
  const Coordinates* direction = nullptr;
  Coordinates normal;
  for (const Coordinates& d : from_first) {
    if (!normal.empty()) {
      if (!is_zero(context, dot(ring, normal, d)))
        return numbered("face", face) +
               (face < mesh.first_cut
                    ? " is not planar"
                    : ", which cuts off " + numbered("vertex", face - mesh.first_cut) +
                          ", is not planar");
    } else if (!direction) {
      if (!is_zero(context, d)) direction = &d;
    } else if (Coordinates n = cross(ring, *direction, d); !is_zero(context, n)) {
      normal = std::move(n);
    }
  }
  return {};
}

std::string not_convex(Context& context, const Mesh& mesh) {
  const Sides sides(mesh, context.meter());
  if (mesh.faces.empty()) return "there is no face";
  if (std::string no = not_manifold(mesh, sides, context.meter()); !no.empty()) return no;
  if (std::string no = not_oriented(sides); !no.empty()) return no;
  if (std::string no = not_connected(mesh, sides, context.meter()); !no.empty()) return no;
  const auto edges = valences(mesh, sides);
  for (std::size_t v = 0; v < mesh.vertices; ++v)
    if (edges[v] < 3) return numbered("vertex", v) + " is on two faces only";
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (std::string no = not_planar(context, mesh, f); !no.empty()) return no;
  SeenFromInside seen(context, mesh);
  if (std::string no = seen.not_outward(); !no.empty()) return no;
  if (std::string no = seen.not_locally_convex(sides); !no.empty()) return no;
  return seen.not_once_around();
}

}  // namespace seam::check
