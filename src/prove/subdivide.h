// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "prove/region.h"

namespace seam::prove {

/// Is f > 0 (strict) or f >= 0 where the conditions hold? The polynomials are in the
/// variables of the factors, over one tower.
struct Question {
  Factors factors;
  exact::Polynomial f;
  bool strict = true;
  std::vector<Condition> where;
  bool may_touch = true;  ///< it is worth while to look for zeros of f
};

/// Barycentric coordinates in each factor, the scale of each free.
using Place = std::vector<std::vector<exact::Polynomial>>;

/// A point of a factor's closure.
struct Corner {
  std::vector<exact::Polynomial> l;  ///< integral; not all 0
  exact::Integer total;              ///< their sum
  std::vector<double> at;            ///< l / total
  Corners support = 0;               ///< which are not 0
};
using CornerPtr = std::shared_ptr<const Corner>;

/// A product of simplices within the domain.
struct Piece {
  std::vector<std::vector<CornerPtr>> corners;
  bernstein::Form f;
  std::vector<bernstein::Form> where;
  int node = 0;  ///< in the tree
  double lowest = 0;
};

/// Cuts the domain into pieces, the worst first, until all are plain, or a corner of one
/// refutes, or a limit is reached. Places given beforehand, where f is expected to touch 0, are
/// made corners.
class Subdivision {
 public:
  Subdivision(Workshop&, const Question&, std::vector<Place> touches);

  enum class Outcome { proved, refuted, paused, late, hopeless };
  /// Goes on until `pieces` have been looked at since the beginning.
  Outcome run(long pieces);

  certificate::Subdivision steps() const;                   ///< once proved
  const Place& refutation() const { return *refutation_; }  ///< once refuted
  std::vector<const Piece*> worst(int count) const;         ///< of those still open
  long looked_at() const { return looked_at_; }

 private:
  struct Node {
    certificate::Step::Kind kind = certificate::Step::Kind::plain;
    int index = 0;
    std::vector<exact::Polynomial> weights;
    std::vector<int> parts;
  };
  struct Cut {
    int factor = 0;
    std::vector<exact::Polynomial> weights;
  };
  struct Worse {
    bool operator()(const Piece& a, const Piece& b) const {
      return a.lowest != b.lowest ? a.lowest > b.lowest : a.node > b.node;
    }
  };

  bool settle(const Piece&);
  bool refutes(const Piece&);
  std::optional<Cut> choose(const Piece&) const;
  std::optional<Cut> cut_at_touch(const Piece&) const;
  std::optional<Cut> cut_at_zero_corner(const Piece&, bool& hopeless) const;
  Cut cut_longest_edge(const Piece&) const;
  Cut edge(const Piece&, int factor, int i, int j) const;
  void divide(const Piece&, const Cut&);
  void push(Piece);

  Workshop* workshop_;
  const Question* question_;
  std::vector<Place> touches_;
  std::vector<bool> relevant_;  ///< of each factor: some form depends on it
  std::vector<Node> tree_;
  std::vector<Piece> open_;  ///< a heap
  std::optional<Place> refutation_;
  long looked_at_ = 0;
};

/// All choices of one corner a factor.
std::vector<std::vector<int>> corner_choices(const Piece&);

/// Whether the relation holds for a number of this sign.
bool holds(certificate::Relation, exact::Sign);

}  // namespace seam::prove
