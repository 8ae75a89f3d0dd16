// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/form.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/contract.h"

// Why `part` is right.
//
//   Let b(m) be the coefficients with the binomials divided out, times degree!: the
//   polynomial's polar form at m(0) times corner 0, m(1) times corner 1, .... Replacing one
//   argument `corner` by p = sum w_j c_j gives sum w_j b(m - e_corner + e_j), by
//   multilinearity. Round r does it for the r-th of the arguments, for all m with at least r of
//   them; it reads entries with one fewer, so falling order works in place.

namespace seam::bernstein {

using exact::Ball;
using exact::Coordinates;
using exact::Integer;
using exact::Polynomial;
using exact::Sign;

namespace {

constexpr double inflate = 1 + 0x1p-48;  // above every rounding made in a radius

void add_product(Ball& sum, const Ball& a, const Ball& b) {
  const double product = a.middle * b.middle;
  const double total = sum.middle + product;
  sum.radius = (sum.radius + std::abs(a.middle) * b.radius + std::abs(b.middle) * a.radius +
                a.radius * b.radius + (std::abs(product) + std::abs(total)) * 0x1p-52) *
                   inflate +
               0x1p-1000;
  sum.middle = total;
}

// A ball around the number divided by a power of 2 common to all, so that nothing overflows.
Ball scaled(const Coordinates& number, const exact::TowerPtr& tower, long shift) {
  if (shift == 0) return exact::ball(tower, number);
  Coordinates high = number;
  for (Integer& c : high) mpz_tdiv_q_2exp(c.get_mpz_t(), c.get_mpz_t(), shift);
  Ball result = exact::ball(tower, high);
  double slack = 0;  // one unit of each basis element
  for (std::size_t i = 0; i < number.size(); ++i) {
    Coordinates unit(number.size());
    unit[i] = 1;
    const Ball b = exact::ball(tower, unit);
    slack += std::abs(b.middle) + b.radius;
  }
  result.radius = (result.radius + slack) * inflate;
  return result;
}

}  // namespace

Cut::Cut(std::vector<Polynomial> weights, const std::vector<Integer>& totals)
    : weights_(std::move(weights)) {
  Polynomial sum = weights_.front().ring().constant(0);
  for (std::size_t j = 0; j < weights_.size(); ++j)
    sum = sum + exact::Rational(totals[j]) * weights_[j];
  const Polynomial scale = exact::inverse(sum);
  for (std::size_t j = 0; j < weights_.size(); ++j) {
    const Polynomial& w = weights_[j];
    const auto numerators = w.numerators();
    exact::require(numerators.denominator == 1, "Cut: a weight that is not integral");
    const exact::TowerPtr& tower = w.ring().tower();
    multipliers_.emplace_back(
        tower, w.is_zero() ? Coordinates(dimension(tower)) : numerators.terms.begin()->second);
    shares_.push_back(exact::ball(exact::Rational(totals[j]) * scale * w));
  }
}

Form::Form(const Polynomial& polynomial, std::shared_ptr<const Shape> shape) {
  const exact::TowerPtr& tower = polynomial.ring().tower();
  auto node = std::make_shared<Node>();
  node->rows = std::make_unique<exact::Rows>(tower, shape->count());
  std::size_t bits = 0;
  for (const auto& [exponents, coordinates] : polynomial.numerators().terms) {
    std::vector<std::vector<int>> grouped;
    Integer factor = 1, factorial;
    auto next = exponents.begin();
    for (int k = 0; k < shape->factors(); ++k) {
      grouped.emplace_back(next, next + shape->corners(k));
      next += shape->corners(k);
      for (const int e : grouped.back()) {
        mpz_fac_ui(factorial.get_mpz_t(), e);
        factor *= factorial;
      }
    }
    Coordinates multiple = coordinates;
    for (Integer& c : multiple) {
      c *= factor;
      bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
    }
    node->rows->set(shape->index(grouped), multiple);
  }
  const long shift = bits > 500 ? static_cast<long>(bits) - 500 : 0;
  for (int i = 0; i < shape->count(); ++i)
    node->balls.push_back(scaled(node->rows->at(i), tower, shift));
  node->shape = std::move(shape);
  node_ = std::move(node);
}

Form Form::part(int factor, int corner, const CutPtr& cut) const {
  exact::require(cut->involves(corner), "Form::part: the point is on the opposite facet");
  auto node = std::make_shared<Node>();
  node->shape = node_->shape;
  node->balls = node_->balls;
  node->parent = node_;
  node->factor = factor;
  node->corner = corner;
  node->cut = cut;
  const Shape& s = shape();
  for (int round = 1; round <= s.degree(factor); ++round)
    for (const auto& [index, exponent] : s.ranked(factor, corner)) {
      if (exponent < round) break;
      Ball sum;
      for (int j = 0; j < s.corners(factor); ++j)
        if (cut->involves(j))
          add_product(sum, node->balls[s.moved(index, factor, corner, j)], cut->shares_[j]);
      node->balls[index] = sum;
    }
  return Form(std::move(node));
}

const exact::Rows& Form::Node::exact_rows() const {
  if (rows) return *rows;
  auto result = std::make_unique<exact::Rows>(parent->exact_rows());
  std::vector<exact::Rows::Term> terms;
  for (int round = 1; round <= shape->degree(factor); ++round)
    for (const auto& [index, exponent] : shape->ranked(factor, corner)) {
      if (exponent < round) break;
      terms.clear();
      for (int j = 0; j < shape->corners(factor); ++j)
        if (cut->involves(j))
          terms.push_back({shape->moved(index, factor, corner, j), &cut->multipliers_[j]});
      result->combine(index, terms);
    }
  rows = std::move(result);
  return *rows;
}

Form::Guess Form::guess(int index) const {
  const Ball& b = node_->balls[index];
  if (b.middle > b.radius) return Guess::positive;
  if (b.middle < -b.radius) return Guess::negative;
  return Guess::unknown;
}

Sign Form::sign(int index) const {
  switch (guess(index)) {
    case Guess::positive:
      return Sign::positive;
    case Guess::negative:
      return Sign::negative;
    case Guess::unknown:
      break;
  }
  return node_->exact_rows().sign(index);
}

}  // namespace seam::bernstein
