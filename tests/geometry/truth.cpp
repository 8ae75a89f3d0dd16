// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "symbolic/coefficients.h"

namespace seam::geometry::testing {
namespace {

using symbolic::Numbers;
using symbolic::Proposition;
using symbolic::Relation;
using Values = std::map<std::string, Formula>;

bool in_relation(exact::Sign sign, Relation relation) {
  const int s = static_cast<int>(sign);
  switch (relation) {
    case Relation::positive:
      return s > 0;
    case Relation::nonnegative:
      return s >= 0;
    case Relation::zero:
      return s == 0;
    case Relation::nonzero:
      return s != 0;
    case Relation::nonpositive:
      return s <= 0;
    case Relation::negative:
      return s < 0;
  }
  return false;
}

// All ways to write n as a sum of `parts` terms >= 0.
std::vector<std::vector<int>> compositions(int n, std::size_t parts) {
  if (parts == 1) return {{n}};
  std::vector<std::vector<int>> result;
  for (int first = 0; first <= n; ++first)
    for (std::vector<int> rest : compositions(n - first, parts - 1)) {
      rest.insert(rest.begin(), first);
      result.push_back(std::move(rest));
    }
  return result;
}

// A grid on a closed simplex without corners at infinity.
std::vector<Values> grid(const symbolic::Simplex& simplex) {
  constexpr int fineness = 6;
  std::vector<Values> result;
  for (const auto& weights : compositions(fineness, simplex.corners.size())) {
    Point point(simplex.variables.size());
    for (std::size_t k = 0; k < weights.size(); ++k)
      for (std::size_t x = 0; x < point.size(); ++x)
        point[x] += Formula(exact::Rational(weights[k], fineness)) * simplex.corners[k][x + 1];
    Values values;
    for (std::size_t x = 0; x < point.size(); ++x)
      values.emplace(simplex.variables[x], point[x]);
    result.push_back(std::move(values));
  }
  return result;
}

std::vector<Values> grid(const symbolic::Domain& domain) {
  std::vector<Values> result{{}};
  for (const auto& factor : domain.factors) {
    std::vector<Values> longer;
    for (const Values& values : result)
      for (Values more : grid(factor)) {
        more.insert(values.begin(), values.end());
        longer.push_back(std::move(more));
      }
    result = std::move(longer);
  }
  return result;
}

bool decide(const symbolic::Zero& zero, const Numbers& numbers) {
  return testing::vanishes(zero.formula, numbers);
}

bool decide(const symbolic::Sign& sign, const Numbers& numbers) {
  return std::ranges::all_of(grid(sign.domain), [&](const Values& values) {
    return in_relation(numbers.sign(subst(sign.formula, values)), sign.relation);
  });
}

bool decide(const symbolic::OnlySolutions&, const Numbers&) {
  throw std::logic_error("truth: no systems here");
}

bool decide(const symbolic::OneSolution&, const Numbers&) {
  throw std::logic_error("truth: no systems here");
}

bool decide(const symbolic::Solutions&, const Numbers&) {
  return false;
}

bool decide(const symbolic::Mesh&, const Numbers&) {
  throw std::logic_error("truth: no meshes here");
}

bool decide(const symbolic::Distinct& distinct, const Numbers& numbers) {
  for (std::size_t i = 0; i < distinct.tuples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (numbers.equal(distinct.tuples[i], distinct.tuples[j])) return false;
  return true;
}

class Classes {
 public:
  explicit Classes(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) { return parent_[i] == i ? i : parent_[i] = root(parent_[i]); }
  void join(int i, int j) { parent_[root(i)] = root(j); }
  int count() {
    std::set<int> roots;
    for (int i = 0; i < std::ssize(parent_); ++i) roots.insert(root(i));
    return static_cast<int>(roots.size());
  }

 private:
  std::vector<int> parent_;
};

bool decide(const certificate::Gluing& gluing, const Numbers&) {
  const int n = static_cast<int>(gluing.patches.size());
  Classes corners(4 * n), patches(n);
  std::map<std::pair<int, int>, int> seams_at;
  for (const auto& seam : gluing.seams) {
    ++seams_at[{seam.patch, seam.side}];
    ++seams_at[{seam.other_patch, seam.other_side}];
    auto a = gluing.patches.at(seam.patch).at(seam.side);
    auto b = gluing.patches.at(seam.other_patch).at(seam.other_side);
    if (seam.reversed) std::swap(b.from, b.to);
    corners.join(4 * seam.patch + a.from, 4 * seam.other_patch + b.from);
    corners.join(4 * seam.patch + a.to, 4 * seam.other_patch + b.to);
    patches.join(seam.patch, seam.other_patch);
  }
  int unused = 0;
  for (int p = 0; p < n; ++p) {
    const int sides = static_cast<int>(gluing.patches[p].size());
    unused += 4 - sides;
    for (int side = 0; side < sides; ++side)
      if (seams_at[{p, side}] != 1) return false;
  }
  return patches.count() == 1 &&
         corners.count() - unused - std::ssize(gluing.seams) + n == gluing.euler;
}

}  // namespace

bool holds(const Proposition& p, const Numbers& numbers) {
  const auto part_holds = [&](const Proposition& part) { return holds(part, numbers); };
  switch (p.kind) {
    case Proposition::Kind::all:
      return std::ranges::all_of(p.parts, part_holds);
    case Proposition::Kind::any:
      return std::ranges::any_of(p.parts, part_holds);
    case Proposition::Kind::suffices:
      return holds(p.parts.front(), numbers);
    case Proposition::Kind::negation:
      return !holds(p.parts.at(0), numbers);
    case Proposition::Kind::atom:
      return std::visit([&](const auto& atom) { return decide(atom, numbers); }, p.atom);
  }
  return false;
}

bool vanishes(const Formula& f, const Numbers& numbers) {
  const auto names = variables(f);
  return coefficients(f, {names.begin(), names.end()}, numbers).empty();
}

bool vanishes(const Point& point, const Numbers& numbers) {
  return std::ranges::all_of(point,
                             [&](const Formula& f) { return testing::vanishes(f, numbers); });
}

}  // namespace seam::geometry::testing
