// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/matrix.h"
#include "geometry/vector.h"
#include "symbolic/formula.h"
#include "symbolic/proposition.h"

namespace seam::geometry {

/// The names of the two parameters of a patch inside formulas of this module. They hold a
/// character that no .seam name can, so they never meet a user's symbol.
inline const std::string parameter_u = "u~", parameter_v = "v~";

/// A Bézier curve of degree n: control points P0 .. Pn.
struct Curve {
  std::vector<Point> control;
  int degree() const { return static_cast<int>(control.size()) - 1; }
};

/// A polynomial patch in Bernstein-Bézier form, on the triangle u, v >= 0, u + v <= 1 or on the
/// unit square. Coordinates are formulas: numbers, or with parameters in them. All control
/// points have one dimension.
class Patch {
 public:
  enum class Shape { triangle, square };

  /// Row j, entry i belongs to u^i v^j; row j of a triangle of degree n has n + 1 - j
  /// entries, every row of a square has m + 1.
  static Patch triangle(std::vector<std::vector<Point>> rows);
  static Patch square(std::vector<std::vector<Point>> rows);
  Patch(Shape shape, std::vector<std::vector<Point>> rows);

  Shape shape() const { return shape_; }
  int degree_u() const;   ///< triangle: the total degree
  int degree_v() const;   ///< triangle: the total degree
  int dimension() const;  ///< of the space
  const std::vector<std::vector<Point>>& rows() const { return rows_; }
  const Point& control(int i, int j) const { return rows_[j][i]; }

  int sides() const { return shape_ == Shape::triangle ? 3 : 4; }  ///< as many as corners

 private:
  Shape shape_;
  std::vector<std::vector<Point>> rows_;
};

/// p(u, v), one formula a coordinate, unexpanded.
Point evaluate(const Patch&, const Formula& u, const Formula& v);
Point evaluate(const Curve&, const Formula& u);

/// The partial derivative d^(i+j) p / du^i dv^j, as a patch of its own (of lower degree, of
/// vectors), formed from differences of control points; and its value at (u, v).
Patch derivative(const Patch&, int i, int j);
Curve derivative(const Curve&, int order);
Point derivative(const Patch&, int i, int j, const Formula& u, const Formula& v);
Point derivative(const Curve&, int order, const Formula& u);

/// D1 x D2, not normalised. Dimension 3.
Point normal(const Patch&, const Formula& u, const Formula& v);

/// The domain in these variables.
symbolic::Domain domain(const Patch&, const std::string& u, const std::string& v);

/// Side k = 1, 2, 3 (, 4): v = 0, u = 0, then w = 0 on a triangle, v = 1, u = 1 on a square. As
/// the curve that runs with the growing parameter (w = 0: from (1,0) to (0,1)).
Curve edge(const Patch&, int k);

/// The corners from which and to which side k runs. Corners are numbered from 0, round the
/// domain: (0,0), (1,0), (0,1) of a triangle, (0,0), (1,0), (1,1), (0,1) of a square.
struct Ends {
  int from = 0, to = 0;
};
Ends ends(Patch::Shape, int k);
const Point& corner(const Patch&, int number);

/// The same surface with another choice of parameters: side k becomes v = 0, run through by u
/// from 0 to 1, backwards if `reversed`; the patch lies at v > 0. All k and both directions:
/// all symmetries of the domain (6 of the triangle, 8 of the square), each once.
Patch along(const Patch&, int k, bool reversed);

Patch swap(const Patch&);  ///< u and v exchanged  NOLINT(bugprone-exception-escape)

/// The same curve or surface, every degree raised by one.
Patch elevate(const Patch&);
Curve elevate(const Curve&);
/// Raised to this degree (on a square: both degrees), not below the one it has.
Patch elevate(const Patch&, int degree);
Curve elevate(const Curve&, int degree);

/// f applied to every control point.
Patch map(const Patch&, const std::function<Point(const Point&)>& f);

}  // namespace seam::geometry
