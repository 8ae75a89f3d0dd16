// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "exact/polynomial.h"

namespace seam::exact {

/// Multiplication by a number with integer coordinates.
class Multiplier {
 public:
  Multiplier(const TowerPtr&, const Coordinates&);

 private:
  friend class Rows;
  struct Entry {
    int row, column;
    Integer value;
  };
  std::vector<Entry> entries_;  ///< of the matrix; none if a rational integer
  Integer scalar_;
  bool is_scalar_ = true;
};

/// Many numbers of one tower with integer coordinates, in one block.
class Rows {
 public:
  Rows(TowerPtr, int count);
  ~Rows();
  Rows(const Rows&);
  Rows& operator=(const Rows&) = delete;

  int count() const { return count_; }
  Coordinates at(int index) const;
  void set(int index, const Coordinates&);
  Sign sign(int index) const;
  Ball ball(int index) const;

  /// row[target] = sum multiplier * row[source]. The target may be a source.
  struct Term {
    int source;
    const Multiplier* multiplier;
  };
  void combine(int target, const std::vector<Term>&);

 private:
  struct Block;
  TowerPtr tower_;
  int count_, width_;
  std::unique_ptr<Block> block_;
};

}  // namespace seam::exact
