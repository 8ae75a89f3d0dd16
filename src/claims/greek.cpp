// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/greek.h"

#include <algorithm>
#include <array>

#include "text/utf8.h"

// Letters that look the same and are meant the same, such as the micro sign and
// mu, or the two shapes of phi, are one name.

namespace seam::claims {
namespace {

struct Letter {
  char32_t code;
  std::string_view name;
};

constexpr std::array letters = {
    Letter{U'α', "alpha"},        Letter{U'β', "beta"},       Letter{U'γ', "gamma"},
    Letter{U'δ', "delta"},        Letter{U'ε', "epsilon"},    Letter{U'ζ', "zeta"},
    Letter{U'η', "eta"},          Letter{U'θ', "theta"},      Letter{U'ι', "iota"},
    Letter{U'κ', "kappa"},        Letter{U'λ', "lambda"},     Letter{U'μ', "mu"},
    Letter{U'ν', "nu"},           Letter{U'ξ', "xi"},         Letter{U'ο', "omicron"},
    Letter{U'π', "pi"},           Letter{U'ρ', "rho"},        Letter{U'σ', "sigma"},
    Letter{U'ς', "sigma"},        Letter{U'τ', "tau"},        Letter{U'υ', "upsilon"},
    Letter{U'φ', "phi"},          Letter{U'χ', "chi"},        Letter{U'ψ', "psi"},
    Letter{U'ω', "omega"},        Letter{U'Α', "Alpha"},      Letter{U'Β', "Beta"},
    Letter{U'Γ', "Gamma"},        Letter{U'Δ', "Delta"},      Letter{U'Ε', "Epsilon"},
    Letter{U'Ζ', "Zeta"},         Letter{U'Η', "Eta"},        Letter{U'Θ', "Theta"},
    Letter{U'Ι', "Iota"},         Letter{U'Κ', "Kappa"},      Letter{U'Λ', "Lambda"},
    Letter{U'Μ', "Mu"},           Letter{U'Ν', "Nu"},         Letter{U'Ξ', "Xi"},
    Letter{U'Ο', "Omicron"},      Letter{U'Π', "Pi"},         Letter{U'Ρ', "Rho"},
    Letter{U'Σ', "Sigma"},        Letter{U'Τ', "Tau"},        Letter{U'Υ', "Upsilon"},
    Letter{U'Φ', "Phi"},          Letter{U'Χ', "Chi"},        Letter{U'Ψ', "Psi"},
    Letter{U'Ω', "Omega"},        Letter{U'\u03D1', "theta"}, Letter{U'\u03D5', "phi"},
    Letter{U'\u03D6', "pi"},      Letter{U'\u03F0', "kappa"}, Letter{U'\u03F1', "rho"},
    Letter{U'\u03F5', "epsilon"}, Letter{U'\u00B5', "mu"},    Letter{U'\u2126', "Omega"},
    Letter{U'\u2206', "Delta"},
};

}  // namespace

std::string_view greek_name(char32_t code) {
  const auto* found = std::ranges::find(letters, code, &Letter::code);
  return found == letters.end() ? std::string_view{} : found->name;
}

bool is_greek_name(std::string_view name) {
  return std::ranges::find(letters, name, &Letter::name) != letters.end();
}

std::string spelled_out(std::string_view name) {
  std::string out;
  for (std::size_t at = 0; at < name.size();) {
    const text::CodePoint point = text::decode(name, at);
    const std::size_t length = point.length == 0 ? 1 : point.length;
    const std::string_view greek =
        point.value < 0x80 ? std::string_view{} : greek_name(point.value);
    out += greek.empty() ? name.substr(at, length) : greek;
    at += length;
  }
  return out;
}

}  // namespace seam::claims
