// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "claims/evaluate.h"
#include "claims/function_type.h"
#include "claims/limits.h"
#include "claims/meaning.h"
#include "symbolic/proposition.h"

namespace seam::claims {

/// Whether the language has this name already.
bool is_taken(const std::string& name);

/// Reads the items of a file, one after the other, into a meaning.
class Reader {
 public:
  Reader(Meaning& meaning, const Opener& open, const Limits& limits)
      : meaning_(meaning), open_(open), limits_(limits), evaluator_(*meaning.numbers) {}

  void read(const File& file) {
    for (const Item& item : file.items) {
      items_.push_back(std::make_unique<Item>(item));
      read(*items_.back());
    }
  }

  /// What the expression of a claim, a question or a definition stands in: of a cell of a table
  /// the value of its column, and what that rests on; of all others nothing.
  struct Place {
    Scope scope;
    std::vector<symbolic::Proposition> standing;
  };
  const Place& place(const std::string& id) const;

  /// A statement in such a place.
  Lowered lower(const Expression& statement, const Place&);
  /// What the number seems to be. Throws `Unsupported` where none is found.
  std::string likely_decimal(const Expression& number, const Place&, int digits);
  /// Whether the name is defined as a number.
  bool defines_number(const std::string& name) const;

  void check_using();
  MeantAsk question(const std::string& id, const Expression&, int digits);

 private:
  void read(const Item& item);
  void include(const Item& item);
  void define(const Item& item);
  void begin(Definition& sequence);
  void define_param(const Item& item);
  Definition parameter(const Item& item, const std::string& name);
  void set_condition(const Item& item);
  std::optional<Value> arbitrary_function(const std::string& name, const FunctionType&,
                                          const Item&);
  Value root(const Item& item);
  void claim(const Item& item);
  void table(const Item& item);
  void figure(const Item& item);
  void show(MeantFigure&, const Expression& shown);
  MeantFigure::Functions functions(const Expression& each, Scope&);
  MeantFigure::Colour colour(const MeantFigure&, const Expression&, const Scope&);
  MeantClaim meant(const Claim& claim, const Scope& scope, text::Span span);
  Lowered lower(const Expression& statement, const Scope& scope, const std::string& part);
  void answer(MeantAsk&, const Formula& number, const std::string& decimal, int digits);
  void enclose(MeantAsk&, const Extremum&, int digits);
  /// Does it, or throws `Unsupported` with the reason why it is left undone. `part` tells the
  /// steps at one place apart.
  void within_limits(const text::Span& where, const std::string& part,
                     const std::string& subject, const std::function<void()>& step);
  static std::string defined(const Item&, const std::string& name);
  void report(text::Diagnostic d) { meaning_.errors.push_back(std::move(d)); }
  void add_id(const std::string& id, const text::Span& where);
  void add_ids(const Claim&, const text::Span& where);  ///< and that of its correction

  Meaning& meaning_;
  const Opener& open_;
  const Limits& limits_;
  Evaluator evaluator_;
  std::vector<std::unique_ptr<Item>> items_;  // functions refer to them
  std::set<std::string> included_;
  std::map<std::string, text::Span> ids_;
  std::map<std::string, Place> places_;  // of cells
};

}  // namespace seam::claims
