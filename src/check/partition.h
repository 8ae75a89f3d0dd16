// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace seam::check {

/// Disjoint sets of 0 ... size - 1.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size), classes_(static_cast<long>(size)) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  long classes() const { return classes_; }

  bool are_together(std::size_t a, std::size_t b) { return root(a) == root(b); }

  void merge(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parent_[a] = b;
    --classes_;
  }

 private:
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::size_t> parent_;
  long classes_;
};

}  // namespace seam::check
