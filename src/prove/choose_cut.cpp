// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "prove/linear.h"
#include "prove/subdivide.h"

// Why the search ends where f is positive on a compact domain.
//
//   Coefficients approach the values of f as a piece shrinks, and halving longest edges shrinks
//   every piece.
//
// Where f touches 0 at a corner with a gradient 0 and a positive definite Hessian H.
//
//   The coefficient next to the corner along edges a and b is about H(a, b): it is positive
//   once the angle between a and b, as H measures it, is less than a right one. So the edge
//   opposite is halved first, the longest of them, for else parts of it may wait forever. The
//   further ones become positive as the piece shrinks.

namespace seam::prove {

using bernstein::Form;
using bernstein::Shape;
using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

double distance(const Corner& a, const Corner& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i)
    sum += (a.at[i] - b.at[i]) * (a.at[i] - b.at[i]);
  return std::sqrt(sum);
}

}  // namespace

std::optional<Subdivision::Cut> Subdivision::choose(const Piece& piece) const {
  if (auto cut = cut_at_touch(piece)) return cut;
  bool hopeless = false;
  if (auto cut = cut_at_zero_corner(piece, hopeless)) return cut;
  if (hopeless) return std::nullopt;
  if (std::ranges::none_of(relevant_, [](bool r) { return r; })) return std::nullopt;
  return cut_longest_edge(piece);
}

std::optional<Subdivision::Cut> Subdivision::cut_at_touch(const Piece& piece) const {
  for (const Place& place : touches_) {
    std::optional<Cut> cut;
    bool inside = true;
    for (std::size_t k = 0; inside && k < place.size(); ++k) {
      if (!relevant_[k]) continue;
      std::vector<std::vector<double>> about;
      for (const CornerPtr& corner : piece.corners[k]) about.push_back(corner->at);
      std::vector<double> target;
      for (const Polynomial& l : place[k]) target.push_back(exact::ball(l).middle);
      const auto near = barycentric(about, target);
      inside = !near.empty() && std::ranges::min(near) > -1e-6;
      if (!inside || std::ranges::max(near) > 1 - 1e-9) continue;
      std::vector<std::vector<Polynomial>> corners;
      for (const CornerPtr& corner : piece.corners[k]) corners.push_back(corner->l);
      auto weights = barycentric(corners, place[k]);
      inside = std::ranges::none_of(
          weights, [](const Polynomial& w) { return exact::sign(w) == Sign::negative; });
      if (!inside) continue;
      Integer denominator = 1;
      for (const Polynomial& w : weights)
        denominator = lcm(denominator, w.numerators().denominator);
      for (Polynomial& w : weights) w = Rational(denominator) * w;
      if (std::ranges::count_if(weights, [](const Polynomial& w) { return !w.is_zero(); }) > 1)
        cut = Cut{static_cast<int>(k), std::move(weights)};
    }
    if (inside && cut) return cut;
  }
  return std::nullopt;
}

// Where f and its derivatives along two edges of different factors vanish, and the mixed one is
// negative, no part will ever be plain.
std::optional<Subdivision::Cut> Subdivision::cut_at_zero_corner(const Piece& piece,
                                                                bool& hopeless) const {
  const Form& f = piece.f;
  const Shape& shape = f.shape();
  struct Edge {
    int factor, to;
  };
  for (const auto& choice : corner_choices(piece)) {
    const int pure = shape.corner(choice);
    if (f.guess(pure) != Form::Guess::unknown || f.sign(pure) != Sign::zero) continue;
    std::vector<Edge> flat;  // edges along which the derivative is 0
    for (int k = 0; k < shape.factors(); ++k)
      for (int to = 0; shape.degree(k) > 0 && to < shape.corners(k); ++to)
        if (to != choice[k] && f.sign(shape.moved(pure, k, choice[k], to)) == Sign::zero)
          flat.push_back({k, to});
    double longest = 0;
    std::pair<Edge, Edge> opposite;
    for (const Edge& a : flat)
      for (const Edge& b : flat) {
        if (std::pair(a.factor, a.to) >= std::pair(b.factor, b.to)) continue;
        const int once = shape.moved(pure, a.factor, choice[a.factor], a.to);
        const int twice = shape.moved(once, b.factor, choice[b.factor], b.to);
        if (twice < 0 || f.guess(twice) != Form::Guess::negative) continue;
        if (a.factor != b.factor) {
          hopeless = question_->where.empty();
          continue;
        }
        const auto& corners = piece.corners[a.factor];
        const double length = distance(*corners[a.to], *corners[b.to]);
        if (length <= longest * (1 + 1e-9)) continue;
        longest = length;
        opposite = {a, b};
      }
    if (longest > 0)
      return edge(piece, opposite.first.factor, opposite.first.to, opposite.second.to);
  }
  return std::nullopt;
}

Subdivision::Cut Subdivision::cut_longest_edge(const Piece& piece) const {
  double longest = -1;
  std::array<int, 3> best = {};
  for (std::size_t k = 0; k < piece.corners.size(); ++k) {
    if (!relevant_[k]) continue;
    const auto& corners = piece.corners[k];
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const double length = distance(*corners[i], *corners[j]);
        if (length <= longest * (1 + 1e-9)) continue;
        longest = length;
        best = {static_cast<int>(k), static_cast<int>(i), static_cast<int>(j)};
      }
  }
  return edge(piece, best[0], best[1], best[2]);
}

// The middle: both ends contribute the same total.
Subdivision::Cut Subdivision::edge(const Piece& piece, int factor, int i, int j) const {
  const auto& corners = piece.corners[factor];
  const exact::Ring& numbers = corners[0]->l[0].ring();
  Cut cut{factor, std::vector<Polynomial>(corners.size(), numbers.constant(0))};
  const Integer common = lcm(corners[i]->total, corners[j]->total);
  cut.weights[i] = numbers.constant(Rational(common / corners[i]->total));
  cut.weights[j] = numbers.constant(Rational(common / corners[j]->total));
  return cut;
}

}  // namespace seam::prove
