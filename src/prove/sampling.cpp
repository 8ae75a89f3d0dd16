// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/sampling.h"

#include <cmath>
#include <cstdint>

namespace seam::prove {
namespace {

// The same points every time.
class Sequence {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

double about(const exact::Polynomial& f, const std::vector<double>& values) {
  const auto numerators = f.numerators();
  double sum = 0;
  for (const auto& [exponents, coordinates] : numerators.terms) {
    double term = exact::ball(f.ring().tower(), coordinates).middle;
    for (std::size_t i = 0; i < exponents.size(); ++i)
      term *= std::pow(values[i], exponents[i]);
    sum += term;
  }
  return sum / numerators.denominator.get_d();
}

std::vector<std::vector<double>> sample(const Factors& factors, std::size_t lines, int count) {
  Sequence sequence;
  std::vector<std::vector<double>> points;
  for (int n = 0; n < count; ++n) {
    std::vector<double> point;
    for (const Factor& factor : factors) {
      std::vector<double> sum(factor.corners.front().size(), 0.0);
      for (const auto& corner : factor.corners) {
        const double share = sequence.next() + 1e-3;
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += share * exact::ball(corner[i]).middle;
      }
      for (std::size_t i = 1; i < sum.size(); ++i) point.push_back(sum[i] / sum[0]);
    }
    for (std::size_t i = 0; i < lines; ++i) {
      const double t = 2 * sequence.next() - 1;
      point.push_back(n % 3 == 0 ? t : 4 * t / (1.01 - t * t));
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace seam::prove
