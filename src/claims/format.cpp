// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>
#include <utility>

#include "claims/printer.h"

// The text of an expression as the grammar reads it back. Quantifiers and `solve` inside
// another statement always stand in parentheses, although the grammar could do without: where
// they end is then plain to see.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;
using Break = Piece::Break;
using Children = std::vector<Expression>;

Level tighter(Level level) {
  return static_cast<Level>(static_cast<int>(level) + 1);
}

// `f((x = 1) and y)`: without parentheses the argument would begin like `x = 1`, a named one.
bool begins_like_named(const Expression& e) {
  switch (e.kind) {
    case Kind::relation:
      return e.children.front().kind == Kind::name && e.text.starts_with("=");
    case Kind::truncated:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::each:
    case Kind::limit:
      return begins_like_named(e.children.front());
    default:
      return false;
  }
}

class Printer {
 public:
  std::vector<Piece> pieces = {Piece{}};

  void print(const Expression& e, Level wanted) {
    ++depth_;
    if (level(e) >= wanted)
      bare(e);
    else
      enclosed(e);
    --depth_;
  }

 private:
  void put(const std::string& text) { pieces.back().text += text; }

  void may_break(bool blank = true, Break kind = Break::soft) {
    pieces.push_back({kind, blank, depth_, {}});
  }

  void enclosed(const Expression& e) {
    put("(");
    bare(e);
    put(")");
  }

  template <typename Print>
  void separated(const Children& children, std::size_t first, const Print& print_one) {
    for (std::size_t i = first; i < children.size(); ++i) {
      if (i > first) {
        put(",");
        may_break();
      }
      ++depth_;
      print_one(children[i]);
      --depth_;
    }
  }

  // A chain of operators of one level breaks at all of them alike.
  void infix(const Expression& e, Level left, Level right, const std::string& operation,
             bool blanks) {
    if (level(e.children[0]) == level(e) && left == level(e))
      bare(e.children[0]);
    else
      print(e.children[0], left);
    may_break(blanks);
    put(blanks ? operation + " " : operation);
    print(e.children[1], right);
  }

  void binary(const Expression& e) {
    const Level own = level(e);
    if (own == Level::sum)
      infix(e, own, tighter(own), e.text, true);
    else if (own == Level::product)
      infix(e, own, tighter(own), e.text, false);
    else {
      print(e.children[0], Level::postfix);
      put("^");
      print(e.children[1], Level::factor);
    }
  }

  void relation(const Expression& e) {
    std::istringstream operations(e.text);
    std::string operation;
    print(e.children[0], Level::range);
    for (std::size_t i = 1; i < e.children.size(); ++i) {
      operations >> operation;
      may_break();
      put(operation + " ");
      print(e.children[i], Level::range);
    }
  }

  // What stands between brackets: a statement, `E for i in R`, `u = 1/3`.
  void element(const Expression& e, Level wanted, bool argument = false) {
    const bool tail = e.kind == Kind::each || e.kind == Kind::limit;
    if (e.kind == Kind::named) {
      put(e.text + " = ");
      print(e.children[0], Level::range);
      return;
    }
    const Expression& head = tail ? e.children[0] : e;
    if (argument && begins_like_named(head))
      enclosed(head);
    else
      print(head, wanted);
    if (!tail) return;
    may_break();
    put("for ");
    if (e.kind == Kind::each) return separated(e.children, 1, [&](auto& b) { binding(b); });
    put(e.text + " -> ");
    print(e.children[1], Level::range);
  }

  void entry(const Expression& e) {
    if (e.kind != Kind::weighted) return element(e, Level::range);
    print(e.children[0], Level::range);
    put(":");
    print(e.children[1], Level::range);
  }

  // ---- brackets

  void row(const Expression& e, const std::string& open, const std::string& close) {
    put(open);
    separated(e.children, 0, [&](auto& child) { element(child, Level::equivalence); });
    put(close);
  }

  void arguments(const Expression& e, const std::string& open, const std::string& close) {
    print(e.children[0], Level::callable);
    put(open);
    separated(e.children, 1,
              [&](auto& child) { element(child, Level::equivalence, e.kind == Kind::call); });
    put(close);
  }

  void matrix(const Expression& e) {
    put("[");
    for (std::size_t i = 0; i < e.children.size(); ++i) {
      if (i > 0) {
        put(";");
        may_break();
      }
      ++depth_;
      row(e.children[i], "", "");
      --depth_;
    }
    put("]");
  }

  // A net of one row stays on its line; others have a row on each line.
  void net(const Expression& e) {
    const Break kind = e.children.size() > 1 ? Break::hard : Break::soft;
    put(e.text + " [");
    for (std::size_t i = 0; i < e.children.size(); ++i) {
      if (i > 0) put(";");
      may_break(true, kind);
      ++depth_;
      separated(e.children[i].children, 0, [&](auto& child) { entry(child); });
      --depth_;
    }
    put(" ]");
  }

