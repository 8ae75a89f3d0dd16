// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/cover.h"

#include <algorithm>
#include <cmath>

#include "exact/recognise.h"

// Of each function the runs of a mesh on which it is above the bound, their ends made precise
// by bisection. From the beginning on, the run that leads farthest is followed, and of those
// that overlap with it the one that leads farthest after it. Each leads farther than that
// before, so this ends. Cuts lie in the middle of overlaps, where both functions have room.

namespace seam::claims {
namespace {

using exact::Rational;

constexpr double nearest = 1e-9, farthest = 1e9, ratio = 1.05;
constexpr int even_steps = 200;
constexpr double same_value = 1e-12;

// Where a function is not below the bound, in distances from the beginning.
struct Run {
  std::size_t function;
  bool negative;
  double begin, end;
};

// Distances from the beginning, close to each other near it.
std::vector<double> mesh(double room, double scale) {
  std::vector<double> result;
  const double last = std::isfinite(room) ? room * (1 - nearest) : farthest * scale;
  const double unit = std::isfinite(room) ? room : scale;
  for (double d = nearest * unit; d < last; d *= ratio) result.push_back(d);
  if (std::isfinite(room))
    for (int i = 1; i < even_steps; ++i) result.push_back(room * i / even_steps);
  result.push_back(last);
  std::ranges::sort(result);
  return result;
}

// Between a distance where it holds and one where it does not.
double border(const std::function<bool(double)>& above, double inside, double outside) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (inside + outside) / 2;
    (above(middle) ? inside : outside) = middle;
  }
  return inside;
}

void add_runs(std::vector<Run>& runs, std::size_t index, bool negative,
              const std::function<double(double)>& gain, const std::vector<double>& mesh,
              double zero) {
  const auto above = [&](double d) { return gain(d) >= -zero; };
  std::optional<double> begin;
  if (above(0) && above(mesh[0])) begin = 0;
  double last = 0;
  for (const double d : mesh) {
    const bool here = above(d);
    if (here && !begin) begin = last == 0 ? d : border(above, d, last);
    if (!here && begin) {
      runs.push_back({index, negative, *begin, border(above, last, d)});
      begin.reset();
    }
    last = d;
  }
  if (begin) runs.push_back({index, negative, *begin, HUGE_VAL});
}

}  // namespace

std::vector<Stretch> cover(const std::vector<std::function<double(double)>>& functions,
                           double bound, double from, double to) {
  const double side = to > from ? 1 : -1;
  const auto distances = mesh(std::abs(to - from), std::max(1.0, std::abs(from)));
  const double zero = same_value * std::max(1.0, std::abs(bound));
  std::vector<Run> runs;
  for (std::size_t i = 0; i < functions.size(); ++i)
    for (const bool negative : {false, true}) {
      const auto gain = [&](double d) {
        const double value = functions[i](from + side * d);
        return (negative ? -value : value) - bound;
      };
      add_runs(runs, i, negative, gain, distances, zero);
    }
  const Run* run = nullptr;
  for (const Run& other : runs)
    if (other.begin == 0 && (!run || other.end > run->end)) run = &other;
  std::vector<Stretch> result;
  double reached = 0;
  while (run && std::isfinite(run->end)) {
    const Run* next = nullptr;
    for (const Run& other : runs)
      if (other.begin < run->end && other.end > (next ? next->end : run->end)) next = &other;
    if (!next) return {};
    const double low = std::max(reached, next->begin);
    const double cut = (low + run->end) / 2;
    result.push_back(
        {run->function, run->negative,
         exact::simplest(Rational(from + side * cut), Rational((run->end - low) / 4))});
    reached = cut;
    run = next;
  }
  if (!run) return {};
  result.push_back({run->function, run->negative, std::nullopt});
  return result;
}

}  // namespace seam::claims
