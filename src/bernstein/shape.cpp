// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/shape.h"

#include <algorithm>
#include <map>
#include <utility>

#include "exact/contract.h"

namespace seam::bernstein {

namespace {

void list_monomials(int corners, int degree, std::vector<int>& prefix,
                    std::vector<std::vector<int>>& result) {
  if (std::ssize(prefix) + 1 == corners) {
    prefix.push_back(degree);
    result.push_back(prefix);
    prefix.pop_back();
    return;
  }
  for (int e = degree; e >= 0; --e) {
    prefix.push_back(e);
    list_monomials(corners, degree - e, prefix, result);
    prefix.pop_back();
  }
}

}  // namespace

Shape::Shape(std::vector<int> corners, std::vector<int> degrees)
    : corners_(std::move(corners)), degrees_(std::move(degrees)) {
  exact::require(corners_.size() == degrees_.size(), "Shape: one degree a factor");
  for (int k = 0; k < factors(); ++k) {
    std::vector<int> prefix;
    monomials_.emplace_back();
    list_monomials(corners_[k], degrees_[k], prefix, monomials_.back());
    strides_.push_back(count_);
    count_ *= static_cast<int>(monomials_.back().size());

    std::map<std::vector<int>, int> places;
    for (const auto& m : monomials_.back()) places.emplace(m, static_cast<int>(places.size()));
    moves_.emplace_back();
    for (const auto& m : monomials_.back()) {
      std::vector<int> row;
      for (int from = 0; from < corners_[k]; ++from)
        for (int to = 0; to < corners_[k]; ++to) {
          auto moved = m;
          --moved[from];
          ++moved[to];
          row.push_back(m[from] > 0 ? places.at(moved) : -1);
        }
      moves_.back().push_back(std::move(row));
    }
  }
  for (int k = 0; k < factors(); ++k) {
    ranked_.emplace_back();
    for (int c = 0; c < corners_[k]; ++c) {
      std::vector<Ranked> order;
      for (int i = 0; i < count_; ++i) order.push_back({i, monomials_[k][local(i, k)][c]});
      std::ranges::stable_sort(order, std::greater(), &Ranked::exponent);
      ranked_.back().push_back(std::move(order));
    }
  }
}

int Shape::local(int index, int factor) const {
  return index / strides_[factor] % static_cast<int>(monomials_[factor].size());
}

std::vector<std::vector<int>> Shape::exponents(int index) const {
  std::vector<std::vector<int>> result;
  for (int k = 0; k < factors(); ++k) result.push_back(monomials_[k][local(index, k)]);
  return result;
}

int Shape::index(const std::vector<std::vector<int>>& exponents) const {
  int result = 0;
  for (int k = 0; k < factors(); ++k) {
    const auto at = std::ranges::find(monomials_[k], exponents[k]);
    exact::require(at != monomials_[k].end(), "Shape::index: outside the shape");
    result += strides_[k] * static_cast<int>(at - monomials_[k].begin());
  }
  return result;
}

int Shape::corner(const std::vector<int>& corner_of_factor) const {
  std::vector<std::vector<int>> exponents;
  for (int k = 0; k < factors(); ++k) {
    exponents.emplace_back(corners_[k], 0);
    exponents.back()[corner_of_factor[k]] = degrees_[k];
  }
  return index(exponents);
}

int Shape::moved(int index, int factor, int from, int to) const {
  const int here = local(index, factor);
  const int there = moves_[factor][here][from * corners_[factor] + to];
  return there < 0 ? -1 : index + strides_[factor] * (there - here);
}

unsigned Shape::support(int index, int factor) const {
  unsigned bits = 0;
  const auto& m = monomials_[factor][local(index, factor)];
  for (int c = 0; c < corners_[factor]; ++c)
    if (m[c] > 0) bits |= 1U << c;
  return bits;
}

}  // namespace seam::bernstein
