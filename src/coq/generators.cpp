// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/generators.h"

#include <algorithm>

// A generator that the statement names but the theorem does not need is left out: what is said
// of all numbers that it could be is then said without it.

namespace seam::coq {

using certificate::Certificate;
using certificate::Generator;

std::optional<std::vector<std::size_t>> generators_among(const std::set<std::string>& symbols,
                                                         const Certificate& certificate,
                                                         const Formulas& formulas) {
  const auto& generators = certificate.statement.generators;
  for (const Generator& generator : certificate.evidence.generators)
    if (symbols.contains(generator.name)) return std::nullopt;
  std::set<std::string> needed = symbols;
  std::vector<std::size_t> found;
  for (std::size_t i = generators.size(); i-- > 0;) {
    if (!needed.contains(generators[i].name)) continue;
    if (generators[i].function != certificate::Elementary::none) return std::nullopt;
    needed.merge(formulas.symbols({generators[i].polynomial}));
    found.push_back(i);
  }
  std::ranges::reverse(found);
  return found;
}

Generators write_generators(const std::vector<std::size_t>& which,
                            const Certificate& certificate, Formulas& formulas, Names& names) {
  Generators result;
  std::string codes, reals;
  result.proof = "I";
  for (const std::size_t i : which) {
    const Generator& generator = certificate.statement.generators[i];
    const std::string name = names.of(generator.name);
    const std::string interval = names.fresh(name + "_interval");
    const std::string root = names.fresh(name + "_root");
    formulas.place(generator.name, name);
    const Written low = constant(generator.low), high = constant(generator.high);
    const Written polynomial = formulas.write(generator.polynomial);
    result.quantified += "forall " + name + " : R, " + low.text + " <= " + name +
                         " <= " + high.text + " -> " + polynomial.text + " = 0 ->\n";
    result.intros += " " + name + " " + interval + " " + root;
    codes.insert(0, "Generator " + polynomial.code + " " + low.code + " " + high.code +
                        (codes.empty() ? "" : "; "));
    reals.insert(0, name + (reals.empty() ? "" : "; "));
    result.proof = "(conj " + result.proof + " (conj " + interval + " " + root + "))";
  }
  result.arguments = "[" + codes + "] [" + reals + "]";
  return result;
}

}  // namespace seam::coq
