// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "claims/latex.h"
#include "claims/typeset.h"

// The functions that have a notation of their own, each for the arguments it is written with; a
// call with others is typeset like any call.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

struct Notation {
  std::size_t arguments;
  Typeset (*write)(const Expression& call);
};

const Expression& argument(const Expression& call, std::size_t i) {
  return call.children[i];
}

std::string plain(const Expression& call, std::size_t i) {
  return typeset(argument(call, i), Level::range);
}

Typeset between(const Expression& call, const std::string& open, const std::string& close) {
  return {open + " " + plain(call, 1) + " " + close};
}

Typeset derivative(const Expression& call, const std::string& order) {
  const std::string up = order.empty() ? "" : "^{" + order + "}";
  return {"\\frac{\\partial" + up + "}{\\partial " + plain(call, 2) + up + "} " +
              typeset(argument(call, 1), Level::postfix),
          Level::sum};
}

const std::map<std::string, Notation, std::less<>>& notations() {
  using E = const Expression&;
  static const std::map<std::string, Notation, std::less<>> all = {
      {"sqrt", {1, [](E c) -> Typeset { return {"\\sqrt{" + plain(c, 1) + "}"}; }}},
      {"cbrt", {1, [](E c) -> Typeset { return {"\\sqrt[3]{" + plain(c, 1) + "}"}; }}},
      {"abs", {1, [](E c) { return between(c, "\\lvert", "\\rvert"); }}},
      {"norm", {1, [](E c) { return between(c, "\\lVert", "\\rVert"); }}},
      {"norm2",
       {1,
        [](E c) -> Typeset {
          return {between(c, "{\\lVert", "\\rVert}^{2}").tex, Level::power};
        }}},
      {"floor", {1, [](E c) { return between(c, "\\lfloor", "\\rfloor"); }}},
      {"ceil", {1, [](E c) { return between(c, "\\lceil", "\\rceil"); }}},
      {"factorial",
       {1,
        [](E c) -> Typeset {
          return {typeset(c.children[1], Level::postfix) + "!", Level::power};
        }}},
      {"transpose",
       {1,
        [](E c) -> Typeset {
          return {"{" + typeset(c.children[1], Level::postfix) + "}^{\\top}", Level::power};
        }}},
      {"inverse",
       {1,
        [](E c) -> Typeset {
          return {"{" + typeset(c.children[1], Level::postfix) + "}^{-1}", Level::power};
        }}},
      {"binomial",
       {2,
        [](E c) -> Typeset { return {"\\binom{" + plain(c, 1) + "}{" + plain(c, 2) + "}"}; }}},
      {"dot",
       {2,
        [](E c) -> Typeset {
          return {"\\langle " + plain(c, 1) + ", " + plain(c, 2) + " \\rangle"};
        }}},
      {"cross",
       {2,
        [](E c) -> Typeset {
          return {typeset(c.children[1], Level::postfix) + " \\times " +
                      typeset(c.children[2], Level::postfix),
                  Level::sum};
        }}},
  };
  return all;
}

std::string macro(const std::string& name) {
  for (const char* known : {"sin", "cos", "tan", "exp", "log", "max", "min", "det", "gcd"})
    if (name == known) return "\\" + name;
  return {};
}

// `\sum_{i=1}^{n} E`, `\max_{(u, v) \in T} E`
Typeset over(const std::string& sign, const Expression& each) {
  std::string below, above;
  const Expression& first = each.children[1];
  const bool counts = each.children.size() == 2 && first.children.size() == 2 &&
                      first.children[0].children.size() == 1 &&
                      first.children[1].kind == Kind::range &&
                      (sign == "\\sum" || sign == "\\prod");
  if (counts) {
    const Expression& range = first.children[1];
    below = latex_name(first.children[0].children[0].text) + "=" +
            typeset(range.children[0], Level::sum);
    above = "^{" + typeset(range.children[1], Level::sum) + "}";
  } else {
    for (std::size_t i = 1; i < each.children.size(); ++i)
      below += (i > 1 ? ",\\ " : "") + typeset_binding(each.children[i]);
  }
  return {sign + "_{" + below + "}" + above + " " + typeset(each.children[0], Level::product),
          Level::sum};
}

}  // namespace

Typeset typeset_function(const Expression& call) {
  if (call.children[0].kind != Kind::name || call.children.size() < 2) return {};
  const std::string& name = call.children[0].text;
  const std::size_t arguments = call.children.size() - 1;
  const Expression& first = call.children[1];

  if (arguments == 1 && first.kind == Kind::each) {
    if (name == "sum" || name == "product")
      return over(name == "sum" ? "\\sum" : "\\prod", first);
    if (name == "max" || name == "min") return over("\\" + name, first);
    if (name == "argmax" || name == "argmin")
      return over("\\operatorname{" + name + "}", first);
  }
  if (name == "limit" && arguments == 1 && first.kind == Kind::limit)
    return {"\\lim_{" + latex_name(first.text) + " \\to " +
                typeset(first.children[1], Level::range) + "} " +
                typeset(first.children[0], Level::product),
            Level::sum};
  for (std::size_t i = 1; i <= arguments; ++i) {
    const Kind kind = call.children[i].kind;
    if (kind == Kind::each || kind == Kind::limit) return {};
    if (kind == Kind::named && (name != "subst" || i == 1)) return {};
  }

  if (const auto found = notations().find(name);
      found != notations().end() && found->second.arguments == arguments)
    return found->second.write(call);
  if (name == "diff" && arguments >= 2 && arguments <= 3 && call.children[2].kind == Kind::name)
    return derivative(call, arguments == 3 ? plain(call, 3) : "");
  if (name == "subst" && arguments >= 2)
    return {"{" + typeset(first, Level::postfix) + "}\\big|_{" +
                typeset_list(call.children, 2, true) + "}",
            Level::power};
  if (const std::string known = macro(name); !known.empty())
    return {known + fenced("(", typeset_list(call.children, 1, true), ")")};
  return {};
}

}  // namespace seam::claims
