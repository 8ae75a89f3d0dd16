// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/subdivide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exact/contract.h"
#include "prove/linear.h"
#include "prove/plain.h"

// Why the search ends where f is positive on a compact domain.
//
//   Coefficients approach the values of f as a piece shrinks, and halving longest edges shrinks every piece.
//
// Where f touches 0 at a corner with a gradient 0 and a positive definite Hessian H.
//
//   The coefficient next to the corner along edges a and b is about H(a, b): it is positive once the angle between
//   a and b, as H measures it, is less than a right one. So the edge opposite is halved first.
//   The further ones become positive as the piece shrinks.

namespace seam::prove {

using bernstein::CutPtr;
using bernstein::Form;
using bernstein::Shape;
using certificate::Relation;
using certificate::Step;
using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

CornerPtr make_corner(std::vector<Polynomial> l) {
  auto corner = std::make_shared<Corner>();
  Polynomial total = l.front().ring().constant(0);
  for (std::size_t i = 0; i < l.size(); ++i) {
    total = total + l[i];
    if (!l[i].is_zero()) corner->support |= 1U << i;
  }
  const auto sum = total.rational();
  exact::require(sum.has_value() && sum->get_den() == 1, "Subdivision: an irrational scale");
  corner->total = sum->get_num();
  for (const Polynomial& c : l) corner->at.push_back(exact::ball(Rational(1, corner->total) * c).middle);
  corner->l = std::move(l);
  return corner;
}

double distance(const Corner& a, const Corner& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i) sum += (a.at[i] - b.at[i]) * (a.at[i] - b.at[i]);
  return std::sqrt(sum);
}

// All choices of one corner a factor.
std::vector<std::vector<int>> corner_choices(const Piece& piece) {
  std::vector<std::vector<int>> result = {{}};
  for (const auto& corners : piece.corners) {
    std::vector<std::vector<int>> longer;
    for (const auto& choice : result)
      for (int c = 0; c < std::ssize(corners); ++c) {
        longer.push_back(choice);
        longer.back().push_back(c);
      }
    result = std::move(longer);
  }
  return result;
}

double lowest(const Form& form) {
  double result = form.about(0);
  for (int i = 1; i < form.shape().count(); ++i) result = std::min(result, form.about(i));
  return result;
}

}  // namespace

bool holds(Relation relation, Sign sign) {
  switch (relation) {
    case Relation::positive:
      return sign == Sign::positive;
    case Relation::nonnegative:
      return sign != Sign::negative;
    case Relation::zero:
      return sign == Sign::zero;
    case Relation::nonzero:
      return sign != Sign::zero;
    case Relation::nonpositive:
      return sign != Sign::positive;
    case Relation::negative:
      return sign == Sign::negative;
  }
  return false;
}

Subdivision::Subdivision(Workshop& workshop, const Question& question, std::vector<Place> touches)
    : workshop_(&workshop), question_(&question), touches_(std::move(touches)) {
  const exact::RingPtr numbers = exact::Ring::make(question.f.ring().tower(), {});
  const auto form = [&](const Polynomial& f) {
    const auto [polynomial, shape] = in_barycentric(question.factors, f);
    return Form(polynomial, shape);
  };
  Piece root{{}, form(question.f), {}, 0, 0};
  for (const auto& condition : question.where) root.where.push_back(form(condition.formula));
  for (std::size_t k = 0; k < question.factors.size(); ++k) {
    root.corners.emplace_back();
    const std::size_t size = question.factors[k].corners.size();
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<Polynomial> l(size, numbers->constant(0));
      l[i] = numbers->constant(1);
      root.corners.back().push_back(make_corner(std::move(l)));
    }
    relevant_.push_back(root.f.shape().degree(static_cast<int>(k)) > 0 ||
                        std::ranges::any_of(root.where, [&](const Form& g) {
                          return g.shape().degree(static_cast<int>(k)) > 0;
                        }));
  }
  tree_.emplace_back();
  push(std::move(root));
}

void Subdivision::push(Piece piece) {
  piece.lowest = lowest(piece.f);
  open_.push_back(std::move(piece));
  std::ranges::push_heap(open_, Worse());
}

Subdivision::Outcome Subdivision::run(long pieces) {
  while (!open_.empty()) {
    if (looked_at_ >= pieces) return Outcome::paused;
    if (looked_at_ % 16 == 15 && workshop_->late()) return Outcome::late;
    ++looked_at_;
    std::ranges::pop_heap(open_, Worse());
    const Piece piece = std::move(open_.back());
    open_.pop_back();
    if (refutes(piece)) return Outcome::refuted;
    if (settle(piece)) continue;
    const auto cut = choose(piece);
    if (!cut) return Outcome::hopeless;
    divide(piece, *cut);
  }
  return Outcome::proved;
}

