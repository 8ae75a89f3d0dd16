// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/extremum_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "bernstein/critical.h"
#include "bernstein/extremum.h"
#include "bernstein/refine.h"
#include "claims/extremum_trials.h"
#include "exact/recognise.h"
#include "exact/roots.h"
#include "symbolic/expand.h"

// A place is found in doubles and followed to many digits. Its coordinates are then guessed:
// fractions, numbers of the field so far, roots of a polynomial with small integers, which the
// field grows by. A guess counts where all derivatives within the face are 0 there, exactly.
// Of functions with roots only corners, centres of faces and the points of a grid are tried.

namespace seam::claims {
namespace {

using bernstein::Landscape;
using bernstein::Spot;
using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;
using symbolic::Simplex;

constexpr long guess_bits = 1200;
constexpr int most_degree = 12;

// A part in coordinates that make each factor of its domain a standard simplex. Of a minimum
// the negative.
struct Ground {
  const Extremum::Part* part;
  std::size_t index;
  Landscape landscape;
};

std::map<std::string, Formula> in_shares(const Extremum::Part& part,
                                         const std::vector<Formula>& shares) {
  std::map<std::string, Formula> result;
  std::size_t next = 0;
  for (const Simplex& factor : part.domain.factors) {
    const std::size_t size = factor.variables.size();
    for (std::size_t j = 0; j < size; ++j) {
      Formula x = factor.corners[0][j + 1];
      for (std::size_t i = 0; i < size; ++i)
        x += shares[next + i] * (factor.corners[i + 1][j + 1] - factor.corners[0][j + 1]);
      result.emplace(factor.variables[j], x);
    }
    next += size;
  }
  return result;
}

// A formula in these variables, over the field of the numbers in `all`.
Polynomial expanded(const Numbers& numbers, const Formula& all,
                    const std::vector<std::string>& variables, const Formula& f) {
  const Numbers::Field& field = numbers.field(all);
  if (!field.transcendental.empty())
    throw Unsupported("where an extremum with numbers that are not algebraic is attained");
  return symbolic::Expansion(exact::Ring::make(field.ring->tower(), variables), {},
                             field.values)(f);
}

Ground ground(Evaluator& evaluator, const Extremum& extremum, std::size_t index) {
  const Extremum::Part& part = extremum.parts[index];
  std::vector<int> dimensions;
  std::vector<std::string> names;
  std::vector<Formula> shares;
  for (const Simplex& factor : part.domain.factors) {
    dimensions.push_back(static_cast<int>(factor.variables.size()));
    for (std::size_t i = 0; i < factor.variables.size(); ++i) {
      names.push_back("share~" + std::to_string(names.size()));
      shares.push_back(Formula::symbol(names.back()));
    }
  }
  const auto place = in_shares(part, shares);
  if (has_parameter(part))
    throw Unsupported("the value of an extremum that depends on a parameter");
  const Formula above = symbolic::subst(part.value.numerator, place);
  const Formula below = symbolic::subst(part.value.denominator, place);
  Polynomial numerator = expanded(evaluator.numbers, above * below, names, above);
  Polynomial denominator = expanded(evaluator.numbers, above * below, names, below);
  std::vector<double> centre;
  for (const int dimension : dimensions)
    centre.insert(centre.end(), dimension, 1.0 / (dimension + 1));
  if (!extremum.maximum) numerator = -numerator;
  if (bernstein::Sketch(denominator).value(centre) < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  return {&part, index, Landscape(numerator, denominator, dimensions)};
}

struct Found {
  Ground ground;
  Spot spot;
};

// The best spots of all parts; functions that are the same are searched once.
std::vector<Found> best_spots(Evaluator& evaluator, const Extremum& extremum) {
  std::vector<Ground> seen;
  std::vector<Found> result;
  for (std::size_t i = 0; i < extremum.parts.size(); ++i) {
    Ground here = ground(evaluator, extremum, i);
    const auto is_same = [&](const Ground& g) { return g.landscape == here.landscape; };
    if (std::ranges::any_of(seen, is_same)) continue;
    for (Spot& spot : here.landscape.highest()) result.push_back({here, std::move(spot)});
    seen.push_back(std::move(here));
  }
  double best = -HUGE_VAL;
  for (const Found& found : result) best = std::max(best, found.spot.value);
  std::erase_if(result, [&](const Found& found) {
    return found.spot.value < best - 1e-8 * std::max(1e-3, std::abs(best));
  });
  if (result.empty()) throw Unsupported("no place was found where this extremum is attained");
  return result;
}

// A place, number by number, in a field that grows by what they need.
class Guess {
 public:
  Guess(Numbers& numbers, const Landscape::Restriction& f)
      : numbers_(numbers),
        names_(f.numerator.ring().variables()),
        numerator_(symbolic::formula(f.numerator)),
        denominator_(symbolic::formula(f.denominator)) {
    include(numerator_);
    include(denominator_);
  }

  bool add(const Rational& value) {
    const RingPtr field = numbers_.field(symbols_).ring;
    const Rational simple = exact::simplest(value, Rational(1, exact::Integer(1) << 80));
    if (mpz_sizeinbase(simple.get_den_mpz_t(), 2) < 36) {
      at_.emplace_back(simple);
      return true;
    }
    if (field->tower())
      if (const auto known = exact::recognise(field, value, guess_bits)) {
        at_.push_back(symbolic::formula(*known));
        return true;
      }
    const auto f = exact::annihilator(field, value, most_degree, guess_bits);
    if (!f) return false;
    for (const exact::RootInterval& root : exact::real_roots(exact::squarefree(*f))) {
      if (value < root.low || value > root.high) continue;
      std::vector<Formula> terms;
      for (int i = 0; i <= exact::degree(*f); ++i)
        terms.push_back(symbolic::formula((*f)[i]) *
                        symbolic::power(Formula::symbol("share~"), i));
      at_.push_back(
          numbers_.root(symbolic::sum(std::move(terms)), "share~", root.low, root.high));
      include(at_.back());
      return true;
    }
    return false;
  }

  // Whether all derivatives are 0 there.
  bool is_critical() const {
    const Numbers::Field& field = numbers_.field(symbols_);
    symbolic::Expansion function(exact::Ring::make(field.ring->tower(), names_), {},
                                 field.values);
    symbolic::Expansion number(field.ring, {}, field.values);
    std::vector<Polynomial> place;
    for (const Formula& x : at_) place.push_back(number(x));
    const Polynomial above = function(numerator_), below = function(denominator_);
    const auto value = [&](const Polynomial& g) { return g.substitute(field.ring, place); };
    const Polynomial n = value(above), d = value(below);
    for (int i = 0; i < std::ssize(at_); ++i)
      if (!(value(above.derivative(i)) * d - n * value(below.derivative(i))).is_zero())
        return false;
    return true;
  }

  const std::vector<Formula>& at() const { return at_; }

 private:
  void include(const Formula& f) { symbols_.merge(symbolic::symbols(f)); }

  Numbers& numbers_;
  std::vector<std::string> names_;
  Formula numerator_, denominator_;
  std::set<std::string> symbols_;
  std::vector<Formula> at_;
};

Attained attained_at(Evaluator& evaluator, const Extremum::Part& part, std::size_t index,
                     std::map<std::string, Formula> point) {
  Attained result{index, std::move(point), {}, 0};
  std::map<std::string, Scalar> map;
  for (auto& [name, coordinate] : result.point) {
    coordinate = evaluator.numbers.normal_form(coordinate);
    map.emplace(name, Scalar(coordinate));
  }
  result.here = substitute(part.value, map, evaluator.numbers);
  result.value = evaluator.numbers.normal_form(result.here.numerator);
  return result;
}

Attained attained_at(Evaluator& evaluator, const Ground& ground,
                     const Landscape::Restriction& f, const std::vector<Formula>& at) {
  std::map<std::string, Formula> coordinates;
  const auto& names = f.numerator.ring().variables();
  for (std::size_t i = 0; i < at.size(); ++i) coordinates.emplace(names[i], at[i]);
  std::vector<Formula> shares;
  for (const Polynomial& x : f.place)
    shares.push_back(symbolic::subst(symbolic::formula(x), coordinates));
  return attained_at(evaluator, *ground.part, ground.index, in_shares(*ground.part, shares));
}

std::optional<Attained> exactly(Evaluator& evaluator, const Found& found) {
  const auto f = found.ground.landscape.on(found.spot.face);
  if (found.spot.is_centre) {
    std::vector<Formula> at;
    for (const double share : found.spot.at)
      at.emplace_back(Rational(1, std::lround(1 / share)));
    return attained_at(evaluator, found.ground, f, at);
  }
  const auto location =
      bernstein::refined(f.numerator, f.denominator, found.spot.at, guess_bits);
  if (!location) return std::nullopt;
  try {
    Guess guess(evaluator.numbers, f);
    for (const Rational& share : *location)
      if (!guess.add(share)) return std::nullopt;
    if (!guess.is_critical()) return std::nullopt;
    return attained_at(evaluator, found.ground, f, guess.at());
  } catch (const symbolic::NumberLimit&) {
    return std::nullopt;
  }
}

// The trials with the best value, about; centres before points of the grid.
std::vector<Trial> best_trials(Evaluator& evaluator, const Extremum& extremum) {
  if (std::ranges::any_of(extremum.parts, has_parameter))
    throw Unsupported("the value of an extremum that depends on a parameter");
  std::vector<Trial> all = trials(evaluator, extremum);
  const double side = extremum.maximum ? 1 : -1;
  double best = -HUGE_VAL;
  for (const Trial& trial : all)
    if (side * trial.value > best) best = side * trial.value;
  std::erase_if(all, [&](const Trial& trial) {
    return !(side * trial.value >= best - 1e-12 * std::max(1.0, std::abs(best)));
  });
  if (all.empty()) throw Unsupported("no place was found where this extremum is attained");
  return all;
}

Attained attained_at(Evaluator& evaluator, const Extremum& extremum, const Trial& trial) {
  return attained_at(evaluator, extremum.parts[trial.part], trial.part,
                     point_of(extremum, trial));
}

// Places that the best may be attained at, one after the other; null where one was not
// recognised.
using Candidates = std::vector<std::function<std::optional<Attained>()>>;

Candidates candidates(Evaluator& evaluator, const Extremum& extremum) {
  Candidates result;
  if (has_roots(extremum)) {
    for (const Trial& trial : best_trials(evaluator, extremum))
      if (trial.is_centre)
        result.emplace_back([&evaluator, &extremum, trial] {
          return std::optional(attained_at(evaluator, extremum, trial));
        });
  } else {
    for (const Found& found : best_spots(evaluator, extremum))
      result.emplace_back([&evaluator, found] { return exactly(evaluator, found); });
  }
  return result;
}

bool is_before(const Numbers& numbers, const Extremum& extremum, const Attained& a,
               const Attained& b) {
  if (a.part != b.part) return a.part < b.part;
  for (const Simplex& factor : extremum.parts[a.part].domain.factors)
    for (const std::string& name : factor.variables) {
      const exact::Sign sign = numbers.sign(a.point.at(name) - b.point.at(name));
      if (sign != exact::Sign::zero) return sign == exact::Sign::negative;
    }
  return false;
}

}  // namespace

std::vector<Attained> attained(Evaluator& evaluator, const Extremum& extremum,
                               std::size_t most) {
  std::vector<Attained> best;
  for (const auto& candidate : candidates(evaluator, extremum)) {
    if (best.size() >= most) break;
    auto place = candidate();
    if (!place) continue;
    if (!best.empty()) {
      const Formula gain =
          extremum.maximum ? place->value - best[0].value : best[0].value - place->value;
      const exact::Sign sign = evaluator.numbers.sign(gain);
      if (sign == exact::Sign::negative) continue;
      if (sign == exact::Sign::positive) best.clear();
      const auto is_same = [&](const Attained& other) {
        return !is_before(evaluator.numbers, extremum, other, *place) &&
               !is_before(evaluator.numbers, extremum, *place, other);
      };
      if (std::ranges::any_of(best, is_same)) continue;
    }
    best.push_back(std::move(*place));
  }
  if (best.empty())
    throw Unsupported("this extremum is attained at no point that was recognised exactly");
  std::ranges::stable_sort(best, [&](const Attained& a, const Attained& b) {
    return is_before(evaluator.numbers, extremum, a, b);
  });
  return best;
}

Attained nearly_attained(Evaluator& evaluator, const Extremum& extremum, long bits) {
  if (has_roots(extremum))
    return attained_at(evaluator, extremum, best_trials(evaluator, extremum).front());
  const Found found = best_spots(evaluator, extremum).front();
  const auto f = found.ground.landscape.on(found.spot.face);
  std::optional<std::vector<Rational>> location;
  if (!found.spot.is_centre)
    location = bernstein::refined(f.numerator, f.denominator, found.spot.at, bits);
  std::vector<Formula> at;
  for (std::size_t i = 0; i < found.spot.at.size(); ++i) {
    const double share = found.spot.at[i];
    at.emplace_back(location               ? (*location)[i]
                    : found.spot.is_centre ? Rational(1, std::lround(1 / share))
                                           : Rational(share));
  }
  return attained_at(evaluator, found.ground, f, at);
}

double about(Evaluator& evaluator, const Extremum& extremum) {
  if (has_roots(extremum)) return best_trials(evaluator, extremum).front().value;
  double value = -HUGE_VAL;
  for (const Found& found : best_spots(evaluator, extremum))
    value = std::max(value, found.spot.value);
  return extremum.maximum ? value : -value;
}

bool is_oblique(Evaluator& evaluator, const Extremum& extremum) {
  const auto is_simple = [](const Extremum::Part& p) { return p.domain.factors.size() < 2; };
  if (std::ranges::all_of(extremum.parts, is_simple) ||
      std::ranges::any_of(extremum.parts, has_parameter) || has_roots(extremum))
    return false;
  for (const Found& found : best_spots(evaluator, extremum)) {
    const auto f = found.ground.landscape.on(found.spot.face);
    const auto above = bernstein::Sketch(f.numerator).jet(found.spot.at);
    const auto below = bernstein::Sketch(f.denominator).jet(found.spot.at);
    std::vector<std::size_t> factor;  // of each coordinate
    for (std::size_t k = 0; k < found.spot.face.size(); ++k)
      factor.insert(factor.end(), std::popcount(found.spot.face[k]) - 1, k);
    const auto second = [&](std::size_t i, std::size_t j) {
      return above.hessian[i][j] - above.value / below.value * below.hessian[i][j];
    };
    for (std::size_t i = 0; i < factor.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (factor[i] != factor[j] &&
            std::abs(second(i, j)) > 1e-7 * std::sqrt(std::abs(second(i, i) * second(j, j))))
          return true;
  }
  return false;
}

}  // namespace seam::claims
