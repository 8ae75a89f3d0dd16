// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml_signs.h"

#include "report/html_escape.h"
#include "report/mathml_symbols.h"

namespace seam::report {
namespace {

using Atom = MathmlAtom;
using Space = Atom::Space;

// Of a fence that does not say whether it opens or closes.
constexpr const char* bar = " stretchy=\"false\" lspace=\"0\" rspace=\"0\"";

}  // namespace

std::string mathml_operator(std::string_view sign, const char* attributes) {
  return html_element("mo" + std::string(attributes), html_escape(sign));
}

std::string mathml_identifier(std::string_view name, const char* attributes) {
  return html_element("mi" + std::string(attributes), html_escape(name));
}

std::optional<MathmlAtom> mathml_sign(char c) {
  const std::string sign(1, c);
  switch (c) {
    case '~':
      return Atom{"<mspace width=\"0.3em\"/>", Space::blank};
    case '-':
      return Atom{mathml_operator("−"), Space::sign};
    case '+':
      return Atom{mathml_operator("+"), Space::sign};
    case '(':
    case '[':
      return Atom{mathml_operator(sign, " stretchy=\"false\""), Space::open};
    case ')':
    case ']':
      return Atom{mathml_operator(sign, " stretchy=\"false\""), Space::close};
    case '=':
    case '<':
    case '>':
      return Atom{mathml_operator(sign, " form=\"infix\""), Space::relation, false, true};
    case '.':
      return Atom{mathml_operator(sign, " lspace=\"0\" rspace=\"0\"")};
    case '|':
      return Atom{mathml_operator(sign, bar)};
    case '!':
      return Atom{mathml_operator(sign), Space::close};
    case ',':
    case ';':
    case ':':
      return Atom{mathml_operator(sign), Space::punctuation};
    case '/':
    case '*':
    case '?':
    case '@':
    case '`':
      return Atom{mathml_operator(sign), Space::relation};
    default:
      return std::nullopt;
  }
}

std::optional<MathmlAtom> mathml_command(std::string_view name) {
  const Symbol found = symbol(name);
  switch (found.kind) {
    case Symbol::Kind::identifier:
      return Atom{mathml_identifier(found.text, "")};
    case Symbol::Kind::upright:
      return Atom{mathml_identifier(found.text, " mathvariant=\"normal\"")};
    case Symbol::Kind::function:
      return Atom{mathml_identifier(found.text, " mathvariant=\"normal\""), Space::function};
    case Symbol::Kind::limits:
      return Atom{found.text.size() == 3 && static_cast<unsigned char>(found.text[0]) >= 0x80
                      ? mathml_operator(found.text, " movablelimits=\"false\"")
                      : mathml_identifier(found.text, " mathvariant=\"normal\""),
                  Space::function, true};
    case Symbol::Kind::sign:
      return Atom{mathml_operator(found.text), Space::sign};
    case Symbol::Kind::operation:
      return Atom{mathml_operator(found.text), Space::relation};
    case Symbol::Kind::breaking:
      return Atom{mathml_operator(found.text, " form=\"infix\""), Space::relation, false, true};
    case Symbol::Kind::open:
      return Atom{mathml_operator(found.text, " form=\"prefix\" stretchy=\"false\""),
                  Space::open};
    case Symbol::Kind::close:
      return Atom{mathml_operator(found.text, " form=\"postfix\" stretchy=\"false\""),
                  Space::close};
    case Symbol::Kind::fence:
      return Atom{mathml_operator(found.text, bar)};
    case Symbol::Kind::punctuation:
      return Atom{mathml_operator(found.text), Space::punctuation};
    case Symbol::Kind::blank:
      return Atom{"<mspace width=\"" + std::string(found.text) + "\"/>", Space::blank};
    case Symbol::Kind::nothing:
      return Atom{};
    case Symbol::Kind::may_end:
      return Atom{"", Space::blank, false, true};
    case Symbol::Kind::none:
      break;
  }
  return std::nullopt;
}

}  // namespace seam::report
