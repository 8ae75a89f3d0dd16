// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claims/value.h"

namespace seam::claims {

class Evaluator;

/// What the integer parameters of a file stand for at present: a number, or any integer of a
/// range, as a symbol for a real number of that range.
struct Integers {
  /// An integer that is not known: `first`, and all beyond it, upwards or downwards; without
  /// `first` any at all.
  struct General {
    std::optional<long> first;
    bool upward = true;
  };
  struct Kept {
    Value value;
    std::vector<symbolic::Proposition> sides;
  };

  std::map<std::string, const Item*> known;  ///< the parameters, by their symbols
  std::map<std::string, Scalar> values;      ///< numbers, or symbols with a shift
  std::map<std::string, General> general;    ///< those of them that are symbols
  long room = 1000;                          ///< how many values may be tried, one by one
  std::set<const Item*> stepping;            ///< sequences of which a step is being taken
  bool relaxed = false;  ///< parameters without a value stand for all integers they may be
  /// Values of sequences and sums that are not known, and what is known of them.
  std::set<std::string> opaque;
  std::map<std::string, Scalar> replaced;
  std::map<std::string, Kept> lets;                            ///< evaluated with these values
  std::map<std::pair<const Item*, std::string>, Value> steps;  ///< of sequences
};

/// Other values for integer parameters, as long as it lives.
class Assigned {
 public:
  Assigned(Evaluator&, const std::string& parameter, Scalar value);
  ~Assigned();
  Assigned(const Assigned&) = delete;
  Assigned& operator=(const Assigned&) = delete;

 private:
  Evaluator& evaluator_;
  Integers before_;
  std::size_t parameters_;
};

/// An integer that may be given as `parameter + shift`.
struct Index {
  std::string parameter;  ///< empty: a number
  long shift = 0;
};
std::optional<Index> as_index(Evaluator&, const Scalar&);

/// Makes the parameter any integer from `first` on, for as long as the present `Assigned`
/// lives.
void generalise(Evaluator&, const std::string& parameter, Integers::General);

/// Whether a general integer, or an unknown value of a sequence or a sum, stands in it.
bool holds_integer(const Evaluator&, const Scalar&);

/// The value of an integer parameter; throws `IntegerMet` where it has none.
Scalar integer_value(Evaluator&, const std::string& parameter);

/// base^exponent, where the exponent is a sum of multiples of integer parameters; nothing if it
/// is no such sum.
std::optional<Scalar> integer_power(Evaluator&, const Scalar& base, const Scalar& exponent);

/// The integers that a parameter may be, as far as its set and its condition bound it; `rest`
/// is what they say besides, of the parameter's symbol. What they say of `others` too, further
/// names of the same item without a value, is left to the range of these.
struct IntegerRange {
  std::optional<long> low, high;
  std::vector<symbolic::Constraint> rest;
  std::set<std::string> others;
};
IntegerRange integer_range(Evaluator&, const std::string& parameter);

}  // namespace seam::claims
