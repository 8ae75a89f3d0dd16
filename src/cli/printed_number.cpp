// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/printed_number.h"

#include <algorithm>
#include <array>
#include <string>

// First each command and sign becomes one character (`*` before a power of ten, `_` for digits
// that go on), and what prints nothing goes; then the rest has to read as one number.

namespace seam::cli {
namespace {

constexpr int longest_exponent = 6;  // digits

struct Spelling {
  std::string_view latex, meaning;
};
// Longer ones first.
constexpr std::array spellings = {Spelling{"\\thinspace", ""}, Spelling{"\\ensuremath", ""},
                                  Spelling{"\\mathrm", ""},    Spelling{"\\mathbf", ""},
                                  Spelling{"\\textrm", ""},    Spelling{"\\textbf", ""},
                                  Spelling{"\\cdots", "_"},    Spelling{"\\ldots", "_"},
                                  Spelling{"\\dots", "_"},     Spelling{"\\times", "*"},
                                  Spelling{"\\cdot", "*"},     Spelling{"\\text", ""},
                                  Spelling{"\\num", ""},       Spelling{"\\,", ""},
                                  Spelling{"\\;", ""},         Spelling{"\\:", ""},
                                  Spelling{"\\!", ""},         Spelling{"\\ ", ""},
                                  Spelling{"...", "_"},        Spelling{"…", "_"},
                                  Spelling{"×", "*"},          Spelling{"·", "*"},
                                  Spelling{"−", "-"},          Spelling{"~", ""},
                                  Spelling{" ", ""},           Spelling{"\n", ""},
                                  Spelling{"\t", ""},          Spelling{"\r", ""},
                                  Spelling{"E", "e"}};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::optional<std::string> spelled_out(std::string_view latex) {
  std::string result;
  while (!latex.empty()) {
    const auto* found = std::ranges::find_if(
        spellings, [&](const Spelling& s) { return latex.starts_with(s.latex); });
    if (found != spellings.end()) {
      result += found->meaning;
      latex.remove_prefix(found->latex.size());
      // `\timesx` is another command.
      if (is_letter(found->latex.back()) && found->latex.front() == '\\' && !latex.empty() &&
          is_letter(latex.front()))
        return std::nullopt;
    } else if (std::string_view("0123456789.+-*^e{}").find(latex.front()) !=
               std::string_view::npos) {
      result += latex.front();
      latex.remove_prefix(1);
    } else {
      return std::nullopt;
    }
  }
  return result;
}

class Reading {
 public:
  explicit Reading(std::string_view text) : rest_(text) {}

  std::optional<claims::PrintedNumber> number() {
    claims::PrintedNumber result;
    skip_braces();
    result.negative = take('-');
    if (!result.negative) take('+');
    skip_braces();
    result.digits = digits();
    const bool starts = !result.digits.empty();
    if (take('.')) {
      const std::string after = digits();
      if (!starts && after.empty()) return std::nullopt;
      result.digits = (starts ? result.digits : "0") + (after.empty() ? "" : "." + after);
    } else if (!starts) {
      return std::nullopt;
    }
    result.truncated = take('_');
    const bool power = take('*');
    if (power && !(take('1') && take('0') && take('^'))) return std::nullopt;
    if (power || take('e')) {
      const auto found = exponent(power);
      if (!found) return std::nullopt;
      result.exponent = *found;
    }
    skip_braces();
    if (!rest_.empty()) return std::nullopt;
    return result;
  }

 private:
  bool take(char c) {
    skip_braces();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    if (c != '^' && c != 'e') skip_braces();
    return true;
  }

  void skip_braces() {
    while (rest_.starts_with('{') || rest_.starts_with('}')) rest_.remove_prefix(1);
  }

  std::string digits() {
    std::string result;
    for (skip_braces(); !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9';
         skip_braces()) {
      result += rest_.front();
      rest_.remove_prefix(1);
    }
    return result;
  }

  // In braces; without them a power is one digit, and after an e there are any.
  std::optional<int> exponent(bool is_power) {
    std::string_view found = rest_;
    if (rest_.starts_with('{')) {
      found = rest_.substr(1, rest_.find('}') - 1);
      rest_.remove_prefix(std::min(found.size() + 2, rest_.size()));
    } else {
      found = found.substr(0, is_power ? 1 : found.find('}'));
      rest_.remove_prefix(found.size());
    }
    const bool negative = found.starts_with('-');
    if (negative || found.starts_with('+')) found.remove_prefix(1);
    if (found.empty() || found.size() > longest_exponent ||
        found.find_first_not_of("0123456789") != std::string_view::npos)
      return std::nullopt;
    const int size = std::stoi(std::string(found));
    return negative ? -size : size;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<claims::PrintedNumber> printed_number(std::string_view latex) {
  const auto text = spelled_out(latex);
  return text ? Reading(*text).number() : std::nullopt;
}

}  // namespace seam::cli
