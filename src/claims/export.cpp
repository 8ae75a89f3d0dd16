// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/export.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "claims/angles.h"
#include "claims/conjunction.h"
#include "claims/describe.h"
#include "claims/evaluate.h"
#include "claims/measure.h"
#include "exact/contract.h"
#include "symbolic/atoms.h"

namespace seam::claims {
namespace {

using certificate::Goal;
using certificate::Node;
using certificate::Term;
using symbolic::Fact;
using symbolic::Point;
using symbolic::Proposition;

class Exporter {
 public:
  explicit Exporter(const Numbers& numbers) : numbers_(numbers) {}

  Exported run(const Stated& stated) {
    gather(stated.goal);
    for (const Proposition& guard : stated.guards) gather(guard);
    field_ = &numbers_.field(names_);
    result_.statement.goal = goal(stated.goal);
    for (const Proposition& guard : stated.guards) add_guard(guard);
    // Facts may bring formulas with facts of their own.
    for (std::size_t i = 0; i < facts_.size(); ++i) add_fact(facts_[i]);
    add_generators();
    add_scales();
    return std::move(result_);
  }

 private:
  Term node(Node::Kind kind, std::string text, std::vector<Term> operands, int exponent) {
    const auto key = std::make_tuple(kind, text, operands, exponent);
    const auto [place, fresh] =
        interned_.emplace(key, static_cast<Term>(result_.statement.nodes.size()));
    if (fresh)
      result_.statement.nodes.push_back({kind, std::move(text), std::move(operands), exponent});
    return place->second;
  }

  Term term(const Formula& f) {
    if (const auto found = terms_.find(f.identity()); found != terms_.end())
      return found->second;
    kept_.push_back(f);  // so that no other node can take its address
    if (f.kind() == Formula::Kind::applied)
      return terms_.emplace(f.identity(), applied(f)).first->second;
    Term result = 0;
    std::vector<Term> operands;
    if (f.kind() != Formula::Kind::known)
      for (const Formula& operand : f.operands()) operands.push_back(term(operand));
    switch (f.kind()) {
      case Formula::Kind::constant:
        result = node(Node::Kind::constant, f.value().get_str(), {}, 0);
        break;
      case Formula::Kind::symbol:
        if (const auto other = field_->dependent.find(f.name());
            other != field_->dependent.end()) {
          result = term(other->second);
          break;
        }
        if (symbolic::is_generator(f.name())) used_.insert(f.name());
        result = node(Node::Kind::symbol, f.name(), {}, 0);
        break;
      case Formula::Kind::sum:
        result = node(Node::Kind::sum, {}, std::move(operands), 0);
        break;
      case Formula::Kind::product:
        result = node(Node::Kind::product, {}, std::move(operands), 0);
        break;
      case Formula::Kind::power:
        result = node(Node::Kind::power, {}, std::move(operands), f.exponent());
        break;
      case Formula::Kind::root:
        result = function(f, operands[0]);
        break;
      case Formula::Kind::applied:
      case Formula::Kind::inverse:
        throw exact::ContractError("exported: a quotient that was not cleared");
      case Formula::Kind::known:
        result = term(f.operands()[0]);
        facts_.insert(facts_.end(), f.facts().begin(), f.facts().end());
        break;
    }
    terms_.emplace(f.identity(), result);
    return result;
  }

  // The symbol of a root of a function; roots under it have theirs already.
  Term function(const Formula& f, Term radicand) {
    const std::size_t before = atoms_.entries().size();
    atoms_.add(f);
    const std::string& name = atoms_[f].name;
    if (atoms_.entries().size() > before)
      result_.statement.functions.push_back({name, radicand, f.exponent()});
    return node(Node::Kind::symbol, name, {}, 0);
  }

  // A sine stands behind the cosine of the same operand.
  Term applied(const Formula& f) {
    if (!symbolic::is_elementary(f.name()))
      throw Unsupported("an arbitrary function in a statement of this kind: '" + f.name() +
                        "'");
    const Formula fine = angles_.in_finest(f);
    if (!fine.same(f)) return term(fine);
    const Formula& operand = f.operands()[0];
    if (f.name() == "sin") applied(Formula::applied("cos", {operand}));
    const Term inside = term(operand);
    const std::size_t before = atoms_.entries().size();
    atoms_.add(f);
    const std::string& name = atoms_[f].name;
    if (atoms_.entries().size() > before)
      result_.statement.functions.push_back({name, inside, 0, kind_of(f.name())});
    return node(Node::Kind::symbol, name, {}, 0);
  }

  std::vector<Term> terms(const Point& point) {
    std::vector<Term> all;
    for (const Formula& f : point) all.push_back(term(f));
    return all;
  }

  certificate::Simplex simplex(const symbolic::Simplex& s) {
    certificate::Simplex result{s.variables, {}, s.open};
    for (const Point& corner : s.corners) result.corners.push_back(terms(corner));
    return result;
  }

