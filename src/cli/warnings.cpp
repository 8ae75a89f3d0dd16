// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/warnings.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cli/files.h"
#include "prove/slack.h"

// A name is used where it stands at all, whatever binds it there; so what is said not to be
// used is not.

namespace seam::cli {
namespace {

using claims::Expression;
using Kind = Expression::Kind;
using Names = std::set<std::string>;

void collect(const Expression& e, Names& names) {
  if (e.kind == Kind::name) names.insert(e.text);
  for (const Expression& child : e.children) collect(child, names);
}

bool uses(const Expression& e, const std::string& name) {
  return (e.kind == Kind::name && e.text == name) ||
         std::ranges::any_of(e.children,
                             [&](const Expression& child) { return uses(child, name); });
}

void each_part(const Expression& e, const std::function<void(const Expression&)>& f) {
  f(e);
  for (const Expression& child : e.children) each_part(child, f);
}

Names names_in(const claims::Item& item) {
  Names names(item.names.begin(), item.names.end());
  const auto add = [&](const Expression& e) { collect(e, names); };
  std::ranges::for_each(item.expressions, add);
  std::ranges::for_each(item.columns, add);
  if (item.where) add(*item.where);
  add(item.claim.statement);
  if (item.claim.corrected) add(*item.claim.corrected);
  std::ranges::for_each(item.claim.hints, add);
  for (const auto& row : item.rows) {
    add(row.value);
    std::ranges::for_each(row.printed, add);
    for (const auto& [number, corrected] : row.corrected) add(corrected);
  }
  return names;
}

bool is_definition(const claims::Item& item) {
  using ItemKind = claims::Item::Kind;
  return item.kind == ItemKind::let || item.kind == ItemKind::sequence ||
         item.kind == ItemKind::root || item.kind == ItemKind::define ||
         item.kind == ItemKind::param;
}

// Statements about nothing but numbers easily come to the same.
bool has_variables(const certificate::Statement& statement) {
  return std::ranges::any_of(statement.nodes, [&](const certificate::Node& node) {
    return node.kind == certificate::Node::Kind::symbol &&
           std::ranges::none_of(statement.generators,
                                [&](const auto& number) { return number.name == node.text; });
  });
}

class Warnings {
 public:
  Warnings(std::filesystem::path file, const report::FileRun& run)
      : file_(std::move(file)), run_(run) {}

  void about_definitions() {
    const claims::File parsed = claims::parse(open(file_)).file;
    std::vector<Names> used;
    for (const claims::Item& item : parsed.items) {
      if (item.kind == claims::Item::Kind::include) return;  // which may use any of them
      used.push_back(names_in(item));
    }
    for (std::size_t i = 0; i < parsed.items.size(); ++i) {
      const claims::Item& item = parsed.items[i];
      if (!is_definition(item)) continue;
      const auto names = item.names.empty() ? std::vector{item.name} : item.names;
      for (const std::string& name : names) {
        bool is_used = false;
        for (std::size_t k = 0; k < used.size(); ++k)
          is_used = is_used || (k != i && used[k].contains(name));
        if (!is_used)
          add("unused-definition", {}, item.name_span, "'" + name + "' is never used",
              "no claim speaks of it");
      }
    }
  }

  void about(const claims::MeantClaim& claim) {
    const auto found = std::ranges::find_if(
        claims_, [&](const report::ClaimRun* c) { return c->id == claim.claim.id; });
    if (found == claims_.end()) return;
    const report::ClaimRun& run = **found;
    const text::Span& where = claim.span;
    about_variables(claim);
    if (claim.printed.exported && run.printed.verdict == report::Verdict::proven)
      about_reasons(claim, run);
    if (run.corrected && !run.printed.digest.empty() &&
        run.corrected->digest == run.printed.digest)
      add("same-correction", run.id, where, "the correction says the same as what is printed",
          "both were turned into the same statement");
    if (!claim.printed.exported || !has_variables(claim.printed.exported->statement)) return;
    const auto [first, fresh] = digests_.emplace(run.printed.digest, &run);
    const bool is_cell = run.id.find('.') != std::string::npos && tables_.contains(run.id);
    if (!fresh && !is_cell && first->second->printed.text != run.printed.text)
      add("same-statement", run.id, where,
          "'" + run.id + "' was turned into the same statement as '" + first->second->id + "'",
          "do they say the same in other words?");
  }

