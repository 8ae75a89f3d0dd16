// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/any_mesh.h"

#include <algorithm>

#include "claims/parameters.h"

// Of any closed mesh the numbers of vertices, edges and faces are symbols; what truncation
// makes of them is said, with the reason, in geometry/truncation.cpp. What holds for all real
// values of the symbols holds for all meshes. The other way round it need not, for not all
// numbers are those of a mesh; so a statement is besides made of a few meshes, and only these
// can refute it.

namespace seam::claims {
namespace {

using symbolic::Constraint;
using symbolic::Proposition;

struct Known {
  const char* name;
  long vertices, edges, faces;
  bool trivalent;
};
constexpr Known known_meshes[] = {
    {"a tetrahedron", 4, 6, 4, true},     {"a cube", 8, 12, 6, true},
    {"a dodecahedron", 20, 30, 12, true}, {"an octahedron", 6, 12, 8, false},
    {"a square pyramid", 5, 8, 5, false}, {"a torus of nine squares", 9, 18, 9, false}};

using Values = std::map<std::string, Formula>;

bool is_free_of(const symbolic::Simplex& factor, const Values& values) {
  return std::ranges::none_of(factor.variables,
                              [&](const std::string& v) { return values.contains(v); });
}

// The statement with numbers for symbols; nothing where its conditions are not met.
std::optional<Proposition> put_in(Proposition p, const Values& values,
                                  const Evaluator& evaluator) {
  if (auto* zero = std::get_if<symbolic::Zero>(&p.atom))
    zero->formula = symbolic::subst(zero->formula, values);
  auto* sign = std::get_if<symbolic::Sign>(&p.atom);
  if (!sign) return p;
  sign->formula = symbolic::subst(sign->formula, values);
  std::erase_if(sign->domain.factors,
                [&](const symbolic::Simplex& factor) { return !is_free_of(factor, values); });
  std::vector<Constraint> where;
  for (const Constraint& c : sign->domain.where) {
    const Formula formula = symbolic::subst(c.formula, values);
    if (!symbolic::is_number(formula))
      where.push_back({formula, c.relation});
    else if (!meets(evaluator.numbers.sign(formula), c.relation))
      return std::nullopt;
  }
  sign->domain.where = std::move(where);
  return p;
}

void collect_atoms(const Proposition& p, std::vector<Proposition>& atoms) {
  if (p.kind == Proposition::Kind::suffices) return;
  if (p.kind == Proposition::Kind::atom) atoms.push_back(p);
  if (p.kind == Proposition::Kind::any || p.kind == Proposition::Kind::negation)
    throw Unsupported("a statement about any mesh that is not a conjunction of comparisons");
  for (const Proposition& part : p.parts) collect_atoms(part, atoms);
}

bool holds_any(const Proposition& p, const std::set<std::string>& symbols) {
  const auto held = variables_of(p);
  return std::ranges::any_of(symbols, [&](const auto& s) { return held.contains(s); }) ||
         std::ranges::any_of(p.parts,
                             [&](const auto& part) { return holds_any(part, symbols); });
}

}  // namespace

AnyMesh any_mesh(Evaluator& evaluator, const std::string& name) {
  const auto symbol = [&](const char* what, long least) {
    const std::string s = evaluator.bind(std::string(what) + "_" + name);
    evaluator.parameters.push_back({s, symbolic::whole_line_right(s, least, false), {}});
    return Scalar(Formula::symbol(s));
  };
  evaluator.any_meshes.push_back(name);
  return {symbol("V", 3), symbol("E", 3), symbol("F", 2)};
}

AnyMesh truncated(const AnyMesh& mesh) {
  AnyMesh result = mesh;
  result.vertices = Scalar(2) * mesh.edges;
  result.edges = Scalar(3) * mesh.edges;
  result.faces = mesh.vertices + mesh.faces;
  result.planar = mesh.planar && mesh.trivalent;
  result.trivalent = true;
  return result;
}

void suppose(Evaluator& evaluator, const Item& param) {
  const auto take = [&](auto&& self, const Expression& e) -> void {
    if (e.kind == Expression::Kind::conjunction) {
      for (const Expression& part : e.children) self(self, part);
      return;
    }
    const bool is_call = e.kind == Expression::Kind::call && e.children.size() == 2;
    const std::string what = is_call ? e.children[0].text : "";
    if (what != "planar" && what != "trivalent")
      fail(e, "a mesh is supposed planar(M), trivalent(M), or both");
    const std::string& name = e.children[1].text;
    if (std::ranges::find(param.names, name) == param.names.end())
      fail(e.children[1], "expected a mesh of this item");
    Definition& definition = evaluator.globals.at(name);
    if (!definition.value) throw Broken();
    auto& mesh = std::get<AnyMesh>(definition.value->content);
    (what == "planar" ? mesh.planar : mesh.trivalent) = true;
    if (what == "planar") return;
    const Constraint ends{
        Formula(3) * mesh.vertices.numerator - Formula(2) * mesh.edges.numerator,
        Relation::zero};
    for (Parameter& parameter : evaluator.parameters)
      if (parameter.name == mesh.vertices.numerator.name() ||
          parameter.name == mesh.edges.numerator.name())
        parameter.where = {ends};
  };
  take(take, *param.where);
}

Proposition of_meshes(const Evaluator& evaluator, Proposition p) {
  std::set<std::string> symbols;
  bool trivalent = false;
  for (const std::string& name : evaluator.any_meshes) {
    const auto& value = evaluator.globals.at(name).value;
    if (!value) continue;
    const auto* mesh = value->as<AnyMesh>();
    std::set<std::string> own;
    for (const Scalar* number : {&mesh->vertices, &mesh->edges, &mesh->faces})
      own.insert(number->numerator.name());
    if (!holds_any(p, own)) continue;
    symbols.merge(own);
    trivalent = trivalent || mesh->trivalent;
  }
  if (symbols.empty()) return p;
  std::vector<Proposition> atoms, parts;
  collect_atoms(p, atoms);
  for (const Proposition& atom : atoms)
    if (!holds_any(atom, symbols)) parts.push_back(atom);
  for (const Known& known : known_meshes) {
    if (trivalent && !known.trivalent) continue;
    Values values;
    for (const std::string& s : symbols)
      values.emplace(s, s[0] == 'V' ? known.vertices : s[0] == 'E' ? known.edges : known.faces);
    for (const Proposition& atom : atoms) {
      if (!holds_any(atom, symbols)) continue;
      auto instance = put_in(atom, values, evaluator);
      if (!instance) continue;
      instance->about = std::string("for ") + known.name;
      parts.push_back(std::move(*instance));
    }
  }
  parts.insert(parts.begin(), symbolic::suffices(std::move(p), "for any mesh"));
  return symbolic::all(std::move(parts));
}

}  // namespace seam::claims