  certificate::Domain domain(const symbolic::Domain& d) {
    certificate::Domain result;
    for (const auto& factor : d.factors) result.factors.push_back(simplex(factor));
    for (const auto& constraint : d.where)
      result.where.push_back({term(constraint.formula), constraint.relation});
    return result;
  }

  certificate::Obligation obligation(const symbolic::Zero& z) {
    return certificate::Zero{term(z.formula)};
  }
  certificate::Obligation obligation(const symbolic::Sign& s) {
    const Term formula = term(s.formula);
    return certificate::Sign{formula, s.relation, domain(s.domain)};
  }
  certificate::Obligation obligation(const symbolic::Solutions& s) {
    certificate::Solutions result;
    result.system = terms(s.system);
    result.unknown = s.unknown;
    result.for_all = s.for_all;
    result.domain = simplex(s.domain);
    for (const Formula& value : s.exact) result.solutions.push_back({term(value), {}, {}});
    for (const auto& [low, high] : s.near)
      result.solutions.push_back({-1, low.get_str(), high.get_str()});
    return result;
  }
  certificate::Obligation obligation(const symbolic::OnlySolutions& s) {
    certificate::OnlySolutions result;
    result.system = terms(s.system);
    result.unknowns = s.unknowns;
    result.for_all = s.for_all;
    result.domain = domain(s.domain);
    for (const auto& solution : s.solutions) {
      auto& [numerators, denominators] = result.solutions.emplace_back();
      for (const auto& [numerator, denominator] : solution) {
        numerators.push_back(term(numerator));
        denominators.push_back(term(denominator));
      }
    }
    return result;
  }
  certificate::Obligation obligation(const symbolic::OneSolution& s) {
    certificate::OneSolution result{terms(s.system),  s.unknowns, s.for_all,
                                    domain(s.domain), {},         {}};
    for (const auto& [low, high] : s.near) {
      result.low.push_back(low.get_str());
      result.high.push_back(high.get_str());
    }
    return result;
  }
  certificate::Obligation obligation(const certificate::Gluing& g) { return g; }
  certificate::Obligation obligation(const symbolic::Distinct& d) {
    certificate::Distinct result;
    for (const Point& tuple : d.tuples) result.tuples.push_back(terms(tuple));
    return result;
  }

  certificate::Obligation obligation(const symbolic::Mesh& m) {
    certificate::Mesh result{m.vertices, {}, m.faces, terms(m.ratios), m.property, m.values};
    for (const Point& point : m.points) result.points.push_back(terms(point));
    return result;
  }

  int add(certificate::Obligation o, const std::string& about, std::string text) {
    auto& all = result_.statement.obligations;
    const std::size_t bucket = o.index() * 1'000'003 + std::hash<std::string>()(text);
    for (const int known : buckets_[bucket])
      if (all[known] == o) return known;
    buckets_[bucket].push_back(static_cast<int>(all.size()));
    all.push_back(std::move(o));
    result_.about.push_back(about);
    result_.text.push_back(std::move(text));
    return static_cast<int>(all.size()) - 1;
  }

  Goal goal(const Proposition& p, const std::string& around = {}) {
    const std::string& about = p.about.empty() ? around : p.about;
    Goal result;
    switch (p.kind) {
      case Proposition::Kind::atom:
        result.kind = Goal::Kind::obligation;
        result.obligation = std::visit(
            [&](const auto& a) { return add(obligation(a), about, describe(a)); }, p.atom);
        measures_.resize(result_.statement.obligations.size(), measure_of(p.atom));
        return result;
      case Proposition::Kind::all:
        result.kind = Goal::Kind::all;
        break;
      case Proposition::Kind::any:
        result.kind = Goal::Kind::any;
        break;
      case Proposition::Kind::negation:
        result.kind = Goal::Kind::negation;
        break;
      case Proposition::Kind::suffices:
        result.kind = Goal::Kind::suffices;
        break;
    }
    const bool joins = result.kind == Goal::Kind::all || result.kind == Goal::Kind::any;
    for (const Proposition& part : p.parts) {
      Goal next = goal(part, about);
      // "All of" within "all of" says no more than one long "all of".
      if (next.kind == result.kind && joins)
        result.parts.insert(result.parts.end(), next.parts.begin(), next.parts.end());
      else
        result.parts.push_back(std::move(next));
    }
    if (result.parts.size() == 1 && joins) {
      Goal only = std::move(result.parts.front());
      return only;
    }
    return result;
  }

  // Last, for scales are no part of the statement. Without one the formula itself is measured.
  void add_scales() {
    const std::size_t own = result_.statement.nodes.size();
    for (const auto& [scale, unit] : measures_) {
      auto& measure = result_.measures.emplace_back();
      if (unit.empty() || !speaks_of(result_.statement, scale)) continue;
      measure = {scale.is(1) ? -1 : term(scale), unit};
    }
    auto& nodes = result_.statement.nodes;
    result_.further.assign(nodes.begin() + static_cast<long>(own), nodes.end());
    nodes.resize(own);
  }