bool Subdivision::settle(const Piece& piece) {
  const Factors& factors = question_->factors;
  if (is_plain(factors, piece, piece.f, 1, question_->strict)) return true;
  for (std::size_t i = 0; i < piece.where.size(); ++i)
    if (is_broken(factors, piece, piece.where[i], question_->where[i].relation)) {
      tree_[piece.node].kind = Step::Kind::outside;
      tree_[piece.node].index = static_cast<int>(i);
      return true;
    }
  return false;
}

bool Subdivision::refutes(const Piece& piece) {
  for (const auto& choice : corner_choices(piece)) {
    bool inside = true;
    for (std::size_t k = 0; k < choice.size(); ++k)
      inside = inside && (!relevant_[k] || !is_outside(question_->factors[k],
                                                       piece.corners[k][choice[k]]->support));
    if (!inside) continue;
    const auto sign = [&](const Form& form) { return form.sign(form.shape().corner(choice)); };
    const Sign s = sign(piece.f);
    if (s == Sign::positive || (s == Sign::zero && !question_->strict)) continue;
    for (std::size_t i = 0; i < piece.where.size(); ++i)
      inside = inside && holds(question_->where[i].relation, sign(piece.where[i]));
    if (!inside) continue;
    refutation_.emplace();
    for (std::size_t k = 0; k < choice.size(); ++k) {
      refutation_->push_back(piece.corners[k][choice[k]]->l);
      if (!relevant_[k])  // any point will do: the centre
        for (Polynomial& l : refutation_->back()) l = l.ring().constant(1);
    }
    return true;
  }
  return false;
}

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
      for (const Polynomial& w : weights) denominator = lcm(denominator, w.numerators().denominator);
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
    for (const Edge& a : flat)
      for (const Edge& b : flat) {
        if (std::pair(a.factor, a.to) >= std::pair(b.factor, b.to)) continue;
        const int once = shape.moved(pure, a.factor, choice[a.factor], a.to);
        const int twice = shape.moved(once, b.factor, choice[b.factor], b.to);
        if (twice < 0 || f.guess(twice) != Form::Guess::negative) continue;
        if (a.factor == b.factor) return edge(piece, a.factor, a.to, b.to);
        hopeless = question_->where.empty();
      }
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

void Subdivision::divide(const Piece& piece, const Cut& cut) {
  const auto& corners = piece.corners[cut.factor];
  const exact::Ring& numbers = corners[0]->l[0].ring();
  std::vector<Polynomial> l(corners[0]->l.size(), numbers.constant(0));
  for (std::size_t j = 0; j < corners.size(); ++j)
    for (std::size_t i = 0; i < l.size(); ++i) l[i] = l[i] + cut.weights[j] * corners[j]->l[i];
  const CornerPtr middle = make_corner(std::move(l));
  const auto shared = std::make_shared<const bernstein::Cut>(cut.weights);
  tree_[piece.node].kind = Step::Kind::split;
  tree_[piece.node].index = cut.factor;
  tree_[piece.node].weights = cut.weights;
  for (int i = 0; i < std::ssize(corners); ++i) {
    if (!shared->involves(i)) continue;
    Piece part{piece.corners, piece.f.part(cut.factor, i, shared), {}, 0, 0};
    part.corners[cut.factor][i] = middle;
    for (const Form& g : piece.where) part.where.push_back(g.part(cut.factor, i, shared));
    part.node = static_cast<int>(tree_.size());
    tree_[piece.node].parts.push_back(part.node);
    tree_.emplace_back();
    push(std::move(part));
  }
}

certificate::Subdivision Subdivision::steps() const {
  certificate::Subdivision result;
  std::vector<int> pending = {0};
  while (!pending.empty()) {
    const Node& node = tree_[pending.back()];
    pending.pop_back();
    Step step{node.kind, node.index, {}};
    for (const Polynomial& w : node.weights) step.weights.push_back(workshop_->write(w));
    result.push_back(std::move(step));
    pending.insert(pending.end(), node.parts.rbegin(), node.parts.rend());
  }
  return result;
}

std::vector<const Piece*> Subdivision::worst(int count) const {
  std::vector<const Piece*> result;
  for (const Piece& piece : open_) result.push_back(&piece);
  std::ranges::sort(result, [](const Piece* a, const Piece* b) { return Worse()(*b, *a); });
  if (std::ssize(result) > count) result.resize(count, nullptr);
  return result;
}

}  // namespace seam::prove
