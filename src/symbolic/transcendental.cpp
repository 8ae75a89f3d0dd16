// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/forest.h"

// Values of elementary functions at numbers, and their inverses, under the name of what they
// are; asked for twice, they are one generator. A sine comes after the cosine of the same
// argument and is defined beside it, so that a field that holds it holds both.

namespace seam::symbolic {

using exact::Rational;
using exact::Sign;

namespace {

// A text that breaks off may be that of another number too.
void require_whole(const std::string& name) {
  constexpr std::size_t longest = 20'000;
  if (name.size() > longest) throw NumberLimit("a function of a number that takes pages");
}

}  // namespace

Formula Numbers::pi() {
  if (forest_->index.contains("(pi)")) return Formula::symbol("(pi)");
  return forest_->add({"(pi)", 0, 0, 0, "pi", 0}, 0);
}

Formula Numbers::elementary(const std::string& function, const Formula& number) {
  const Formula argument = normal_form(number);
  const std::string name = function + "(" + text(argument) + ")";
  require_whole(name);
  if (forest_->index.contains(name)) return Formula::symbol(name);
  if (function == "log" && sign(argument) != Sign::positive)
    throw NumberError("logarithm of a number that is not positive");
  const Formula over = function == "sin" ? argument + elementary("cos", argument) : argument;
  return forest_->add({name, 0, 0, 0, function, argument}, over);
}

// The root of x * symbol - 1, between bounds that are wider than those known.
Formula Numbers::transcendental_inverse(const Formula& number) {
  const Formula x = normal_form(number);
  const std::string name = "(1/(" + text(x) + "))";
  require_whole(name);
  if (forest_->index.contains(name)) return Formula::symbol(name);
  const bool positive = sign(x) == Sign::positive;
  for (long bits = 64; bits <= max_precision; bits *= 2) {
    const auto e = forest_->enclosure(x, bits);
    if (!e || e->low * e->high <= 0 || (positive ? e->low * 2 < e->high : e->high * 2 > e->low))
      continue;
    const Rational low = 1 / e->high, high = 1 / e->low;
    const Rational margin = (positive ? low : Rational(-high)) / 4;
    return forest_->add({name, x * Formula::symbol(name) - Formula(1), low - margin,
                         high + margin, "inverse", x},
                        x);
  }
  throw NumberLimit("a divisor that is not enclosed closely enough: " + text(x, 60));
}

}  // namespace seam::symbolic
