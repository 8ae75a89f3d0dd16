// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::report {

/// What is left to read of a formula, and the words in it that hold no mathematics.
class MathmlCursor {
 public:
  struct Unknown {};  ///< thrown at what is not in the subset

 protected:
  explicit MathmlCursor(std::string_view latex) : rest_(latex) {}

  bool at(std::string_view text) const { return rest_.starts_with(text); }
  bool take(std::string_view text);
  char next();
  void skip_blanks();

  /// The name of a command: letters, or one other sign.
  std::string_view name();

  /// Letters, digits and a few signs between braces.
  std::string letters();

  /// What stands between the braces of `\\text`, as plain text.
  std::string text();

  static bool is_letter(char);
  static bool is_digit(char);

  std::string_view rest_;

 private:
  std::string written(std::string_view name);
};

}  // namespace seam::report
