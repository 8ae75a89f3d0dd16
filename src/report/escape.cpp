// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/escape.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace seam::report {
namespace {

struct Replacement {
  char32_t point;
  const char* latex;
};

constexpr std::array replacements = {
    Replacement{U'\\', "\\textbackslash{}"},
    Replacement{U'{', "\\{"},
    Replacement{U'}', "\\}"},
    Replacement{U'$', "\\$"},
    Replacement{U'&', "\\&"},
    Replacement{U'#', "\\#"},
    Replacement{U'%', "\\%"},
    Replacement{U'_', "\\_\\allowbreak{}"},
    Replacement{U'^', "\\textasciicircum{}"},
    Replacement{U'~', "\\textasciitilde{}"},
    Replacement{U'<', "\\textless{}"},
    Replacement{U'>', "\\textgreater{}"},
    Replacement{U'|', "\\textbar{}"},
    Replacement{U'"', "\\textquotedbl{}"},
    Replacement{U'\'', "\\textquotesingle{}"},
    Replacement{U'`', "\\textasciigrave{}"},
    Replacement{U'-', "-{}"},  // no ligature of two
    Replacement{U'\n', " "},
    Replacement{U'\t', " "},
    Replacement{U'\u00A0', "~"},
    Replacement{U'§', "\\S{}"},
    Replacement{U'°', "\\textdegree{}"},
    Replacement{U'±', "\\textpm{}"},
    Replacement{U'·', "\\textperiodcentered{}"},
    Replacement{U'×', "\\texttimes{}"},
    Replacement{U'÷', "\\textdiv{}"},
    Replacement{U'–', "\\textendash{}"},
    Replacement{U'—', "\\textemdash{}"},
    Replacement{U'‘', "\\textquoteleft{}"},
    Replacement{U'’', "\\textquoteright{}"},
    Replacement{U'“', "\\textquotedblleft{}"},
    Replacement{U'”', "\\textquotedblright{}"},
    Replacement{U'…', "\\ldots{}"},
    Replacement{U'α', "$\\alpha$"},
    Replacement{U'β', "$\\beta$"},
    Replacement{U'γ', "$\\gamma$"},
    Replacement{U'δ', "$\\delta$"},
    Replacement{U'ε', "$\\varepsilon$"},
    Replacement{U'ζ', "$\\zeta$"},
    Replacement{U'η', "$\\eta$"},
    Replacement{U'θ', "$\\theta$"},
    Replacement{U'κ', "$\\kappa$"},
    Replacement{U'λ', "$\\lambda$"},
    Replacement{U'μ', "$\\mu$"},
    Replacement{U'ν', "$\\nu$"},
    Replacement{U'ξ', "$\\xi$"},
    Replacement{U'π', "$\\pi$"},
    Replacement{U'ρ', "$\\rho$"},
    Replacement{U'σ', "$\\sigma$"},
    Replacement{U'τ', "$\\tau$"},
    Replacement{U'φ', "$\\varphi$"},
    Replacement{U'χ', "$\\chi$"},
    Replacement{U'ψ', "$\\psi$"},
    Replacement{U'ω', "$\\omega$"},
    Replacement{U'Γ', "$\\Gamma$"},
    Replacement{U'Δ', "$\\Delta$"},
    Replacement{U'Θ', "$\\Theta$"},
    Replacement{U'Λ', "$\\Lambda$"},
    Replacement{U'Π', "$\\Pi$"},
    Replacement{U'Σ', "$\\Sigma$"},
    Replacement{U'Φ', "$\\Phi$"},
    Replacement{U'Ψ', "$\\Psi$"},
    Replacement{U'Ω', "$\\Omega$"},
    Replacement{U'→', "$\\to$"},
    Replacement{U'←', "$\\leftarrow$"},
    Replacement{U'↦', "$\\mapsto$"},
    Replacement{U'⇒', "$\\Rightarrow$"},
    Replacement{U'⇔', "$\\Leftrightarrow$"},
    Replacement{U'∀', "$\\forall$"},
    Replacement{U'∃', "$\\exists$"},
    Replacement{U'∂', "$\\partial$"},
    Replacement{U'∈', "$\\in$"},
    Replacement{U'∑', "$\\sum$"},
    Replacement{U'−', "$-$"},
    Replacement{U'√', "$\\surd$"},
    Replacement{U'∞', "$\\infty$"},
    Replacement{U'∧', "$\\wedge$"},
    Replacement{U'∨', "$\\vee$"},
    Replacement{U'¬', "$\\neg$"},
    Replacement{U'≈', "$\\approx$"},
    Replacement{U'≠', "$\\neq$"},
    Replacement{U'≡', "$\\equiv$"},
    Replacement{U'≤', "$\\leq$"},
    Replacement{U'≥', "$\\geq$"},
    Replacement{U'²', "\\texttwosuperior{}"},
    Replacement{U'³', "\\textthreesuperior{}"},
    Replacement{U'¹', "\\textonesuperior{}"},
    Replacement{U'½', "\\textonehalf{}"},
    Replacement{U'¼', "\\textonequarter{}"},
    Replacement{U'¾', "\\textthreequarters{}"},
};

constexpr std::u32string_view plain =
    U"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:;!?()[]/*+=@";

// Accented letters that the input and font encodings of the report know.
bool is_latin_letter(char32_t point) {
  if (point == U'×' || point == U'÷') return false;
  return (point >= 0xC0 && point <= 0xFF) || point == U'ı' || point == U'Œ' || point == U'œ' ||
         std::u32string_view(U"ĂăĄąĆćČčĎďĘęĚěĞğĹĺŁłŃńŇňŐőŔŕŘřŚśŞşŠšŢţŤťŮůŰűŸŹźŻżŽž")
                 .find(point) != std::u32string_view::npos;
}

// Marks that stand over or under the letter before them, as accents of text and of mathematics.
struct Accent {
  char32_t mark;
  const char *text, *mathematics;  // empty: there is none
};

constexpr std::array accents = {
    Accent{0x0300, "`", "grave"}, Accent{0x0301, "'", "acute"}, Accent{0x0302, "^", "hat"},
    Accent{0x0303, "~", "tilde"}, Accent{0x0304, "=", "bar"},   Accent{0x0306, "u", "breve"},
    Accent{0x0307, ".", "dot"},   Accent{0x0308, "\"", "ddot"}, Accent{0x030A, "r", "mathring"},
    Accent{0x030B, "H", ""},      Accent{0x030C, "v", "check"}, Accent{0x0323, "d", ""},
    Accent{0x0327, "c", ""},      Accent{0x0328, "k", ""},      Accent{0x20D7, "", "vec"}};

std::string numbered(const char* format, unsigned value) {
  char buffer[24];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// One code point and the number of bytes it took; what is not UTF-8 is taken byte by byte.
struct Decoded {
  char32_t point = 0;
  std::size_t length = 1;
  bool valid = true;
};

Decoded decode(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  const Decoded broken{lead, 1, false};
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return broken;
  char32_t point = lead & (0xFF >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return broken;
    point = point << 6 | (byte & 0x3F);
  }
  const char32_t least = length == 4 ? 0x10000 : length == 3 ? 0x800 : 0x80;
  return point < least ? broken : Decoded{point, length, true};
}

std::string latex_of(const Decoded& decoded, std::string_view bytes) {
  if (!decoded.valid) return numbered("[byte %02X]", decoded.point);
  if (plain.find(decoded.point) != plain.npos) return std::string(bytes);
  const auto* found = std::ranges::find(replacements, decoded.point, &Replacement::point);
  if (found != replacements.end()) return found->latex;
  if (is_latin_letter(decoded.point)) return std::string(bytes);
  return numbered("[U+%04X]", decoded.point);
}

// A letter with the accent that follows it; nothing if there is no such sign.
std::string accented(char32_t letter, const Accent& accent) {
  const std::string text = accent.text, mathematics = accent.mathematics;
  const auto* greek = std::ranges::find(replacements, letter, &Replacement::point);
  if (greek != replacements.end()) {
    const std::string latex = greek->latex;
    const bool is_letter =
        (letter >= U'α' && letter <= U'ω') || (letter >= U'Γ' && letter <= U'Ω');
    if (!is_letter || mathematics.empty()) return "";
    return "$\\" + mathematics + "{" + latex.substr(1, latex.size() - 2) + "}$";
  }
  const bool is_plain_letter =
      (letter >= U'a' && letter <= U'z') || (letter >= U'A' && letter <= U'Z');
  if (!is_plain_letter) return "";
  const std::string base(1, static_cast<char>(letter));
  if (text.empty()) return "$\\" + mathematics + "{" + base + "}$";
  const bool loses_dot = !mathematics.empty() && (base == "i" || base == "j");
  return "\\" + text + "{" + (loses_dot ? "\\" : "") + base + "}";
}

// The letter at the beginning of a text together with the accent behind it, and how many bytes
// both take; 0 where there is none.
std::pair<std::string, std::size_t> accented_start(std::string_view text,
                                                   const Decoded& letter) {
  if (!letter.valid || text.size() == letter.length) return {"", 0};
  const Decoded mark = decode(text.substr(letter.length));
  const auto* accent = std::ranges::find(accents, mark.point, &Accent::mark);
  if (!mark.valid || accent == accents.end()) return {"", 0};
  std::string latex = accented(letter.point, *accent);
  const std::size_t length = latex.empty() ? 0 : letter.length + mark.length;
  return {std::move(latex), length};
}

}  // namespace

std::string escape(std::string_view text) {
  constexpr int longest_word = 16, width_of_number = 7;
  std::string result;
  int word = 0;
  while (!text.empty()) {
    const Decoded decoded = decode(text);
    const auto [letter, length] = accented_start(text, decoded);
    const std::string_view bytes = text.substr(0, length > 0 ? length : decoded.length);
    text.remove_prefix(bytes.size());
    const std::string printed = length > 0 ? letter : latex_of(decoded, bytes);
    result += printed;
    const bool is_number = printed.size() > 1 && printed.front() == '[';
    word = bytes == " " ? 0 : word + (is_number ? width_of_number : 1);
    if (word >= longest_word || bytes == "/" || bytes == "," || bytes == "*") {
      result += "\\allowbreak{}";
      word = 0;
    }
  }
  return result;
}

}  // namespace seam::report
