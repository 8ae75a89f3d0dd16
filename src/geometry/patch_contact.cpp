// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>

#include "geometry/contact.h"
#include "geometry/side_contact.h"

// The sides that agree are found with the parameters of the patches set to fixed rationals:
// sides that agree identically do so there. A pair that agrees there by chance is one
// alternative too many, and fails.

namespace seam::geometry {
namespace {

using symbolic::Sign;

Patch with_numbers(const Patch& p, const std::map<std::string, Formula>& values) {
  return map(p, [&](const Point& point) {
    Point result;
    for (const Formula& x : point) result.push_back(subst(x, values));
    return result;
  });
}

std::map<std::string, Formula> chosen_values(const std::vector<Patch>& patches) {
  std::set<std::string> names;
  for (const Patch& p : patches)
    for (const auto& row : p.rows())
      for (const Point& point : row)
        for (const Formula& x : point) names.merge(variables(x));
  std::map<std::string, Formula> result;
  long k = 0;
  for (const std::string& name : names) {
    exact::Rational value(101 + 17 * k, 211 + 29 * k);
    value.canonicalize();
    result.emplace(name, Formula(value));
    ++k;
  }
  return result;
}

using Condition = Proposition (*)(const Contact&);

Proposition along_a_common_side(const Patch& p, const Patch& q, Condition condition,
                                const Numbers& numbers) {
  const std::vector<Patch> patches{p, q};
  const auto values = chosen_values(patches);
  std::vector<Proposition> alternatives;
  for (const Seam& seam : seams({with_numbers(p, values), with_numbers(q, values)}, numbers))
    if (seam.patch != seam.other_patch) {
      Proposition alternative = condition(contact(patches, seam));
      alternative.about = name({seam.patch, seam.side}) + ", " +
                          name({seam.other_patch, seam.other_side}) +
                          (seam.reversed ? " reversed" : "");
      alternatives.push_back(std::move(alternative));
    }
  if (alternatives.size() == 1) return alternatives.front();
  if (!alternatives.empty()) return any(std::move(alternatives));

  const std::vector<SideIndex> sides = all_sides(patches);
  return some_side_agrees(patches, {sides.begin(), sides.begin() + p.sides()},
                          {sides.begin() + p.sides(), sides.end()});
}

}  // namespace

Proposition regular(const Patch& p) {
  const Point n = normal(p, Formula::symbol(parameter_u), Formula::symbol(parameter_v));
  return atom(Sign{norm2(n), symbolic::Relation::positive, domain(p, parameter_u, parameter_v)},
              "the normal is nowhere 0");
}

Proposition g0(const Patch& p, const Patch& q, const Numbers& numbers) {
  return along_a_common_side(p, q, g0, numbers);
}

Proposition g1(const Patch& p, const Patch& q, const Numbers& numbers) {
  return along_a_common_side(p, q, g1, numbers);
}

Proposition g2(const Patch& p, const Patch& q, const Numbers& numbers) {
  return along_a_common_side(p, q, g2, numbers);
}

}  // namespace seam::geometry
