// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "claims/evaluate.h"

namespace seam::claims {

/// A call of a function that the language brings along: its arguments, not evaluated yet.
struct Call {
  Evaluator& evaluator;
  const Expression& at;
  const Scope& scope;

  std::size_t count() const { return at.children.size() - 1; }
  const Expression& operator[](std::size_t i) const { return at.children[i + 1]; }
  Value value(std::size_t i) const { return evaluator.evaluate((*this)[i], scope); }
  Formula number(std::size_t i) const { return evaluator.number((*this)[i], scope); }
  long integer(std::size_t i) const { return evaluator.integer((*this)[i], scope); }
  Vector vector(std::size_t i) const { return as_vector(evaluator, value(i), (*this)[i]); }

  /// The argument as a T, or an error that says what was expected.
  template <class T>
  T get(std::size_t i, const char* what) const {
    const Value v = value(i);
    if (const T* found = v.as<T>()) return *found;
    fail((*this)[i], std::string("expected ") + what + ", found " + description(v));
  }
};

struct Builtin {
  int least, most;  ///< number of arguments; most < 0: any number
  Value (*apply)(const Call&);
};
using Builtins = std::map<std::string, Builtin>;

const Builtins& number_builtins();       ///< sqrt abs sum product count binomial …
const Builtins& elementary_builtins();   ///< exp log sin cos tan limit
const Builtins& function_builtins();     ///< diff subst numerator denominator
const Builtins& coefficient_builtins();  ///< degree coefficients bernstein
const Builtins& vector_builtins();       ///< dot cross det norm2 …
const Builtins& patch_builtins();        ///< D1 D2 normal gauss control edge …
const Builtins& solid_builtins();        ///< faces dual rotations orbit surface …
const Builtins& mesh_builtins();         ///< mesh truncate counts valences …
const Builtins& extremum_builtins();     ///< max min argmax argmin
const Builtins& minimax_builtins();      ///< minimax
const Builtins& spline_builtins();       ///< blending tensor

/// Surfaces and solids live in space, and their points are numbers: an error at `at`, or
/// `Unsupported`, where they would not.
geometry::Surface glue(std::vector<geometry::Patch>, const Expression& at, const Numbers&);
geometry::Mesh solid(geometry::Mesh, const Expression& at);
/// An error at `at` where a face has less than three corners.
void require_faces(const geometry::Mesh&, const Expression& at);
void require_in_space(const symbolic::Point&, const Expression& at, const char* what);

/// A value given by an `each` argument (`sum(E for i in R)`) or by a list: its items.
std::vector<Value> items_of_argument(const Call&);

/// A function on a patch as the part of an extremum.
Extremum::Part part_of(const Field&, const Expression& at);

/// The closed, bounded set that the first so many bindings of `E for …` range over; their names
/// join the scope.
symbolic::Domain bound_domain(const Call&, std::size_t bindings, Scope&);
/// Closed and bounded.
bool is_compact(const symbolic::Domain&);

/// The largest (least) of some numbers, resting on the comparison with each of the others.
Formula greatest(Evaluator&, const std::vector<Formula>&, bool maximum);

}  // namespace seam::claims
