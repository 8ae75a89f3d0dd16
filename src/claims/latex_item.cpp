// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/function_type.h"
#include "claims/latex.h"
#include "claims/typeset.h"

namespace seam::claims {
namespace {

std::string names(const std::vector<std::string>& all) {
  std::string tex;
  for (const std::string& name : all) tex += (tex.empty() ? "" : ", ") + latex_name(name);
  return tex;
}

std::string head(const Item& item) {
  if (item.parameters.empty()) return latex_name(item.name);
  return latex_name(item.name, true) + "(" + names(item.parameters) + ")";
}

std::string member(const std::string& who, const Expression& set) {
  return who + " \\in " + shallow(typeset(set, Level::range, true), set);
}

std::string space(const std::string& dimension) {
  return "\\mathbb{R}" + (dimension == "1" ? "" : "^{" + dimension + "}");
}

std::string param(const Item& item) {
  std::string tex = names(item.names);
  if (const auto function = FunctionType::of(item.type))
    return tex + "\\colon " + space(std::to_string(function->arguments)) + " \\to " +
           space(std::to_string(function->components));
  if (item.type == "integer")
    tex += " \\in \\mathbb{Z}";
  else if (item.type == "mesh")
    tex += "\\text{ a closed mesh}";
  else if (!item.type.empty())
    tex += " \\in \\mathbb{R}^{" + item.type.substr(item.type.find(' ') + 1) + "}";
  else if (item.expressions.empty())
    tex += " \\in \\mathbb{R}";
  if (!item.expressions.empty())
    tex =
        member(item.type.empty() ? tex : tex + ",\\ " + names(item.names), item.expressions[0]);
  return item.where ? tex + "\\text{ where }" + latex(*item.where) : tex;
}

// s(0) = START, s(k + 1) = STEP
std::string sequence(const Item& item) {
  const std::string name = latex_name(item.name, true);
  return name + "(0) = " + latex(item.expressions[0]) + ",\\quad " + name + "(" +
         names(item.parameters) + " + 1) = " + latex(item.expressions[1]);
}

}  // namespace

std::string latex(const Item& item) {
  switch (item.kind) {
    case Item::Kind::let:
      return head(item) + " = " + latex(item.expressions[0]);
    case Item::Kind::define:
      return head(item) + " :\\iff " + latex(item.expressions[0]);
    case Item::Kind::sequence:
      return sequence(item);
    case Item::Kind::param:
      return param(item);
    case Item::Kind::root:
      return member(latex_name(item.name), item.expressions[1]) + ",\\ " +
             latex(item.expressions[0]) + " = 0";
    default:
      return {};
  }
}

}  // namespace seam::claims
