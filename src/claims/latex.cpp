// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/latex.h"

#include <algorithm>

#include "claims/typeset.h"

namespace seam::claims {
namespace {

using Kind = Expression::Kind;
using Children = std::vector<Expression>;

constexpr std::size_t widest_pmatrix = 10;

// What looks like one number with a number in front of it: another, also with an exponent, or a
// fraction.
bool continues_number(const std::string& tex) {
  const std::size_t first = std::min(tex.find_first_not_of('{'), tex.size());
  const std::string_view rest = std::string_view(tex).substr(first);
  return !rest.empty() &&
         ((rest.front() >= '0' && rest.front() <= '9') || rest.starts_with("\\frac"));
}

// `3x`, `3(a + b)`, but `3 \cdot 4`, `3 \cdot 4^k`, `3 \cdot \frac12` and `a \cdot (b + c)`,
// which else would look like a call.
Typeset product(const Expression& e) {
  const std::string left = typeset(e.children[0], Level::product);
  const std::string right = typeset(e.children[1], Level::power);
  const Expression& last = e.children[0].kind == Kind::binary && e.children[0].text == "*"
                               ? e.children[0].children[1]
                               : e.children[0];
  const bool names = last.kind == Kind::name && e.children[1].kind == Kind::name;
  const bool side_by_side = last.kind == Kind::number && !continues_number(right);
  return {left + (side_by_side ? " " : names ? "\\, " : " \\cdot ") + right, Level::product};
}

Typeset binary(const Expression& e) {
  const Children& c = e.children;
  if (e.text == "/")
    return {"\\frac{" + typeset(c[0], Level::range) + "}{" + typeset(c[1], Level::range) + "}",
            Level::power};
  if (e.text == "^")
    return {"{" + typeset(c[0], Level::postfix) + "}^{" + typeset(c[1], Level::range) + "}",
            Level::power};
  if (e.text == "*") return product(e);
  std::string right = typeset(c[1], Level::product);
  if (right.starts_with('-')) right = fenced("(", right, ")");
  return {typeset(c[0], Level::sum) + " " + e.text + " " + right, Level::sum};
}

// Begins a row of an array: `\\\\ [` would read the row as a distance.
void begin_row(std::string& tex, const std::string& row) {
  if (!tex.empty()) tex += row.starts_with('[') ? " \\\\ {}" : " \\\\ ";
  tex += row;
}

// Rows of lists as an array, without its brackets.
std::string rows(const Children& lists, bool row) {
  std::string tex;
  for (const Expression& list : lists) {
    std::string cells;
    for (std::size_t i = 0; i < list.children.size(); ++i)
      cells += (i > 0 ? " & " : "") + typeset(list.children[i], Level::equivalence, row);
    begin_row(tex, cells);
  }
  return tex;
}

std::size_t columns(const Children& lists) {
  std::size_t most = 1;
  for (const Expression& list : lists) most = std::max(most, list.children.size());
  return most;
}

std::string array(const Children& lists, const std::string& open, const std::string& close) {
  return "\\left" + open + "\\begin{array}{" + std::string(columns(lists), 'c') + "} " +
         rows(lists, true) + " \\end{array}\\right" + close;
}

Typeset matrix(const Expression& e) {
  if (columns(e.children) > widest_pmatrix) return {array(e.children, "(", ")")};
  return {"\\begin{pmatrix} " + rows(e.children, true) + " \\end{pmatrix}"};
}

Typeset tuple(const Expression& e, bool row) {
  std::string tex;
  for (const Expression& child : e.children) {
    const std::string entry = typeset(child, row ? Level::statement : Level::equivalence, true);
    if (row)
      tex += (tex.empty() ? "" : ", ") + entry;
    else
      begin_row(tex, entry);
  }
  if (row) return {fenced("(", tex, ")")};
  return {"\\begin{pmatrix} " + tex + " \\end{pmatrix}"};
}

// `triangle_patch` as words.
std::string shape(std::string text) {
  std::ranges::replace(text, '_', ' ');
  return "\\text{" + text + " }";
}

Typeset indexed(const Expression& e) {
  std::string tex;
  for (std::size_t i = 1; i < e.children.size(); ++i)
    tex += (i > 1 ? " \\\\ b_{" : "b_{") + e.children[i].text +
           "} = " + typeset(e.children[i].children[0], Level::equivalence, true);
  return {shape(e.text) + typeset(e.children[0], Level::callable, true) +
              R"(\ \left\{\begin{array}{l} )" + tex + R"( \end{array}\right\})",
          Level::prefix};
}

Typeset call(const Expression& e) {
  if (Typeset own = typeset_function(e); !own.tex.empty()) return own;
  const Expression& callee = e.children[0];
  const std::string function = callee.kind == Kind::name ? latex_name(callee.text, true)
                                                         : typeset(callee, Level::callable);
  return {function + fenced("(", typeset_list(e.children, 1, true), ")")};
}

Typeset index(const Expression& e) {
  return {"{" + typeset(e.children[0], Level::callable) + "}_{" +
          typeset_list(e.children, 1, true) + "}"};
}

// TeX nests a few hundred groups at most, some of them its own.
bool too_deep(const std::string& tex) {
  constexpr int limit = 60;
  int depth = 0, deepest = 0;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '\\') {
      const std::string_view rest = std::string_view(tex).substr(i + 1);
      if (rest.starts_with("left") || rest.starts_with("begin")) ++depth;
      if (rest.starts_with("right") || rest.starts_with("end")) --depth;
      ++i;
    } else if (tex[i] == '{') {
      ++depth;
    } else if (tex[i] == '}') {
      --depth;
    }
    deepest = std::max(deepest, depth);
  }
  return deepest > limit;
}

}  // namespace

