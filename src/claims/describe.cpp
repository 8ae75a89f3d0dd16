// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/describe.h"

#include "claims/mesh_words.h"

namespace seam::claims {
namespace {

using symbolic::Formula;

std::string relation_text(certificate::Relation relation) {
  static const char* const signs[] = {" > 0", " >= 0", " = 0", " != 0", " <= 0", " < 0"};
  return signs[static_cast<int>(relation)];
}

std::string short_text(const Formula& f) {
  return symbolic::text(f, 200);
}

std::string joined(const std::vector<std::string>& unknowns) {
  std::string names;
  for (const std::string& unknown : unknowns) names += (names.empty() ? "" : ", ") + unknown;
  return names;
}

}  // namespace

std::string describe(const symbolic::Zero& z) {
  return short_text(z.formula) + " = 0";
}

std::string describe(const symbolic::Sign& s) {
  return short_text(s.formula) + relation_text(s.relation);
}

std::string describe(const symbolic::Solutions& s) {
  return std::to_string(s.exact.size() + s.near.size()) + " solutions in " + s.unknown;
}

std::string describe(const symbolic::OnlySolutions& s) {
  return std::to_string(s.solutions.size()) + " solutions in " + joined(s.unknowns);
}

std::string describe(const symbolic::OneSolution& s) {
  return "one solution in " + joined(s.unknowns);
}

std::string describe(const certificate::Gluing& g) {
  return std::to_string(g.patches.size()) + " patches, " + std::to_string(g.seams.size()) +
         " seams, closed and connected, Euler characteristic " + std::to_string(g.euler);
}

std::string describe(const symbolic::Distinct& d) {
  return std::to_string(d.tuples.size()) + " different items";
}

std::string describe(const symbolic::Mesh& m) {
  return describe_mesh(m);
}

}  // namespace seam::claims
