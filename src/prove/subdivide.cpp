// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/subdivide.h"

#include <algorithm>
#include <utility>

#include "exact/contract.h"
#include "prove/plain.h"

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
  for (const Polynomial& c : l)
    corner->at.push_back(exact::ball(Rational(1, corner->total) * c).middle);
  corner->l = std::move(l);
  return corner;
}

double lowest(const Form& form) {
  double result = form.about(0);
  for (int i = 1; i < form.shape().count(); ++i) result = std::min(result, form.about(i));
  return result;
}

}  // namespace

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

Subdivision::Subdivision(Workshop& workshop, const Question& question,
                         std::vector<Place> touches)
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
  if (is_plain(factors, piece, piece.f, 1, question_->strict, question_->where)) return true;
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

void Subdivision::divide(const Piece& piece, const Cut& cut) {
  const auto& corners = piece.corners[cut.factor];
  const exact::Ring& numbers = corners[0]->l[0].ring();
  std::vector<Polynomial> l(corners[0]->l.size(), numbers.constant(0));
  for (std::size_t j = 0; j < corners.size(); ++j)
    for (std::size_t i = 0; i < l.size(); ++i) l[i] = l[i] + cut.weights[j] * corners[j]->l[i];
  const CornerPtr middle = make_corner(std::move(l));
  std::vector<Integer> totals;
  for (const CornerPtr& corner : corners) totals.push_back(corner->total);
  const auto shared = std::make_shared<const bernstein::Cut>(cut.weights, totals);
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
