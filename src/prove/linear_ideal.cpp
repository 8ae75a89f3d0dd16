// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/linear_ideal.h"

#include <utility>

// An equation that is solved holds no variable of those solved before. So dividing by one after
// the other takes all these variables out of f, each in as many steps as its degree.

namespace seam::prove {

using exact::Polynomial;

namespace {

constexpr int most_steps = 500;

Polynomial in_ring(const Polynomial& f, const Polynomial& of) {
  return of.ring().embed(f);
}

Polynomial coefficient(const Polynomial& f, int variable, int exponent) {
  const auto all = f.coefficients({variable});
  const auto found = all.find({exponent});
  return found == all.end() ? f.ring().constant(0) : found->second;
}

// -1 if there is none.
int solvable_variable(const Polynomial& f) {
  for (int v = 0; v < std::ssize(f.ring().variables()); ++v)
    if (f.degree(v) == 1 && coefficient(f, v, 1).is_number()) return v;
  return -1;
}

// d.rest stays f less the sum: `times` * by is taken off the one and added to the other.
void take_off(LinearIdeal::Division& d, const Polynomial times, const Polynomial& by,
              const std::map<std::size_t, Polynomial>& expression) {
  d.rest = d.rest - times * by;
  for (const auto& [i, cofactor] : expression) {
    const Polynomial more = times * in_ring(cofactor, times);
    const auto [place, is_new] = d.cofactors.emplace(i, more);
    if (!is_new) place->second = place->second + more;
  }
}

}  // namespace

// The expression of a solved equation has `rest` as the polynomial and, in `cofactors`, what it
// is made of.
void LinearIdeal::divide_by(const Solved& solved, Division& d) const {
  const Polynomial by = in_ring(solved.expression.rest, d.rest);
  if (solved.variable < 0) {
    take_off(d, d.rest, by, solved.expression.cofactors);
    return;
  }
  const Polynomial x = by.ring().variable(solved.variable);
  for (int degree = d.rest.degree(solved.variable); degree > 0;
       degree = d.rest.degree(solved.variable))
    take_off(d, coefficient(d.rest, solved.variable, degree) * x.pow(degree - 1), by,
             solved.expression.cofactors);
}

LinearIdeal::Division LinearIdeal::divide(const Polynomial& f) const {
  Division d{workshop_.ring(f.ring().variables())->embed(f), {}};
  for (auto& [i, cofactor] : d.cofactors) cofactor = in_ring(cofactor, d.rest);
  for (const Solved& solved : solved_) divide_by(solved, d);
  for (int step = 0; step < most_steps && take_off_a_multiple(d); ++step) {
  }
  return d;
}

bool LinearIdeal::take_off_a_multiple(Division& d) const {
  std::vector<int> all;
  for (int v = 0; v < std::ssize(d.rest.ring().variables()); ++v) all.push_back(v);
  const auto terms = d.rest.coefficients(all);
  for (auto term = terms.rbegin(); term != terms.rend(); ++term)
    for (const Division& equation : unsolved_) {
      const Polynomial by = in_ring(equation.rest, d.rest);
      const auto of_equation = by.coefficients(all);
      const auto& [lead, number] = *of_equation.rbegin();
      Polynomial times = term->second * d.rest.ring().embed(
                                            exact::inverse(workshop_.numbers()->embed(number)));
      bool divides = true;
      for (std::size_t v = 0; divides && v < lead.size(); ++v) {
        const int excess = term->first[v] - lead[v];
        divides = excess >= 0;
        if (divides) times = times * d.rest.ring().variable(static_cast<int>(v)).pow(excess);
      }
      if (!divides) continue;
      take_off(d, times, by, equation.cofactors);
      return true;
    }
  return false;
}

void LinearIdeal::add(const Polynomial& generator) {
  // generator = rest + sum c_i g_i, so rest = 1 * generator - sum c_i g_i.
  Division d = divide(generator);
  const Polynomial one = d.rest.ring().constant(1);
  for (auto& [i, cofactor] : d.cofactors) cofactor = -cofactor;
  d.cofactors.emplace(count_++, one);
  if (d.rest.is_zero()) return;
  const int v = d.rest.is_number() ? -1 : solvable_variable(d.rest);
  if (v < 0 && !d.rest.is_number()) {
    unsolved_.push_back(std::move(d));
    return;
  }
  const Polynomial lead = v < 0 ? d.rest : coefficient(d.rest, v, 1);
  const Polynomial scale =
      d.rest.ring().embed(exact::inverse(workshop_.numbers()->embed(lead)));
  d.rest = scale * d.rest;
  for (auto& [i, cofactor] : d.cofactors) cofactor = scale * cofactor;
  solved_.push_back({v, std::move(d)});
}

}  // namespace seam::prove
