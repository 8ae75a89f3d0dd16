// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/slack.h"

#include <algorithm>
#include <array>
#include <queue>

#include "exact/field.h"
#include "prove/slack_part.h"
#include "prove/workshop.h"

// Parts of the domain have bounds from below (slack_part.cpp); where none is known it is 0, for
// the obligation holds. Corners of parts that are points of the domain bound from above. The
// part with the least bound is halved next, until the bounds are close or so much work is done.

namespace seam::prove {
namespace {

using certificate::Relation;
using exact::Integer;
using exact::Polynomial;
using exact::Rational;

constexpr int most_coefficients = 500;
constexpr long work = 30'000;  // coefficients to be touched, for all obligations together

const Rational tiny(Integer(1), Integer(1) << 40);  // below it is as good as 0

class Search {
 public:
  Search(Workshop& workshop, const Measured& measured, const certificate::Sign& sign)
      : workshop_(workshop), sign_(sign) {
    std::vector<certificate::Term> terms = {sign.formula};
    if (measured.scale >= 0) terms.push_back(measured.scale);
    for (const auto& condition : sign.domain.where) terms.push_back(condition.formula);
    for (const auto& simplex : sign.domain.factors)
      factors_.push_back(make_factor(workshop, simplex));
    const std::vector<std::string> names = variables(factors_);
    if (!workshop.functions(terms).empty()) result_.unknown = "it holds functions";
    for (const certificate::Term term : terms)
      for (const std::string& name : workshop.variables(term))
        if (std::ranges::find(names, name) == names.end())
          result_.unknown = "it is about all real " + name;
    for (const auto& condition : sign.domain.where)
      if (condition.relation == Relation::zero || condition.relation == Relation::nonzero)
        result_.unknown = "the domain is cut by equations";
    if (!result_.unknown.empty()) return;
    const bool is_below =
        sign.relation == Relation::negative || sign.relation == Relation::nonpositive;
    f_ = Rational(is_below ? -1 : 1) * workshop.expand(sign.formula, names);
    scale_ =
        measured.scale >= 0 ? workshop.expand(measured.scale, names) : f_->ring().constant(1);
  }

  Slack run(long effort) {
    if (!result_.unknown.empty()) return result_;
    if (factors_.empty()) return number();
    if (auto first = whole()) refine(std::move(*first), effort);
    return result_;
  }

 private:
  Slack number() {
    const Polynomial value = *f_ * exact::inverse(*scale_);
    if (const auto exact = value.rational()) {
      result_.low = *exact;
      result_.high = *exact;
    } else {
      const auto [low, high] = exact::enclosure(value, FixedForm::bits);
      result_.low = std::max(low, Rational(0));
      result_.high = high;
    }
    return result_;
  }

  std::vector<int> degrees(const Polynomial& f) const {
    std::vector<int> result;
    int first = 0;
    for (const Factor& factor : factors_) {
      std::vector<int> own;
      for (std::size_t j = 0; j < factor.variables.size(); ++j) own.push_back(first++);
      result.push_back(std::max(0, f.degree(own)));
    }
    return result;
  }

  // Raised to a common degree, by powers of the weights.
  FixedForm form(const Polynomial& f, const std::vector<int>& common) const {
    Barycentric result = in_barycentric(factors_, f);
    const exact::Ring& ring = result.polynomial.ring();
    std::vector<int> corners;
    int offset = 0;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      corners.push_back(static_cast<int>(factors_[k].corners.size()));
      Polynomial weight = ring.constant(0);
      for (int i = 0; i < corners.back(); ++i)
        weight =
            weight + ring.embed(factors_[k].corners[i].front()) * ring.variable(offset + i);
      offset += corners.back();
      result.polynomial =
          result.polynomial * weight.pow(common[k] - result.shape->degree(static_cast<int>(k)));
    }
    result.shape = std::make_shared<bernstein::Shape>(corners, common);
    return FixedForm(result);
  }

  std::optional<SlackPart> whole() {
    std::vector<int> common = degrees(*f_);
    const std::vector<int> other = degrees(*scale_);
    double count = 1;
    for (std::size_t k = 0; k < common.size(); ++k) {
      common[k] = std::max(common[k], other[k]);
      for (std::size_t j = 1; j <= factors_[k].variables.size(); ++j)
        count *= static_cast<double>(common[k]) / static_cast<double>(j) + 1;
    }
    if (count > most_coefficients) {
      result_.unknown = "its formula is long";
      return std::nullopt;
    }
    SlackPart part{form(*f_, common), form(*scale_, common), {}, {}, {}, 0};
    for (const auto& [formula, relation] : sign_.domain.where) {
      const Polynomial condition = workshop_.expand(formula, variables(factors_));
      part.where.push_back({form(condition, degrees(condition)), relation});
    }
    for (const Factor& factor : factors_) {
      auto& corners = part.corners.emplace_back();
      for (std::size_t i = 0; i < factor.corners.size(); ++i) {
        corners.emplace_back(factor.corners.size());
        corners.back()[i] = 1;
      }
    }
    return part;
  }

  void refine(SlackPart first, long effort) {
    long cost = 0;
    for (int k = 0; k < first.f.shape().factors(); ++k)
      cost += 4L * first.f.shape().count() * (first.f.shape().degree(k) + 1);
    take(std::move(first));
    while (!parts_.empty()) {
      const SlackPart worst = parts_.top();
      result_.low = std::max(worst.bound, Rational(0));
      const auto& high = result_.high;
      const bool is_close = high && (*high < tiny || (*high - result_.low) * 200 <= *high ||
                                     worst.bound >= *high);
      if (is_close || (effort -= cost) < 0) break;
      parts_.pop();
      halve(worst);
    }
    if (parts_.empty()) {
      result_.unknown = no_point;
      return;
    }
    const bool is_equation =
        sign_.relation == Relation::zero || sign_.relation == Relation::nonzero;
    if (is_equation) {
      result_.unknown = "it is no inequality";
      return;
    }
    if (result_.high) result_.low = std::min(result_.low, *result_.high);
    describe();
  }

