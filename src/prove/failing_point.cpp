// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/failing_point.h"

#include <cstdint>
#include <utility>

#include "exact/field.h"
#include "prove/subdivide.h"

// Points with few coordinates that are not 0 come first, small integers at random after them.
// At each, what has to vanish is made to: an equation that is linear in a variable, as it
// stands there, is solved for it. That is done for the equations among the conditions and,
// where f has to be 0 for the relation to fail, for f. All is exact.

namespace seam::prove {

using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

constexpr int most_pairs = 400;
constexpr int most_random = 600;

class Random {
 public:
  int below(int n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(n));
  }

 private:
  std::uint64_t state_ = 1;
};

class Search {
 public:
  Search(Workshop& workshop, const Factors& factors, const std::vector<Condition>& where,
         const Polynomial& f, certificate::Relation relation)
      : workshop_(workshop),
        factors_(factors),
        where_(where),
        f_(f),
        relation_(relation),
        first_line_(variables(factors).size()),
        count_(f.ring().variables().size()) {
    for (const Condition& condition : where)
      if (condition.relation == certificate::Relation::zero)
        equations_.push_back(condition.formula);
    fails_at_zero_ = !holds(relation, Sign::zero);
  }

  std::optional<certificate::Point> run() {
    const int lines = static_cast<int>(count_ - first_line_);
    Values start;
    for (const Factor& factor : factors_) {
      const std::vector<Polynomial> middle(factor.corners.size(),
                                           workshop_.numbers()->constant(1));
      for (const Polynomial& x : point(factor, middle)) start.push_back(x);
    }
    start.resize(count_, workshop_.numbers()->constant(0));
    const auto with = [&](std::initializer_list<std::pair<int, int>> entries) {
      Values values = start;
      for (const auto& [line, value] : entries)
        values[first_line_ + static_cast<std::size_t>(line)] =
            workshop_.numbers()->constant(value);
      return try_at(std::move(values));
    };
    if (with({})) return found_;
    for (int i = 0; i < lines; ++i)
      for (const int value : {1, -1})
        if (with({{i, value}})) return found_;
    int left = most_pairs;
    for (int i = 0; i < lines; ++i)
      for (int j = 0; j < i && left > 0; ++j)
        for (const int value : {1, -1}) {
          --left;
          if (with({{i, 1}, {j, value}})) return found_;
        }
    Random random;
    for (int n = 0; n < most_random && !workshop_.late(); ++n) {
      Values values = start;
      std::size_t place = 0;
      for (const Factor& factor : factors_) {
        std::vector<Polynomial> weights;
        for (std::size_t i = 0; i < factor.corners.size(); ++i)
          weights.push_back(workshop_.numbers()->constant(1 + random.below(8)));
        for (const Polynomial& x : point(factor, weights)) values[place++] = x;
      }
      const int span = n % 2 == 0 ? 1 : 3;
      for (; place < count_; ++place) {
        const bool is_zero = n % 3 == 0 && random.below(2) == 0;
        values[place] =
            workshop_.numbers()->constant(is_zero ? 0 : random.below(2 * span + 1) - span);
      }
      if (try_at(std::move(values))) return found_;
    }
    return std::nullopt;
  }

 private:
  using Values = std::vector<Polynomial>;

  Polynomial at(const Polynomial& p, const Values& values) const {
    return p.substitute(workshop_.numbers(), values);
  }
  Sign sign(const Polynomial& p, const Values& values) const {
    return exact::sign(at(p, values));
  }

  bool try_at(Values values) {
    if (fits(values)) return true;
    std::vector<bool> used(count_, false);
    std::vector<const Polynomial*> wanted;
    for (const Polynomial& equation : equations_) wanted.push_back(&equation);
    if (fails_at_zero_) wanted.push_back(&f_);
    if (wanted.empty()) return false;
    for (const Polynomial* equation : wanted)
      if (!solve(*equation, values, used)) return false;
    return fits(values);
  }

  // Changes one value so that the equation holds.
  bool solve(const Polynomial& equation, Values& values, std::vector<bool>& used) const {
    const Polynomial here = at(equation, values);
    if (here.is_zero()) return true;
    for (std::size_t v = first_line_; v < count_; ++v) {
      if (used[v] || equation.degree(static_cast<int>(v)) != 1) continue;
      const Polynomial slope = at(equation.derivative(static_cast<int>(v)), values);
      if (slope.is_zero()) continue;
      values[v] = values[v] - here * exact::inverse(slope);
      used[v] = true;
      return true;
    }
    return false;
  }

  bool fits(const Values& values) {
    for (const auto& [formula, relation] : where_)
      if (!holds(relation, sign(formula, values))) return false;
    if (holds(relation_, sign(f_, values))) return false;
    found_.emplace();
    found_->variables = f_.ring().variables();
    for (const Polynomial& value : values) found_->values.push_back(workshop_.write(value));
    return true;
  }

  Workshop& workshop_;
  const Factors& factors_;
  const std::vector<Condition>& where_;
  const Polynomial& f_;
  certificate::Relation relation_;
  std::size_t first_line_, count_;
  std::vector<Polynomial> equations_;
  bool fails_at_zero_ = false;
  std::optional<certificate::Point> found_;
};

}  // namespace

std::optional<certificate::Point> failing_point(Workshop& workshop, const Factors& factors,
                                                const std::vector<Condition>& where,
                                                const Polynomial& f,
                                                certificate::Relation relation) {
  return Search(workshop, factors, where, f, relation).run();
}

}  // namespace seam::prove
