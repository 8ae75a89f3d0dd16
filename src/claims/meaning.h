// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "claims/export.h"
#include "claims/limits.h"
#include "claims/syntax.h"
#include "claims/value.h"

namespace seam::claims {

/// A statement as obligations, or why there are none for it.
struct Lowered {
  std::optional<Exported> exported;
  std::string unsupported;             ///< a sentence
  std::string reason = "unsupported";  ///< with that: `unsupported`, `time` or `memory`
  std::set<std::string> predicates;
};

struct MeantClaim {
  Claim claim;  ///< as written; a table cell: made from its row
  std::vector<std::string> comments;
  text::Span span;
  Lowered printed;
  std::optional<Lowered> corrected;

  /// Of a table cell: the right side of its comparison.
  const Expression& printed_value() const {
    const Expression& e = claim.statement;
    return e.kind == Expression::Kind::truncated ? e.children[0].children[1] : e.children[1];
  }
};

struct MeantTable {
  struct Row {
    std::string label;
    Expression value;
    std::vector<MeantClaim> cells;
  };
  Claim heading;
  std::vector<std::string> comments, labels;
  std::vector<Row> rows;
};

/// The decimal and the closed form are what the statement says of the value, for the checker to
/// confirm. Of an extremum `enclosure` says the decimal alone, without the place where it is
/// attained; where `statement` cannot be confirmed, perhaps that can.
struct MeantAsk {
  std::string id;
  Expression expression;
  std::string decimal, closed_form;
  Lowered statement;
  std::optional<Lowered> enclosure;
};

/// What a picture shows. Nothing in it is decided.
struct MeantFigure {
  /// Functions on a domain of one or two bounded variables. One component: a graph.
  struct Functions {
    std::vector<symbolic::Simplex> domain;  ///< intervals, or one triangle
    std::vector<Vector> functions;
  };
  struct Colour {
    std::string text, latex;  ///< as written: `gauss`
    /// None: the word says all. One, or one a patch or function: in the parameters of
    /// geometry, the variables of the domain, and `position`.
    std::vector<Formula> formulas = {};
    std::vector<std::string> position = {};  ///< the symbols of x, y, z
  };
  std::string id, title, at;
  std::vector<Value> values;                     ///< patches, surfaces, meshes, curves
  std::map<std::string, geometry::Patch> named;  ///< those shown that have names in the file
  std::optional<Functions> functions;
  std::optional<Colour> colour;
  std::vector<std::string> with;  ///< `net`, `curvature_lines`, `contours`
  std::string unsupported;        ///< why there is nothing to draw; empty: there is
};

struct MeantSection {
  std::string title;
};

/// A definition, param or root, as written.
struct MeantDefinition {
  Item item;
};

using MeantItem =
    std::variant<MeantSection, MeantDefinition, MeantClaim, MeantTable, MeantFigure, MeantAsk>;

/// What a file says: its claims as obligations, in file order. If `errors` is not empty the
/// rest is what could still be read.
struct Meaning {
  std::string paper, by, source, year;
  std::vector<MeantItem> items;
  std::vector<text::Diagnostic> errors;
  std::shared_ptr<Numbers> numbers;
};

/// Opens a file named by an `include`, relative to the folder of the including file; nothing if
/// it must not or cannot be read.
using Opener = std::function<std::shared_ptr<const text::Source>(const std::string& path)>;

Meaning mean(const File&, const Opener&, const Limits& = no_limits);

/// A question that is not in a file: what `seamproof ask FILE 'EXPR'` wants, in the scope of
/// all its definitions.
MeantAsk mean_question(const File&, const Opener&, const Expression&, int digits,
                       std::vector<text::Diagnostic>& errors, const Limits& = no_limits);

}  // namespace seam::claims
