// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "check/judge.h"
#include "prove/prove.h"

// Statements written as formulas in C++, and what prover and checker make of them.
namespace seam::prove {

class Draft;

/// A term of the draft it comes from.
struct T {
  Draft* draft;
  certificate::Term term;
};

class Draft {
 public:
  certificate::Statement statement;

  T number(const std::string& text) {
    return add({certificate::Node::Kind::constant, text, {}, 0});
  }
  T symbol(const std::string& name) {
    return add({certificate::Node::Kind::symbol, name, {}, 0});
  }
  T add(certificate::Node node) {
    statement.nodes.push_back(std::move(node));
    return {this, static_cast<certificate::Term>(statement.nodes.size() - 1)};
  }
  /// The root of a polynomial in the symbol of that name.
  T generator(const std::string& name, T polynomial, const std::string& low,
              const std::string& high) {
    statement.generators.push_back({name, polynomial.term, low, high});
    return symbol(name);
  }

  /// Corners in homogeneous coordinates, the weight first, as rationals.
  certificate::Simplex simplex(std::vector<std::string> variables,
                               const std::vector<std::vector<std::string>>& corners,
                               std::vector<bool> open = {}) {
    certificate::Simplex result{std::move(variables), {}, std::move(open)};
    for (const auto& corner : corners) {
      result.corners.emplace_back();
      for (const std::string& c : corner) result.corners.back().push_back(number(c).term);
    }
    result.open.resize(corners.size(), false);
    return result;
  }
  certificate::Simplex triangle(bool open = false) {
    return simplex({"u", "v"}, {{"1", "0", "0"}, {"1", "1", "0"}, {"1", "0", "1"}},
                   {open, open, open});
  }
  certificate::Simplex segment(const std::string& name, const std::string& low,
                               const std::string& high, bool open_low = false,
                               bool open_high = false) {
    return simplex({name}, {{"1", low}, {"1", high}}, {open_high, open_low});
  }
  certificate::Simplex from_zero(const std::string& name, bool open = false) {
    return simplex({name}, {{"1", "0"}, {"0", "1"}}, {false, open});
  }

  certificate::Evidence proof(certificate::Obligation obligation, const Budget& budget = {}) {
    statement.obligations = {std::move(obligation)};
    statement.guards.clear();
    statement.goal = {certificate::Goal::Kind::obligation, {}, 0};
    return prove(statement, budget);
  }
  /// What the checker says of the prover's evidence.
  certificate::Verdict verdict(certificate::Obligation obligation, const Budget& budget = {}) {
    const auto evidence = proof(std::move(obligation), budget);
    const auto judgement = check::judge(statement, evidence);
    const auto* nothing = std::get_if<certificate::Nothing>(&evidence.proofs[0]);
    if (nothing) {
      last = nothing->reason + ": " + nothing->detail;
    } else {
      last = judgement.reason;
      EXPECT_NE(judgement.verdict, certificate::Verdict::undecided) << judgement.reason;
    }
    return judgement.verdict;
  }
  std::string last;  ///< why the last verdict was `undecided`
};

inline T operator+(T a, T b) {
  return a.draft->add({certificate::Node::Kind::sum, "", {a.term, b.term}, 0});
}
inline T operator*(T a, T b) {
  return a.draft->add({certificate::Node::Kind::product, "", {a.term, b.term}, 0});
}
inline T operator+(T a, int b) {
  return a + a.draft->number(std::to_string(b));
}
inline T operator+(int a, T b) {
  return b + a;
}
inline T operator*(int a, T b) {
  return b.draft->number(std::to_string(a)) * b;
}
inline T operator-(T a) {
  return -1 * a;
}
inline T operator-(T a, T b) {
  return a + -b;
}
inline T operator-(T a, int b) {
  return a + -b;
}
inline T operator-(int a, T b) {
  return -b + a;
}
inline T operator^(T a, int n) {
  return a.draft->add({certificate::Node::Kind::power, "", {a.term}, n});
}

}  // namespace seam::prove
