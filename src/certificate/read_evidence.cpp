// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <utility>

#include "certificate/read_parts.h"

namespace seam::certificate {
namespace {

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

Reduction read_squares(const Reader& in) {
  const bool is_strict = in.has("ideal");
  if (is_strict)
    in.members({"squares", "weights", "excluded", "cofactors", "ideal"});
  else
    in.members({"squares", "weights"});
  Reduction result{Reduction::Kind::squares, in["weights"].integers(), {}, {}};
  const auto append = [&](const std::vector<int>& terms) {
    if (terms.size() != in["weights"].integers().size()) in.fail("as many terms as weights");
    result.terms.insert(result.terms.end(), terms.begin(), terms.end());
  };
  append(in["squares"].integers());
  if (!is_strict) return result;
  append(in["cofactors"].integers());
  result.conditions = in["excluded"].integers();
  result.parts.push_back(read_sign_proof(in["ideal"]));
  return result;
}

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
  if (in.has("both")) {
    in.members({"both"});
    return {both, {}, {}, in["both"].list(read_sign_proof)};
  }
  if (in.has("condition")) {
    in.members({"condition", "times"});
    return {condition, {in["times"].integer()}, {in["condition"].integer()}, {}};
  }
  if (in.has("factors")) {
    in.members({"factors", "parts"});
    return {factors, in["factors"].integers(), {}, in["parts"].list(read_sign_proof)};
  }
  if (in.has("squares")) return read_squares(in);
  in.members({"combination", "cofactors", "parts"});
  return {combination, in["cofactors"].integers(), in["combination"].integers(),
          in["parts"].list(read_sign_proof)};
}

bool is_reduction(const Reader& in) {
  return in.has("multiplier") || in.has("conjugate") || in.has("cases") || in.has("both") ||
         in.has("condition") || in.has("factors") || in.has("squares") || in.has("combination");
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

}  // namespace

Evidence read_evidence(const Reader& in) {
  in.members({"generators", "nodes", "proofs"});
  return {in["generators"].list(read_generator), in["nodes"].list(read_node),
          in["proofs"].list(read_proof)};
}

}  // namespace seam::certificate
