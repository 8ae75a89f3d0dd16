// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/extremum_trials.h"

#include <algorithm>

#include "symbolic/approximate.h"
#include "symbolic/atoms.h"

// All weights of a factor's corners that are 0 or 1 but not all 0, and all with a fixed sum; of
// a product every choice of one from each factor.

namespace seam::claims {
namespace {

using exact::Rational;
using symbolic::Simplex;
using Weights = std::vector<int>;

// How many steps a grid takes along an edge, in a domain of that dimension.
int grid_of(std::size_t dimension) {
  constexpr int steps[] = {1, 48, 12, 6, 4};
  return dimension < std::size(steps) ? steps[dimension] : 1;
}

std::vector<Weights> of_faces(std::size_t corners) {
  std::vector<Weights> result;
  for (unsigned chosen = 1; chosen < 1U << corners; ++chosen) {
    result.emplace_back();
    for (std::size_t i = 0; i < corners; ++i)
      result.back().push_back(static_cast<int>(chosen >> i & 1U));
  }
  return result;
}

std::vector<Weights> of_grid(std::size_t corners, int sum) {
  if (corners == 1) return {{sum}};
  std::vector<Weights> result;
  for (int first = 0; first <= sum; ++first)
    for (Weights rest : of_grid(corners - 1, sum - first)) {
      rest.insert(rest.begin(), first);
      result.push_back(std::move(rest));
    }
  return result;
}

// A function in doubles on its domain.
class Height {
 public:
  Height(const Extremum::Part& part, const Numbers& numbers) : part_(part), numbers_(numbers) {
    for (const std::string& symbol :
         symbolic::symbols(part.value.numerator * part.value.denominator))
      if (symbolic::is_generator(symbol))
        point_[symbol] = numbers.approximate(Formula::symbol(symbol));
    for (const Simplex& factor : part.domain.factors)
      for (const auto& corner : factor.corners) {
        corners_.emplace_back();
        for (const Formula& x : corner) corners_.back().push_back(numbers.approximate(x));
      }
  }

  double operator()(const std::vector<Weights>& weights) {
    std::size_t next = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const auto& names = part_.domain.factors[k].variables;
      double total = 0;
      std::vector<double> sum(names.size());
      for (const int weight : weights[k]) {
        total += weight;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * corners_[next][i + 1];
        ++next;
      }
      for (std::size_t i = 0; i < sum.size(); ++i) point_[names[i]] = sum[i] / total;
    }
    return approximate(part_.value, point_, numbers_);
  }

 private:
  const Extremum::Part& part_;
  const Numbers& numbers_;
  std::map<std::string, double> point_;
  std::vector<std::vector<double>> corners_;  // of all factors, one after the other
};

void add(std::vector<Trial>& result, Evaluator& evaluator, const Extremum& extremum,
         bool is_centre) {
  for (std::size_t index = 0; index < extremum.parts.size(); ++index) {
    const Extremum::Part& part = extremum.parts[index];
    std::size_t dimension = 0;
    for (const Simplex& factor : part.domain.factors) dimension += factor.variables.size();
    std::vector<std::vector<Weights>> all = {{}};
    for (const Simplex& factor : part.domain.factors) {
      const std::size_t corners = factor.corners.size();
      std::vector<std::vector<Weights>> longer;
      for (const auto& begin : all)
        for (Weights& weights :
             is_centre ? of_faces(corners) : of_grid(corners, grid_of(dimension))) {
          longer.push_back(begin);
          longer.back().push_back(weights);
        }
      all = std::move(longer);
    }
    Height height(part, evaluator.numbers);
    for (auto& weights : all) {
      const double value = height(weights);
      result.push_back({index, std::move(weights), value, is_centre});
    }
  }
}

}  // namespace

std::vector<Trial> centres(Evaluator& evaluator, const Extremum& extremum) {
  std::vector<Trial> result;
  add(result, evaluator, extremum, true);
  return result;
}

std::vector<Trial> trials(Evaluator& evaluator, const Extremum& extremum) {
  std::vector<Trial> result = centres(evaluator, extremum);
  add(result, evaluator, extremum, false);
  return result;
}

std::map<std::string, Formula> point_of(const Extremum& extremum, const Trial& trial) {
  std::map<std::string, Formula> result;
  for (std::size_t k = 0; k < trial.weights.size(); ++k) {
    const Simplex& factor = extremum.parts[trial.part].domain.factors[k];
    int total = 0;
    for (const int weight : trial.weights[k]) total += weight;
    for (std::size_t i = 0; i < factor.variables.size(); ++i) {
      Formula x = 0;
      for (std::size_t c = 0; c < factor.corners.size(); ++c) {
        Rational share(trial.weights[k][c], total);
        share.canonicalize();
        x += Formula(share) * factor.corners[c][i + 1];
      }
      result.emplace(factor.variables[i], x);
    }
  }
  return result;
}

bool has_parameter(const Extremum::Part& part) {
  std::set<std::string> open = symbolic::variables(part.value.numerator);
  open.merge(symbolic::variables(part.value.denominator));
  for (const Simplex& factor : part.domain.factors)
    for (const std::string& variable : factor.variables) open.erase(variable);
  return !open.empty();
}

bool has_roots(const Extremum& extremum) {
  return std::ranges::any_of(extremum.parts, [](const Extremum::Part& part) {
    symbolic::Atoms atoms;
    atoms.add(part.value.numerator * part.value.denominator);
    return !atoms.entries().empty();
  });
}

double approximate(const Scalar& value, const std::map<std::string, double>& point,
                   const Numbers& numbers) {
  return symbolic::approximate(value.numerator, point, numbers) /
         symbolic::approximate(value.denominator, point, numbers);
}

}  // namespace seam::claims
