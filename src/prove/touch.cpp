// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/touch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "bernstein/critical.h"
#include "exact/recognise.h"
#include "exact/roots.h"

// Only search: whatever is returned has been evaluated exactly, and where nothing is found
// nothing is claimed.

namespace seam::prove {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;
using exact::Sign;

namespace {

// A face of the domain: some corners of each factor.
using Face = std::vector<Corners>;

std::vector<Face> faces(const Factors& factors) {
  std::vector<Face> result = {{}};
  for (const Factor& factor : factors) {
    std::vector<Face> longer;
    for (const Face& face : result)
      for (Corners c = 1; c < 1U << factor.corners.size(); ++c) {
        longer.push_back(face);
        longer.back().push_back(c);
      }
    result = std::move(longer);
  }
  return result;
}

std::vector<int> members(Corners corners) {
  std::vector<int> result;
  for (int i = 0; corners >> i != 0; ++i)
    if ((corners >> i & 1U) != 0) result.push_back(i);
  return result;
}

class Search {
 public:
  Search(Workshop& workshop, const Factors& factors, const Barycentric& f)
      : workshop_(workshop), factors_(factors), f_(f), sketch_(f.polynomial) {
    int offset = 0;
    for (const Factor& factor : factors) {
      offsets_.push_back(offset);
      offset += static_cast<int>(factor.corners.size());
    }
    size_ = offset;
  }

  // A touch on the face near the piece, if there is one.
  std::optional<Touch> look(const Face& face, const Piece& piece) {
    std::vector<double> start(size_, 0);
    for (std::size_t k = 0; k < face.size(); ++k) {
      int count = 0;
      for (const CornerPtr& corner : piece.corners[k]) {
        if ((corner->support & ~face[k]) != 0) continue;
        ++count;
        for (std::size_t i = 0; i < corner->at.size(); ++i)
          start[offsets_[k] + i] += corner->at[i];
      }
      if (count == 0) return std::nullopt;
      for (std::size_t i = 0; i < factors_[k].corners.size(); ++i)
        start[offsets_[k] + i] /= count;
    }
    directions_.clear();
    free_.clear();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto corners = members(face[k]);
      for (std::size_t i = 1; i < corners.size(); ++i) {
        free_.push_back({static_cast<int>(k), corners[0], corners[i]});
        directions_.emplace_back(size_, 0.0);
        directions_.back()[offsets_[k] + corners[0]] = -1;
        directions_.back()[offsets_[k] + corners[i]] = 1;
      }
    }
    if (free_.empty()) return std::nullopt;
    const auto at = bernstein::critical_point(sketch_, nullptr, start, directions_);
    const auto is_share = [](double x) {
      return std::isfinite(x) && x > -1e-9 && x < 1 + 1e-9;
    };
    if (at.empty() || !std::ranges::all_of(at, is_share)) return std::nullopt;
    std::vector<long> key;
    for (const double x : at) key.push_back(std::lround(x * 1e9));
    if (!seen_.insert(key).second) return std::nullopt;
    if (auto touch = as_fractions(at)) return touch;
    if (free_.size() == 1)
      if (auto touch = as_double_root(at)) return touch;
    if (workshop_.tower()) return as_numbers(at);
    return std::nullopt;
  }

 private:
  struct Free {
    int factor, from, to;
  };

  // The place with these values of the free coordinates, the others in a factor being 0 but for
  // one.
  Place place(const std::vector<double>& at, const std::vector<Polynomial>& values) const {
    Place result;
    const RingPtr numbers = workshop_.numbers();
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      result.emplace_back(factors_[k].corners.size(), numbers->constant(0));
      // A factor without freedom is at the corner where the search was kept.
      const auto first = at.begin() + offsets_[k];
      const auto corner = std::max_element(first, first + factors_[k].corners.size()) - first;
      if (std::ranges::none_of(free_,
                               [&](const Free& f) { return f.factor == static_cast<int>(k); }))
        result.back()[corner] = numbers->constant(1);
    }
    for (std::size_t a = 0; a < free_.size(); ++a) {
      auto& l = result[free_[a].factor];
      if (a == 0 || free_[a - 1].factor != free_[a].factor)
        l[free_[a].from] = numbers->constant(1);
      l[free_[a].from] = l[free_[a].from] - values[a];
      l[free_[a].to] = values[a];
    }
    return result;
  }

  std::optional<Touch> verify(Place place) const {
    const RingPtr numbers = workshop_.numbers();
    std::vector<Polynomial> values;
    for (const auto& l : place)
      for (const Polynomial& c : l) {
        if (exact::sign(c) == Sign::negative) return std::nullopt;
        values.push_back(c);
      }
    const RingPtr ring = workshop_.ring(f_.polynomial.ring().variables());
    const Sign sign = exact::sign(ring->embed(f_.polynomial).substitute(numbers, values));
    if (sign == Sign::positive) return std::nullopt;
    return Touch{std::move(place), sign};
  }

