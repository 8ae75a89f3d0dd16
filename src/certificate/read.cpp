// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <array>
#include <utility>

#include "certificate/fault.h"
#include "certificate/json.h"
#include "certificate/reader.h"
#include "certificate/to_json.h"

// Brackets are counted before anything is parsed, so that no text can make the parser or
// the functions below recurse deeply. Every object must have exactly the members that
// are read from it; indices are checked at the end, by `fault`.

namespace seam::certificate {
namespace {

constexpr int max_nesting = 2 * max_goal_depth + 40;

void demand_shallow(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > max_nesting) throw FormatError("brackets are nested too deeply");
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

Json parsed(std::string_view text) {
  if (text.size() > max_bytes) throw FormatError("longer than 64 MiB");
  demand_shallow(text);
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    throw FormatError(error.what());
  }
}

template <typename Kind, std::size_t Count>
Kind read_spelling(const Reader& in, const std::array<Kind, Count>& kinds) {
  const std::string text = in.text();
  for (const Kind kind : kinds)
    if (text == spelling(kind)) return kind;
  in.fail("another word than '" + text + "'");
}

Relation read_relation(const Reader& in) {
  return read_spelling(
      in, std::array{Relation::positive, Relation::nonnegative, Relation::zero,
                     Relation::nonzero, Relation::nonpositive, Relation::negative});
}

Verdict read_verdict(const Reader& in) {
  return read_spelling(in, std::array{Verdict::proven, Verdict::refuted, Verdict::conditional,
                                      Verdict::undecided});
}

Node read_node(const Reader& in) {
  if (in.is_text()) return {Node::Kind::constant, in.text(), {}, 0};
  const std::string kind = in.only_member();
  if (kind == "symbol") return {Node::Kind::symbol, in["symbol"].text(), {}, 0};
  if (kind == "sum") return {Node::Kind::sum, {}, in["sum"].integers(), 0};
  if (kind == "product") return {Node::Kind::product, {}, in["product"].integers(), 0};
  const std::vector<int> power = in["power"].integers();
  if (power.size() != 2) in.fail("a base and an exponent");
  return {Node::Kind::power, {}, {power[0]}, power[1]};
}

Generator read_generator(const Reader& in) {
  in.members({"name", "polynomial", "low", "high"});
  return {in["name"].text(), in["polynomial"].integer(), in["low"].text(), in["high"].text()};
}

Function read_function(const Reader& in) {
  in.members({"name", "radicand", "degree"});
  return {in["name"].text(), in["radicand"].integer(), in["degree"].integer()};
}

Simplex read_simplex(const Reader& in) {
  in.members({"variables", "corners", "open"});
  return {in["variables"].texts(),
          in["corners"].list([](const Reader& corner) { return corner.integers(); }),
          in["open"].list([](const Reader& facet) { return facet.truth(); })};
}

Constraint read_constraint(const Reader& in) {
  in.members({"formula", "relation"});
  return {in["formula"].integer(), read_relation(in["relation"])};
}

Sign read_sign(const Reader& in) {
  in.members({"formula", "relation", "factors", "where"});
  return {in["formula"].integer(),
          read_relation(in["relation"]),
          {in["factors"].list(read_simplex), in["where"].list(read_constraint)}};
}

Solution read_solution(const Reader& in) {
  if (in.is_integer()) return {in.integer(), {}, {}};
  in.members({"low", "high"});
  return {-1, in["low"].text(), in["high"].text()};
}

Solutions read_solutions(const Reader& in) {
  in.members({"system", "unknown", "for_all", "domain", "solutions"});
  return {in["system"].integers(), in["unknown"].text(), in["for_all"].texts(),
          read_simplex(in["domain"]), in["solutions"].list(read_solution)};
}

OnlySolutions read_only_solutions(const Reader& in) {
  in.members({"system", "unknowns", "for_all", "factors", "where", "solutions"});
  const auto read_tuple = [](const Reader& tuple) {
    tuple.members({"numerators", "denominators"});
    return OnlySolutions::Tuple{tuple["numerators"].integers(),
                                tuple["denominators"].integers()};
  };
  return {in["system"].integers(),
          in["unknowns"].texts(),
          in["for_all"].texts(),
          {in["factors"].list(read_simplex), in["where"].list(read_constraint)},
          in["solutions"].list(read_tuple)};
}

OneSolution read_one_solution(const Reader& in) {
  in.members({"system", "unknowns", "for_all", "factors", "where", "low", "high"});
  return {in["system"].integers(),
          in["unknowns"].texts(),
          in["for_all"].texts(),
          {in["factors"].list(read_simplex), in["where"].list(read_constraint)},
          in["low"].texts(),
          in["high"].texts()};
}

Gluing::Side read_side(const Reader& in) {
  const std::vector<int> ends = in.integers();
  if (ends.size() != 2) in.fail("two corners");
  return {ends[0], ends[1]};
}

Gluing::Seam read_seam(const Reader& in) {
  in.members({"patch", "side", "other_patch", "other_side", "reversed"});
  return {in["patch"].integer(), in["side"].integer(), in["other_patch"].integer(),
          in["other_side"].integer(), in["reversed"].truth()};
}

Gluing read_gluing(const Reader& in) {
  in.members({"patches", "seams", "euler"});
  return {in["patches"].list([](const Reader& sides) { return sides.list(read_side); }),
          in["seams"].list(read_seam), in["euler"].integer()};
}

Obligation read_obligation(const Reader& in) {
  const std::string kind = in.only_member();
  if (kind == "zero") return Zero{in["zero"].integer()};
  if (kind == "sign") return read_sign(in["sign"]);
  if (kind == "solutions") return read_solutions(in["solutions"]);
  if (kind == "only_solutions") return read_only_solutions(in["only_solutions"]);
  if (kind == "one_solution") return read_one_solution(in["one_solution"]);
  if (kind == "gluing") return read_gluing(in["gluing"]);
  return Distinct{in["distinct"].list([](const Reader& tuple) { return tuple.integers(); })};
}

Goal read_goal(const Reader& in) {
  if (in.is_integer()) return {Goal::Kind::obligation, {}, in.integer()};
  const std::string kind = in.only_member();
  if (kind == "all") return {Goal::Kind::all, in["all"].list(read_goal), -1};
  if (kind == "any") return {Goal::Kind::any, in["any"].list(read_goal), -1};
  return {Goal::Kind::negation, {read_goal(in["not"])}, -1};
}

Statement read_statement(const Reader& in) {
  std::vector<Function> functions;
  if (in.has("functions")) {
    in.members({"generators", "functions", "nodes", "obligations", "guards", "goal"});
    functions = in["functions"].list(read_function);
  } else {
    in.members({"generators", "nodes", "obligations", "guards", "goal"});
  }
  return {in["generators"].list(read_generator),
          std::move(functions),
          in["nodes"].list(read_node),
          in["obligations"].list(read_obligation),
          in["guards"].integers(),
          read_goal(in["goal"])};
}

Step read_step(const Reader& in) {
  if (in.is_text()) {
    if (in.text() != "plain") in.fail("a step");
    return {};
  }
  if (in.has("outside")) {
    in.members({"outside"});
    return {Step::Kind::outside, in["outside"].integer(), {}};
  }
  in.members({"split", "at"});
  return {Step::Kind::split, in["split"].integer(), in["at"].integers()};
}

Pieces read_pieces(const Reader& in) {
  Pieces pieces;
  if (in.has("square")) {
    in.members({"side", "square", "cofactor", "steps"});
    pieces.square = in["square"].integer();
    pieces.cofactor = in["cofactor"].integer();
  } else {
    in.members({"side", "steps"});
  }
  pieces.side = read_relation(in["side"]);
  pieces.steps = in["steps"].list(read_step);
  return pieces;
}

Pieces read_tree(const Reader& in) {
  in.members({"pieces"});
  return read_pieces(in["pieces"]);
}

Point read_point(const Reader& in) {
  in.members({"variables", "values"});
  return {in["variables"].texts(), in["values"].integers()};
}

Roots read_roots(const Reader& in) {
  in.members(
      {"divisor", "cofactors", "quotients", "multiplicities", "rest", "inside", "outside"});
  return {in["divisor"].integer(),      in["cofactors"].integers(),
          in["quotients"].integers(),   in["multiplicities"].integers(),
          in["rest"].integer(),         in["inside"].list(read_tree),
          in["outside"].list(read_tree)};
}

Nothing read_nothing(const Reader& in) {
  in.members({"reason", "detail"});
  return {in["reason"].text(), in["detail"].text()};
}

Witness read_witness(const Reader& in) {
  in.members({"point", "other"});
  return {read_point(in["point"]), in["other"].list(read_point)};
}

WrongSolution read_wrong_solution(const Reader& in) {
  in.members({"value", "claimed"});
  return {in["value"].integer(), in["claimed"].integer()};
}

SignProof read_sign_proof(const Reader& in);

// Recursion is bounded: brackets are counted.
Reduction read_reduction(const Reader& in) {
  using enum Reduction::Kind;
  const auto of_two_parts = [&in](Reduction::Kind kind, const char* name, const char* first,
                                  const char* second) -> Reduction {
    in.members({name, first, second});
    return {kind,
            {in[name].integer()},
            {},
            {read_sign_proof(in[first]), read_sign_proof(in[second])}};
  };
  if (in.has("multiplier"))
    return of_two_parts(multiplier, "multiplier", "positive", "product");
  if (in.has("conjugate")) return of_two_parts(conjugate, "conjugate", "sum", "product");
  if (in.has("cases")) return of_two_parts(cases, "cases", "above", "below");
  in.members({"combination", "cofactors", "parts"});
  return {combination, in["cofactors"].integers(), in["combination"].integers(),
          in["parts"].list(read_sign_proof)};
}

bool is_reduction(const Reader& in) {
  return in.has("multiplier") || in.has("conjugate") || in.has("cases") ||
         in.has("combination");
}

Computation read_computation(const Reader& in) {
  if (in.text() != "computation") in.fail("a proof");
  return {};
}

SignProof read_sign_proof(const Reader& in) {
  if (in.is_text()) return read_computation(in);
  if (is_reduction(in)) return read_reduction(in);
  return read_tree(in);
}

Combination read_combination(const Reader& in) {
  in.members({"equations", "cofactors"});
  return {in["equations"].integers(), in["cofactors"].integers()};
}

EliminationFactor read_elimination_factor(const Reader& in) {
  in.members({"formula", "power", "condition", "trees"});
  return {in["formula"].integer(), in["power"].integer(), in["condition"].integer(),
          in["trees"].list(read_sign_proof)};
}

EliminationStep read_elimination_step(const Reader& in) {
  EliminationStep step;
  if (in.has("product")) {
    in.members({"combination", "product"});
    step.combination = read_combination(in["combination"]);
    step.factors = in["product"].list(read_elimination_factor);
  } else if (in.has("cases")) {
    in.members({"cases"});
    step.kind = EliminationStep::Kind::cases;
    step.formula = in["cases"].integer();
  } else if (in.has("solution")) {
    in.members({"solution", "equations"});
    step.kind = EliminationStep::Kind::solution;
    step.index = in["solution"].integer();
    step.equations = in["equations"].integers();
  } else {
    in.members({"outside", "multiplier", "combination", "remainder", "positive", "broken"});
    step.kind = EliminationStep::Kind::outside;
    step.index = in["outside"].integer();
    step.formula = in["multiplier"].integer();
    step.combination = read_combination(in["combination"]);
    step.remainder = in["remainder"].integer();
    step.positive = in["positive"].list(read_sign_proof);
    step.broken = in["broken"].list(read_sign_proof);
  }
  return step;
}

Box read_box(const Reader& in) {
  in.members({"low", "high"});
  return {in["low"].texts(), in["high"].texts()};
}

Isolation read_isolation(const Reader& in) {
  in.members({"combination", "inner", "outer", "faces", "conditions", "dominance", "cover"});
  return {in["combination"].list([](const Reader& row) { return row.texts(); }),
          read_box(in["inner"]),
          read_box(in["outer"]),
          in["faces"].list(read_pieces),
          in["conditions"].list(read_pieces),
          in["dominance"].list(read_pieces),
          in["cover"].list(read_pieces)};
}

Proof read_proof(const Reader& in) {
  if (in.is_text()) return read_computation(in);
  if (is_reduction(in)) return read_reduction(in);
  const std::string kind = in.only_member();
  if (kind == "nothing") return read_nothing(in["nothing"]);
  if (kind == "pieces") return read_pieces(in["pieces"]);
  if (kind == "witness") return read_witness(in["witness"]);
  if (kind == "roots") return read_roots(in["roots"]);
  if (kind == "elimination") return Elimination{in["elimination"].list(read_elimination_step)};
  if (kind == "isolation") return read_isolation(in["isolation"]);
  return read_wrong_solution(in["wrong_solution"]);
}

Evidence read_evidence(const Reader& in) {
  in.members({"generators", "nodes", "proofs"});
  return {in["generators"].list(read_generator), in["nodes"].list(read_node),
          in["proofs"].list(read_proof)};
}

}  // namespace

Certificate read(std::string_view text) {
  const Json document = parsed(text);
  const Reader in(document);
  in.members({"format", "claim", "correction", "verdict", "using", "statement", "evidence"});
  if (in["format"].text() != "seamproof certificate 1")
    in["format"].fail("'seamproof certificate 1'");
  Certificate certificate{
      in["claim"].text(),  in["correction"].truth(),        read_verdict(in["verdict"]),
      in["using"].texts(), read_statement(in["statement"]), read_evidence(in["evidence"])};
  const std::string found = fault(certificate.statement, certificate.evidence);
  if (!found.empty()) throw FormatError(found);
  return certificate;
}

}  // namespace seam::certificate
