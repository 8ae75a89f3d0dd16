// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/fault.h"

#include <algorithm>
#include <ranges>
#include <stdexcept>
#include <utility>

namespace seam::certificate {
namespace {

constexpr std::size_t max_digits = 20'000;

struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void demand(bool condition, const char* otherwise) {
  if (!condition) throw Fault(otherwise);
}

bool is_natural(std::string_view text) {
  return !text.empty() && text.size() <= max_digits && (text == "0" || text.front() != '0') &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

template <typename List>
void demand_index(int index, const List& list, const char* otherwise) {
  demand(index >= 0 && std::cmp_less(index, list.size()), otherwise);
}

/// Checks against the nodes below `count`.
class Terms {
 public:
  explicit Terms(std::size_t count) : count_(count) {}

  void demand_term(Term term) const {
    demand(term >= 0 && std::cmp_less(term, count_), "a term is none of the nodes before it");
  }
  void demand_terms(const std::vector<Term>& terms) const {
    for (const Term term : terms) demand_term(term);
  }

  void operator()(const Node& node) const {
    const bool has_text = node.kind == Node::Kind::constant || node.kind == Node::Kind::symbol;
    demand(has_text ? node.operands.empty() : node.text.empty(), "a node of two kinds");
    demand(node.kind == Node::Kind::power || node.exponent == 0, "an exponent out of place");
    demand_terms(node.operands);
    if (node.kind == Node::Kind::constant)
      demand(is_rational(node.text),
             "a constant is not a rational number in its only spelling");
    if (node.kind == Node::Kind::symbol) demand(!node.text.empty(), "a symbol without a name");
    if (node.kind == Node::Kind::power)
      demand(node.operands.size() == 1 && node.exponent >= 0,
             "a power takes one base and an exponent that is not negative");
  }

  void operator()(const Generator& generator) const {
    demand(!generator.name.empty(), "a number without a name");
    if (generator.function != Elementary::none) {
      demand(generator.polynomial == 0 && generator.low.empty() && generator.high.empty(),
             "a number of two kinds");
      if (generator.function != Elementary::pi) demand_term(generator.argument);
      return;
    }
    demand_term(generator.polynomial);
    demand(is_rational(generator.low) && is_rational(generator.high),
           "the ends of an interval are not rational");
  }

  void operator()(const Function& function) const {
    demand(!function.name.empty(), "a function without a name");
    demand_term(function.operand);
    demand(function.elementary != Elementary::pi, "a number among the functions");
    demand(!function.is_root() || function.degree >= 2, "a root of a degree below 2");
  }

  void operator()(const Zero& zero) const { demand_term(zero.formula); }

  void operator()(const Simplex& simplex) const {
    const std::size_t size = simplex.variables.size() + 1;
    demand(simplex.corners.size() == size && simplex.open.size() == size,
           "a simplex in k variables has k + 1 corners and facets");
    for (const auto& corner : simplex.corners) {
      demand(corner.size() == size, "a corner in k variables has k + 1 coordinates");
      demand_terms(corner);
    }
  }

  void operator()(const Sign& sign) const {
    demand_term(sign.formula);
    std::ranges::for_each(sign.domain.factors, *this);
    for (const Constraint& constraint : sign.domain.where) demand_term(constraint.formula);
  }

  void operator()(const Solutions& solutions) const {
    demand_terms(solutions.system);
    demand(solutions.domain.variables.size() == 1, "the domain of one unknown is not linear");
    const bool is_everything =
        solutions.domain.corners.empty() && solutions.domain.open.empty();
    if (!is_everything) (*this)(solutions.domain);
    for (const Solution& solution : solutions.solutions) {
      if (solution.value == -1) {
        demand(is_rational(solution.low) && is_rational(solution.high),
               "the ends of an interval are not rational");
      } else {
        demand_term(solution.value);
        demand(solution.low.empty() && solution.high.empty(), "a solution given twice");
      }
    }
  }

  void operator()(const OnlySolutions& only) const {
    demand_terms(only.system);
    std::ranges::for_each(only.domain.factors, *this);
    for (const Constraint& constraint : only.domain.where) demand_term(constraint.formula);
    for (const auto& [numerators, denominators] : only.solutions) {
      demand(numerators.size() == only.unknowns.size() &&
                 denominators.size() == only.unknowns.size(),
             "a solution has not one quotient for each unknown");
      demand_terms(numerators);
      demand_terms(denominators);
    }
  }

  void operator()(const OneSolution& one) const {
    demand_terms(one.system);
    std::ranges::for_each(one.domain.factors, *this);
    for (const Constraint& constraint : one.domain.where) demand_term(constraint.formula);
    (*this)(Box{one.low, one.high});
    demand(one.low.size() == one.unknowns.size(), "not one interval for each unknown");
  }

  void operator()(const Gluing& gluing) const {
    for (const auto& sides : gluing.patches)
      for (const auto& [from, to] : sides) {
        demand_index(from, sides, "a side begins at no corner");
        demand_index(to, sides, "a side ends at no corner");
      }
    for (const auto& seam : gluing.seams) {
      demand_index(seam.patch, gluing.patches, "a seam on no patch");
      demand_index(seam.other_patch, gluing.patches, "a seam on no patch");
      demand_index(seam.side, gluing.patches[static_cast<std::size_t>(seam.patch)],
                   "a seam on no side");
      demand_index(seam.other_side, gluing.patches[static_cast<std::size_t>(seam.other_patch)],
                   "a seam on no side");
    }
  }

  void operator()(const Distinct& distinct) const {
    for (const auto& tuple : distinct.tuples) {
      demand(tuple.size() == distinct.tuples.front().size(), "tuples of different lengths");
      demand_terms(tuple);
    }
  }

  void operator()(const Mesh& mesh) const {
    demand(mesh.vertices >= 0, "a negative number of vertices");
    demand(mesh.points.empty() || std::cmp_equal(mesh.points.size(), mesh.vertices),
           "not one point for each vertex");
    for (const auto& point : mesh.points) {
      demand(point.size() == 3, "a vertex has not three coordinates");
      demand_terms(point);
    }
    for (std::vector<int> face : mesh.faces) {
      demand(face.size() >= 3, "a face of less than three corners");
      for (const int vertex : face)
        demand(vertex >= 0 && vertex < mesh.vertices, "a face at no vertex");
      std::ranges::sort(face);
      demand(std::ranges::adjacent_find(face) == face.end(), "a face twice at one vertex");
    }
    demand_terms(mesh.ratios);
  }

  void operator()(const Nothing&) const {}
  void operator()(const Computation&) const {}

  void operator()(const Pieces& pieces) const {
    for (const Step& step : pieces.steps) {
      demand(step.index >= 0, "a step of a negative index");
      demand(step.kind == Step::Kind::split || step.weights.empty(), "weights out of place");
      demand_terms(step.weights);
    }
    if (pieces.square == -1 && pieces.cofactor == -1) return;
    demand_term(pieces.square);
    demand_term(pieces.cofactor);
  }

  void operator()(const Reduction& reduction) const { demand_sound(reduction, 0); }

  void operator()(const Point& point) const {
    demand(point.variables.size() == point.values.size(), "not one value for each variable");
    demand_terms(point.values);
  }

  void operator()(const Witness& witness) const {
    (*this)(witness.point);
    demand(witness.other.size() <= 1, "more than two points");
    std::ranges::for_each(witness.other, *this);
  }

  void operator()(const Roots& roots) const {
    demand_term(roots.divisor);
    demand_term(roots.rest);
    demand_terms(roots.cofactors);
    demand_terms(roots.quotients);
    std::ranges::for_each(roots.inside, *this);
    std::ranges::for_each(roots.outside, *this);
  }

  void operator()(const WrongSolution& wrong) const {
    demand_term(wrong.value);
    demand(wrong.claimed >= -1, "a claimed solution of a negative index");
  }

  void operator()(const Combination& combination) const {
    demand(combination.equations.size() == combination.cofactors.size(),
           "not one cofactor for each equation");
    demand_terms(combination.cofactors);
  }

  void operator()(const EliminationStep& step) const {
    (*this)(step.combination);
    for (const EliminationFactor& factor : step.factors) {
      demand_term(factor.formula);
      demand(factor.power >= 1 && factor.condition >= -1,
             "a factor with an index out of place");
      demand_sound(factor.trees);
    }
    demand_term(step.formula);
    demand_term(step.remainder);
    demand(step.index >= 0, "a step of a negative index");
    demand_sound(step.positive);
    demand_sound(step.broken);
  }

  void operator()(const Box& box) const {
    demand(box.low.size() == box.high.size(), "a box with an interval of one end");
    for (const auto* ends : {&box.low, &box.high})
      demand(std::ranges::all_of(*ends, is_rational),
             "the ends of an interval are not rational");
  }

  void operator()(const Isolation& isolation) const {
    for (const auto& row : isolation.combination)
      demand(std::ranges::all_of(row, is_rational), "an entry of a matrix is not rational");
    (*this)(isolation.inner);
    (*this)(isolation.outer);
    for (const auto* trees :
         {&isolation.faces, &isolation.conditions, &isolation.dominance, &isolation.cover})
      std::ranges::for_each(*trees, *this);
  }

  void operator()(const Elimination& elimination) const {
    std::ranges::for_each(elimination.steps, *this);
  }

 private:
  void demand_sound(const std::vector<SignProof>& proofs) const {
    for (const SignProof& proof : proofs) std::visit(*this, proof);
  }

  static void demand_fitting(const Reduction& reduction) {
    const std::size_t terms = reduction.terms.size(), parts = reduction.parts.size();
    const std::size_t conditions = reduction.conditions.size();
    switch (reduction.kind) {
      case Reduction::Kind::combination:
        return demand(conditions == terms, "not one cofactor for each condition");
      case Reduction::Kind::condition:
        return demand(conditions == 1 && terms == 1 && parts == 0,
                      "not the one condition, and number, that a rule takes");
      case Reduction::Kind::squares:
        return demand(
            parts == 0 ? terms % 2 == 0 && conditions == 0 : terms % 3 == 0 && parts == 1,
            "not one weight, and one cofactor, for each square");
      case Reduction::Kind::factors:
        return demand(conditions == 0 && parts == terms, "not one proof for each factor");
      default:
        demand(conditions == 0, "conditions out of place");
        demand(terms == (reduction.kind == Reduction::Kind::both ? 0 : 1) && parts == 2,
               "not the terms, or not the two proofs, that a rule takes");
    }
  }

  void demand_sound(const Reduction& reduction, int depth) const {
    demand(depth < max_proof_depth, "a proof is nested too deeply");
    demand_terms(reduction.terms);
    for (const int condition : reduction.conditions)
      demand(condition >= 0, "a condition of a negative index");
    demand_fitting(reduction);
    for (const SignProof& part : reduction.parts)
      if (const auto* inner = std::get_if<Reduction>(&part))
        demand_sound(*inner, depth + 1);
      else if (const auto* pieces = std::get_if<Pieces>(&part))
        (*this)(*pieces);
  }

  std::size_t count_;
};

void check_goal(const Goal& goal, std::size_t obligations, int depth) {
  demand(depth < max_goal_depth, "a goal is nested too deeply");
  if (goal.kind == Goal::Kind::obligation) {
    demand(goal.obligation >= 0 && std::cmp_less(goal.obligation, obligations),
           "a goal names an obligation that is none");
    demand(goal.parts.empty(), "an obligation has no parts");
    return;
  }
  demand(goal.obligation == -1, "an obligation out of place");
  const bool single = goal.kind == Goal::Kind::negation || goal.kind == Goal::Kind::suffices;
  demand(!single || goal.parts.size() == 1, "this goal takes one part");
  for (const Goal& part : goal.parts) check_goal(part, obligations, depth + 1);
}

void check_nodes(const std::vector<Node>& nodes, std::size_t before) {
  for (std::size_t i = 0; i < nodes.size(); ++i) Terms{before + i}(nodes[i]);
}

void check(const Statement& statement, const Evidence& evidence) {
  const std::size_t stated = statement.nodes.size();
  const Terms of_statement{stated};
  check_nodes(statement.nodes, 0);
  std::ranges::for_each(statement.generators, of_statement);
  std::ranges::for_each(statement.functions, of_statement);
  for (const Obligation& obligation : statement.obligations)
    std::visit(of_statement, obligation);
  for (const int guard : statement.guards)
    demand_index(guard, statement.obligations, "a guard is no obligation");
  check_goal(statement.goal, statement.obligations.size(), 0);

  const Terms of_evidence{stated + evidence.nodes.size()};
  check_nodes(evidence.nodes, stated);
  std::ranges::for_each(evidence.generators, of_evidence);
  demand(evidence.proofs.size() == statement.obligations.size(),
         "there is not one proof for each obligation");
  for (const Proof& proof : evidence.proofs) std::visit(of_evidence, proof);
}

}  // namespace

bool is_rational(std::string_view text) {
  if (text.starts_with('-')) {
    text.remove_prefix(1);
    if (text == "0") return false;
  }
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return is_natural(text);
  const std::string_view denominator = text.substr(slash + 1);
  return is_natural(text.substr(0, slash)) && text.front() != '0' && is_natural(denominator) &&
         denominator != "0" && denominator != "1";
}

std::string fault(const Statement& statement, const Evidence& evidence) {
  try {
    check(statement, evidence);
    return {};
  } catch (const Fault& found) {
    return found.what();
  }
}

}  // namespace seam::certificate
