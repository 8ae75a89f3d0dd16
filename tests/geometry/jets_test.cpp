// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "geometry/contact.h"
#include "geometry/powers.h"
#include "nets.h"
#include "spheroids.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

// p over x < 0, q over x > 0 of graphs of height z(x, y); q with bent parameters.
class JetsTest : public ::testing::Test {
 protected:
  using Height = std::function<Formula(const Formula& x, const Formula& y)>;
  Patch left(const Height& z) const { return square_of({-v, u, z(-v, u)}, 8, 8, numbers); }
  Patch right(const Height& z) const {
    const Formula x = v * (1 + u) + v * v, y = u + 2 * v - u * v;
    return square_of({x, y, z(x, y)}, 8, 8, numbers);
  }
  bool is_g(int order, const Patch& p, const Patch& q) const {
    const auto jets = [=](const Contact& c) { return equal_jets(c, order); };
    return holds(along_a_common_side(p, q, jets, search).proposition, numbers);
  }
  bool is_c(int order, const Patch& p, const Patch& q) const {
    const auto same = [=](const Contact& c) { return equal_derivatives(c, order); };
    return holds(along_a_common_side(p, q, same, search).proposition, numbers);
  }
  template <class Condition>
  bool meet(const Patch& p, const Patch& q, Condition condition) const {
    return holds(along_a_common_side(p, q, condition, search).proposition, numbers);
  }
  int smoothness(const Patch& p, const Patch& q) const {
    int order = -1;
    while (order < 5 && is_g(order + 1, p, q)) ++order;
    return order;
  }

  symbolic::Numbers numbers;
  const Search search{numbers, [this](const Formula& f) { return vanishes(f, numbers); }, {}};
};

TEST_F(JetsTest, one_graph_is_smooth_however_it_is_parametrised) {
  const Height z = [](const Formula& x, const Formula& y) {
    return x * x + 3 * x * y + y * y * x + x * x * x + x * x * x * x;
  };
  EXPECT_EQ(smoothness(left(z), right(z)), 5);
  EXPECT_EQ(smoothness(right(z), left(z)), 5);
  for (const Patch& q : parametrisations(right(z))) EXPECT_TRUE(is_g(3, left(z), q));
}

TEST_F(JetsTest, two_graphs_are_as_smooth_as_their_difference_is_flat) {
  const Height z = [](const Formula& x, const Formula& y) { return x * x + x * y; };
  for (int order = 0; order < 5; ++order) {
    const Height other = [&](const Formula& x, const Formula& y) {
      return z(x, y) + ratio(1, 1000) * power(x, order + 1);
    };
    EXPECT_EQ(smoothness(left(z), right(other)), order);
    EXPECT_EQ(smoothness(right(other), left(z)), order);
  }
}

TEST_F(JetsTest, orders_0_1_2_are_the_classical_ones) {
  const auto g_0 = [](const Contact& c) { return g0(c); };
  const auto g_1 = [](const Contact& c) { return g1(c); };
  const auto g_2 = [](const Contact& c) { return g2(c); };
  const Height z = [](const Formula& x, const Formula& y) { return x * x + x * y; };
  const auto plus = [&](const Formula& along, const Formula& across, const Formula& bend) {
    return right([=](const Formula& x, const Formula& y) {
      return z(x, y) + along * y * (1 - y) + across * x * y + bend * x * x * y;
    });
  };
  std::vector<Patch> others{right(z), left(z)};
  for (const int order : {0, 1, 2, 3})
    others.push_back(plus(order == 0, order == 1, order == 2));
  for (const Patch& q : others) {
    EXPECT_EQ(is_g(0, left(z), q), meet(left(z), q, g_0));
    EXPECT_EQ(is_g(1, left(z), q), meet(left(z), q, g_1));
    EXPECT_EQ(is_g(2, left(z), q), meet(left(z), q, g_2));
  }
}

TEST_F(JetsTest, spheroids_are_g2_and_no_smoother) {
  const auto mirrored = [](const Patch& p, const Point& n, const Formula& share) {
    return map(p, [&](const Point& x) { return reflect(x, n, 0, share); });
  };
  const Patch octoid = octoid_patch(), hexoid = hexoid_patch();
  EXPECT_EQ(smoothness(octoid, mirrored(octoid, {1, 0, 0}, 1)), 2);
  EXPECT_EQ(smoothness(hexoid, mirrored(hexoid, {0, 1, -1}, ratio(1, 2))), 2);
}

TEST_F(JetsTest, a_fold_has_no_equal_jets) {
  const Height z = [](const Formula& x, const Formula& y) { return x * x + x * y; };
  EXPECT_FALSE(is_g(1, left(z), left(z)));
  EXPECT_FALSE(is_g(3, left(z), left(z)));
}

TEST_F(JetsTest, derivatives_depend_on_the_parameters) {
  const Height z = [](const Formula& x, const Formula& y) { return x * x * x + x * y; };
  const Patch p = left(z), q = square_of({v, u, z(v, u)}, 8, 8, numbers);
  EXPECT_TRUE(is_c(5, p, q));
  EXPECT_FALSE(is_c(1, p, right(z)));
  for (const Patch& other : parametrisations(q)) EXPECT_TRUE(is_c(5, p, other));
}

TEST_F(JetsTest, triangles_continue_each_other_over_a_parallelogram) {
  const auto graph = [&](const Formula& x, const Formula& y) {
    return triangle_of({x, y, x * x * y - 2 * y * y * y}, 3, numbers);
  };
  const Patch p = graph(u, v);
  for (const Patch& q : parametrisations(graph(u, -v))) {
    EXPECT_FALSE(is_c(1, p, q));  // their third corner is (0,-1), (1,-1) makes a parallelogram
    EXPECT_TRUE(is_g(3, p, q));
  }
  for (const Patch& q : parametrisations(graph(u + v, -v))) EXPECT_TRUE(is_c(3, p, q));
}

TEST_F(JetsTest, curves_have_jets_too) {
  const auto parabola = [&](const Formula& x) {
    return Curve{square_of({x, x * x}, 4, 0, numbers).rows()[0]};
  };
  const Curve x = parabola(u), y = parabola(1 + 2 * u - u * u);
  EXPECT_TRUE(holds(equal_jets(x, y, 6), numbers));
  EXPECT_FALSE(holds(equal_jets(y, parabola(2 + u), 1), numbers));  // y halts at its end
  EXPECT_FALSE(holds(equal_jets(x, parabola(1 - u), 1), numbers));
  EXPECT_FALSE(holds(equal_derivatives(x, y, 1), numbers));
  EXPECT_TRUE(holds(equal_derivatives(x, parabola(1 + u), 6), numbers));
}

TEST(Powers, are_those_of_the_series) {
  symbolic::Numbers numbers;
  Powers powers;  // A = 2 s + 3 s^2, B = 5 s
  powers.extend(2, 5);
  powers.extend(3, 0);
  EXPECT_TRUE(vanishes(powers.coefficient(2, 2, 0) - 4, numbers));
  EXPECT_TRUE(vanishes(powers.coefficient(3, 2, 0) - 12, numbers));
  EXPECT_TRUE(vanishes(powers.coefficient(3, 1, 1) - 15, numbers));
  EXPECT_TRUE(vanishes(powers.coefficient(1, 0, 2), numbers));
}

}  // namespace
}  // namespace seam::geometry
