// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/normal_form.h"

#include <algorithm>
#include <set>

namespace seam::geometry {
namespace {

using symbolic::Fact;

void collect_facts(const Formula& f, std::vector<Fact>& facts, std::set<const void*>& seen) {
  if (!seen.insert(f.identity()).second) return;
  if (f.kind() == Formula::Kind::known)
    facts.insert(facts.end(), f.facts().begin(), f.facts().end());
  for (const Formula& operand : f.operands()) collect_facts(operand, facts, seen);
}

}  // namespace

bool equal(const Formula& a, const Formula& b, const Numbers& numbers) {
  return a.same(b) || numbers.equal(a, b);
}

bool equal(const Point& a, const Point& b, const Numbers& numbers) {
  return std::ranges::equal(
      a, b, [&](const Formula& x, const Formula& y) { return equal(x, y, numbers); });
}

bool is_zero(const Formula& x, const Numbers& numbers) {
  return numbers.sign(x) == exact::Sign::zero;
}

// A rational number rests on nothing.
Formula normal_form(const Formula& x, const Numbers& numbers) {
  if (!is_number(x)) return x;
  Formula value = numbers.normal_form(x);
  if (value.is_constant()) return value;
  std::vector<Fact> facts;
  std::set<const void*> seen;
  collect_facts(x, facts, seen);
  return facts.empty() ? value : Formula::known(std::move(value), std::move(facts));
}

Point normal_form(const Point& point, const Numbers& numbers) {
  Point result;
  for (const Formula& x : point) result.push_back(normal_form(x, numbers));
  return result;
}

}  // namespace seam::geometry