  void about_cell(const claims::MeantClaim& claim) {
    tables_.insert(claim.claim.id);
    about(claim);
  }

  std::vector<report::WarningRun> all;

 private:
  void add(const std::string& rule, const std::string& claim, const text::Span& where,
           const std::string& message, const std::string& hint) {
    const text::Position place = text::position(*where.source, where.begin);
    const std::string& name = where.source->name;
    all.push_back({rule, claim, message, hint, place.line, place.column,
                   name == file_.string() ? "" : name});
  }

  void about_variables(const claims::MeantClaim& claim) {
    std::vector<const Expression*> statements = {&claim.claim.statement};
    if (claim.claim.corrected) statements.push_back(&*claim.claim.corrected);
    for (const Expression* statement : statements)
      each_part(*statement, [&](const Expression& e) {
        if (e.kind != Kind::for_all && e.kind != Kind::for_some) return;
        for (const Expression& binding : e.children)
          if (binding.kind == Kind::binding) about_binding(claim.claim.id, e, binding);
      });
  }

  // One of the variables of a set in several may well be missing.
  void about_binding(const std::string& id, const Expression& e, const Expression& binding) {
    const auto is_used = [&](const Expression& name) {
      return std::ranges::any_of(e.children, [&](const Expression& child) {
        if (&child != &binding) return uses(child, name.text);
        return std::any_of(child.children.begin() + 1, child.children.end(),
                           [&](const Expression& part) { return uses(part, name.text); });
      });
    };
    const auto& names = binding.children[0].children;
    if (binding.text != "all" && std::ranges::any_of(names, is_used)) return;
    for (const Expression& name : names)
      if (!is_used(name))
        add("unused-variable", id, name.span,
            "the variable '" + name.text + "' does not occur in what is said for it",
            "leave it out, or say something of it");
  }

  void about_reasons(const claims::MeantClaim& claim, const report::ClaimRun& run) {
    const certificate::Statement& statement = claim.printed.exported->statement;
    each_part(claim.claim.statement, [&](const Expression& e) {
      if (e.kind != Kind::relation || e.text == "~") return;
      for (std::size_t i = 0; i + 1 < e.children.size(); ++i)
        if (claims::same(e.children[i], e.children[i + 1]))
          add("same-sides", run.id, e.span, "both sides are the same formula",
              "it holds whatever they are");
    });
    if (statement.obligations.empty())
      return add("nothing-to-show", run.id, claim.span,
                 "'" + run.id + "' holds for no reason: there was nothing to show",
                 "is a list or a set in it empty?");
    std::size_t empty = 0, others = 0;
    for (const report::ObligationRun& obligation : run.printed.obligations)
      if (!obligation.guard) ++(obligation.slack.unknown == prove::no_point ? empty : others);
    if (empty > 0 && others == 0)
      add("empty-domain", run.id, claim.span,
          "'" + run.id + "' holds for no reason: " + prove::no_point,
          "what is supposed never happens");
  }

  std::filesystem::path file_;
  const report::FileRun& run_;
  std::vector<const report::ClaimRun*> claims_ = report::claims(run_);
  std::map<std::string, const report::ClaimRun*> digests_;
  Names tables_;
};

}  // namespace

std::vector<report::WarningRun> warnings_of(const std::filesystem::path& file,
                                            const claims::Meaning& meaning,
                                            const report::FileRun& run) {
  Warnings warnings(file, run);
  warnings.about_definitions();
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item)) warnings.about(*claim);
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const claims::MeantClaim& cell : row.cells) warnings.about_cell(cell);
  }
  std::ranges::stable_sort(warnings.all, [](const auto& a, const auto& b) {
    return a.included != b.included ? a.included < b.included : a.line < b.line;
  });
  return std::move(warnings.all);
}

}  // namespace seam::cli
