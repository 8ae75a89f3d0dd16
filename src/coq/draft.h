// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "coq/factor.h"
#include "coq/generators.h"

namespace seam::coq {

/// A theorem in the making: what it says, line by line, and how it is proven.
class Draft {
 public:
  Draft(const certificate::Certificate&, std::vector<certificate::Term> terms,
        const std::vector<std::size_t>& generators);

  Formulas& formulas() { return formulas_; }
  const Formulas& formulas() const { return formulas_; }
  Names& names() { return names_; }

  /// One more line of what is said, or of the proof.
  void say(const std::string& line) { statement_ += "  " + line + "\n"; }
  void prove(const std::string& line) { proof_ += "  " + line + "\n"; }
  /// Names for what is said next, in the proof.
  void intro(const std::string& name) { intros_ += " " + name; }
  /// `intros` of all that was named since the last time.
  void prove_intros();

  /// `let n := ... in` for values that are used more than once, as far as they hold only
  /// symbols that have places, or of all.
  void say_shared();
  /// A value with a name: by its formula, and why it is that.
  void define(const std::string& name, const Written& formula, const std::string& proof);

  /// `[named values]` and so on, as the theorems of the library are given them.
  std::string generators() const { return generators_.arguments; }
  std::string roots() const { return generators_.proof; }
  std::string definitions() const;
  std::string named() const;
  std::string defined() const;

  std::string finish(const std::string& name) const;

 private:
  Names names_;
  Formulas formulas_;
  std::vector<certificate::Term> terms_;
  Generators generators_;
  std::string statement_, intros_, proof_;
  struct Definition {
    std::string name, code, proof;
  };
  std::vector<Definition> definitions_;
};

/// `[a; b]`.
std::string list(const std::vector<std::string>&);

}  // namespace seam::coq
