// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/extremum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "bernstein/critical.h"
#include "exact/contract.h"

// A maximum is a critical point within one of the faces. On each face Newton's method starts
// from every point of a grid that is not lower than its neighbours.

namespace seam::bernstein {

using exact::Polynomial;
using exact::RingPtr;

namespace {

constexpr double same_value = 1e-9;  // of the range of all values seen
constexpr double same_place = 1e-7;
constexpr double margin = 1e-9;  // from the boundary of a face

// How many steps a grid takes along an edge of a face of that dimension.
int grid_of(std::size_t dimension) {
  constexpr int steps[] = {1, 96, 24, 10, 7};
  return dimension < std::size(steps) ? steps[dimension] : 0;
}

std::vector<Face> faces(const std::vector<int>& dimensions) {
  std::vector<Face> result = {{}};
  for (const int dimension : dimensions) {
    std::vector<Face> longer;
    for (const Face& face : result)
      for (unsigned corners = 1; corners < 2U << dimension; ++corners) {
        longer.push_back(face);
        longer.back().push_back(corners);
      }
    result = std::move(longer);
  }
  return result;
}

// The dimensions of the face within each factor.
std::vector<int> extents(const Face& face) {
  std::vector<int> result;
  for (const unsigned corners : face) result.push_back(std::popcount(corners) - 1);
  return result;
}

class FaceSearch {
 public:
  FaceSearch(const Landscape::Restriction& f, const Face& face)
      : face_(face),
        extents_(extents(face)),
        size_(f.numerator.ring().variables().size()),
        numerator_(f.numerator),
        denominator_(f.denominator) {}

  std::vector<Spot> run() {
    centre();
    if (size_ == 0) return spots_;
    const int steps = grid_of(size_);
    std::vector<int> index;
    sample(index, 0, 0, steps);
    for (const auto& [here, value] : heights_)
      if (is_peak(here, value)) climb(spot(here, steps));
    return spots_;
  }

  double lowest = HUGE_VAL;  ///< of the values seen

 private:
  double value(const std::vector<double>& at) {
    const double result = numerator_.value(at) / denominator_.value(at);
    lowest = std::min(lowest, result);
    return result;
  }

  void centre() {
    std::vector<double> at;
    for (const int extent : extents_) at.insert(at.end(), extent, 1.0 / (extent + 1));
    spots_.push_back({value(at), face_, at, true});
  }

  static std::vector<double> spot(const std::vector<int>& index, int steps) {
    std::vector<double> at;
    for (const int i : index) at.push_back(static_cast<double>(i) / steps);
    return at;
  }

  // The points of the grid within the face, `index` being the beginning of one.
  void sample(std::vector<int>& index, std::size_t factor, int used, int steps) {
    if (index.size() == size_) {
      heights_.emplace(index, value(spot(index, steps)));
      return;
    }
    std::size_t begin = 0;
    for (std::size_t k = 0; k < factor; ++k) begin += extents_[k];
    if (index.size() == begin + extents_[factor]) return sample(index, factor + 1, 0, steps);
    for (int i = 1; used + i < steps; ++i) {
      index.push_back(i);
      sample(index, factor, used + i, steps);
      index.pop_back();
    }
  }

  bool is_peak(const std::vector<int>& here, double height) const {
    const auto is_higher = [&](const std::vector<int>& there) {
      const auto found = heights_.find(there);
      return found != heights_.end() && found->second > height;
    };
    for (std::size_t i = 0; i < size_; ++i)
      for (const int di : {-1, 1}) {
        auto there = here;
        there[i] += di;
        if (is_higher(there)) return false;
        for (std::size_t j = 0; j < i; ++j)
          for (const int dj : {-1, 1}) {
            auto across = there;
            across[j] += dj;
            if (is_higher(across)) return false;
          }
      }
    return true;
  }

  bool is_within(const std::vector<double>& at) const {
    std::size_t next = 0;
    for (const int extent : extents_) {
      double left = 1;
      for (int i = 0; i < extent; ++i, ++next) {
        if (!(at[next] > margin)) return false;
        left -= at[next];
      }
      if (!(left > margin)) return false;
    }
    return true;
  }

  void climb(const std::vector<double>& start) {
    std::vector<Direction> axes(size_, Direction(size_, 0));
    for (std::size_t i = 0; i < size_; ++i) axes[i][i] = 1;
    const auto at = critical_point(numerator_, &denominator_, start, axes);
    if (at.empty() || !is_within(at)) return;
    const auto is_known = [&](const Spot& spot) {
      for (std::size_t i = 0; i < size_; ++i)
        if (std::abs(spot.at[i] - at[i]) > same_place) return false;
      return !spot.is_centre;
    };
    if (std::ranges::none_of(spots_, is_known)) spots_.push_back({value(at), face_, at, false});
  }

  Face face_;
  std::vector<int> extents_;
  std::size_t size_;
  Sketch numerator_, denominator_;
  std::map<std::vector<int>, double> heights_;
  std::vector<Spot> spots_;
};

}  // namespace

Landscape::Landscape(Polynomial numerator, Polynomial denominator, std::vector<int> dimensions)
    : numerator_(std::move(numerator)),
      denominator_(std::move(denominator)),
      dimensions_(std::move(dimensions)) {
  int total = 0;
  for (const int dimension : dimensions_) total += dimension;
  exact::require(std::ssize(numerator_.ring().variables()) == total,
                 "Landscape: other variables than coordinates");
}

bool Landscape::operator==(const Landscape& other) const {
  return dimensions_ == other.dimensions_ &&
         numerator_.ring().tower() == other.numerator_.ring().tower() &&
         numerator_ == other.numerator_ && denominator_ == other.denominator_;
}

Landscape::Restriction Landscape::on(const Face& face) const {
  std::vector<std::string> names;
  for (const int extent : extents(face))
    for (int i = 0; i < extent; ++i) names.push_back("t" + std::to_string(names.size()));
  const RingPtr ring = exact::Ring::make(numerator_.ring().tower(), names);
  std::vector<Polynomial> place;
  int next = 0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int first = std::countr_zero(face[k]);
    std::vector<Polynomial> shares(dimensions_[k] + 1, ring->constant(0));
    shares[first] = ring->constant(1);
    for (int i = first + 1; i <= dimensions_[k]; ++i) {
      if ((face[k] >> i & 1U) == 0) continue;
      shares[i] = ring->variable(next++);
      shares[first] = shares[first] - shares[i];
    }
    place.insert(place.end(), shares.begin() + 1, shares.end());
  }
  return {numerator_.substitute(ring, place), denominator_.substitute(ring, place), place};
}

std::vector<Spot> Landscape::highest() const {
  std::vector<Spot> spots;
  double lowest = HUGE_VAL;
  for (const Face& face : faces(dimensions_)) {
    FaceSearch search(on(face), face);
    for (Spot& spot : search.run())
      if (std::isfinite(spot.value)) spots.push_back(std::move(spot));
    lowest = std::min(lowest, search.lowest);
  }
  if (spots.empty()) return spots;
  double best = -HUGE_VAL;
  for (const Spot& spot : spots) best = std::max(best, spot.value);
  const double slack =
      same_value * (best - (std::isfinite(lowest) ? lowest : best)) + 1e-14 * std::abs(best);
  std::erase_if(spots, [&](const Spot& spot) { return spot.value < best - slack; });
  std::ranges::stable_sort(spots, [](const Spot& a, const Spot& b) {
    return std::pair(a.at.size(), !a.is_centre) < std::pair(b.at.size(), !b.is_centre);
  });
  return spots;
}

}  // namespace seam::bernstein