std::string fenced(const std::string& open, const std::string& body, const std::string& close) {
  constexpr std::size_t longest = 200;
  const bool tall =
      body.find("\\frac") != std::string::npos || body.find("\\begin") != std::string::npos;
  if (!tall || body.size() > longest) return open + body + close;
  return "\\left" + open + " " + body + " \\right" + close;
}

std::string typeset_list(const Children& children, std::size_t first, bool row) {
  std::string tex;
  for (std::size_t i = first; i < children.size(); ++i)
    tex += (i > first ? ", \\allowbreak " : "") + typeset(children[i], Level::statement, row);
  return tex;
}

std::string typeset(const Expression& e, Level wanted, bool row) {
  const Typeset made = typeset(e, row);
  return made.level >= wanted ? made.tex : fenced("(", made.tex, ")");
}

Typeset typeset(const Expression& e, bool row) {
  switch (e.kind) {
    case Kind::number:
      return {e.text};
    case Kind::name:
      return {latex_name(e.text)};
    case Kind::string:
      return {latex_text("``" + e.text + "''")};
    case Kind::negate:
      return {"-" + typeset(e.children[0], Level::power), Level::factor};
    case Kind::binary:
      return binary(e);
    case Kind::call:
      return call(e);
    case Kind::named:
      return {latex_name(e.text) + " = " + typeset(e.children[0], Level::range),
              Level::relation};
    case Kind::index:
      return index(e);
    case Kind::tuple:
      return tuple(e, row);
    case Kind::list:
      return {fenced("[", typeset_list(e.children, 0, true), "]")};
    case Kind::half_open:
      return {e.text.substr(0, 1) + typeset_list(e.children, 0, true) + e.text.substr(1)};
    case Kind::matrix:
      return matrix(e);
    case Kind::range:
      return {"\\{" + typeset(e.children[0], Level::sum) + ", \\ldots, " +
              typeset(e.children[1], Level::sum) + "\\}"};
    case Kind::infinity:
      return {"\\infty"};
    case Kind::plane:
      return {"\\operatorname{plane}" + fenced("(", typeset_list(e.children, 0, true), ")")};
    case Kind::patch:
      return {shape(e.text) + array(e.children, "[", "]"), Level::prefix};
    case Kind::indexed:
      return indexed(e);
    case Kind::control:
      return typeset(e.children[0], true);
    case Kind::weighted:
      return {typeset(e.children[0], Level::range, true) + " : " +
                  typeset(e.children[1], Level::range, true),
              Level::relation};
    case Kind::from:
      return {shape(e.text) + typeset(e.children[0], Level::callable), Level::prefix};
    case Kind::read:
      return {"\\operatorname{read}(" + latex_text(e.text) + ")"};
    default:
      return typeset_statement(e);
  }
}

std::string shallow(const std::string& tex, const Expression& e) {
  return too_deep(tex) ? latex_text(format(e)) : tex;
}

std::string latex(const Expression& e) {
  return shallow(typeset(e, Level::statement), e);
}

}  // namespace seam::claims
