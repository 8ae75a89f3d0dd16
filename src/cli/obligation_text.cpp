// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/obligation_text.h"

#include <algorithm>

namespace seam::cli {
namespace {

using certificate::Relation;
using certificate::Simplex;
using certificate::Term;
using symbolic::Formula;

constexpr std::size_t longest = 600;  // bytes of a formula

std::string formula_text(Term term, Formulas& formulas) {
  std::string text = symbolic::text(formulas(term), longest);
  if (text.ends_with("...")) text += " (the certificate has all of it)";
  return text;
}

std::string related(Term term, Relation relation, Formulas& formulas) {
  static const char* const signs[] = {" > 0", " >= 0", " = 0", " != 0", " <= 0", " < 0"};
  return formula_text(term, formulas) + signs[static_cast<int>(relation)];
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string result;
  for (const std::string& part : parts) result += (result.empty() ? "" : separator) + part;
  return result;
}

// The coordinates of a corner are those of a point, or of a direction.
bool is_point(const std::vector<Term>& corner, Formulas& formulas) {
  return formulas(corner[0]).is(1);
}

std::string interval(const Simplex& s, Formulas& formulas) {
  const auto end = [&](std::size_t i) {
    const std::string value = formula_text(s.corners[i][1], formulas);
    if (is_point(s.corners[i], formulas)) return value;
    return std::string(value.starts_with('-') ? "-infinity" : "infinity");
  };
  const bool turned = end(1) == "-infinity";  // the lower end is named first
  const std::size_t low = turned ? 1 : 0, high = turned ? 0 : 1;
  // The facet that is left out is the one opposite to the corner.
  const bool open_low = s.open[high] || !is_point(s.corners[low], formulas);
  const bool open_high = s.open[low] || !is_point(s.corners[high], formulas);
  return s.variables[0] + " in " + (open_low ? "(" : "[") + end(low) + ", " + end(high) +
         (open_high ? ")" : "]");
}

// 0 and the unit vectors, in their order.
bool is_standard(const Simplex& s, Formulas& formulas) {
  for (std::size_t i = 0; i < s.corners.size(); ++i)
    for (std::size_t j = 0; j < s.corners[i].size(); ++j)
      if (!formulas(s.corners[i][j]).is(j == 0 || i == j ? 1 : 0)) return false;
  return true;
}

std::string tuple(const std::vector<Term>& corner, Formulas& formulas) {
  std::vector<std::string> entries;
  for (std::size_t j = 1; j < corner.size(); ++j)
    entries.push_back(formula_text(corner[j], formulas));
  return (is_point(corner, formulas) ? "(" : "the direction (") + joined(entries, ", ") + ")";
}

std::string simplex(const Simplex& s, Formulas& formulas) {
  const bool all_points = std::ranges::all_of(s.corners, [&](const auto& corner) {
    return is_point(corner, formulas) || formulas(corner[0]).is(0);
  });
  if (all_points && s.variables.size() == 1) return interval(s, formulas);
  const bool has_open = std::ranges::find(s.open, true) != s.open.end();
  const bool all_open = std::ranges::find(s.open, false) == s.open.end();
  const std::string names = joined(s.variables, ", ");
  if (is_standard(s, formulas) && (all_open || !has_open))
    return names + (all_open ? " > 0, " : " >= 0, ") + joined(s.variables, " + ") +
           (all_open ? " < 1" : " <= 1");
  std::vector<std::string> corners;
  for (const auto& corner : s.corners)
    corners.push_back(all_points ? tuple(corner, formulas)
                                 : formula_text(corner[0], formulas) + " times " +
                                       tuple(corner, formulas));
  return "(" + names + ") in the simplex with the corners " + joined(corners, ", ") +
         (has_open ? ", without some of its sides" : "");
}

}  // namespace

std::string obligation_text(const certificate::Obligation& obligation, Formulas& formulas) {
  if (const auto* zero = std::get_if<certificate::Zero>(&obligation))
    return readable(formula_text(zero->formula, formulas) + " = 0");
  const auto* sign = std::get_if<certificate::Sign>(&obligation);
  if (!sign) return {};
  std::vector<std::string> ranges, conditions;
  for (const Simplex& factor : sign->domain.factors)
    ranges.push_back(simplex(factor, formulas));
  for (const auto& condition : sign->domain.where)
    conditions.push_back(related(condition.formula, condition.relation, formulas));
  std::string text = related(sign->formula, sign->relation, formulas);
  if (!ranges.empty()) text += "  for " + joined(ranges, ", ");
  if (!conditions.empty()) text += "  where " + joined(conditions, " and ");
  return readable(text);
}

}  // namespace seam::cli
