// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/touch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "bernstein/critical.h"
#include "bernstein/refine.h"
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
    const auto numerators = f.polynomial.numerators();
    for (const auto& term : numerators.terms)
      size_of_f_ = std::max(
          size_of_f_,
          std::abs(exact::ball(f.polynomial.ring().number(term.second, numerators.denominator))
                       .middle));
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
    return as_numbers(at);
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

  // f within the face, in its free coordinates.
  Polynomial within_face(const std::vector<double>& at) const {
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
    return ring->embed(f_.polynomial).substitute(plane, along);
  }

  // The location to many digits: f is 0 there, and it is an exact number, or f is nearly 0, and
  // a fraction nearby does.
  std::optional<Touch> as_numbers(const std::vector<double>& at) {
    const Polynomial f = within_face(at), one = f.ring().constant(1);
    std::vector<double> start;
    for (const Free& free : free_) start.push_back(at[offsets_[free.factor] + free.to]);
    std::vector<Rational> t;
    const long many = std::max(1000L, 50L * exact::dimension(workshop_.tower()));
    for (const long bits : {300L, many}) {
      const auto location = bernstein::refined(f, one, start, bits);
      if (!location) return std::nullopt;
      t = *location;
      std::vector<Polynomial> values;
      for (const Rational& x : t) values.push_back(workshop_.numbers()->constant(x));
      const auto value = exact::enclosure(f.substitute(workshop_.numbers(), values), 2 * bits);
      const Rational nothing(1, Integer(1) << (bits - 50));
      if (value.high > nothing || value.low < -nothing) return nearly(at, t, value.high, bits);
    }
    std::vector<Polynomial> values;
    for (const Rational& x : t) {
      const auto number = guessed(x, many - 40);
      if (!number) return std::nullopt;
      values.push_back(*number);
    }
    for (Polynomial& x : values) x = workshop_.numbers()->embed(x);
    return verify(place(at, values));
  }

  // As many digits as it takes for the gradient to be less than f.
  std::optional<Touch> nearly(const std::vector<double>& at, const std::vector<Rational>& t,
                              const Rational& value, long most_bits) const {
    constexpr double small = 1e-5;
    const double about = value.get_d();
    if (about > small * size_of_f_) return std::nullopt;
    const long bits =
        about > 0 ? std::min(most_bits, 24L - std::ilogb(about / size_of_f_)) : most_bits;
    std::vector<Polynomial> values;
    for (const Rational& x : t)
      values.push_back(
          workshop_.numbers()->constant(exact::simplest(x, Rational(1, Integer(1) << bits))));
    Place where = place(at, values);
    if (about <= 0) return verify(std::move(where));
    for (const auto& l : where)
      for (const Polynomial& c : l)
        if (exact::sign(c) == Sign::negative) return std::nullopt;
    return Touch{std::move(where), Sign::positive};
  }

  // A number over the tower, which may grow.
  std::optional<Polynomial> guessed(const Rational& value, long bits) {
    constexpr int most_degree = 8, most_dimension = 24;
    if (exact::dimension(workshop_.tower()) > most_dimension) return std::nullopt;
    if (auto known = exact::recognise(workshop_.numbers(), value, bits)) return known;
    const int most =
        std::min(most_degree, most_dimension / exact::dimension(workshop_.tower()));
    const auto f = exact::annihilator(workshop_.numbers(), value, most, bits);
    if (!f) return std::nullopt;
    const auto roots = exact::squarefree(*f);
    for (const exact::RootInterval& root : exact::real_roots(roots))
      if (root.low <= value && value <= root.high) return workshop_.adjoin(roots, root);
    return std::nullopt;
  }

  Workshop& workshop_;
  const Factors& factors_;
  const Barycentric& f_;
  bernstein::Sketch sketch_;
  std::vector<int> offsets_;
  int size_ = 0;
  double size_of_f_ = 0;  ///< its largest coefficient, about
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
