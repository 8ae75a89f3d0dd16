// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "claims/printer.h"

namespace seam::claims {

/// Mathematics, and how tightly it binds as typeset: a fraction needs no parentheses in a
/// product.
struct Typeset {
  std::string tex;
  Level level = Level::callable;
};

/// `row`: a vector stands in a row, not as a column; so it does inside lists and nets.
Typeset typeset(const Expression&, bool row = false);

/// For a place that wants at least this level: in parentheses if it binds looser.
std::string typeset(const Expression&, Level wanted, bool row = false);

/// A statement, a binding, or what stands in front of `for`.
Typeset typeset_statement(const Expression&);

/// A call of a function that has a notation of its own: a root, a norm, a sum ...; else empty.
Typeset typeset_function(const Expression& call);

/// `u \in [0, 1]`
std::string typeset_binding(const Expression& binding);

/// Between brackets that grow with what stands in them, unless that is long: lines must break
/// there.
std::string fenced(const std::string& open, const std::string& body, const std::string& close);

/// Separated by commas, where lines may break.
std::string typeset_list(const std::vector<Expression>&, std::size_t first, bool row);

/// The mathematics of an expression, or its source where TeX would give up on so deep a nest.
std::string shallow(const std::string& tex, const Expression&);

}  // namespace seam::claims
