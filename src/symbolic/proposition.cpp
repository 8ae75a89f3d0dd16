// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/proposition.h"

#include <utility>

namespace seam::symbolic {

Simplex interval(const std::string& variable, const Formula& low, const Formula& high,
                 bool open_low, bool open_high) {
  // Facet i lies opposite corner i: the facet l_0 = 0 is the upper end.
  return {{variable}, {{1, low}, {1, high}}, {open_high, open_low}};
}

Simplex whole_line_right(const std::string& variable, const Formula& from, bool open) {
  return {{variable}, {{1, from}, {0, 1}}, {false, open}};
}

Simplex whole_line_left(const std::string& variable, const Formula& to, bool open) {
  return {{variable}, {{1, to}, {0, -1}}, {false, open}};
}

Simplex standard_simplex(const std::vector<std::string>& variables, bool interior) {
  Simplex simplex{variables, {}, std::vector<bool>(variables.size() + 1, interior)};
  for (std::size_t corner = 0; corner <= variables.size(); ++corner) {
    Point point(variables.size() + 1, Formula(0));
    point[0] = 1;
    if (corner > 0) point[corner] = 1;
    simplex.corners.push_back(std::move(point));
  }
  return simplex;
}

Proposition all(std::vector<Proposition> parts, std::string about) {
  return {Proposition::Kind::all, std::move(about), std::move(parts), {}};
}

Proposition any(std::vector<Proposition> parts, std::string about) {
  return {Proposition::Kind::any, std::move(about), std::move(parts), {}};
}

Proposition negation(Proposition part, std::string about) {
  return {Proposition::Kind::negation, std::move(about), {std::move(part)}, {}};
}

Proposition suffices(Proposition part, std::string about) {
  return {Proposition::Kind::suffices, std::move(about), {std::move(part)}, {}};
}

Proposition atom(Atom statement, std::string about) {
  return {Proposition::Kind::atom, std::move(about), {}, std::move(statement)};
}

Proposition truth() {
  return all({});
}
Proposition falsehood() {
  return any({});
}

}  // namespace seam::symbolic
