// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "claims/syntax.h"

namespace seam::claims {

/// Trees as the grammar can make them, of every kind; the same seed gives the same trees.
class RandomTree {
 public:
  explicit RandomTree(unsigned seed) : engine_(seed) {}

  Expression value(int depth);
  Expression statement(int depth);
  File file(int items);

 private:
  using Kind = Expression::Kind;

  int below(int bound) { return static_cast<int>(engine_() % static_cast<unsigned>(bound)); }
  bool maybe() { return below(2) == 0; }
  std::string pick(const std::vector<std::string>& of);
  std::string name();
  std::string id();
  std::string quoted();
  Expression any(int depth) { return below(6) == 0 ? statement(depth) : value(depth); }
  std::vector<Expression> several(int least, int most, Expression (RandomTree::*make)(int),
                                  int depth);

  Expression number(int = 0);
  Expression name_leaf(int = 0);
  Expression list(int depth);
  Expression element(int depth);
  Expression argument(int depth);
  Expression call(int depth);
  Expression index(int depth);
  Expression matrix(int depth);
  Expression net(int depth);
  Expression indexed(int depth);
  Expression entry(bool rational, int depth);
  Expression names();
  Expression set(int depth);
  Expression ranged(int depth);
  Expression quantified(int depth);
  Expression relation(int depth);
  Expression solve(int depth);
  Expression hint(int depth);

  Item item(Item::Kind);
  void fill_claim(Item&);
  void fill_table(Item&);
  void fill_param(Item&);

  std::mt19937 engine_;
  int ids_ = 0;
};

}  // namespace seam::claims
