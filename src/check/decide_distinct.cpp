// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>

#include "check/rules.h"

// Two tuples are different if they certainly differ in some place, and equal if they
// certainly agree in all.

namespace seam::check {
namespace {

enum class Comparison { different, equal, unknown };

Comparison compare(Context& context, const Coordinates& a, const Coordinates& b) {
  Comparison result = Comparison::equal;
  for (std::size_t i = 0; i < a.size(); ++i) {
    context.meter().charge(1);
    if (a[i].terms == b[i].terms && a[i].denominator == b[i].denominator) continue;
    const auto sign = context.tower().find_sign(context.ring().difference(a[i], b[i]));
    if (sign && *sign != 0) return Comparison::different;
    if (!sign) result = Comparison::unknown;
  }
  return result;
}

}  // namespace

bool decide(Context& context, const certificate::Distinct& distinct,
            const certificate::Proof& proof) {
  demand(std::holds_alternative<certificate::Computation>(proof),
         "evidence of a kind that says nothing of different tuples");
  std::vector<Coordinates> tuples;
  for (const auto& terms : distinct.tuples) {
    Coordinates& tuple = tuples.emplace_back();
    for (const certificate::Term term : terms) tuple.push_back(context.number(term));
  }
  bool all_different = true;
  for (std::size_t i = 0; i < tuples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      context.meter().charge(1);
      const Comparison comparison = compare(context, tuples[i], tuples[j]);
      if (comparison == Comparison::equal) return false;
      all_different = all_different && comparison == Comparison::different;
    }
  demand(all_different, "two tuples are not seen to be different");
  return true;
}

}  // namespace seam::check
