// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
// Random statements with random evidence: whatever is accepted is compared with the values on
// a grid, which are computed in another way.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "builder.h"

namespace seam::check::test {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool flip() { return below(2) == 0; }

 private:
  std::mt19937 random_;
};

bool meets(Relation relation, long value) {
  switch (relation) {
    case Relation::positive:
      return value > 0;
    case Relation::nonnegative:
      return value >= 0;
    case Relation::zero:
      return value == 0;
    case Relation::nonzero:
      return value != 0;
    case Relation::nonpositive:
      return value <= 0;
    case Relation::negative:
      return value < 0;
  }
  return false;
}

// A quadratic in u and v with small coefficients; its value at (u, v) / n, times n^2.
struct Quadratic {
  int coefficients[6];  // of 1, u, v, u^2, u v, v^2

  Quadratic(Dice& dice, int offset) {
    for (int& c : coefficients) c = dice.flip() ? dice.below(5) - 2 : 0;
    coefficients[0] += offset;
  }
  long at(long u, long v, long n) const {
    const auto& c = coefficients;
    return c[0] * n * n + (c[1] * u + c[2] * v) * n + c[3] * u * u + c[4] * u * v +
           c[5] * v * v;
  }
  Term term(Case& c) const {
    const Term u = c.symbol("u");
    const Term v = c.symbol("v");
    const std::vector<Term> monomials = {c.number(1),  u, v, c.power(u, 2), c.product({u, v}),
                                         c.power(v, 2)};
    std::vector<Term> terms;
    for (int i = 0; i < 6; ++i) terms.push_back(c.scaled(coefficients[i], monomials[i]));
    return c.sum(terms);
  }
};

Relation random_relation(Dice& dice) {
  return static_cast<Relation>(dice.below(6));
}

struct Shape {
  bool is_square = false;
  std::vector<std::vector<bool>> open;  // by factor and facet
};

Domain domain(Case& c, const Shape& shape) {
  Domain result;
  if (shape.is_square)
    result.factors = {c.segment("u"), c.segment("v")};
  else
    result.factors = {c.triangle()};
  for (std::size_t m = 0; m < result.factors.size(); ++m)
    result.factors[m].open = shape.open[m];
  return result;
}

bool is_inside(const Shape& shape, long u, long v, long n) {
  const std::vector<std::vector<long>> coordinates =
      shape.is_square ? std::vector<std::vector<long>>{{n - u, u}, {n - v, v}}
                      : std::vector<std::vector<long>>{{n - u - v, u, v}};
  for (std::size_t m = 0; m < coordinates.size(); ++m)
    for (std::size_t i = 0; i < coordinates[m].size(); ++i)
      if (coordinates[m][i] < 0 || (shape.open[m][i] && coordinates[m][i] == 0)) return false;
  return true;
}

// A whole tree: every leaf plain or outside, at random.
void grow(Case& c, Dice& dice, const Domain& domain, int depth, Subdivision& steps) {
  if (depth == 0 || dice.below(3) == 0) {
    steps.push_back(!domain.where.empty() && dice.below(3) == 0 ? outside(0) : plain());
    return;
  }
  const int factor = dice.below(static_cast<int>(domain.factors.size()));
  std::vector<Term> weights;
  int parts = 0;
  for (std::size_t i = 0; i < domain.factors[factor].corners.size(); ++i) {
    const int weight = dice.below(3);
    weights.push_back(c.number(weight));
    if (weight > 0) ++parts;
  }
  if (parts == 0) weights.front() = c.number(parts = 1);
  steps.push_back(split(factor, weights));
  for (int i = 0; i < parts; ++i) grow(c, dice, domain, depth - 1, steps);
}

