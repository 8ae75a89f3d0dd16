// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/rules.h"
#include "check/system.h"

// Why there is a solution in the inner box. G is continuous, G_i < 0 on the lower face of x_i
// and G_i > 0 on the upper one: by the theorem of Poincaré and Miranda all G_i are 0 somewhere
// in the box. G is an invertible combination of as many F, so all F are 0 there.
//
// Why there is no second one in the outer box. Let G(x) = G(y). For each i the mean value
// theorem gives a point of the segment, hence of the box, at which the gradient of G_i is
// orthogonal to x - y. The matrix of these gradients is strictly diagonally dominant: where the
// diagonal entry plus the others with any signs is positive, it exceeds the sum of their
// absolute values. Hence it is invertible, and x = y.
//
// The cover: at a solution all F and all G are 0, so there x_j lies in the outer box.

namespace seam::check {
namespace {

using certificate::Box;
using certificate::Isolation;
using certificate::OneSolution;
using certificate::Pieces;
using certificate::Relation;

constexpr std::size_t most_unknowns = 4;

class Isolating {
 public:
  Isolating(Context& context, const OneSolution& stated, const Isolation& shown)
      : context_(context), ring_(context.ring()), stated_(stated), shown_(shown) {
    std::vector<certificate::Term> terms = stated.system;
    for (const auto& condition : stated.domain.where) terms.push_back(condition.formula);
    demand(context.functions(std::move(terms)).empty(), "unsupported: a system with functions");
    domain_ = make_region(context, stated.domain, {});
    const std::set<int> bound = context.variables(stated.unknowns);
    demand(bound == variables(domain_) && !bound.empty(),
           "degenerate: the unknowns are not those of the domain");
    demand(bound.size() <= most_unknowns, "unsupported: more than four unknowns");
    for (const std::string& name : stated.unknowns) unknowns_.push_back(context.variable(name));
    equations_ = read_system(context, stated.system, stated.for_all, bound);
  }

  bool decide() {
    if (shown_.combination.empty()) {
      demand(shown_.cover.size() == 1, "not one tree that there is no solution");
      verify(context_, solutions(), constant(-1), Relation::nonnegative, shown_.cover.front());
      return false;
    }
    combine();
    const Intervals inner = intervals(shown_.inner);
    const Intervals stated = intervals({stated_.low, stated_.high});
    verify_inside(inner);
    verify_faces(inner);
    verify_conditions(inner);
    if (is_apart(inner, stated)) return false;
    const Intervals outer = intervals(shown_.outer);
    demand(is_within(inner, stated), "the inner box is not in that of the statement");
    demand(is_within(inner, outer), "the inner box is not in the outer one");
    verify_dominance(outer);
    verify_cover(outer);
    return true;
  }

 private:
  struct Ends {
    Polynomial low, high;
  };
  using Intervals = std::vector<Ends>;

  Intervals intervals(const Box& box) {
    demand(box.low.size() == unknowns_.size(), "not one interval for each unknown");
    Intervals result;
    for (std::size_t j = 0; j < unknowns_.size(); ++j) {
      result.push_back({context_.rational(box.low[j]), context_.rational(box.high[j])});
      demand(is_below(result.back().low, result.back().high), "an interval is empty");
    }
    return result;
  }

  bool is_below(const Polynomial& a, const Polynomial& b) {
    return context_.tower().sign(ring_.difference(b, a)) > 0;
  }
  bool is_within(const Intervals& small, const Intervals& large) {
    for (std::size_t j = 0; j < small.size(); ++j)
      if (is_below(small[j].low, large[j].low) || is_below(large[j].high, small[j].high))
        return false;
    return true;
  }
  bool is_apart(const Intervals& a, const Intervals& b) {
    for (std::size_t j = 0; j < a.size(); ++j)
      if (is_below(a[j].high, b[j].low) || is_below(b[j].high, a[j].low)) return true;
    return false;
  }

  // The box as a region, without the interval of unknown number `left_out`.
  Region region(const Intervals& box, std::size_t left_out) {
    Region result;
    int next = context_.free_symbol();
    for (std::size_t j = 0; j < box.size(); ++j) {
      if (j == left_out) continue;
      result.factors.push_back(make_factor(
          context_, {unknowns_[j]}, {{constant(1), box[j].low}, {constant(1), box[j].high}},
          {false, false}, next));
      next += 2;
    }
    return result;
  }

