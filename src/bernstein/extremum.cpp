// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/extremum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bernstein/critical.h"
#include "exact/contract.h"
#include "exact/recognise.h"

// The maximum is at a corner, at a critical point within an edge, or at one inside. Newton's
// method starts from every point of a grid that is not lower than its neighbours.

namespace seam::bernstein {

using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;
using exact::RootInterval;
using exact::Univariate;

namespace {

constexpr int grid = 24;
constexpr double same_value = 1e-8;

using Spot = std::vector<double>;

struct Edge {
  Candidate::Point start, direction;
};

std::vector<Edge> edges(Patch patch) {
  if (patch == Patch::triangle) return {{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}, {{1, 0}, {-1, 1}}};
  return {{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}, {{0, 1}, {1, 0}}, {{1, 0}, {0, 1}}};
}

bool is_in(Patch patch, const Spot& x) {
  constexpr double slack = 1e-9;
  const double limit = patch == Patch::triangle ? x[0] + x[1] : std::max(x[0], x[1]);
  return x[0] > -slack && x[1] > -slack && limit < 1 + slack;
}

class Search {
 public:
  Search(const Polynomial& numerator, const Polynomial& denominator, Patch patch)
      : numerator_(numerator),
        denominator_(denominator),
        patch_(patch),
        sketch_(numerator),
        sketch_below_(denominator) {}

  std::vector<Candidate> run() {
    for (const Edge& edge : edges(patch_)) {
      corner(edge.start);
      corner({edge.start[0] + edge.direction[0], edge.start[1] + edge.direction[1]});
      within(edge);
    }
    inside();
    double best = found_.front().value;
    for (const Candidate& c : found_) best = std::max(best, c.value);
    std::erase_if(found_, [&](const Candidate& c) {
      return c.value < best - same_value * std::max(1.0, std::abs(best));
    });
    return found_;
  }

 private:
  double value(const Spot& x) const {
    return sketch_.jet(x).value / sketch_below_.jet(x).value;
  }

  void add(Candidate candidate) {
    const auto same = [&](const Candidate& c) {
      return c.at == candidate.at && c.is_critical == candidate.is_critical;
    };
    if (std::ranges::none_of(found_, same)) found_.push_back(std::move(candidate));
  }

  void corner(const Candidate::Point& at) {
    add({value({at[0].get_d(), at[1].get_d()}), at, true, std::nullopt});
  }

  static Candidate::Point simplest(const Spot& x) {
    const Rational tolerance(1, 10'000'000);
    return {exact::simplest(Rational(x[0]), tolerance),
            exact::simplest(Rational(x[1]), tolerance)};
  }

  // The critical points along the edge are the roots of n' d - n d', exactly.
  void within(const Edge& edge) {
    const RingPtr line = exact::Ring::make(numerator_.ring().tower(), {"t"});
    std::vector<Polynomial> along;
    for (int i = 0; i < 2; ++i)
      along.push_back(line->constant(edge.start[i]) + edge.direction[i] * line->variable(0));
    const Polynomial n = numerator_.substitute(line, along);
    const Polynomial d = denominator_.substitute(line, along);
    const Polynomial slope = n.derivative(0) * d - n * d.derivative(0);
    if (slope.is_zero()) return;
    const Univariate f = exact::squarefree(exact::univariate(slope, 0));
    for (RootInterval root : exact::real_roots(f, 0, 1)) {
      while (root.high - root.low > Rational(1, 1L << 40)) root = exact::halved(f, root);
      const double t = Rational((root.low + root.high) / 2).get_d();
      const Spot x = {edge.start[0].get_d() + t * edge.direction[0].get_d(),
                      edge.start[1].get_d() + t * edge.direction[1].get_d()};
      const Rational fraction = exact::simplest(Rational(t), Rational(1, 10'000'000));
      Candidate candidate{value(x), {}, false, std::nullopt};
      for (int i = 0; i < 2; ++i)
        candidate.at[i] = edge.start[i] + fraction * edge.direction[i];
      candidate.is_critical = exact::value(f, line->constant(fraction)).is_zero();
      if (!candidate.is_critical)
        candidate.on_edge = Candidate::OnEdge{edge.start, edge.direction, f, root};
      add(std::move(candidate));
    }
  }

  void inside() {
    std::vector<std::vector<double>> heights(grid + 1,
                                             std::vector<double>(grid + 1, -HUGE_VAL));
    const auto spot = [](int i, int j) { return Spot{double(i) / grid, double(j) / grid}; };
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; j <= grid; ++j)
        if (is_in(patch_, spot(i, j))) heights[i][j] = value(spot(i, j));
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; j <= grid; ++j) {
        if (!is_in(patch_, spot(i, j))) continue;
        bool is_peak = true;
        for (int a = std::max(0, i - 1); a <= std::min(grid, i + 1); ++a)
          for (int b = std::max(0, j - 1); b <= std::min(grid, j + 1); ++b)
            is_peak = is_peak && heights[a][b] <= heights[i][j];
        if (is_peak) climb(spot(i, j));
      }
  }

  void climb(const Spot& start) {
    const Spot x = critical_point(sketch_, &sketch_below_, start, {{1, 0}, {0, 1}});
    if (x.empty() || !is_in(patch_, x)) return;
    Candidate candidate{value(x), simplest(x), false, std::nullopt};
    const RingPtr numbers = exact::Ring::make(numerator_.ring().tower(), {});
    const std::vector<Polynomial> at = {numbers->constant(candidate.at[0]),
                                        numbers->constant(candidate.at[1])};
    candidate.is_critical = true;
    for (int i = 0; i < 2; ++i) {
      const Polynomial slope = numerator_.derivative(i).substitute(numbers, at) *
                                   denominator_.substitute(numbers, at) -
                               numerator_.substitute(numbers, at) *
                                   denominator_.derivative(i).substitute(numbers, at);
      candidate.is_critical = candidate.is_critical && slope.is_zero();
    }
    add(std::move(candidate));
  }

  const Polynomial& numerator_;
  const Polynomial& denominator_;
  Patch patch_;
  Sketch sketch_, sketch_below_;
  std::vector<Candidate> found_;
};

}  // namespace

std::vector<Candidate> maximum(const Polynomial& numerator, const Polynomial& denominator,
                               Patch patch) {
  exact::require(numerator.ring().variables().size() == 2, "maximum: not two variables");
  return Search(numerator, denominator, patch).run();
}

}  // namespace seam::bernstein
