// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/form.h"

#include <gtest/gtest.h>

namespace seam::bernstein {
namespace {

using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;
using exact::Sign;

struct Forms : testing::Test {
  RingPtr ring = exact::Ring::make(nullptr, {"a", "b", "c"});
  RingPtr numbers = exact::Ring::make(nullptr, {});
  Polynomial a = ring->variable(0), b = ring->variable(1), c = ring->variable(2);
  CutPtr cut(std::vector<long> weights, std::vector<exact::Integer> totals) {
    std::vector<Polynomial> all;
    for (const long w : weights) all.push_back(numbers->constant(w));
    return std::make_shared<const Cut>(std::move(all), totals);
  }
  // Exactly: the polynomial over a part is the polynomial with the corner's coordinate shared
  // out.
  void expect_signs_of(const Polynomial& expected, const Form& form) {
    const auto terms = expected.numerators().terms;
    for (int i = 0; i < form.shape().count(); ++i) {
      const auto found = terms.find(form.shape().exponents(i)[0]);
      const int sign = found == terms.end() ? 0 : sgn(found->second[0]);
      EXPECT_EQ(static_cast<int>(form.sign(i)), sign) << "coefficient " << i;
    }
  }
};

TEST_F(Forms, a_part_is_a_linear_substitution) {
  const Polynomial f = a * a * a - ring->constant(2) * a * b * c + b * b * c - c * c * c;
  const Form whole(f, std::make_shared<Shape>(std::vector{3}, std::vector{3}));
  expect_signs_of(f, whole);
  // corner 0 replaced by 2 c0 + c1 + 3 c2
  const Form part = whole.part(0, 0, cut({2, 1, 3}, {1, 1, 1}));
  const auto shared = [&](const Polynomial& g) {
    return g.substitute(ring, {ring->constant(2) * a, b + a, c + ring->constant(3) * a});
  };
  expect_signs_of(shared(f), part);
  // then corner 1 by the middle of the edge from the new corner (total 6) to corner 1
  const Form twice = part.part(0, 1, cut({1, 6, 0}, {6, 1, 1}));
  expect_signs_of(shared(f).substitute(ring, {a + b, ring->constant(6) * b, c}), twice);
}

TEST_F(Forms, a_zero_is_decided_exactly) {
  const Polynomial f = (a - b) * (a - b) + c * c;
  const Form whole(f, std::make_shared<Shape>(std::vector{3}, std::vector{2}));
  const Form part = whole.part(0, 0, cut({1, 1, 0}, {1, 1, 1}));
  const int corner = part.shape().corner({0});
  EXPECT_EQ(part.guess(corner), Form::Guess::unknown);
  EXPECT_EQ(part.sign(corner), Sign::zero);
}

TEST_F(Forms, numbers_too_large_for_doubles_are_no_obstacle) {
  exact::Integer huge = 1;
  huge <<= 3000;
  const Polynomial f = Rational(huge) * a + Rational(huge + 1) * b - Rational(huge) * c;
  const Form form(f, std::make_shared<Shape>(std::vector{3}, std::vector{1}));
  expect_signs_of(f, form);
}

}  // namespace
}  // namespace seam::bernstein
