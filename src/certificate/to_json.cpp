// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/to_json.h"

#include <array>
#include <stdexcept>
#include <type_traits>

#include "certificate/json.h"

// An object with one member, {"kind": ...}, for one of several kinds. Members stand in the
// order of the declarations in statement.h and evidence.h.

namespace seam::certificate {
namespace {

template <typename T>
Json list(const std::vector<T>& entries);
template <typename... Kinds>
Json to_json(const std::variant<Kinds...>& value);

template <typename Plain>
requires(std::is_arithmetic_v<Plain> || std::is_same_v<Plain, std::string>) Json
    to_json(const Plain& value) {
  return value;
}

template <typename T>
Json to_json(const std::vector<T>& entries) {
  return list(entries);
}

Json to_json(const Node& node) {
  switch (node.kind) {
    case Node::Kind::constant:
      return node.text;
    case Node::Kind::symbol:
      return {{"symbol", node.text}};
    case Node::Kind::sum:
      return {{"sum", list(node.operands)}};
    case Node::Kind::product:
      return {{"product", list(node.operands)}};
    case Node::Kind::power:
      return {{"power", list(std::vector{node.operands.at(0), node.exponent})}};
  }
  throw FormatError("a node of no kind");
}

Json to_json(const Generator& generator) {
  if (generator.function == Elementary::pi)
    return {{"name", generator.name}, {"function", spelling(generator.function)}};
  if (generator.function != Elementary::none)
    return {{"name", generator.name},
            {"function", spelling(generator.function)},
            {"argument", generator.argument}};
  return {{"name", generator.name},
          {"polynomial", generator.polynomial},
          {"low", generator.low},
          {"high", generator.high}};
}

Json to_json(const Function& function) {
  if (!function.is_root())
    return {{"name", function.name},
            {"function", spelling(function.elementary)},
            {"argument", function.operand}};
  return {{"name", function.name}, {"radicand", function.operand}, {"degree", function.degree}};
}

Json to_json(const Simplex& simplex) {
  return {{"variables", list(simplex.variables)},
          {"corners", list(simplex.corners)},
          {"open", list(simplex.open)}};
}

Json to_json(const Constraint& constraint) {
  return {{"formula", constraint.formula}, {"relation", spelling(constraint.relation)}};
}

Json to_json(const Solution& solution) {
  if (solution.value >= 0) return solution.value;
  return {{"low", solution.low}, {"high", solution.high}};
}

Json to_json(const Gluing::Side& side) {
  return Json::array({side.from, side.to});
}

Json to_json(const Gluing::Seam& seam) {
  return {{"patch", seam.patch},
          {"side", seam.side},
          {"other_patch", seam.other_patch},
          {"other_side", seam.other_side},
          {"reversed", seam.reversed}};
}

Json to_json(const Zero& zero) {
  return {{"zero", zero.formula}};
}

Json to_json(const Sign& sign) {
  return {{"sign",
           {{"formula", sign.formula},
            {"relation", spelling(sign.relation)},
            {"factors", list(sign.domain.factors)},
            {"where", list(sign.domain.where)}}}};
}

Json to_json(const Solutions& solutions) {
  return {{"solutions",
           {{"system", list(solutions.system)},
            {"unknown", solutions.unknown},
            {"for_all", list(solutions.for_all)},
            {"domain", to_json(solutions.domain)},
            {"solutions", list(solutions.solutions)}}}};
}

Json to_json(const OnlySolutions::Tuple& tuple) {
  return {{"numerators", list(tuple.numerators)}, {"denominators", list(tuple.denominators)}};
}

Json to_json(const OnlySolutions& only) {
  return {{"only_solutions",
           {{"system", list(only.system)},
            {"unknowns", list(only.unknowns)},
            {"for_all", list(only.for_all)},
            {"factors", list(only.domain.factors)},
            {"where", list(only.domain.where)},
            {"solutions", list(only.solutions)}}}};
}

Json to_json(const OneSolution& one) {
  return {{"one_solution",
           {{"system", list(one.system)},
            {"unknowns", list(one.unknowns)},
            {"for_all", list(one.for_all)},
            {"factors", list(one.domain.factors)},
            {"where", list(one.domain.where)},
            {"low", list(one.low)},
            {"high", list(one.high)}}}};
}

Json to_json(const Gluing& gluing) {
  return {{"gluing",
           {{"patches", list(gluing.patches)},
            {"seams", list(gluing.seams)},
            {"euler", gluing.euler}}}};
}

Json to_json(const Distinct& distinct) {
  return {{"distinct", list(distinct.tuples)}};
}

Json to_json(const Mesh& mesh) {
  return {{"mesh",
           {{"vertices", mesh.vertices},
            {"points", list(mesh.points)},
            {"faces", list(mesh.faces)},
            {"ratios", list(mesh.ratios)},
            {"property", spelling(mesh.property)},
            {"values", list(mesh.values)}}}};
}

Json to_json(const Goal& goal) {
  switch (goal.kind) {
    case Goal::Kind::all:
      return {{"all", list(goal.parts)}};
    case Goal::Kind::any:
      return {{"any", list(goal.parts)}};
    case Goal::Kind::negation:
      return {{"not", to_json(goal.parts.at(0))}};
    case Goal::Kind::suffices:
      return {{"suffices", to_json(goal.parts.at(0))}};
    case Goal::Kind::obligation:
      return goal.obligation;
  }
  throw FormatError("a goal of no kind");
}

Json to_json(const Nothing& nothing) {
  return {{"nothing", {{"reason", nothing.reason}, {"detail", nothing.detail}}}};
}

Json to_json(const Computation&) {
  return "computation";
}

Json to_json(const Step& step) {
  if (step.kind == Step::Kind::plain) return "plain";
  if (step.kind == Step::Kind::outside) return {{"outside", step.index}};
  return {{"split", step.index}, {"at", list(step.weights)}};
}

Json members(const Pieces& pieces) {
  Json value = {{"side", spelling(pieces.side)}};
  if (pieces.square != -1 || pieces.cofactor != -1) {
    value["square"] = pieces.square;
    value["cofactor"] = pieces.cofactor;
  }
  value["steps"] = list(pieces.steps);
  return value;
}

Json to_json(const Pieces& pieces) {
  return {{"pieces", members(pieces)}};
}

// The terms are as many weights, squares and, for a strict sign, cofactors.
Json squares(const Reduction& reduction) {
  const auto n = static_cast<long>(reduction.terms.size() / (reduction.parts.empty() ? 2 : 3));
  const auto begin = reduction.terms.begin();
  const auto share = [&](long k) {
    return list(std::vector(begin + k * n, begin + (k + 1) * n));
  };
  Json value = {{"squares", share(1)}, {"weights", share(0)}};
  if (reduction.parts.empty()) return value;
  value["excluded"] = list(reduction.conditions);
  value["cofactors"] = share(2);
  value["ideal"] = to_json(reduction.parts.front());
  return value;
}

Json to_json(const Reduction& reduction) {
  const auto part = [&reduction](std::size_t i) { return to_json(reduction.parts.at(i)); };
  switch (reduction.kind) {
    case Reduction::Kind::multiplier:
      return {
          {"multiplier", reduction.terms.at(0)}, {"positive", part(0)}, {"product", part(1)}};
    case Reduction::Kind::conjugate:
      return {{"conjugate", reduction.terms.at(0)}, {"sum", part(0)}, {"product", part(1)}};
    case Reduction::Kind::both:
      return {{"both", list(reduction.parts)}};
    case Reduction::Kind::cases:
      return {{"cases", reduction.terms.at(0)}, {"above", part(0)}, {"below", part(1)}};
    case Reduction::Kind::condition:
      return {{"condition", reduction.conditions.at(0)}, {"times", reduction.terms.at(0)}};
    case Reduction::Kind::factors:
      return {{"factors", list(reduction.terms)}, {"parts", list(reduction.parts)}};
    case Reduction::Kind::squares:
      return squares(reduction);
    case Reduction::Kind::combination:
      return {{"combination", list(reduction.conditions)},
              {"cofactors", list(reduction.terms)},
              {"parts", list(reduction.parts)}};
  }
  throw FormatError("a reduction of no kind");
}

Json to_json(const Point& point) {
  return {{"variables", list(point.variables)}, {"values", list(point.values)}};
}

Json to_json(const Witness& witness) {
  return {{"witness", {{"point", to_json(witness.point)}, {"other", list(witness.other)}}}};
}

Json to_json(const Roots& roots) {
  return {{"roots",
           {{"divisor", roots.divisor},
            {"cofactors", list(roots.cofactors)},
            {"quotients", list(roots.quotients)},
            {"multiplicities", list(roots.multiplicities)},
            {"rest", roots.rest},
            {"inside", list(roots.inside)},
            {"outside", list(roots.outside)}}}};
}

Json to_json(const WrongSolution& wrong) {
  return {{"wrong_solution", {{"value", wrong.value}, {"claimed", wrong.claimed}}}};
}

// Trees stand bare: there is nothing else that they could be.
Json trees(const std::vector<Pieces>& entries) {
  Json values = Json::array();
  for (const Pieces& tree : entries) values.push_back(members(tree));
  return values;
}

Json to_json(const Combination& combination) {
  return {{"equations", list(combination.equations)},
          {"cofactors", list(combination.cofactors)}};
}

Json to_json(const EliminationFactor& factor) {
  return {{"formula", factor.formula},
          {"power", factor.power},
          {"condition", factor.condition},
          {"trees", list(factor.trees)}};
}

Json to_json(const EliminationStep& step) {
  switch (step.kind) {
    case EliminationStep::Kind::product:
      return {{"combination", to_json(step.combination)}, {"product", list(step.factors)}};
    case EliminationStep::Kind::cases:
      return {{"cases", step.formula}};
    case EliminationStep::Kind::solution:
      return {{"solution", step.index}, {"equations", list(step.equations)}};
    case EliminationStep::Kind::outside:
      return {{"outside", step.index},
              {"multiplier", step.formula},
              {"combination", to_json(step.combination)},
              {"remainder", step.remainder},
              {"positive", list(step.positive)},
              {"broken", list(step.broken)}};
  }
  throw FormatError("a step of no kind");
}

Json to_json(const Elimination& elimination) {
  return {{"elimination", list(elimination.steps)}};
}

Json to_json(const Box& box) {
  return {{"low", list(box.low)}, {"high", list(box.high)}};
}

Json to_json(const Isolation& isolation) {
  return {{"isolation",
           {{"combination", list(isolation.combination)},
            {"inner", to_json(isolation.inner)},
            {"outer", to_json(isolation.outer)},
            {"faces", trees(isolation.faces)},
            {"conditions", trees(isolation.conditions)},
            {"dominance", trees(isolation.dominance)},
            {"cover", trees(isolation.cover)}}}};
}

template <typename... Kinds>
Json to_json(const std::variant<Kinds...>& value) {
  return std::visit([](const auto& kind) { return to_json(kind); }, value);
}

template <typename T>
Json list(const std::vector<T>& entries) {
  Json values = Json::array();
  for (const T& entry : entries) values.push_back(to_json(entry));
  return values;
}

Json to_json(const Evidence& evidence) {
  return {{"generators", list(evidence.generators)},
          {"nodes", list(evidence.nodes)},
          {"proofs", list(evidence.proofs)}};
}

}  // namespace

Json to_json(const Statement& statement) {
  Json value = {{"generators", list(statement.generators)}};
  if (!statement.functions.empty()) value["functions"] = list(statement.functions);
  value["nodes"] = list(statement.nodes);
  value["obligations"] = list(statement.obligations);
  value["guards"] = list(statement.guards);
  value["goal"] = to_json(statement.goal);
  return value;
}

Json to_json(const Certificate& certificate) {
  return {
      {"format", "seamproof certificate 1"},      {"claim", certificate.claim},
      {"correction", certificate.correction},     {"verdict", spelling(certificate.verdict)},
      {"using", list(certificate.using_claims)},  {"statement", to_json(certificate.statement)},
      {"evidence", to_json(certificate.evidence)}};
}

}  // namespace seam::certificate
