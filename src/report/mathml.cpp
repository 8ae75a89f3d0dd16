// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml.h"

#include <vector>

#include "report/html_escape.h"
#include "report/mathml_cursor.h"
#include "report/mathml_symbols.h"

// Read from left to right, one function a construct. Every function that opens an element
// closes it, and text goes through `html_escape`, so whatever comes out is well-formed. Each
// step takes at least a byte, and groups nest to a bound, so it ends.

namespace seam::report {
namespace {

constexpr int deepest = 150;

std::string operation(std::string_view sign, const char* attributes = "") {
  return html_element("mo" + std::string(attributes), html_escape(sign));
}

std::string word(std::string_view text, const char* variant) {
  return html_element("mi" + std::string(variant), html_escape(text));
}

// One element, as the arguments of a script or a root must be.
std::string single(const std::string& row) {
  return html_element("mrow", row);
}

struct Atom {
  std::string xml;
  bool limits = false;   // scripts stand below and above
  bool may_end = false;  // a line may end behind it
};

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
    std::string all, piece;
    while (!rest_.empty()) {
      const Atom atom = scripted();
      piece += atom.xml;
      if (atom.may_end && !rest_.empty()) {
        all += html_element("math", piece) + "<wbr/>";
        piece.clear();
      }
    }
    return all + html_element("math", piece);
  }

 private:
  // An atom with its primes, its subscript and its superscript.
  Atom scripted() {
    Atom base = atom();
    std::string above, below;
    for (;;) {
      skip_blanks();
      if (take("'"))
        above += operation("′");
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
    return {html_element(tag, xml)};
  }

  // What stands up to a closing sign.
  std::string row(std::string_view close) {
    if (++depth_ > deepest) throw Unknown{};
    std::string all;
    skip_blanks();
    while (!take(close)) {
      if (rest_.empty()) throw Unknown{};
      all += scripted().xml;
      skip_blanks();
    }
    --depth_;
    return all;
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
    if (is_letter(c)) return {word(std::string(1, c), "")};
    if (c == '\\') return command(name());
    if (c == '{') return {single(row("}"))};
    if (c == '~') return {"<mspace width=\"0.3em\"/>"};
    if (c == '-') return {operation("−")};
    if (c == '(' || c == '[' || c == ')' || c == ']')
      return {operation(std::string(1, c), " stretchy=\"false\"")};
    if (c == ',') return {operation(","), false, false};
    if (c == '=' || c == '<' || c == '>')
      return {operation(std::string(1, c), " form=\"infix\""), false, true};
    if (c == '.') return {operation(".", " lspace=\"0\" rspace=\"0\"")};
    if (std::string_view("+/:;!?*|@`").find(c) != std::string_view::npos)
      return {operation(std::string(1, c), c == '|' ? " stretchy=\"false\"" : "")};
    throw Unknown{};
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
      return {single(operation("(") +
                     html_element("mfrac linethickness=\"0\"", above + single(argument())) +
                     operation(")"))};
    }
    if (name == "sqrt") return root();
    if (name == "left") return fenced();
    if (name == "begin") return environment();
    if (name == "text" || name == "textrm") return {html_element("mtext", html_escape(text()))};
    if (name == "operatorname") return {word(letters(), " mathvariant=\"normal\"")};
    if (name == "mathrm") return {word(letters(), " mathvariant=\"normal\"")};
    if (name == "mathit") return {word(letters(), " class=\"word\"")};
    if (name == "mathbf") return {html_element("mrow class=\"bold\"", argument())};
    if (name == "mathbb") return {word(double_struck(letters()), "")};
    if (const std::string_view sign = accent(name); !sign.empty())
      return {html_element("mover accent=\"true\"", single(argument()) + operation(sign))};
    return sign(symbol(name));
  }

  static Atom sign(const Symbol& found) {
    switch (found.kind) {
      case Symbol::Kind::identifier:
        return {word(found.text, "")};
      case Symbol::Kind::function:
        return {word(found.text, " mathvariant=\"normal\"")};
      case Symbol::Kind::limits:
        return {found.text.size() == 3 && !is_letter(found.text[0])
                    ? operation(found.text, " movablelimits=\"false\"")
                    : word(found.text, " mathvariant=\"normal\""),
                true};
      case Symbol::Kind::operation:
        return {operation(found.text)};
      case Symbol::Kind::breaking:
        return {operation(found.text, " form=\"infix\""), false, true};
      case Symbol::Kind::fence:
        return {operation(found.text, " stretchy=\"false\"")};
      case Symbol::Kind::punctuation:
        return {operation(found.text)};
      case Symbol::Kind::blank:
        return {"<mspace width=\"" + std::string(found.text) + "\"/>"};
      case Symbol::Kind::nothing:
        return {};
      case Symbol::Kind::may_end:
        return {"", false, true};
      case Symbol::Kind::none:
        break;
    }
    throw Unknown{};
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
      return operation(std::string(1, c), " stretchy=\"true\" fence=\"true\"");
    if (c != '\\') throw Unknown{};
    const Symbol found = symbol(name());
    if (found.kind != Symbol::Kind::fence) throw Unknown{};
    return operation(found.text, " stretchy=\"true\" fence=\"true\"");
  }

  Atom fenced() {
    const std::string open = fence();
    const std::string inside = row("\\right");
    return {single(open + inside + fence())};
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
      return Atom{single(operation(open) + table + operation(close))};
    };
    if (kind == "pmatrix") return between("(", ")");
    if (kind == "bmatrix") return between("[", "]");
    if (kind == "vmatrix") return between("|", "|");
    if (kind == "cases") return {single(operation("{") + table)};
    return {table};
  }

  std::string rows(const std::string& end) {
    if (++depth_ > deepest) throw Unknown{};
    std::string all, cells, cell;
    const auto end_cell = [&] {
      cells += html_element("mtd", cell);
      cell.clear();
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
        cell += scripted().xml;
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