TEST(Soundness, what_pieces_prove_is_true_on_a_grid) {
  Dice dice(7);
  int proven = 0;
  for (int round = 0; round < 20'000; ++round) {
    Case c;
    Shape shape{dice.flip(), {}};
    for (const int facets : shape.is_square ? std::vector{2, 2} : std::vector{3}) {
      auto& open = shape.open.emplace_back();
      for (int i = 0; i < facets; ++i) open.push_back(dice.below(3) == 0);
    }
    Domain where = domain(c, shape);
    const Quadratic formula(dice, dice.below(3));
    const Quadratic condition(dice, 0);
    const Relation relation = random_relation(dice);
    if (dice.flip()) where.where = {{condition.term(c), random_relation(dice)}};
    c.claim(Sign{formula.term(c), relation, where});
    Pieces evidence;
    grow(c, dice, where, 2, evidence.steps);
    evidence.side = random_relation(dice);
    const Finding finding = c.finding(evidence);
    ASSERT_NE(finding.kind, Kind::fails);
    if (finding.kind != Kind::holds) continue;
    ++proven;
    constexpr long n = 12;
    for (long u = 0; u <= n; ++u)
      for (long v = 0; v <= n; ++v) {
        const bool is_point =
            is_inside(shape, u, v, n) &&
            (where.where.empty() || meets(where.where[0].relation, condition.at(u, v, n)));
        ASSERT_TRUE(!is_point || meets(relation, formula.at(u, v, n)))
            << "round " << round << ": " << u << ", " << v;
      }
  }
  EXPECT_GT(proven, 1000);
}

TEST(Soundness, what_a_witness_refutes_is_false) {
  Dice dice(11);
  int refuted = 0;
  for (int round = 0; round < 5'000; ++round) {
    Case c;
    Shape shape{dice.flip(), {}};
    for (const int facets : shape.is_square ? std::vector{2, 2} : std::vector{3})
      shape.open.emplace_back(facets, dice.flip());
    const Quadratic formula(dice, 0);
    const Relation relation = random_relation(dice);
    c.claim(Sign{formula.term(c), relation, domain(c, shape)});
    const int u = dice.below(8) - 2;
    const int v = dice.below(8) - 2;
    const auto fourth = [&c](int k) { return c.product({c.number(k), c.number("1/4")}); };
    const Finding finding = c.finding(Witness{{{"u", "v"}, {fourth(u), fourth(v)}}, {}});
    const bool is_witness = is_inside(shape, u, v, 4) && !meets(relation, formula.at(u, v, 4));
    ASSERT_EQ(finding.kind, is_witness ? Kind::fails : Kind::open) << round;
    refuted += is_witness;
  }
  EXPECT_GT(refuted, 300);
}

TEST(Soundness, signs_of_numbers_agree_with_floating_point) {
  Dice dice(13);
  Case c;
  const Term a = c.root("sqrt(2)", c.number(2), "1", "2");
  const Term b = c.root("sqrt(1+sqrt(2))", c.sum({c.number(1), a}), "1", "2");
  const Term t = c.symbol("t");
  c.generator("t", c.sum({c.power(t, 3), c.scaled(-1, c.product({b, t})), c.number(-3)}), "1",
              "3");
  const long double root_a = std::sqrt(2.0L);
  const long double root_b = std::sqrt(1 + root_a);
  long double root_t = 2;
  for (int i = 0; i < 60; ++i)
    root_t -= (root_t * root_t * root_t - root_b * root_t - 3) / (3 * root_t * root_t - root_b);
  const std::vector<std::pair<Term, long double>> factors = {
      {a, root_a}, {b, root_b}, {t, root_t}};
  const std::size_t node_count = c.statement.nodes.size();
  for (int round = 0; round < 2'000; ++round) {
    std::vector<Term> terms;
    long double value = 0;
    for (int i = 0; i < 4; ++i) {
      const int k = dice.below(19) - 9;
      Term term = c.number(k);
      long double size = k;
      for (const auto& [factor, root] : factors)
        for (int e = dice.below(4); e > 0; --e) {
          term = c.product({term, factor});
          size *= root;
        }
      terms.push_back(term);
      value += size;
    }
    c.claim(Sign{c.sum(terms), Relation::positive, {}});
    if (std::fabs(value) > 1e-6L) {
      ASSERT_EQ(c.finding(Computation{}).kind, value > 0 ? Kind::holds : Kind::fails) << round;
    }
    c.statement.nodes.resize(node_count);
  }
}

}  // namespace
}  // namespace seam::check::test
