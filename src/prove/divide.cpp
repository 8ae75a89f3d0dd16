// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/divide.h"

#include <algorithm>

// Each step keeps the identity. The number of steps is bounded: with several equations, or
// functions, a degree that was lowered may rise again.

namespace seam::prove {

using exact::Polynomial;

namespace {

constexpr int most_steps = 200;
constexpr std::size_t most_choices = 12;

Polynomial leading(const Polynomial& p, int variable) {
  return p.coefficients({variable}).rbegin()->second;
}

// In which the polynomial has a number as leading coefficient.
std::vector<int> monic_in(const Polynomial& p) {
  std::vector<int> result;
  for (int v = 0; v < std::ssize(p.ring().variables()); ++v)
    if (p.degree(v) > 0 && leading(p, v).is_number()) result.push_back(v);
  return result;
}

class Divider {
 public:
  Divider(Workshop& workshop, const std::vector<Polynomial>& equations, std::vector<int> in)
      : workshop_(workshop), equations_(equations), in_(std::move(in)) {
    for (std::size_t i = 0; i < equations.size(); ++i)
      scales_.push_back(workshop.ring(equations[i].ring().variables())
                            ->embed(exact::inverse(
                                workshop.numbers()->embed(leading(equations[i], in_[i])))));
  }

  Division operator()(const Polynomial& f) const {
    Division result{f, std::vector(equations_.size(), f.ring().constant(0))};
    bool goes_on = true;
    for (int step = 0; goes_on && step < most_steps; ++step) {
      goes_on = false;
      for (std::size_t i = 0; i < equations_.size(); ++i) {
        const int v = in_[i];
        const int excess = result.rest.degree(v) - equations_[i].degree(v);
        if (excess < 0) continue;
        const Polynomial quotient =
            leading(result.rest, v) * scales_[i] * f.ring().variable(v).pow(excess);
        result.rest = workshop_.reduced(result.rest - quotient * equations_[i]);
        result.cofactors[i] = workshop_.reduced(result.cofactors[i] + quotient);
        goes_on = true;
      }
    }
    return result;
  }

 private:
  Workshop& workshop_;
  const std::vector<Polynomial>& equations_;
  std::vector<int> in_;
  std::vector<Polynomial> scales_;
};

}  // namespace

std::vector<Division> divisions(Workshop& workshop, const Polynomial& f,
                                const std::vector<Polynomial>& equations) {
  std::vector<Polynomial> used;
  std::vector<std::size_t> origin;
  std::vector<std::vector<int>> choices = {{}};
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const std::vector<int> variables = monic_in(equations[i]);
    if (variables.empty()) continue;
    used.push_back(equations[i]);
    origin.push_back(i);
    std::vector<std::vector<int>> longer;
    for (const auto& choice : choices)
      for (const int v : variables) {
        if (longer.size() == most_choices) break;
        longer.push_back(choice);
        longer.back().push_back(v);
      }
    choices = std::move(longer);
  }
  std::vector<Division> result;
  if (used.empty()) return result;
  for (const auto& choice : choices) {
    const Division division = Divider(workshop, used, choice)(f);
    Division all{division.rest, std::vector(equations.size(), f.ring().constant(0))};
    for (std::size_t i = 0; i < used.size(); ++i)
      all.cofactors[origin[i]] = division.cofactors[i];
    result.push_back(std::move(all));
  }
  return result;
}

}  // namespace seam::prove