  void indexed(const Expression& e) {
    const Kind degree = e.children[0].kind;
    put(e.text + " ");
    if (degree == Kind::number || degree == Kind::name || degree == Kind::tuple)
      bare(e.children[0]);
    else
      enclosed(e.children[0]);
    put(" {");
    for (std::size_t i = 1; i < e.children.size(); ++i) {
      if (i > 1) put(";");
      may_break();
      put(e.children[i].text + ": ");
      ++depth_;
      entry(e.children[i].children[0]);
      --depth_;
    }
    put(" }");
  }

  // ---- bindings, quantifiers, solve

  void names(const Expression& list, bool tuple) {
    if (tuple) put("(");
    for (std::size_t i = 0; i < list.children.size(); ++i)
      put((i > 0 ? ", " : "") + list.children[i].text);
    if (tuple) put(")");
  }

  void binding(const Expression& b) {
    const bool bare_names = b.text == "all";
    const Expression& bound = b.children[0];
    names(bound, !bare_names && bound.children.size() > 1);
    std::size_t next = 1;
    if (!bare_names) {
      put(" in ");
      print(b.children[next++], Level::range);
    }
    if (next == b.children.size()) return;
    put(" where ");
    print(b.children[next], Level::equivalence);
  }

  void quantified(const Expression& e) {
    const bool all = e.kind == Kind::for_all;
    const bool bare_names = e.children[0].text == "all";
    put(!all ? "for some " : bare_names ? "for all " : "for ");
    for (std::size_t i = 0; i + 1 < e.children.size(); ++i) {
      if (i > 0) put(", ");
      binding(e.children[i]);
    }
    put(":");
    may_break();
    print(e.children.back(), Level::statement);
  }

  void solve(const Expression& e) {
    put("solve ");
    for (std::size_t i = 0; i < e.children[0].children.size(); ++i) {
      const Expression& unknown = e.children[0].children[i];
      if (i > 0) put(", ");
      if (unknown.kind == Kind::binding)
        binding(unknown);
      else
        put(unknown.text);
    }
    put(":");
    may_break();
    const bool nested = e.children[1].kind == Kind::solve;
    print(e.children[1], nested ? Level::equivalence : Level::statement);
    for (const Expression& condition : e.children[2].children) {
      may_break();
      put("where ");
      print(condition, Level::equivalence);
    }
    may_break();
    const Children& solutions = e.children[3].children;
    put("gives ");
    put(e.text);
    if (e.text == "one" && !solutions.empty()) put(" ~ ");
    separated(solutions, 0, [&](auto& solution) { print(solution, Level::range); });
  }

  void bare(const Expression& e) {
    const Level own = level(e);
    switch (e.kind) {
      case Kind::number:
      case Kind::name:
        return put(e.text);
      case Kind::string:
        return put('"' + e.text + '"');
      case Kind::read:
        return put("read \"" + e.text + '"');
      case Kind::infinity:
        return put("infinity");
      case Kind::negate:
        put("-");
        return print(e.children[0], Level::factor);
      case Kind::binary:
        return binary(e);
      case Kind::call:
        return arguments(e, "(", ")");
      case Kind::index:
        return arguments(e, "[", "]");
      case Kind::tuple:
        return row(e, "(", ")");
      case Kind::list:
        return row(e, "[", "]");
      case Kind::half_open:
        return row(e, e.text.substr(0, 1), e.text.substr(1));
      case Kind::matrix:
        return matrix(e);
      case Kind::range:
        print(e.children[0], Level::sum);
        put("..");
        return print(e.children[1], Level::sum);
      case Kind::plane:
        put("plane ");
        print(e.children[0],
              e.children[0].kind == Kind::number ? Level::postfix : Level::callable);
        put(" ");
        return print(e.children[1], Level::sum);
      case Kind::patch:
        return net(e);
      case Kind::indexed:
        return indexed(e);
      case Kind::from:
        put(e.text + " from ");
        return print(e.children[0], Level::range);
      case Kind::relation:
        return relation(e);
      case Kind::truncated:
        relation(e.children[0]);
        return put(" truncated");
      case Kind::for_all:
      case Kind::for_some:
        return quantified(e);
      case Kind::conjunction:
        return infix(e, own, tighter(own), "and", true);
      case Kind::disjunction:
        return infix(e, own, tighter(own), "or", true);
      case Kind::implication:
        return infix(e, tighter(own), own, "implies", true);
      case Kind::equivalence:
        return infix(e, own, tighter(own), "iff", true);
      case Kind::negation:
        put("not ");
        return print(e.children[0], Level::negation);
      case Kind::solve:
        return solve(e);
      case Kind::binding:
        return binding(e);
      case Kind::named:
      case Kind::each:
      case Kind::limit:
        return element(e, Level::equivalence);
      case Kind::weighted:
      case Kind::control:
        return entry(e);
    }
  }

  int depth_ = 0;
};

}  // namespace

std::vector<Piece> pieces(const Expression& e, Level wanted) {
  Printer printer;
  printer.print(e, wanted);
  return std::move(printer.pieces);
}

std::string format(const Expression& e) {
  return lay_out(pieces(e, Level::statement), 0, 4);
}

}  // namespace seam::claims