  void combine() {
    const std::size_t n = unknowns_.size();
    demand(equations_.size() == n && shown_.combination.size() == n,
           "not as many equations as unknowns");
    std::vector<Coordinates> matrix;
    for (const auto& row : shown_.combination) {
      demand(row.size() == n, "not as many equations as unknowns");
      Coordinates& entries = matrix.emplace_back();
      Polynomial sum;
      for (std::size_t j = 0; j < n; ++j) {
        entries.push_back(context_.rational(row[j]));
        sum = ring_.sum(sum, ring_.product(entries.back(), equations_[j]));
      }
      combined_.push_back(sum);
    }
    demand(context_.tower().sign(determinant(ring_, matrix)) != 0,
           "the combination of equations is not invertible");
  }

  void verify_inside(const Intervals& inner) {
    for (std::size_t vertex = 0; vertex < std::size_t{1} << inner.size(); ++vertex)
      for (const Factor& factor : domain_.factors) {
        Coordinates values;
        for (const int variable : factor.variables)
          for (std::size_t j = 0; j < inner.size(); ++j)
            if (unknowns_[j] == variable)
              values.push_back((vertex >> j & 1) != 0 ? inner[j].high : inner[j].low);
        demand(contains(context_, factor, values), "the inner box leaves the domain");
      }
  }

  void verify_faces(const Intervals& inner) {
    demand(shown_.faces.size() == 2 * inner.size(), "not two faces for each unknown");
    for (std::size_t j = 0; j < inner.size(); ++j) {
      const Region face = region(inner, j);
      verify(context_, face, ring_.substitute(combined_[j], unknowns_[j], inner[j].low),
             Relation::negative, shown_.faces[2 * j]);
      verify(context_, face, ring_.substitute(combined_[j], unknowns_[j], inner[j].high),
             Relation::positive, shown_.faces[2 * j + 1]);
    }
  }

  void verify_conditions(const Intervals& inner) {
    demand(shown_.conditions.size() == domain_.where.size(), "not one tree for each condition");
    const Region box = region(inner, inner.size());
    for (std::size_t i = 0; i < domain_.where.size(); ++i)
      verify(context_, box, domain_.where[i].formula, domain_.where[i].relation,
             shown_.conditions[i]);
  }

  void verify_dominance(const Intervals& outer) {
    const std::size_t n = outer.size(), choices = std::size_t{1} << (n - 1);
    demand(shown_.dominance.size() == n * choices, "not one tree for each choice of signs");
    const Region box = region(outer, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t signs = 0; signs < choices; ++signs) {
        Polynomial sum = derivative(combined_[i], unknowns_[i], context_.meter());
        std::size_t left = signs;
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i) continue;
          const Polynomial slope = derivative(combined_[i], unknowns_[j], context_.meter());
          sum = ring_.sum(sum, left % 2 == 0 ? slope : negated(slope));
          left /= 2;
        }
        verify(context_, box, sum, Relation::positive, shown_.dominance[i * choices + signs]);
      }
  }

  // The domain where the system vanishes.
  Region solutions() const {
    Region result = domain_;
    for (const auto* formulas : {&equations_, &combined_})
      for (const Polynomial& f : *formulas) result.where.push_back({f, Relation::zero});
    return result;
  }

  void verify_cover(const Intervals& outer) {
    demand(shown_.cover.size() == 2 * outer.size(), "not two trees for each unknown");
    const Region all = solutions();
    for (std::size_t j = 0; j < outer.size(); ++j) {
      const Polynomial x = symbol(unknowns_[j]);
      verify(context_, all, ring_.difference(x, outer[j].low), Relation::nonnegative,
             shown_.cover[2 * j]);
      verify(context_, all, ring_.difference(outer[j].high, x), Relation::nonnegative,
             shown_.cover[2 * j + 1]);
    }
  }

  Context& context_;
  Ring& ring_;
  const OneSolution& stated_;
  const Isolation& shown_;
  Region domain_;
  std::vector<int> unknowns_;
  std::vector<Polynomial> equations_, combined_;  // F and G
};

}  // namespace

bool decide(Context& context, const OneSolution& stated, const certificate::Proof& proof) {
  const auto* isolation = std::get_if<Isolation>(&proof);
  demand(isolation != nullptr, "evidence of a kind that says nothing of one solution");
  return Isolating(context, stated, *isolation).decide();
}

}  // namespace seam::check
