// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml.h"

#include <vector>

#include "report/html_escape.h"
#include "report/mathml_cursor.h"
#include "report/mathml_row.h"
#include "report/mathml_signs.h"
#include "report/mathml_symbols.h"

// Read from left to right, one function a construct. Every function that opens an element
// closes it, and text goes through `html_escape`, so whatever comes out is well-formed. Each
// step takes at least a byte, and groups nest to a bound, so it ends.

namespace seam::report {
namespace {

constexpr int deepest = 150;

// One element, as the arguments of a script or a root must be.
std::string single(const std::string& row) {
  return html_element("mrow", row);
}

using Atom = MathmlAtom;
using Space = Atom::Space;

std::string double_struck(const std::string& letter) {
  if (letter == "R") return "ℝ";
  if (letter == "Z") return "ℤ";
  if (letter == "Q") return "ℚ";
  if (letter == "N") return "ℕ";
  if (letter == "C") return "ℂ";
  throw MathmlCursor::Unknown{};
}

class Reader : MathmlCursor {
 public:
  explicit Reader(std::string_view latex) : MathmlCursor(latex) {}

  std::string pieces() {
    std::string all;
    MathmlRow piece;
    while (!rest_.empty()) {
      const Atom atom = scripted();
      piece.add(atom);
      if (atom.may_end && !rest_.empty()) all += html_element("math", piece.take()) + "<wbr/>";
    }
    return all + html_element("math", piece.take());
  }

 private:
  // An atom with its primes, its subscript and its superscript.
  Atom scripted() {
    Atom base = atom();
    std::string above, below;
    for (;;) {
      skip_blanks();
      if (take("'"))
        above += mathml_operator("′");
      else if (take("^"))
        above += argument();
      else if (take("_"))
        below += argument();
      else
        break;
    }
    if (above.empty() && below.empty()) return base;
    const std::string both = base.limits ? "under" : "sub";
    std::string tag = "m" + (below.empty() ? "" : both) +
                      (above.empty() ? "" : std::string(base.limits ? "over" : "sup"));
    std::string xml = single(base.xml);
    if (!below.empty()) xml += single(below);
    if (!above.empty()) xml += single(above);
    return {html_element(tag, xml), base.space};
  }

  // What stands up to a closing sign.
  std::string row(std::string_view close) {
    if (++depth_ > deepest) throw Unknown{};
    MathmlRow all;
    skip_blanks();
    while (!take(close)) {
      if (rest_.empty()) throw Unknown{};
      all.add(scripted());
      skip_blanks();
    }
    --depth_;
    return all.take();
  }

  std::string argument() {
    skip_blanks();
    if (rest_.empty()) throw Unknown{};
    return take("{") ? row("}") : atom().xml;
  }

  Atom atom() {
    skip_blanks();
    if (rest_.empty()) return {};
    const char c = rest_.front();
    if (is_digit(c)) return number();
    next();
    if (is_letter(c)) return {mathml_identifier(std::string(1, c))};
    if (c == '\\') return command(name());
    if (c == '{') return {single(row("}"))};
    return known(mathml_sign(c));
  }

