// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathematics.h"

#include <string>
#include <vector>

#include "report/escape.h"

namespace seam::report {
namespace {

using namespace std::string_view_literals;

// Words between blanks.
constexpr std::string_view commands =
    " Big Bigl Bigr Delta Gamma Lambda Leftarrow Leftrightarrow Omega Phi Pi Psi "
    "Rightarrow Sigma Theta Upsilon Vert Xi allowbreak alpha angle approx arccos arcsin "
    "arctan ast backslash bar beta big bigl bigr bigwedge binom bmod bullet cap cdot "
    "cdots chi circ colon cong cos cosh cot csc cup dbinom deg delta det dfrac "
    "displaystyle dot dots dotsb dotsc ell emptyset epsilon equiv eta exists exp forall "
    "frac gamma gcd ge geq hat iff iint implies in infty int iota kappa lVert lambda land "
    "langle lbrace lbrack lceil ldots le leftarrow leq lfloor lim limits ln lnot log "
    "longmapsto longrightarrow lor lvert mapsto mathbb mathbf mathcal mathit mathrm "
    "mathsf mathtt max mid min mod mp mu nabla ne neg neq nobreakspace nolimits not notin "
    "nu oint omega operatorname overline parallel partial perp phi pi pm pmod prime prod "
    "psi qquad quad rVert rangle rbrace rbrack rceil rfloor rho rightarrow rvert "
    "scriptstyle sec setminus sigma sim simeq sin sinh sqrt square star subset subseteq "
    "subsetneq substack sum supseteq tan tanh tau text textasciicircum textasciitilde "
    "textbackslash textbf textit textrm textsc textsf textstyle textsuperscript texttt "
    "tfrac theta thinspace tilde times to top triangle underline upsilon varepsilon "
    "varnothing varphi varrho varsigma vartheta vdots vec vee vert wedge widehat xi zeta ";
constexpr std::string_view environments =
    " aligned array bmatrix cases gathered matrix pmatrix smallmatrix split vmatrix ";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool among(std::string_view words, std::string_view word) {
  return words.find(" " + std::string(word) + " ") != std::string_view::npos;
}

// Reads a formula from left to right and keeps what is open.
class Reader {
 public:
  explicit Reader(std::string_view latex) : rest_(latex) {}

  bool is_plain() {
    while (!rest_.empty())
      if (!step()) return false;
    return open_.empty();
  }

 private:
  bool step() {
    const char c = take();
    if (c == '\\') return command();
    if (c == '{') return open("{");
    if (c == '}') return close("{");
    if (c == '&') return !open_.empty() && open_.back() != "{" && open_.back() != "left";
    if (c == '^' && rest_.starts_with('^')) return false;  // ^^5c is a backslash to TeX
    return c == '\n' ||
           (c >= ' ' && c < '\x7F' && c != '$' && c != '%' && c != '#' && c != '"');
  }

  bool command() {
    if (rest_.empty()) return false;
    if (!is_letter(rest_.front()))
      return ",;:! \\{}|_%&#$"sv.find(take()) != std::string_view::npos;
    const std::string_view name = word();
    if (name == "left") return open("left");
    if (name == "right") return close("left");
    if (name == "middle") return !open_.empty() && open_.back() == "left";
    if (name == "begin") return environment() && open(name_);
    if (name == "end") return environment() && close(name_);
    return among(commands, name);
  }

  // `{name}` of an environment that is known.
  bool environment() {
    if (rest_.empty() || take() != '{') return false;
    name_ = word();
    return !rest_.empty() && take() == '}' && among(environments, name_);
  }

  bool open(std::string_view what) {
    open_.push_back(what);
    return true;
  }

  bool close(std::string_view what) {
    if (open_.empty() || open_.back() != what) return false;
    open_.pop_back();
    return true;
  }

  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  std::string_view word() {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view result = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return result;
  }

  std::string_view rest_, name_;
  std::vector<std::string_view> open_;
};

}  // namespace

bool is_plain_mathematics(std::string_view latex) {
  return Reader(latex).is_plain();
}

std::string mathematics(std::string_view latex) {
  if (is_plain_mathematics(latex)) return std::string(latex);
  return "\\text{" + escape(latex) + "}";
}

}  // namespace seam::report
