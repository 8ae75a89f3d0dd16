// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <unordered_map>

#include "exact/elementary.h"
#include "exact/roots.h"
#include "symbolic/expand.h"
#include "symbolic/numbers.h"

namespace seam::symbolic {

/// All generators, and the fields that were asked for, by the indices of their generators.
struct Numbers::Forest {
  using Support = std::vector<std::size_t>;  ///< ascending, closed under "is defined by"
  struct Grown {
    Field field;
    std::vector<exact::Applied> values;    ///< of the transcendental numbers
    std::unique_ptr<Expansion> expansion;  ///< in these, over the tower
  };
  std::vector<Generator> generators;
  std::vector<Support> supports;  ///< of each generator, itself the last
  std::map<std::string, std::size_t> index;
  std::map<Support, Grown> fields;
  std::map<std::pair<int, std::string>, Formula> roots;  ///< by index and radicand
  std::map<std::string, Formula> cosines;                ///< of pi times the key
  std::unordered_map<const void*, std::pair<Formula, Support>> known_supports;

  const Support& support(const Formula&);
  const Grown& grown(const Support&);
  const Grown& field_of(const Formula& f) { return grown(support(f)); }
  exact::Polynomial number(const Formula& f) { return (*field_of(f).expansion)(f); }
  /// In the ring of its field; throws `NumberLimit` if it is not seen to be algebraic.
  exact::Polynomial algebraic(const Formula&);
  /// Throws `NumberLimit` where no precision tried tells it from 0.
  exact::Sign sign(const Formula&);
  /// Nothing where this precision is too low.
  std::optional<exact::Enclosure> enclosure(const Formula&, long bits);

  void extend(Grown&, const Generator&);
  Formula add(Generator, const Formula& over);  ///< the symbol of a new generator
  Formula root_of(const Grown&, const exact::Univariate& squarefree, exact::RootInterval where);
  Formula power_root(const Grown&, const exact::Polynomial& radicand, int n);
  Formula quadratic_root(const Grown&, const exact::Univariate& irreducible,
                         exact::RootInterval where);
  std::string unused(const std::string& name) const;
};

/// All indices of either, ascending.
std::vector<std::size_t> united(const std::vector<std::size_t>&,
                                const std::vector<std::size_t>&);

constexpr int max_degree = 64;   ///< of a field
constexpr int max_search = 160;  ///< of the norm of a polynomial that is to be factored
/// Beyond this many bits a transcendental number is not looked at.
constexpr long max_precision = 1 << 16;

/// Throws `NumberLimit` where a field of this degree over that of the ring would be too large.
void require_small(const exact::RingPtr&, int degree, int most = max_degree);

}  // namespace seam::symbolic
