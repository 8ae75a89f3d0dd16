// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "check/judge.h"

namespace seam::check::test {

using namespace certificate;
using Kind = Finding::Kind;

/// A statement of one obligation and its evidence, put together node by node. Nodes made after
/// `evidence_begins` belong to the evidence.
class Case {
 public:
  Statement statement;
  Evidence evidence;

  Term number(const std::string& text) { return add({Node::Kind::constant, text, {}, 0}); }
  Term number(int value) { return number(std::to_string(value)); }
  Term symbol(const std::string& name) { return add({Node::Kind::symbol, name, {}, 0}); }
  Term sum(std::vector<Term> terms) { return add({Node::Kind::sum, {}, std::move(terms), 0}); }
  Term product(std::vector<Term> terms) {
    return add({Node::Kind::product, {}, std::move(terms), 0});
  }
  Term power(Term base, int n) { return add({Node::Kind::power, {}, {base}, n}); }
  Term scaled(int factor, Term term) { return product({number(factor), term}); }
  Term difference(Term a, Term b) { return sum({a, scaled(-1, b)}); }

  /// coefficients[0] + coefficients[1] * base + ...
  Term polynomial(Term base, const std::vector<std::string>& coefficients) {
    std::vector<Term> terms;
    for (int i = 0; i < std::ssize(coefficients); ++i)
      terms.push_back(product({number(coefficients[i]), power(base, i)}));
    return sum(std::move(terms));
  }

  void generator(const std::string& name, Term polynomial, const std::string& low,
                 const std::string& high) {
    (in_evidence_ ? evidence.generators : statement.generators)
        .push_back({name, polynomial, low, high});
  }
  /// The positive square root of a term.
  Term root(const std::string& name, Term square, const std::string& low,
            const std::string& high) {
    const Term symbol_of_it = symbol(name);
    generator(name, difference(power(symbol_of_it, 2), square), low, high);
    return symbol_of_it;
  }

  /// 0 <= variable <= 1, or less of it.
  Simplex segment(const std::string& variable, const std::string& low = "0",
                  const std::string& high = "1", bool open_low = false,
                  bool open_high = false) {
    const Term one = number(1);
    return {{variable},
            {{one, number(low)}, {one, number(high)}},
            {open_high, open_low}};  // facet 0 is the end opposite to corner 0
  }
  /// low <= variable.
  Simplex ray(const std::string& variable, const std::string& low, bool open_low = false) {
    return {{variable}, {{number(1), number(low)}, {number(0), number(1)}}, {false, open_low}};
  }
  /// u, v >= 0, u + v <= 1.
  Simplex triangle(bool open = false) {
    const Term one = number(1);
    const Term nil = number(0);
    return {
        {"u", "v"}, {{one, nil, nil}, {one, one, nil}, {one, nil, one}}, {open, open, open}};
  }

  /// The statement is this obligation alone.
  void claim(Obligation obligation) {
    statement.obligations = {std::move(obligation)};
    statement.goal = {Goal::Kind::obligation, {}, 0};
  }
  void evidence_begins() { in_evidence_ = true; }
  void proof(Proof proof) { evidence.proofs = {std::move(proof)}; }

  Judgement judged(long effort = 2'000'000'000) const {
    return judge(statement, evidence, effort);
  }
  Finding finding() const { return judged().findings.front(); }
  Finding finding(Proof other) {
    proof(std::move(other));
    return finding();
  }

 private:
  Term add(Node node) {
    (in_evidence_ ? evidence.nodes : statement.nodes).push_back(std::move(node));
    return static_cast<Term>(statement.nodes.size() + evidence.nodes.size()) - 1;
  }
  bool in_evidence_ = false;
};

inline Step plain() {
  return {};
}
inline Step outside(int condition) {
  return {Step::Kind::outside, condition, {}};
}
inline Step split(int factor, std::vector<Term> weights) {
  return {Step::Kind::split, factor, std::move(weights)};
}
inline Pieces pieces(Subdivision steps) {
  return {std::move(steps)};
}

inline Pieces nonzero(Relation side, Subdivision steps = {plain()}) {
  Pieces evidence = pieces(std::move(steps));
  evidence.side = side;
  return evidence;
}

}  // namespace seam::check::test

// The finding is open, for a reason that holds these words.
#define EXPECT_OPEN(found, words)                                           \
  do {                                                                      \
    const ::seam::check::Finding open_ = (found);                           \
    EXPECT_EQ(open_.kind, ::seam::check::Finding::Kind::open);              \
    EXPECT_NE(open_.reason.find(words), std::string::npos) << open_.reason; \
  } while (false)
#define EXPECT_HOLDS(found)                                                     \
  do {                                                                          \
    const ::seam::check::Finding held_ = (found);                               \
    EXPECT_EQ(held_.kind, ::seam::check::Finding::Kind::holds) << held_.reason; \
  } while (false)
#define EXPECT_FAILS(found)                                                         \
  do {                                                                              \
    const ::seam::check::Finding failed_ = (found);                                 \
    EXPECT_EQ(failed_.kind, ::seam::check::Finding::Kind::fails) << failed_.reason; \
  } while (false)