  Atom number() {
    std::size_t length = 0;
    while (length < rest_.size() &&
           (is_digit(rest_[length]) ||
            (rest_[length] == '.' && length + 1 < rest_.size() && is_digit(rest_[length + 1]))))
      ++length;
    const std::string digits(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return {html_element("mn", digits)};
  }

  Atom command(std::string_view name) {
    if (name == "frac" || name == "dfrac" || name == "tfrac") {
      const std::string above = single(argument());
      return {html_element("mfrac", above + single(argument()))};
    }
    if (name == "binom" || name == "dbinom") {
      const std::string above = single(argument());
      return {single(mathml_operator("(") +
                     html_element("mfrac linethickness=\"0\"", above + single(argument())) +
                     mathml_operator(")"))};
    }
    if (name == "sqrt") return root();
    if (name == "left") return fenced();
    if (name == "begin") return environment();
    if (name == "text" || name == "textrm") return {html_element("mtext", html_escape(text()))};
    if (name == "operatorname")
      return {mathml_identifier(letters(), " mathvariant=\"normal\""), Space::function};
    if (name == "mathrm") return {mathml_identifier(letters(), " mathvariant=\"normal\"")};
    if (name == "mathit") return {mathml_identifier(letters(), " class=\"word\"")};
    if (name == "mathbf") return {html_element("mrow class=\"bold\"", argument())};
    if (name == "mathbb") return {mathml_identifier(double_struck(letters()), "")};
    if (const std::string_view sign = accent(name); !sign.empty())
      return {
          html_element("mover accent=\"true\"", single(argument()) + mathml_operator(sign))};
    return known(mathml_command(name));
  }

  static Atom known(const std::optional<Atom>& atom) {
    if (!atom) throw Unknown{};
    return *atom;
  }

  Atom root() {
    skip_blanks();
    if (!take("[")) return {html_element("msqrt", argument())};
    const std::string degree = single(row("]"));
    return {html_element("mroot", single(argument()) + degree)};
  }

  std::string fence() {
    skip_blanks();
    const char c = next();
    if (c == '.') return "";
    if (std::string_view("()[]|/").find(c) != std::string_view::npos)
      return mathml_operator(std::string(1, c), " stretchy=\"true\" fence=\"true\"");
    if (c != '\\') throw Unknown{};
    const Symbol found = symbol(name());
    if (found.kind != Symbol::Kind::fence && found.kind != Symbol::Kind::open &&
        found.kind != Symbol::Kind::close)
      throw Unknown{};
    return mathml_operator(found.text, " stretchy=\"true\" fence=\"true\"");
  }

  Atom fenced() {
    const std::string open = fence();
    const std::string inside = single(row("\\right"));
    return {single(open + inside + fence()), Space::open};
  }

  Atom environment() {
    if (!take("{")) throw Unknown{};
    const std::string kind(name());
    if (!take("}")) throw Unknown{};
    const bool is_matrix = kind == "pmatrix" || kind == "bmatrix" || kind == "vmatrix";
    const bool is_left = kind == "cases" || kind == "aligned" || kind == "split";
    if (!is_matrix && !is_left && kind != "array" && kind != "matrix" && kind != "gathered" &&
        kind != "smallmatrix")
      throw Unknown{};
    std::string columns;
    if (kind == "array") {
      if (!take("{")) throw Unknown{};
      while (!take("}")) columns += next();
    }
    const bool left = is_left || columns.starts_with('l');
    const std::string table =
        html_element(left ? "mtable class=\"left\"" : "mtable", rows("\\end{" + kind + "}"));
    const auto between = [&](const char* open, const char* close) {
      return Atom{single(mathml_operator(open) + table + mathml_operator(close))};
    };
    if (kind == "pmatrix") return between("(", ")");
    if (kind == "bmatrix") return between("[", "]");
    if (kind == "vmatrix") return between("|", "|");
    if (kind == "cases") return {single(mathml_operator("{") + table)};
    return {table};
  }

  std::string rows(const std::string& end) {
    if (++depth_ > deepest) throw Unknown{};
    std::string all, cells;
    MathmlRow cell;
    const auto end_cell = [&] {
      cells += html_element("mtd", cell.take());
      cell = {};
    };
    for (;;) {
      skip_blanks();
      const bool ends = take(end);
      if (ends || take("\\\\")) {
        end_cell();
        all += html_element("mtr", cells);
        cells.clear();
        if (ends) break;
      } else if (take("&")) {
        end_cell();
      } else if (rest_.empty()) {
        throw Unknown{};
      } else {
        cell.add(scripted());
      }
    }
    --depth_;
    return all;
  }

  int depth_ = 0;
};

}  // namespace

std::optional<std::string> mathml(std::string_view latex) {
  try {
    return Reader(latex).pieces();
  } catch (const MathmlCursor::Unknown&) {
    return std::nullopt;
  }
}

}  // namespace seam::report
