// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "claims/meaning.h"

namespace seam::claims {

class Reader;

/// A number as somebody prints it: `-0.2857`, `1.58…` (truncated), `1.5·10^-3`.
struct PrintedNumber {
  std::string digits;  ///< `0.2857`, without a sign
  bool negative = false;
  bool truncated = false;
  int exponent = 0;  ///< the power of ten that the digits are multiplied by

  int places() const;  ///< digits after the point
};

/// The digits of `0.25`, `-0.25`, if the expression is such a number.
std::optional<PrintedNumber> printed_number(const Expression&);
std::string text(const PrintedNumber&);

/// The numbers that a file names, for statements about them that are not in it. Names are, in
/// this order where one means several things: of a question its id; of a cell of a table its
/// id; of a claim `E = F` (or `~`, `<` ...) its id for E, `id.right` for F, `id.corrected` for
/// the right side of its correction; and what `let` and `root` define. `.value` and `.left`
/// after an id change nothing.
class NamedNumbers {
 public:
  NamedNumbers(const File&, const Opener&, const Limits& = no_limits);
  ~NamedNumbers();
  NamedNumbers(const NamedNumbers&) = delete;
  NamedNumbers& operator=(const NamedNumbers&) = delete;

  /// Those of the file; if there are any, no name is known.
  const std::vector<text::Diagnostic>& errors() const { return meaning_.errors; }

  bool knows(const std::string& name) const { return find(name) != nullptr; }
  std::vector<std::string> names() const;
  /// Of all claims and cells, whether they compare numbers or not.
  std::vector<std::string> claim_ids() const;

  /// That the named number is printed so: `E ~ 0.2857`, as written and as obligations. Throws
  /// `Unsupported` where the name has no number.
  struct Statement {
    Expression written;
    Lowered lowered;
  };
  Statement printed_as(const std::string& name, const PrintedNumber&);

  /// What the named number seems to be, with so many digits after the point: for a statement to
  /// confirm. Nothing if it cannot be found.
  std::optional<PrintedNumber> likely(const std::string& name, int places, bool truncated);

 private:
  struct Named {
    std::string id;  ///< where it stands
    Expression value;
  };
  const Named* find(const std::string& name) const;

  Meaning meaning_;
  Opener open_;
  Limits limits_;
  std::unique_ptr<Reader> reader_;
  std::map<std::string, Named> named_;
};

}  // namespace seam::claims
