// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include "drafting.h"

// Polynomials out of noise: what is proven or refuted is accepted by the checker (`verdict`
// expects it), and agrees with the values on a grid.
namespace seam::prove {
namespace {

using certificate::Relation;
using certificate::Verdict;

struct Agreement : testing::Test {
  std::mt19937 random{20260101};
  int small(int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  }
};

// a(i, j) + b(i, j) sqrt(5)
struct Noise {
  int degree = 0;
  std::vector<std::vector<int>> a, b;

  T formula(Draft& d, T u, T v, T s) const {
    T sum = d.number("0");
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        sum = sum + (d.number(std::to_string(a[i][j])) + b[i][j] * s) * (u ^ i) * (v ^ j);
    return sum;
  }
  double operator()(double x, double y) const {
    double sum = 0;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        sum += (a[i][j] + b[i][j] * std::sqrt(5.0)) * std::pow(x, i) * std::pow(y, j);
    return sum;
  }
};

TEST_F(Agreement, random_polynomials_on_triangle_and_square) {
  int decided = 0;
  const int rounds = 120;
  for (int round = 0; round < rounds; ++round) {
    Noise noise;
    noise.degree = small(0, 4);
    noise.a.assign(noise.degree + 1, std::vector<int>(noise.degree + 1, 0));
    noise.b = noise.a;
    const bool irrational = round % 3 == 0;
    for (int i = 0; i <= noise.degree; ++i)
      for (int j = 0; i + j <= noise.degree; ++j) {
        noise.a[i][j] = small(-5, 5);
        if (irrational) noise.b[i][j] = small(-2, 2);
      }
    noise.a[0][0] += 3;
    Draft d;
    const T s = d.generator("sqrt(5)", (d.symbol("sqrt(5)") ^ 2) - 5, "2", "3");
    const T f = noise.formula(d, d.symbol("u"), d.symbol("v"), s);
    const bool square = round % 2 == 0, strict = small(0, 1) == 1;
    certificate::Domain domain;
    if (square)
      domain.factors = {d.segment("u", "0", "1"), d.segment("v", "0", "1")};
    else
      domain.factors = {d.triangle()};
    const Verdict verdict = d.verdict(
        certificate::Sign{f.term, strict ? Relation::positive : Relation::nonnegative, domain},
        {.effort = 3000});
    double least = 1e9;
    for (int i = 0; i <= 50; ++i)
      for (int j = 0; j <= 50; ++j)
        if (square || i + j <= 50) least = std::min(least, noise(i / 50.0, j / 50.0));
    if (verdict != Verdict::undecided) ++decided;
    if (least < -1e-9) {
      EXPECT_EQ(verdict, Verdict::refuted) << "round " << round;
    }
    if (verdict == Verdict::refuted) {
      EXPECT_LT(least, 0.5) << "round " << round;
    }
    if (verdict == Verdict::proven) {
      EXPECT_GE(least, -1e-9) << "round " << round;
    }
  }
  EXPECT_GE(decided, rounds - 2);
}

// m(x - p) with a positive definite form m, plus something of third order: touches 0 at p
// alone.
TEST_F(Agreement, random_touching_zeros_on_a_triangle) {
  for (int round = 0; round < 40; ++round) {
    Draft d;
    const T u = d.symbol("u"), v = d.symbol("v");
    const int q = small(2, 9), p1 = small(0, q - 1), p2 = small(0, q - p1);
    const T x = q * u - p1, y = q * v - p2;
    const int a = small(1, 6), c = small(1, 6);
    int b = small(-5, 5);
    while (b * b >= 4 * a * c) b /= 2;
    const T f = a * (x ^ 2) + b * (x * y) + c * (y ^ 2);
    const T cube = f * (d.number("5") + u + (-2 * v));
    EXPECT_EQ(
        d.verdict(certificate::Sign{cube.term, Relation::nonnegative, {{d.triangle()}, {}}}),
        Verdict::proven)
        << d.last << " round " << round;
    EXPECT_EQ(d.verdict(certificate::Sign{cube.term, Relation::positive, {{d.triangle()}, {}}}),
              Verdict::refuted)
        << d.last << " round " << round;
  }
}

}  // namespace
}  // namespace seam::prove
