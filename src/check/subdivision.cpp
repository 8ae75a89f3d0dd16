// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/subdivision.h"

#include <memory>
#include <utility>

#include "check/piece.h"
#include "check/relation.h"

// Why the parts of a split cover the piece.
//
//   Let the split be at weights w, and l >= 0 the coordinates of a point of the piece. Let t be
//   the least of l_i / w_i over all i with w_i > 0, attained at i. Then l = t w + (l - t w),
//   with l - t w >= 0 in every place and 0 in place i: the point is a combination of the point
//   at w and the corners other than i. So it lies in part i.
//
// A part is made when its turn comes, so that no more pieces are held than the tree is
// deep. The walk takes one step of the evidence at a time, hence it ends.

namespace seam::check {
namespace {

using certificate::Relation;
using certificate::Step;
using certificate::Subdivision;

struct Split {
  Piece piece;
  std::size_t factor;
  Coordinates weights;
};

// A part that is still to be proven; without a split, the whole.
struct Task {
  std::shared_ptr<const Split> split;
  std::size_t corner = 0;
};

// Whether condition number `index` is broken at all points of the region in the piece.
bool is_outside(Context& context, const Region& region, const Piece& piece, std::size_t index) {
  demand(index < region.where.size(), "the evidence names a condition that is none");
  const Relation broken = complement(region.where[index].relation);
  if (broken != Relation::nonzero) return is_plain(context, region, piece, index + 1, broken);
  return is_plain(context, region, piece, index + 1, Relation::positive) ||
         is_plain(context, region, piece, index + 1, Relation::negative);
}

Coordinates split_weights(Context& context, const Step& step, std::size_t corners) {
  demand(step.weights.size() == corners, "a split has not one weight for each corner");
  Coordinates weights;
  bool some = false;
  for (const certificate::Term term : step.weights) {
    weights.push_back(context.number(term));
    const int sign = context.tower().sign(weights.back());
    demand(sign >= 0, "a split has a negative weight");
    some = some || sign > 0;
  }
  demand(some, "the weights of a split are all 0");
  return weights;
}

}  // namespace

void verify(Context& context, const Region& region, const Polynomial& formula,
            Relation relation, const Subdivision& steps) {
  std::vector<Task> tasks = {{}};
  for (const Step& step : steps) {
    demand(!tasks.empty(), "the evidence has steps too many");
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    Piece piece = task.split ? part(context, region, task.split->piece, task.split->factor,
                                    task.split->weights, task.corner)
                             : whole(context, region, formula);
    const auto index = static_cast<std::size_t>(step.index);
    switch (step.kind) {
      case Step::Kind::plain:
        demand(is_plain(context, region, piece, 0, relation),
               "the coefficients over a piece do not show the sign");
        break;
      case Step::Kind::outside:
        demand(is_outside(context, region, piece, index),
               "a condition is not seen to be broken all over a piece");
        break;
      case Step::Kind::split: {
        demand(index < region.factors.size(), "a split of a factor that is none");
        Coordinates weights =
            split_weights(context, step, region.factors[index].corners.size());
        const auto split =
            std::make_shared<const Split>(Split{std::move(piece), index, std::move(weights)});
        for (std::size_t i = split->weights.size(); i-- > 0;)
          if (context.tower().sign(split->weights[i]) > 0) tasks.push_back({split, i});
        break;
      }
      default:
        throw Open("malformed: an unknown kind of step");
    }
  }
  demand(tasks.empty(), "the evidence lacks a piece");
}

}  // namespace seam::check
