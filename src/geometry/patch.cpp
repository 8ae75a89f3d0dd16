// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/patch.h"

#include <iterator>

#include "exact/contract.h"

namespace seam::geometry {

using exact::require;

Patch::Patch(Shape shape, std::vector<std::vector<Point>> rows)
    : shape_(shape), rows_(std::move(rows)) {
  require(!rows_.empty() && !rows_[0].empty(), "Patch: no control points");
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const std::size_t shorter = shape == Shape::triangle ? j : 0;
    require(rows_[j].size() + shorter == rows_[0].size(), "Patch: a row of the wrong length");
    for (const Point& point : rows_[j])
      require(point.size() == rows_[0][0].size(), "Patch: points of different dimensions");
  }
  require(shape == Shape::square || rows_.size() == rows_[0].size(),
          "Patch: a triangle has as many rows as entries in the first");
}

Patch Patch::triangle(std::vector<std::vector<Point>> rows) {
  return {Shape::triangle, std::move(rows)};
}

Patch Patch::square(std::vector<std::vector<Point>> rows) {
  return {Shape::square, std::move(rows)};
}

int Patch::degree_u() const {
  return static_cast<int>(std::ssize(rows_[0])) - 1;
}

int Patch::degree_v() const {
  return static_cast<int>(std::ssize(rows_)) - 1;
}

int Patch::dimension() const {
  return static_cast<int>(std::ssize(rows_[0][0]));
}

symbolic::Domain domain(const Patch& p, const std::string& u, const std::string& v) {
  if (p.shape() == Patch::Shape::triangle) return {{symbolic::standard_simplex({u, v})}, {}};
  return {{symbolic::interval(u, 0, 1), symbolic::interval(v, 0, 1)}, {}};
}

Patch map(const Patch& p, const std::function<Point(const Point&)>& f) {
  auto rows = p.rows();
  for (auto& row : rows)
    for (Point& point : row) point = f(point);
  return {p.shape(), std::move(rows)};
}

}  // namespace seam::geometry
