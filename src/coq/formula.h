// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "certificate/evidence.h"
#include "coq/names.h"

namespace seam::coq {

/// A formula twice: as a term of Coq's real numbers, and as the `expr` whose `eval` is that
/// very term.
struct Written {
  /// How tightly the text binds.
  enum class Level { sum, product, power, atom };
  std::string text, code;
  Level level = Level::atom;
};

/// Text that can stand as an operand of `^`, or as an argument.
std::string in_brackets(const Written&);

Written sum(const Written&, const Written&);
Written difference(const Written&, const Written&);
Written product(const Written&, const Written&);
/// An integer or a fraction, as a certificate writes it.
Written constant(const std::string& rational);

/// The formulas of a certificate, for one theorem. A value that is used more than once gets a
/// name, so that the text is no longer than the certificate.
class Formulas {
 public:
  explicit Formulas(const certificate::Certificate&);

  /// What stands in these terms: the symbols.
  std::set<std::string> symbols(const std::vector<certificate::Term>&) const;
  /// The nodes below these terms that a name shortens the text by, operands first.
  std::vector<certificate::Term> shared(const std::vector<certificate::Term>&) const;

  /// A symbol or a value with this name has this place among the values of `eval`.
  void place(const std::string& symbol, const std::string& name);
  void place(certificate::Term value, const std::string& name);
  /// A barycentric coordinate.
  void place_coordinate(const std::string& name);

  /// A symbol, a coordinate that has a place.
  Written of(const std::string& symbol) const { return symbols_.at(symbol); }
  Written coordinate(const std::string& name) const { return coordinates_.at(name); }
  bool is_constant(certificate::Term) const;

  /// The formula; a value with a name is written by it.
  Written write(certificate::Term) const;
  /// The formula by which a value with a name is defined.
  Written write_definition(certificate::Term) const;

 private:
  const certificate::Node& node(certificate::Term) const;
  Written write_node(const certificate::Node&) const;
  bool is_short(certificate::Term) const;

  const certificate::Certificate& certificate_;
  Written next_place(const std::string& name);

  std::map<std::string, Written> symbols_, coordinates_;
  std::map<certificate::Term, Written> values_;
  int size_ = 0;
};

}  // namespace seam::coq