  // Along its longest edge, lengths taken in barycentric coordinates.
  void halve(const SlackPart& part) {
    int factor = 0;
    std::array<int, 2> edge = {0, 1};
    Rational longest = -1;
    for (std::size_t k = 0; k < factors_.size(); ++k)
      for (std::size_t i = 0; i < part.corners[k].size(); ++i)
        for (std::size_t j = i + 1; j < part.corners[k].size(); ++j) {
          Rational length = 0;
          for (std::size_t c = 0; c < part.corners[k].size(); ++c)
            length += abs(Rational(part.corners[k][i][c] - part.corners[k][j][c]));
          if (length <= longest) continue;
          longest = length;
          factor = static_cast<int>(k);
          edge = {static_cast<int>(i), static_cast<int>(j)};
        }
    Barycentre middle = part.corners[factor][edge[0]];
    for (std::size_t c = 0; c < middle.size(); ++c)
      middle[c] = (middle[c] + part.corners[factor][edge[1]][c]) / 2;
    for (const std::size_t side : {0U, 1U}) {
      const int replaced = edge[side], kept = edge[1 - side];
      SlackPart next{part.f.half(factor, replaced, kept),
                     part.scale.half(factor, replaced, kept),
                     {},
                     part.corners,
                     {},
                     ++count_};
      for (const FixedCondition& c : part.where)
        next.where.push_back({c.form.half(factor, replaced, kept), c.relation});
      next.corners[factor][replaced] = middle;
      take(std::move(next));
    }
  }

  void take(SlackPart part) {
    if (std::ranges::any_of(part.where, is_broken)) return;
    part.bound = bound_below(part.f, part.scale);
    std::vector<int> choice(factors_.size(), 0);
    for (bool more = true; more;) {
      look_at(part, choice);
      more = false;
      for (std::size_t k = 0; k < choice.size() && !more; ++k) {
        more = ++choice[k] < static_cast<int>(part.corners[k].size());
        if (!more) choice[k] = 0;
      }
    }
    parts_.push(std::move(part));
  }

  void look_at(const SlackPart& part, const std::vector<int>& choice) {
    std::vector<Barycentre> place;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      place.push_back(part.corners[k][choice[k]]);
      Corners support = 0;
      for (std::size_t i = 0; i < place.back().size(); ++i)
        if (place.back()[i] != 0) support |= 1U << i;
      if (is_outside(factors_[k], support)) return;
    }
    for (const FixedCondition& c : part.where)
      if (!is_met(c.form[c.form.shape().corner(choice)], c.relation)) return;
    const int index = part.f.shape().corner(choice);
    if (part.scale[index].low <= 0) return;
    Rational value(std::max(part.f[index].high, Integer(0)), part.scale[index].low);
    value.canonicalize();
    if (result_.high && *result_.high <= value) return;
    result_.high = value;
    place_ = std::move(place);
  }

  // The point in its coordinates; the value there once more, exactly, where it may be 0.
  void describe() {
    if (!result_.high) return;
    std::vector<Polynomial> values;
    const exact::RingPtr numbers = exact::Ring::make(f_->ring().tower(), {});
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      std::vector<Polynomial> l;
      for (const Rational& share : place_[k]) l.push_back(numbers->constant(share));
      for (const Polynomial& coordinate : point(factors_[k], l)) values.push_back(coordinate);
    }
    const std::vector<std::string> names = variables(factors_);
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto exact = values[j].rational();
      const auto near =
          exact ? exact::Enclosure{*exact, *exact} : exact::enclosure(values[j], 64);
      result_.at.push_back({names[j], near.low, near.high});
    }
    if (*result_.high < tiny && f_->substitute(numbers, values).is_zero()) {
      result_.low = 0;
      result_.high = 0;
    }
  }

  Workshop& workshop_;
  const certificate::Sign& sign_;
  Factors factors_;
  std::optional<Polynomial> f_, scale_;
  std::priority_queue<SlackPart, std::vector<SlackPart>, Later> parts_;
  std::vector<Barycentre> place_;
  int count_ = 0;
  Slack result_;
};

Slack unknown(std::string why) {
  Slack slack;
  slack.unknown = std::move(why);
  return slack;
}

}  // namespace

std::vector<Slack> slacks(const certificate::Statement& statement,
                          const std::vector<Measured>& measured) {
  std::vector<Slack> result;
  const bool is_elementary = std::ranges::any_of(statement.generators, [](const auto& number) {
    return number.function != certificate::Elementary::none;
  });
  if (is_elementary) {
    result.assign(measured.size(), unknown("it holds exp, log, sin, cos or pi"));
    return result;
  }
  certificate::Evidence none;
  const Budget budget;
  try {
    Workshop workshop(statement, none, budget);
    for (const Measured& one : measured) {
      const auto& sign = std::get<certificate::Sign>(statement.obligations[one.obligation]);
      result.push_back(Search(workshop, one, sign).run(work / std::ssize(measured)));
    }
  } catch (const Unfit& error) {
    result.resize(measured.size(), unknown(error.what()));
  }
  return result;
}

}  // namespace seam::prove
