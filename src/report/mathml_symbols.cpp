// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml_symbols.h"

#include <algorithm>
#include <array>

namespace seam::report {
namespace {

using Kind = Symbol::Kind;

struct Entry {
  std::string_view command;
  Kind kind;
  std::string_view text;
};

constexpr std::array entries = {
    // letters
    Entry{"alpha", Kind::identifier, "α"},
    Entry{"beta", Kind::identifier, "β"},
    Entry{"gamma", Kind::identifier, "γ"},
    Entry{"delta", Kind::identifier, "δ"},
    Entry{"epsilon", Kind::identifier, "ϵ"},
    Entry{"varepsilon", Kind::identifier, "ε"},
    Entry{"zeta", Kind::identifier, "ζ"},
    Entry{"eta", Kind::identifier, "η"},
    Entry{"theta", Kind::identifier, "θ"},
    Entry{"vartheta", Kind::identifier, "ϑ"},
    Entry{"iota", Kind::identifier, "ι"},
    Entry{"kappa", Kind::identifier, "κ"},
    Entry{"lambda", Kind::identifier, "λ"},
    Entry{"mu", Kind::identifier, "μ"},
    Entry{"nu", Kind::identifier, "ν"},
    Entry{"xi", Kind::identifier, "ξ"},
    Entry{"pi", Kind::identifier, "π"},
    Entry{"rho", Kind::identifier, "ρ"},
    Entry{"varrho", Kind::identifier, "ϱ"},
    Entry{"sigma", Kind::identifier, "σ"},
    Entry{"varsigma", Kind::identifier, "ς"},
    Entry{"tau", Kind::identifier, "τ"},
    Entry{"upsilon", Kind::identifier, "υ"},
    Entry{"phi", Kind::identifier, "ϕ"},
    Entry{"varphi", Kind::identifier, "φ"},
    Entry{"chi", Kind::identifier, "χ"},
    Entry{"psi", Kind::identifier, "ψ"},
    Entry{"omega", Kind::identifier, "ω"},
    Entry{"Gamma", Kind::upright, "Γ"},
    Entry{"Delta", Kind::upright, "Δ"},
    Entry{"Theta", Kind::upright, "Θ"},
    Entry{"Lambda", Kind::upright, "Λ"},
    Entry{"Xi", Kind::upright, "Ξ"},
    Entry{"Pi", Kind::upright, "Π"},
    Entry{"Sigma", Kind::upright, "Σ"},
    Entry{"Upsilon", Kind::upright, "Υ"},
    Entry{"Phi", Kind::upright, "Φ"},
    Entry{"Psi", Kind::upright, "Ψ"},
    Entry{"Omega", Kind::upright, "Ω"},
    Entry{"ell", Kind::identifier, "ℓ"},
    Entry{"partial", Kind::upright, "∂"},
    Entry{"infty", Kind::upright, "∞"},
    Entry{"emptyset", Kind::upright, "∅"},
    Entry{"varnothing", Kind::upright, "∅"},
    Entry{"top", Kind::upright, "⊤"},
    Entry{"ldots", Kind::upright, "…"},
    Entry{"dots", Kind::upright, "…"},
    Entry{"dotsc", Kind::upright, "…"},
    Entry{"cdots", Kind::upright, "⋯"},
    Entry{"dotsb", Kind::upright, "⋯"},
    Entry{"vdots", Kind::upright, "⋮"},
    Entry{"bullet", Kind::upright, "•"},
    Entry{"prime", Kind::upright, "′"},
    Entry{"angle", Kind::upright, "∠"},
    Entry{"triangle", Kind::upright, "△"},
    Entry{"square", Kind::upright, "□"},
    Entry{"backslash", Kind::upright, "\\"},
    // names of functions
    Entry{"sin", Kind::function, "sin"},
    Entry{"cos", Kind::function, "cos"},
    Entry{"tan", Kind::function, "tan"},
    Entry{"cot", Kind::function, "cot"},
    Entry{"sec", Kind::function, "sec"},
    Entry{"csc", Kind::function, "csc"},
    Entry{"sinh", Kind::function, "sinh"},
    Entry{"cosh", Kind::function, "cosh"},
    Entry{"tanh", Kind::function, "tanh"},
    Entry{"arcsin", Kind::function, "arcsin"},
    Entry{"arccos", Kind::function, "arccos"},
    Entry{"arctan", Kind::function, "arctan"},
    Entry{"exp", Kind::function, "exp"},
    Entry{"log", Kind::function, "log"},
    Entry{"ln", Kind::function, "ln"},
    Entry{"det", Kind::function, "det"},
    Entry{"gcd", Kind::function, "gcd"},
    Entry{"deg", Kind::function, "deg"},
    Entry{"max", Kind::limits, "max"},
    Entry{"min", Kind::limits, "min"},
    Entry{"sup", Kind::limits, "sup"},
    Entry{"inf", Kind::limits, "inf"},
    Entry{"lim", Kind::limits, "lim"},
    Entry{"sum", Kind::limits, "∑"},
    Entry{"prod", Kind::limits, "∏"},
    Entry{"bigwedge", Kind::limits, "⋀"},
    Entry{"int", Kind::limits, "∫"},
    // operators and relations
    Entry{"cdot", Kind::operation, "⋅"},
    Entry{"times", Kind::operation, "×"},
    Entry{"pm", Kind::sign, "±"},
    Entry{"mp", Kind::sign, "∓"},
    Entry{"ast", Kind::operation, "∗"},
    Entry{"star", Kind::operation, "⋆"},
    Entry{"circ", Kind::operation, "∘"},
    Entry{"setminus", Kind::operation, "∖"},
    Entry{"cap", Kind::operation, "∩"},
    Entry{"cup", Kind::operation, "∪"},
    Entry{"in", Kind::operation, "∈"},
    Entry{"notin", Kind::operation, "∉"},
    Entry{"subset", Kind::operation, "⊂"},
    Entry{"subseteq", Kind::operation, "⊆"},
    Entry{"supseteq", Kind::operation, "⊇"},
    Entry{"to", Kind::operation, "→"},
    Entry{"rightarrow", Kind::operation, "→"},
    Entry{"leftarrow", Kind::operation, "←"},
    Entry{"mapsto", Kind::operation, "↦"},
    Entry{"mid", Kind::operation, "∣"},
    Entry{"perp", Kind::operation, "⊥"},
    Entry{"parallel", Kind::operation, "∥"},
    Entry{"sim", Kind::operation, "∼"},
    Entry{"simeq", Kind::operation, "≃"},
    Entry{"cong", Kind::operation, "≅"},
    Entry{"equiv", Kind::breaking, "≡"},
    Entry{"approx", Kind::breaking, "≈"},
    Entry{"le", Kind::breaking, "≤"},
    Entry{"leq", Kind::breaking, "≤"},
    Entry{"ge", Kind::breaking, "≥"},
    Entry{"geq", Kind::breaking, "≥"},
    Entry{"ne", Kind::breaking, "≠"},
    Entry{"neq", Kind::breaking, "≠"},
    Entry{"land", Kind::breaking, "∧"},
    Entry{"lor", Kind::breaking, "∨"},
    Entry{"implies", Kind::breaking, "⟹"},
    Entry{"Rightarrow", Kind::breaking, "⇒"},
    Entry{"iff", Kind::breaking, "⟺"},
    Entry{"Leftrightarrow", Kind::breaking, "⇔"},
    Entry{"forall", Kind::punctuation, "∀"},
    Entry{"exists", Kind::punctuation, "∃"},
    Entry{"lnot", Kind::punctuation, "¬"},
    Entry{"neg", Kind::punctuation, "¬"},
    Entry{"nabla", Kind::punctuation, "∇"},
    Entry{"colon", Kind::punctuation, ":"},
    // fences
    Entry{"lvert", Kind::open, "|"},
    Entry{"rvert", Kind::close, "|"},
    Entry{"lVert", Kind::open, "‖"},
    Entry{"rVert", Kind::close, "‖"},
    Entry{"vert", Kind::fence, "|"},
    Entry{"Vert", Kind::fence, "‖"},
    Entry{"langle", Kind::open, "⟨"},
    Entry{"rangle", Kind::close, "⟩"},
    Entry{"lfloor", Kind::open, "⌊"},
    Entry{"rfloor", Kind::close, "⌋"},
    Entry{"lceil", Kind::open, "⌈"},
    Entry{"rceil", Kind::close, "⌉"},
    Entry{"lbrace", Kind::open, "{"},
    Entry{"rbrace", Kind::close, "}"},
    Entry{"lbrack", Kind::open, "["},
    Entry{"rbrack", Kind::close, "]"},
    Entry{"{", Kind::open, "{"},
    Entry{"}", Kind::close, "}"},
    Entry{"|", Kind::fence, "‖"},
    // signs and blanks
    Entry{"_", Kind::punctuation, "_"},
    Entry{"%", Kind::punctuation, "%"},
    Entry{"#", Kind::punctuation, "#"},
    Entry{"$", Kind::punctuation, "$"},
    Entry{"&", Kind::punctuation, "&"},
    Entry{",", Kind::blank, "0.17em"},
    Entry{";", Kind::blank, "0.28em"},
    Entry{":", Kind::blank, "0.22em"},
    Entry{" ", Kind::blank, "0.3em"},
    Entry{"quad", Kind::blank, "1em"},
    Entry{"qquad", Kind::blank, "2em"},
    Entry{"thinspace", Kind::blank, "0.17em"},
    Entry{"nobreakspace", Kind::blank, "0.3em"},
    Entry{"!", Kind::nothing, ""},
    Entry{"big", Kind::nothing, ""},
    Entry{"bigl", Kind::nothing, ""},
    Entry{"bigr", Kind::nothing, ""},
    Entry{"displaystyle", Kind::nothing, ""},
    Entry{"textstyle", Kind::nothing, ""},
    Entry{"limits", Kind::nothing, ""},
    Entry{"nolimits", Kind::nothing, ""},
    Entry{"allowbreak", Kind::may_end, ""},
};

struct Accent {
  std::string_view command, sign;
};

constexpr std::array accents = {
    Accent{"hat", "^"},   Accent{"widehat", "^"}, Accent{"bar", "¯"}, Accent{"overline", "¯"},
    Accent{"tilde", "~"}, Accent{"vec", "→"},     Accent{"dot", "˙"},
};

}  // namespace

Symbol symbol(std::string_view command) {
  const auto* found = std::ranges::find(entries, command, &Entry::command);
  return found == entries.end() ? Symbol{} : Symbol{found->kind, found->text};
}

std::string_view accent(std::string_view command) {
  const auto* found = std::ranges::find(accents, command, &Accent::command);
  return found == accents.end() ? std::string_view() : found->sign;
}

}  // namespace seam::report
