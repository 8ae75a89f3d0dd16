// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/figure_marks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "draw/rounded_patch.h"

// A statement speaks of a patch p at parameters that it spells out, as in gauss(p)(u, 1 - u);
// or of a function on p as a whole, as in max(gauss(p)), which is then stated in the parameters
// u, v of p. Where it may be another patch or another part of the statement that the witness is
// about, or where the statement binds the name of the patch, nothing is marked.

namespace seam::draw {
namespace {

using claims::Expression;
using Kind = Expression::Kind;
using Values = std::map<std::string, double>;
using Place = std::array<double, 2>;

std::optional<double> number(std::string_view text) {
  double above = 0, below = 1;
  const char* end = text.data() + text.size();
  auto [rest, error] = std::from_chars(text.data(), end, above);
  if (error != std::errc() || rest == text.data()) return std::nullopt;
  if (rest == end) return above;
  if (*rest != '/') return std::nullopt;
  const auto [last, wrong] = std::from_chars(rest + 1, end, below);
  if (wrong != std::errc() || last != end || below == 0) return std::nullopt;
  return above / below;
}

// `u = 1/4, v = 1/2: ...`; nothing where a value is no rational.
std::optional<Values> values_of(std::string_view witness) {
  Values result;
  witness = witness.substr(0, witness.find(": "));
  while (!witness.empty()) {
    const std::string_view part = witness.substr(0, witness.find(", "));
    witness.remove_prefix(std::min(witness.size(), part.size() + 2));
    const std::size_t sign = part.find(" = ");
    if (sign == std::string_view::npos) return std::nullopt;
    const auto value = number(part.substr(sign + 3));
    if (!value) return std::nullopt;
    result.emplace(part.substr(0, sign), *value);
  }
  return result;
}

std::optional<double> value_of(const Expression& e, const Values& values) {
  if (e.kind == Kind::number) return number(e.text);
  if (e.kind == Kind::name) {
    const auto found = values.find(e.text);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
  std::vector<double> parts;
  for (const Expression& child : e.children)
    if (const auto part = value_of(child, values)) parts.push_back(*part);
  if (parts.size() != e.children.size()) return std::nullopt;
  if (e.kind == Kind::negate) return -parts[0];
  if (e.kind != Kind::binary) return std::nullopt;
  if (e.text == "+") return parts[0] + parts[1];
  if (e.text == "-") return parts[0] - parts[1];
  if (e.text == "*") return parts[0] * parts[1];
  if (e.text == "/" && parts[1] != 0) return parts[0] / parts[1];
  return std::nullopt;
}

// `p`, or a function on p that has its parameters: `D1(p)`, `gauss(p)`; else empty.
std::string patch_of(const Expression& e) {
  static const std::set<std::string> functions = {"D", "D1", "D2", "normal", "gauss"};
  if (e.kind == Kind::name) return e.text;
  const bool on_patch =
      e.kind == Kind::call && e.children.size() >= 2 && e.children[0].kind == Kind::name &&
      functions.contains(e.children[0].text) && e.children[1].kind == Kind::name;
  return on_patch ? e.children[1].text : "";
}

// Where a statement that fails at these values looks at the patch of that name.
class Looks {
 public:
  Looks(std::string patch, const Values& values) : patch_(std::move(patch)), values_(values) {}

  std::vector<Place> at(const Expression& statement) {
    const bool quantified = statement.kind == Kind::for_all || statement.kind == Kind::for_some;
    look(statement);
    if (quantifiers_ > (quantified ? 1 : 0) || is_bound_) return {};
    const bool in_its_own =
        values_.size() == 2 && values_.contains("u") && values_.contains("v");
    if (places_.empty() && as_a_whole_ && !another_ && in_its_own)
      places_.push_back({values_.at("u"), values_.at("v")});
    return places_;
  }

 private:
  void look(const Expression& e) {
    if (e.kind == Kind::for_all || e.kind == Kind::for_some) ++quantifiers_;
    if (e.kind == Kind::binding)
      for (const Expression& name : e.children[0].children)
        if (name.text == patch_) is_bound_ = true;
    if (e.kind == Kind::call && patch_of(e.children[0]) == patch_ && e.children.size() == 3) {
      const auto u = value_of(e.children[1], values_), v = value_of(e.children[2], values_);
      const Place place = {u.value_or(0), v.value_or(0)};
      if (u && v && std::ranges::find(places_, place) == places_.end())
        places_.push_back(place);
      return;
    }
    const bool regular = e.kind == Kind::call && e.children[0].text == "regular" &&
                         e.children.size() == 2 && patch_of(e.children[1]) == patch_;
    const std::string patch = e.kind == Kind::call ? patch_of(e) : "";
    if (regular || patch == patch_)
      as_a_whole_ = true;
    else if (!patch.empty())
      another_ = true;
    for (const Expression& child : e.children) look(child);
  }

  std::string patch_;
  const Values& values_;
  std::vector<Place> places_;
  int quantifiers_ = 0;
  bool as_a_whole_ = false, another_ = false, is_bound_ = false;
};

// Claims that fail at one point share a mark.
void mark(report::FigureRun& figure, const Vector& at, const std::string& claim) {
  const auto same = std::ranges::find(figure.marks, at, &report::FigureRun::Mark::at);
  if (same == figure.marks.end())
    figure.marks.push_back({at, claim});
  else
    same->label += ", " + claim;
}

bool is_inside(const RoundedPatch& patch, const Place& at) {
  const bool square = at[0] >= 0 && at[1] >= 0 && at[0] <= 1 && at[1] <= 1;
  return square && (patch.shape() == RoundedPatch::Shape::square || at[0] + at[1] <= 1);
}

}  // namespace

void mark_refutations(report::FileRun& run, const claims::Meaning& meaning) {
  std::map<std::string, Values> refuted;
  for (const report::ClaimRun* claim : report::claims(run))
    if (claim->printed.verdict == report::Verdict::refuted)
      if (const auto values = values_of(claim->printed.witness))
        refuted.emplace(claim->id, *values);

  std::vector<report::FigureRun*> figures;
  for (report::ItemRun& item : run.items)
    if (auto* figure = std::get_if<report::FigureRun>(&item)) figures.push_back(figure);
  std::size_t next = 0;
  for (const auto& item : meaning.items) {
    const auto* shown = std::get_if<claims::MeantFigure>(&item);
    if (!shown || next >= figures.size()) continue;
    report::FigureRun& figure = *figures[next++];
    for (const auto& [name, patch] : shown->named) {
      const RoundedPatch rounded(patch, *meaning.numbers);
      for (const auto& other : meaning.items) {
        const auto* claim = std::get_if<claims::MeantClaim>(&other);
        const auto values = claim ? refuted.find(claim->claim.id) : refuted.end();
        if (values == refuted.end()) continue;
        for (const Place& at : Looks(name, values->second).at(claim->claim.statement))
          if (is_inside(rounded, at))
            mark(figure, rounded.point(at[0], at[1]), claim->claim.id);
      }
    }
  }
}

}  // namespace seam::draw
