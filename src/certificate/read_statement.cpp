// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <array>
#include <utility>

#include "certificate/read_parts.h"

namespace seam::certificate {

Relation read_relation(const Reader& in) {
  return read_spelling(
      in, std::array{Relation::positive, Relation::nonnegative, Relation::zero,
                     Relation::nonzero, Relation::nonpositive, Relation::negative});
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

namespace {

Elementary read_elementary(const Reader& in) {
  return read_spelling(in, std::array{Elementary::exp, Elementary::log, Elementary::sin,
                                      Elementary::cos, Elementary::pi});
}

}  // namespace

Generator read_generator(const Reader& in) {
  if (in.has("function")) {
    const Elementary function = read_elementary(in["function"]);
    if (function == Elementary::pi) {
      in.members({"name", "function"});
      return {in["name"].text(), 0, {}, {}, function, 0};
    }
    in.members({"name", "function", "argument"});
    return {in["name"].text(), 0, {}, {}, function, in["argument"].integer()};
  }
  in.members({"name", "polynomial", "low", "high"});
  return {in["name"].text(), in["polynomial"].integer(), in["low"].text(), in["high"].text()};
}

namespace {

Function read_function(const Reader& in) {
  if (in.has("function")) {
    in.members({"name", "function", "argument"});
    return {in["name"].text(), in["argument"].integer(), 0, read_elementary(in["function"])};
  }
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

Mesh read_mesh(const Reader& in) {
  in.members({"vertices", "points", "faces", "ratios", "property", "values"});
  const auto read_integers = [](const Reader& list) { return list.integers(); };
  using enum Mesh::Property;
  return {in["vertices"].integer(),
          in["points"].list(read_integers),
          in["faces"].list(read_integers),
          in["ratios"].integers(),
          read_spelling(in["property"],
                        std::array{counts, face_sizes, valences, valence, connected, closed,
                                   manifold, orientable, oriented, planar, convex}),
          in["values"].integers()};
}

Obligation read_obligation(const Reader& in) {
  const std::string kind = in.only_member();
  if (kind == "zero") return Zero{in["zero"].integer()};
  if (kind == "sign") return read_sign(in["sign"]);
  if (kind == "solutions") return read_solutions(in["solutions"]);
  if (kind == "only_solutions") return read_only_solutions(in["only_solutions"]);
  if (kind == "one_solution") return read_one_solution(in["one_solution"]);
  if (kind == "gluing") return read_gluing(in["gluing"]);
  if (kind == "mesh") return read_mesh(in["mesh"]);
  return Distinct{in["distinct"].list([](const Reader& tuple) { return tuple.integers(); })};
}

Goal read_goal(const Reader& in) {
  if (in.is_integer()) return {Goal::Kind::obligation, {}, in.integer()};
  const std::string kind = in.only_member();
  if (kind == "all") return {Goal::Kind::all, in["all"].list(read_goal), -1};
  if (kind == "any") return {Goal::Kind::any, in["any"].list(read_goal), -1};
  if (kind == "suffices") return {Goal::Kind::suffices, {read_goal(in["suffices"])}, -1};
  return {Goal::Kind::negation, {read_goal(in["not"])}, -1};
}

}  // namespace

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

}  // namespace seam::certificate
