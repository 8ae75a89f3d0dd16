// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "exact/square.h"
#include "prove/sign.h"
#include "prove/touch.h"

// Subdivision in bursts; whenever one ends undecided, a look at what is left: does f touch 0
// there, or is it a square times something simpler?

namespace seam::prove {

using exact::Polynomial;
using exact::Sign;

namespace {

constexpr long first_burst = 60;
constexpr int most_touches = 24;
constexpr double same_place = 1e-10;

Sign sign_at(Workshop& workshop, const Factors& factors, const Polynomial& f,
             const Place& place) {
  std::vector<Polynomial> values;
  for (std::size_t k = 0; k < factors.size(); ++k)
    for (const Polynomial& x : point(factors[k], place[k]))
      values.push_back(workshop.numbers()->embed(x));
  return exact::sign(f.substitute(workshop.numbers(), values));
}

bool lies_in(Workshop& workshop, const Question& question, const Place& place) {
  for (std::size_t k = 0; k < place.size(); ++k) {
    Corners support = 0;
    for (std::size_t i = 0; i < place[k].size(); ++i)
      if (!place[k][i].is_zero()) support |= 1U << i;
    if (is_outside(question.factors[k], support)) return false;
  }
  return std::ranges::all_of(question.where, [&](const Condition& c) {
    return holds(c.relation, sign_at(workshop, question.factors, c.formula, place));
  });
}

void lift(Workshop& workshop, Question& question) {
  const auto ring = workshop.ring(question.f.ring().variables());
  question.f = ring->embed(question.f);
  for (auto& condition : question.where) condition.formula = ring->embed(condition.formula);
}

Answer no(Workshop& workshop, const Question& question, Place place) {
  const Sign sign = sign_at(workshop, question.factors, question.f, place);
  return {Answer::Kind::no, {}, std::move(place), sign, {}};
}

Answer neither(std::string reason, std::string detail) {
  return {Answer::Kind::neither, {}, {}, Sign::zero, {std::move(reason), std::move(detail)}};
}

// "Yes" because f = root^2 * cofactor with cofactor >= 0; nothing if that does not come out.
std::optional<Answer> by_square(Workshop& workshop, const Question& question, long effort) {
  const auto split = exact::square_factor(question.f);
  if (!split) return std::nullopt;
  Question rest = question;
  rest.f = split->cofactor;
  Answer answer = decide(workshop, std::move(rest), effort);
  if (answer.kind != Answer::Kind::yes || answer.pieces.square >= 0) return std::nullopt;
  answer.pieces.square = workshop.write(split->root);
  answer.pieces.cofactor = workshop.write(split->cofactor);
  return answer;
}

}  // namespace

Answer decide(Workshop& workshop, Question question) {
  return decide(workshop, std::move(question), workshop.budget().effort);
}

Answer decide(Workshop& workshop, Question question, long effort) {
  std::vector<Place> touches;
  Subdivision search(workshop, question, {});
  bool may_be_square = !question.strict;
  for (long burst = std::min(first_burst, effort);;) {
    switch (search.run(burst)) {
      case Subdivision::Outcome::proved: {
        Answer yes{Answer::Kind::yes, {}, {}, Sign::zero, {}};
        yes.pieces.steps = search.steps();
        return yes;
      }
      case Subdivision::Outcome::refuted:
        return no(workshop, question, search.refutation());
      case Subdivision::Outcome::late:
        return neither("time", "the time given was over after " +
                                   std::to_string(search.looked_at()) + " pieces");
      case Subdivision::Outcome::hopeless:
        if (may_be_square)
          if (auto answer = by_square(workshop, question, effort)) return *answer;
        return neither(
            "degenerate",
            "the formula touches 0 at a corner of a product of domains, where its "
            "mixed derivative is negative; no subdivision of the product shows its sign");
      case Subdivision::Outcome::paused:
        break;
    }
    const Barycentric f = in_barycentric(question.factors, question.f);
    bool is_new = false;
    const auto near = question.may_touch ? search.worst(8) : std::vector<const Piece*>();
    for (const Touch& touch : find_touches(workshop, question.factors, f, near)) {
      lift(workshop, question);
      if (touch.sign != Sign::positive && (touch.sign == Sign::negative || question.strict) &&
          lies_in(workshop, question, touch.place))
        return no(workshop, question, touch.place);
      if (touch.sign == Sign::negative || std::ssize(touches) >= most_touches) continue;
      const auto same = [&](const Place& place) {
        for (std::size_t k = 0; k < place.size(); ++k)
          for (std::size_t i = 0; i < place[k].size(); ++i) {
            const double here = exact::ball(place[k][i]).middle;
            if (std::abs(here - exact::ball(touch.place[k][i]).middle) > same_place)
              return false;
          }
        return true;
      };
      if (std::ranges::any_of(touches, same)) continue;
      touches.push_back(touch.place);
      is_new = true;
    }
    if (is_new) {
      for (Place& place : touches)
        for (auto& l : place)
          for (Polynomial& c : l) c = workshop.numbers()->embed(c);
      search = Subdivision(workshop, question, touches);
      continue;
    }
    if (std::exchange(may_be_square, false))
      if (auto answer = by_square(workshop, question, effort)) return *answer;
    if (burst >= effort)
      return neither("effort",
                     "undecided after " + std::to_string(search.looked_at()) + " pieces");
    burst = std::min(4 * burst, effort);
  }
}

certificate::Point write_point(Workshop& workshop, const Factors& factors, const Place& place) {
  certificate::Point result;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const auto values = point(factors[k], place[k]);
    for (std::size_t j = 0; j < values.size(); ++j) {
      result.variables.push_back(factors[k].variables[j]);
      result.values.push_back(workshop.write(values[j]));
    }
  }
  return result;
}

}  // namespace seam::prove
