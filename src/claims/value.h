// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "claims/scalar.h"
#include "claims/syntax.h"
#include "geometry/surface.h"
#include "symbolic/proposition.h"

namespace seam::claims {

struct Value;

using Vector = std::vector<Scalar>;

/// Rectangular; rows of equal length, at least one.
struct MatrixValue {
  std::vector<Vector> rows;
};

/// `distinct`: the items are tuples of numbers that whoever counts them must prove different.
struct List {
  std::vector<Value> items;
  bool distinct = false;
};

/// A function on the domain of a patch, in the symbols geometry::parameter_u and parameter_v:
/// `D1(p)`, `normal(p)`, `gauss(p)`. One component: a scalar.
struct Field {
  geometry::Patch::Shape shape = geometry::Patch::Shape::triangle;
  std::vector<Scalar> components;
};

/// A function of one parameter: a derivative of a curve, an arbitrary function; in
/// geometry::parameter_u, on [0, 1] or, if not `is_segment`, on the real line.
struct CurveField {
  std::vector<Scalar> components;
  bool is_segment = true;
};

/// One scalar field a patch of a surface.
struct SurfaceField {
  std::vector<Field> fields;
};

/// The largest or least value over all the parts, each a function on a domain.
struct Extremum {
  struct Part {
    Scalar value;
    symbolic::Domain domain;
  };
  bool maximum = true;
  std::vector<Part> parts;
};

/// minimax(E, a, domain): which a makes the largest |E| over the domain least.
struct Minimax {
  std::vector<Extremum::Part> errors;
  std::string unknown;
  std::optional<symbolic::Simplex> range;  ///< of the unknown; none: every real number
};

/// A closed mesh that a parameter stands for, or what truncations make of it: how many
/// vertices, edges, faces it has, and what is known of it.
struct AnyMesh {
  Scalar vertices, edges, faces;
  bool planar = false;
  bool trivalent = false;
};

/// `truncate(M, r, k)` for every integer k from some one on: truncated `least` times or more,
/// which is the case where `parameter` is `first` or more.
struct IteratedMesh {
  std::variant<geometry::Mesh, AnyMesh> mesh;
  Formula ratio;
  long least = 0;
  std::string parameter;
  long first = 0;
};

struct Plane {
  Vector normal;
  Scalar offset;
};

/// The word `triangle`, `square`, `simplex(n)`, `interior(triangle)` as a value.
struct Region {
  bool square = false;
  int dimension = 2;
  bool interior = false;
};

/// `let f(x) = ...` or `define f(x): ...`, or a builtin called without arguments yet.
struct Function {
  const Item* item = nullptr;
};

struct Value {
  std::variant<Scalar, Vector, MatrixValue, List, geometry::Curve, geometry::Patch, Field,
               CurveField, SurfaceField, geometry::Mesh, AnyMesh, IteratedMesh,
               geometry::Surface, Extremum, Minimax, Plane, Region, Function>
      content;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&content);
  }
};

/// `a number`, `a vector of 3`, `a triangle patch of degree 3`: for messages.
std::string description(const Value&);

}  // namespace seam::claims
