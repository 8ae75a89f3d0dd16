// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "claims/builtin.h"

namespace seam::claims {

/// A variable named by an argument, as `u` in diff(E, u): the symbol bound around the call, or
/// a new one.
class Variable {
 public:
  Variable(const Call& call, const Expression& at)
      : evaluator_(call.evaluator), scope_{&call.scope, {}} {
    if (at.kind != Expression::Kind::name) fail(at, "expected the name of a variable");
    for (const Scope* s = &call.scope; s; s = s->outer) {
      const auto found = s->values.find(at.text);
      if (found == s->values.end()) continue;
      adopt(found->second, at);
      return;
    }
    if (const auto found = call.evaluator.globals.find(at.text);
        found != call.evaluator.globals.end() && found->second.value) {
      adopt(*found->second.value, at);
      return;
    }
    symbol_ = evaluator_.bind(at.text);
    fresh_ = true;
    scope_.values[at.text] = {Scalar(Formula::symbol(symbol_))};
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (fresh_)
      evaluator_.release(symbol_);
    else
      evaluator_.varied.erase(evaluator_.varied.find(symbol_));
  }

  const std::string& symbol() const { return symbol_; }
  bool is_fresh() const { return fresh_; }
  const Scope& scope() const { return scope_; }

 private:
  void adopt(const Value& value, const Expression& at) {
    const auto* scalar = value.as<Scalar>();
    if (!scalar || scalar->numerator.kind() != Formula::Kind::symbol ||
        !scalar->is_polynomial())
      fail(at, "expected a variable, found " + description(value));
    symbol_ = scalar->numerator.name();
    if (evaluator_.hidden.contains(symbol_))
      throw Unsupported("'" + at.text +
                        "' as a variable, on which a sequence or a sum depends");
    evaluator_.varied.insert(symbol_);
  }

  Evaluator& evaluator_;
  Scope scope_;
  std::string symbol_;
  bool fresh_ = false;
};

}  // namespace seam::claims
