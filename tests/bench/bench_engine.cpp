// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine costs: the Gauss curvature of a cubic triangle over Q(sqrt 5), numerator and
// denominator, with every sign of their coefficients; and proofs of signs.

#include <benchmark/benchmark.h>

#include <array>

#include "bernstein/form.h"
#include "exact/roots.h"
#include "prove/prove.h"
#include "prove/region.h"

namespace {

using namespace seam;
using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;

using Vector = std::array<Polynomial, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Polynomial dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector diff(const Vector& a, int variable) {
  return {a[0].derivative(variable), a[1].derivative(variable), a[2].derivative(variable)};
}

// A bulging cubic triangle, its coordinates in Q(sqrt 5).
Vector patch(const RingPtr& ring) {
  const Polynomial u = ring->variable(0), v = ring->variable(1), s = *ring->symbol("s");
  const Polynomial w = ring->constant(1) - u - v, bulge = u * v + v * w + w * u;
  const Polynomial deep = u * v * w;
  return {u + s * bulge + Rational(1, 3) * deep, v + s * bulge - s * deep,
          w + s * bulge + Rational(2, 7) * deep};
}

void curvature_of_a_cubic_triangle(benchmark::State& state) {
  const RingPtr rationals = exact::Ring::make(nullptr, {});
  const exact::Univariate f = {rationals->constant(-5), rationals->constant(0),
                               rationals->constant(1)};
  const auto tower = exact::adjoin(f, "s", exact::bracket(f, {2, 3}));
  const RingPtr ring = exact::Ring::make(tower, {"u", "v"}),
                numbers = exact::Ring::make(tower, {});
  const auto c = [&](long x) { return numbers->constant(x); };
  const prove::Factors triangle = {
      {{"u", "v"},
       {{c(1), c(0), c(0)}, {c(1), c(1), c(0)}, {c(1), c(0), c(1)}},
       {false, false, false},
       0}};
  int positive = 0;
  for (auto _ : state) {
    const Vector p = patch(ring);
    const Vector pu = diff(p, 0), pv = diff(p, 1);
    const Vector n = cross(pu, pv);
    const Polynomial l = dot(n, diff(pu, 0)), m = dot(n, diff(pu, 1)), k = dot(n, diff(pv, 1));
    const Polynomial n2 = dot(n, n);
    for (const Polynomial& g : {l * k - m * m, n2 * n2}) {
      const auto [polynomial, shape] = prove::in_barycentric(triangle, g);
      const bernstein::Form form(polynomial, shape);
      for (int i = 0; i < shape->count(); ++i)
        positive += form.sign(i) == exact::Sign::positive;
    }
  }
  benchmark::DoNotOptimize(positive);
}
BENCHMARK(curvature_of_a_cubic_triangle)->Unit(benchmark::kMillisecond);

// (3u - 1)^2 + (3v - 1)^2 + (3u - 1)(3v - 1) + rest over the triangle.
certificate::Statement bowl(const std::string& rest) {
  using Kind = certificate::Node::Kind;
  certificate::Statement s;
  const auto add = [&](certificate::Node node) {
    s.nodes.push_back(std::move(node));
    return static_cast<certificate::Term>(s.nodes.size() - 1);
  };
  const auto number = [&](const std::string& text) {
    return add({Kind::constant, text, {}, 0});
  };
  const auto shifted = [&](const std::string& name) {
    const auto product =
        add({Kind::product, "", {number("3"), add({Kind::symbol, name, {}, 0})}, 0});
    return add({Kind::sum, "", {product, number("-1")}, 0});
  };
  const auto a = shifted("u"), b = shifted("v");
  const auto f = add({Kind::sum,
                      "",
                      {add({Kind::power, "", {a}, 2}), add({Kind::power, "", {b}, 2}),
                       add({Kind::product, "", {a, b}, 0}), number(rest)},
                      0});
  const auto zero = number("0"), one = number("1");
  s.obligations = {certificate::Sign{f,
                                     certificate::Relation::nonnegative,
                                     {{{{"u", "v"},
                                        {{one, zero, zero}, {one, one, zero}, {one, zero, one}},
                                        {false, false, false}}},
                                      {}}}};
  s.goal = {certificate::Goal::Kind::obligation, {}, 0};
  return s;
}

void sign_on_a_triangle(benchmark::State& state) {
  const auto statement = bowl("1/1000");
  for (auto _ : state) benchmark::DoNotOptimize(prove::prove(statement));
}
BENCHMARK(sign_on_a_triangle)->Unit(benchmark::kMillisecond);

void touching_zero(benchmark::State& state) {
  const auto statement = bowl("0");
  for (auto _ : state) benchmark::DoNotOptimize(prove::prove(statement));
}
BENCHMARK(touching_zero)->Unit(benchmark::kMillisecond);

}  // namespace