  void guard_all(const Goal& g) {
    if (g.kind == Goal::Kind::obligation) {
      auto& guards = result_.statement.guards;
      if (std::ranges::find(guards, g.obligation) == guards.end())
        guards.push_back(g.obligation);
      return;
    }
    for (const Goal& part : g.parts) guard_all(part);
  }

  // A guard inside the goal could refute it; so guards are conjunctions, nothing else.
  void add_guard(const Proposition& guard) {
    exact::require(is_conjunction(guard), "exported: a guard that is no conjunction");
    guard_all(goal(guard));
  }

  void add_fact(Fact fact) {
    if (fact.relation == Fact::Relation::zero)
      return add_guard(symbolic::atom(symbolic::Zero{fact.formula}, "what a number is"));
    const auto relation = fact.relation == Fact::Relation::nonzero
                              ? certificate::Relation::nonzero
                              : certificate::Relation::nonnegative;
    add_guard(symbolic::atom(symbolic::Sign{fact.formula, relation, {}}, "what a number is"));
  }

  // The generators that formulas and their facts hold, so that the field of them all is known
  // before the first term is written.
  void gather(const Formula& f) {
    if (!gathered_.insert(f.identity()).second) return;
    if (f.kind() == Formula::Kind::symbol) names_.insert(f.name());
    angles_.add(f);
    for (const Formula& operand : f.operands()) gather(operand);
    for (const Fact& fact : f.facts()) gather(fact.formula);
  }
  void gather(const symbolic::Domain& domain) {
    for (const auto& factor : domain.factors) gather(factor);
    for (const auto& constraint : domain.where) gather(constraint.formula);
  }
  void gather(const symbolic::Simplex& simplex) {
    for (const Point& corner : simplex.corners) gather(corner);
  }
  void gather(const Point& point) {
    for (const Formula& f : point) gather(f);
  }
  void gather(const symbolic::Zero& z) { gather(z.formula); }
  void gather(const symbolic::Sign& s) {
    gather(s.formula);
    gather(s.domain);
  }
  void gather(const symbolic::Solutions& s) {
    gather(s.system);
    gather(s.domain);
    gather(s.exact);
  }
  void gather(const symbolic::OnlySolutions& s) {
    gather(s.system);
    gather(s.domain);
    for (const auto& solution : s.solutions)
      for (const auto& [numerator, denominator] : solution) {
        gather(numerator);
        gather(denominator);
      }
  }
  void gather(const symbolic::OneSolution& s) {
    gather(s.system);
    gather(s.domain);
  }
  void gather(const certificate::Gluing&) {}
  void gather(const symbolic::Distinct& d) {
    for (const Point& tuple : d.tuples) gather(tuple);
  }
  void gather(const symbolic::Mesh& m) {
    for (const Point& point : m.points) gather(point);
    gather(m.ratios);
  }
  void gather(const Proposition& p) {
    for (const Proposition& part : p.parts) gather(part);
    if (p.kind == Proposition::Kind::atom)
      std::visit([this](const auto& atom) { gather(atom); }, p.atom);
  }

  void add_generators() {
    const auto& [roots, others] = std::tie(field_->generators, field_->transcendental);
    for (auto number = others.rbegin(); number != others.rend(); ++number) {
      if (!used_.contains(number->name)) continue;
      used_.merge(symbolic::symbols(number->argument));
      if (number->function == "sin") used_.insert("cos" + number->name.substr(3));
    }
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      if (used_.contains(root->name)) used_.merge(symbolic::symbols(root->polynomial));
    for (const auto* numbers : {&roots, &others})
      for (const auto& number : *numbers)
        if (used_.contains(number.name)) add_generator(number);
  }

  void add_generator(const Numbers::Generator& number) {
    const auto function = kind_of(number.function);
    auto& all = result_.statement.generators;
    if (function == certificate::Elementary::none)
      all.push_back(
          {number.name, term(number.polynomial), number.low.get_str(), number.high.get_str()});
    else
      all.push_back({number.name,
                     0,
                     {},
                     {},
                     function,
                     number.function == "pi" ? 0 : term(number.argument)});
  }

  const Numbers& numbers_;
  const Numbers::Field* field_ = nullptr;
  std::set<const void*> gathered_;
  std::set<std::string> names_;
  Exported result_;
  std::map<std::tuple<Node::Kind, std::string, std::vector<Term>, int>, Term> interned_;
  std::unordered_map<const void*, Term> terms_;
  std::vector<Formula> kept_;
  std::vector<Fact> facts_;
  symbolic::Atoms atoms_;
  Angles angles_;
  std::vector<symbolic::Measure> measures_;
  std::set<std::string> used_;
  std::map<std::size_t, std::vector<int>> buckets_;
};

}  // namespace

Exported exported(const Stated& stated, const Numbers& numbers) {
  return Exporter(numbers).run(stated);
}

}  // namespace seam::claims