  std::optional<Touch> as_fractions(const std::vector<double>& at) const {
    for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
      std::vector<Polynomial> values;
      for (const Free& f : free_)
        values.push_back(workshop_.numbers()->constant(
            exact::simplest(Rational(at[offsets_[f.factor] + f.to]), Rational(tolerance))));
      if (auto touch = verify(place(at, values))) return touch;
    }
    return std::nullopt;
  }

  // Along an edge f is a univariate polynomial; where it touches 0, it has a multiple root.
  std::optional<Touch> as_double_root(const std::vector<double>& at) {
    const RingPtr line = workshop_.ring({"t"});
    std::vector<Polynomial> along;
    for (const auto& l : place(at, {workshop_.numbers()->constant(0)}))
      for (const Polynomial& c : l) along.push_back(line->embed(c));
    along[offsets_[free_[0].factor] + free_[0].from] = line->constant(1) - line->variable(0);
    along[offsets_[free_[0].factor] + free_[0].to] = line->variable(0);
    const RingPtr ring = workshop_.ring(f_.polynomial.ring().variables());
    const auto f = exact::univariate(ring->embed(f_.polynomial).substitute(line, along), 0);
    if (exact::degree(f) < 2) return std::nullopt;
    const auto multiple = exact::gcd(f, exact::derivative(f));
    if (exact::degree(multiple) < 1) return std::nullopt;
    exact::Univariate roots;
    for (const Polynomial& c : exact::squarefree(multiple)) roots.push_back(c);
    const double t = at[offsets_[free_[0].factor] + free_[0].to];
    for (exact::RootInterval root : exact::real_roots(roots, 0, 1)) {
      while (root.high - root.low > Rational(1e-7)) root = exact::halved(roots, root);
      if (std::abs(root.low.get_d() - t) > 1e-5) continue;
      return verify(place(at, {workshop_.adjoin(roots, root)}));
    }
    return std::nullopt;
  }

  // The location to many digits, by Newton's method with exact gradients; then numbers over the
  // tower.
  std::optional<Touch> as_numbers(const std::vector<double>& at) const {
    constexpr long bits = 300;
    std::vector<std::string> names;
    for (std::size_t a = 0; a < free_.size(); ++a) names.push_back("t" + std::to_string(a));
    const RingPtr plane = workshop_.ring(names), numbers = workshop_.numbers();
    std::vector<Polynomial> along;
    for (const auto& l : place(at, std::vector(free_.size(), numbers->constant(0))))
      for (const Polynomial& c : l) along.push_back(plane->embed(c));
    for (std::size_t a = 0; a < free_.size(); ++a) {
      auto& from = along[offsets_[free_[a].factor] + free_[a].from];
      from = from - plane->variable(static_cast<int>(a));
      along[offsets_[free_[a].factor] + free_[a].to] = plane->variable(static_cast<int>(a));
    }
    const RingPtr ring = workshop_.ring(f_.polynomial.ring().variables());
    const Polynomial f = ring->embed(f_.polynomial).substitute(plane, along);
    std::vector<Polynomial> gradient;
    for (std::size_t a = 0; a < free_.size(); ++a)
      gradient.push_back(f.derivative(static_cast<int>(a)));

    std::vector<double> near;
    for (const Free& free : free_) near.push_back(at[offsets_[free.factor] + free.to]);
    const auto hessian = bernstein::Sketch(f).jet(near).hessian;
    std::vector<Rational> t(near.begin(), near.end());
    for (int round = 0; round < 60; ++round) {
      std::vector<Polynomial> here;
      for (const Rational& x : t) here.push_back(numbers->constant(x));
      std::vector<double> slope;
      for (const Polynomial& g : gradient)
        slope.push_back(exact::enclosure(g.substitute(numbers, here), bits).low.get_d());
      const auto step = bernstein::solve(hessian, slope);
      if (step.empty()) return std::nullopt;
      double size = 0;
      for (std::size_t a = 0; a < t.size(); ++a) {
        if (!std::isfinite(step[a])) return std::nullopt;
        size = std::max(size, std::abs(step[a]));
        Rational moved = t[a] - Rational(step[a]);
        Integer kept;  // 2^bits * moved, rounded
        mpq_mul_2exp(moved.get_mpq_t(), moved.get_mpq_t(), bits);
        mpz_fdiv_q(kept.get_mpz_t(), moved.get_num_mpz_t(), moved.get_den_mpz_t());
        t[a] = kept;
        mpq_div_2exp(t[a].get_mpq_t(), t[a].get_mpq_t(), bits);
      }
      if (!(size < 1)) return std::nullopt;
      if (size < 0x1p-240) break;
    }
    std::vector<Polynomial> values;
    for (const Rational& x : t) {
      const auto number = exact::recognise(numbers, x, 220);
      if (!number) return std::nullopt;
      values.push_back(*number);
    }
    return verify(place(at, values));
  }

  Workshop& workshop_;
  const Factors& factors_;
  const Barycentric& f_;
  bernstein::Sketch sketch_;
  std::vector<int> offsets_;
  int size_ = 0;
  std::vector<Free> free_;
  std::vector<bernstein::Direction> directions_;
  std::set<std::vector<long>> seen_;
};

}  // namespace

std::vector<Touch> find_touches(Workshop& workshop, const Factors& factors,
                                const Barycentric& f, const std::vector<const Piece*>& pieces) {
  Search search(workshop, factors, f);
  std::vector<Touch> result;
  for (const Face& face : faces(factors))
    for (const Piece* piece : pieces) {
      if (workshop.late()) return result;
      if (auto touch = search.look(face, *piece)) result.push_back(std::move(*touch));
    }
  return result;
}

}  // namespace seam::prove
