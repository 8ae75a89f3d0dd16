// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/region.h"

#include <algorithm>
#include <utility>

#include "exact/contract.h"

// With W = sum l_i w_i and X_j = sum l_i x_ij the point is X / W, and W > 0. So W^degree f(X /
// W) has the sign of f, and is homogeneous in l.

namespace seam::prove {

using exact::Exponents;
using exact::Polynomial;
using exact::RingPtr;

Factor make_factor(Workshop& workshop, const certificate::Simplex& simplex) {
  Factor factor{simplex.variables, {}, simplex.open, 0};
  for (const auto& corner : simplex.corners) {
    factor.corners.emplace_back();
    for (const certificate::Term term : corner)
      factor.corners.back().push_back(workshop.number(term));
    if (factor.corners.back().front().is_zero())
      factor.infinite |= 1U << (factor.corners.size() - 1);
  }
  return factor;
}

std::vector<std::string> variables(const Factors& factors) {
  std::vector<std::string> result;
  for (const Factor& factor : factors)
    result.insert(result.end(), factor.variables.begin(), factor.variables.end());
  return result;
}

Region make_region(Workshop& workshop, Factors given,
                   const std::vector<certificate::Constraint>& where,
                   const std::vector<const certificate::Function*>& functions) {
  using certificate::Elementary;
  Region region{std::move(given), {}, functions};
  const Polynomial nil = workshop.numbers()->constant(0), one = workshop.numbers()->constant(1);
  for (const auto* function : functions)
    if (function->is_root() || function->elementary == Elementary::exp)
      region.factors.push_back(
          {{function->name}, {{one, nil}, {nil, one}}, {false, !function->is_root()}, 2U});
    else
      region.factors.push_back(
          {{function->name}, {{one, -one}, {one, one}}, {false, false}, 0});
  const auto names = variables(region.factors);
  for (const auto& [formula, relation] : where)
    region.where.push_back({workshop.expand(formula, names), relation});
  region.given = region.where.size();
  for (const auto* function : functions) {
    const Polynomial value = *workshop.ring(names)->symbol(function->name);
    if (function->is_root())
      region.where.push_back(
          {value.pow(function->degree) - workshop.expand(function->operand, names),
           certificate::Relation::zero});
    if (const auto name = workshop.cosine(*function)) {
      const Polynomial cosine = *workshop.ring(names)->symbol(*name);
      region.where.push_back(
          {value * value + cosine * cosine - workshop.ring(names)->constant(1),
           certificate::Relation::zero});
    }
  }
  region.known = region.where.size();
  return region;
}

bool Region::holds_log() const {
  return std::ranges::any_of(functions, [](const auto* function) {
    return function->elementary == certificate::Elementary::log;
  });
}

bool Region::is_elementary() const {
  return !std::ranges::all_of(functions, [](const auto* f) { return f->is_root(); });
}

exact::RingPtr ring(const Workshop& workshop, const Region& region) {
  return workshop.ring(variables(region.factors));
}

bool is_outside(const Factor& factor, Corners support) {
  if ((support & ~factor.infinite) == 0) return true;
  for (std::size_t i = 0; i < factor.open.size(); ++i)
    if (factor.open[i] && (support >> i & 1U) == 0) return true;
  return false;
}

Barycentric in_barycentric(const Factors& factors, const Polynomial& f) {
  // Variables of `f`, in order, then one weight a factor; and coordinates l of all corners.
  std::vector<int> degrees, corners;
  std::vector<std::string> with_weights = f.ring().variables(), coordinates;
  int first = 0;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    std::vector<int> own;
    for (std::size_t j = 0; j < factors[k].variables.size(); ++j) own.push_back(first++);
    degrees.push_back(std::max(0, f.degree(own)));
    corners.push_back(static_cast<int>(factors[k].corners.size()));
    with_weights.push_back("weight " + std::to_string(k));
    for (int i = 0; i < corners.back(); ++i)
      coordinates.push_back("l " + std::to_string(k) + " " + std::to_string(i));
  }
  const exact::TowerPtr& tower = f.ring().tower();
  const RingPtr numbers = exact::Ring::make(tower, {});
  const RingPtr homogeneous = exact::Ring::make(tower, with_weights);
  const RingPtr barycentric = exact::Ring::make(tower, coordinates);

  std::map<Exponents, Polynomial> terms;
  const auto numerators = f.numerators();
  for (const auto& [exponents, number] : numerators.terms) {
    Exponents all = exponents;
    std::size_t next = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      int left = degrees[k];
      for (std::size_t j = 0; j < factors[k].variables.size(); ++j) left -= exponents[next++];
      all.push_back(left);
    }
    terms.emplace(std::move(all), numbers->number(number, numerators.denominator));
  }
  std::vector<Polynomial> values;
  const auto combination = [&](std::size_t k, std::size_t place, int offset) {
    Polynomial sum = barycentric->constant(0);
    for (std::size_t i = 0; i < factors[k].corners.size(); ++i)
      sum = sum + barycentric->embed(factors[k].corners[i][place]) *
                      barycentric->variable(offset + static_cast<int>(i));
    return sum;
  };
  int offset = 0;
  for (std::size_t k = 0; k < factors.size(); offset += corners[k++])
    for (std::size_t j = 0; j < factors[k].variables.size(); ++j)
      values.push_back(combination(k, j + 1, offset));
  offset = 0;
  for (std::size_t k = 0; k < factors.size(); offset += corners[k++])
    values.push_back(combination(k, 0, offset));
  return {homogeneous->polynomial(terms).substitute(barycentric, values),
          std::make_shared<bernstein::Shape>(corners, degrees)};
}

std::vector<Polynomial> point(const Factor& factor, const std::vector<Polynomial>& l) {
  const exact::Ring& numbers = l.front().ring();
  std::vector<Polynomial> sums(factor.corners.front().size(), numbers.constant(0));
  for (std::size_t i = 0; i < l.size(); ++i)
    for (std::size_t j = 0; j < sums.size(); ++j)
      sums[j] = sums[j] + l[i] * numbers.embed(factor.corners[i][j]);
  const Polynomial scale = exact::inverse(sums.front());
  std::vector<Polynomial> result;
  for (std::size_t j = 1; j < sums.size(); ++j) result.push_back(scale * sums[j]);
  return result;
}

}  // namespace seam::prove
