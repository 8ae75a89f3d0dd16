// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/meaning.h"

#include <algorithm>
#include <map>

#include "claims/item_reader.h"
#include "claims/state.h"
#include "claims/stating.h"

// What may take long is done in steps with limits: the value of each definition, each
// statement, each question. One that takes more is left undone; what rests on it says so.

namespace seam::claims {
namespace {

// Each item has one place, and so a name of its own.
std::string place_name(const text::Span& where) {
  return where.source->name + ":" + std::to_string(where.begin);
}

}  // namespace

void Reader::within_limits(const text::Span& where, const std::string& part,
                           const std::string& subject, const std::function<void()>& step) {
  if (const auto refusal = limits_(place_name(where) + part, step))
    throw Unsupported("reading " + subject + ": " + refusal->detail, refusal->reason);
}

std::string Reader::defined(const Item& item, const std::string& name) {
  return "'" + name + "' in line " +
         std::to_string(text::position(*item.span.source, item.span.begin).line);
}

void Reader::read(const Item& item) {
  switch (item.kind) {
    case Item::Kind::paper:
      meaning_.paper = item.name;
      meaning_.by = item.by;
      meaning_.source = item.source;
      meaning_.year = item.year;
      return;
    case Item::Kind::section:
      meaning_.items.push_back(MeantSection{item.name});
      return;
    case Item::Kind::include:
      include(item);
      return;
    case Item::Kind::let:
    case Item::Kind::sequence:
    case Item::Kind::define:
    case Item::Kind::root:
      define(item);
      return;
    case Item::Kind::param:
      define_param(item);
      return;
    case Item::Kind::claim:
      claim(item);
      return;
    case Item::Kind::table:
      table(item);
      return;
    case Item::Kind::figure:
      figure(item);
      return;
    case Item::Kind::ask: {
      add_id(item.name, item.name_span);
      const int digits = item.option.empty() ? 12 : std::stoi(item.option.substr(0, 6));
      try {
        meaning_.items.push_back(question(item.name, item.expressions[0], digits));
      } catch (const Problem& problem) {
        report(problem.diagnostic);
      } catch (const Broken&) {
      }
      return;
    }
  }
}

void Reader::include(const Item& item) {
  if (!included_.insert(item.name).second) return;
  const auto source = open_(item.name);
  if (!source) {
    report({item.name_span, "cannot include \"" + item.name + "\"",
            "only files at or below this file's folder can be included"});
    return;
  }
  const Parsed parsed = parse(source);
  meaning_.errors.insert(meaning_.errors.end(), parsed.errors.begin(), parsed.errors.end());
  read(parsed.file);
}

void Reader::define(const Item& item) {
  meaning_.items.push_back(MeantDefinition{item});
  if (evaluator_.globals.contains(item.name)) {
    report({item.name_span, "'" + item.name + "' is defined already", "choose another name"});
    return;
  }
  if (is_taken(item.name)) {
    report({item.name_span, "'" + item.name + "' is a word of the language",
            "choose another name"});
    evaluator_.globals[item.name].broken = true;
    return;
  }
  Definition definition{&item, {}, {}, false, {}};
  const bool is_function = item.kind == Item::Kind::define || !item.parameters.empty();
  if (item.kind == Item::Kind::sequence) {
    begin(definition);
  } else if (!is_function) {
    evaluator_.sides.clear();
    try {
      within_limits(item.span, "", defined(item, item.name), [&] {
        definition.value = item.kind == Item::Kind::root
                               ? root(item)
                               : evaluator_.evaluate(item.expressions[0], Scope{});
      });
      definition.sides = evaluator_.sides;
    } catch (const Problem& problem) {
      report(problem.diagnostic);
      definition.broken = true;
    } catch (const IntegerMet&) {
      definition.holds_integers = true;
    } catch (const Unsupported& unsupported) {
      definition.unsupported = unsupported.what();
      definition.reason = unsupported.reason;
    } catch (const symbolic::NumberLimit& limit) {
      definition.unsupported = limit.what();
    } catch (const Broken&) {
      definition.broken = true;
    }
  }
  evaluator_.globals.insert_or_assign(item.name, std::move(definition));
}

// The first two values of a sequence show whether it can be worked out.
void Reader::begin(Definition& definition) {
  const Item& item = *definition.item;
  evaluator_.globals.insert_or_assign(item.name, definition);
  try {
    within_limits(item.span, "", defined(item, item.name),
                  [&] { sequence_value(evaluator_, item, Scalar(1), item.expressions[1]); });
  } catch (const Problem& problem) {
    report(problem.diagnostic);
    definition.broken = true;
  } catch (const IntegerMet&) {
    definition.unsupported = "a sequence whose start or step holds an integer parameter";
  } catch (const Unsupported& unsupported) {
    definition.unsupported = unsupported.what();
    definition.reason = unsupported.reason;
  } catch (const Broken&) {
    definition.broken = true;
  }
}

Value Reader::root(const Item& item) {
  const Expression& range = item.expressions[1];
  const symbolic::Simplex interval = evaluator_.continuous_set(range, {"~"}, Scope{});
  const auto low = meaning_.numbers->rational(interval.corners[0][1]);
  const auto high = meaning_.numbers->rational(interval.corners[1][1]);
  if (!low || !high || interval.corners[1][0].is(0))
    fail(range, "expected an interval with rational ends");
  const std::string symbol = evaluator_.bind(item.name);
  Scope scope;
  scope.values[item.name] = {Scalar(Formula::symbol(symbol))};
  const Formula polynomial = as_formula(
      evaluator_, evaluator_.evaluate(item.expressions[0], scope), item.expressions[0]);
  evaluator_.release(symbol);
  for (const std::string& v : symbolic::variables(polynomial))
    if (v != symbol)
      fail(item.expressions[0], "a root of a polynomial with the parameter '" + v + "'");
  for (const std::size_t end : {0U, 1U}) {
    const Formula at_end =
        symbolic::subst(polynomial, {{symbol, Formula(end == 0 ? *low : *high)}});
    if (interval.open[1 - end] && meaning_.numbers->sign(at_end) == exact::Sign::zero)
      fail(range, "the polynomial has a root at an end that is left out", "choose another end");
  }
  try {
    return {Scalar(meaning_.numbers->root(polynomial, symbol, *low, *high))};
  } catch (const symbolic::NumberError& error) {
    fail(item.expressions[0], error.what());
  }
}

Lowered Reader::lower(const Expression& statement, const Scope& scope,
                      const std::string& part) {
  Lowered result;
  try {
    within_limits(statement.span, part, "it", [&] {
      const Stated stated = state(evaluator_, statement, scope);
      result.exported = exported(stated, *meaning_.numbers);
      result.predicates = stated.predicates;
    });
  } catch (const Unsupported& unsupported) {
    result.unsupported = unsupported.what();
    result.reason = unsupported.reason;
  } catch (const symbolic::NumberLimit& limit) {
    result.unsupported = limit.what();
  } catch (const symbolic::NumberError& error) {
    report({statement.span, error.what(), {}});
  } catch (const symbolic::FormulaLimit& error) {
    report({statement.span, error.what(), {}});
  }
  return result;
}

MeantClaim Reader::meant(const Claim& claim, const Scope& scope, text::Span span) {
  MeantClaim result{
      claim, {}, std::move(span), lower(claim.statement, scope, " of " + claim.id), {}};
  if (claim.corrected)
    result.corrected = lower(*claim.corrected, scope, " of " + claim.id + ".corrected");
  return result;
}

void Reader::add_id(const std::string& id, const text::Span& where) {
  const auto [known, fresh] = ids_.emplace(id, where);
  if (fresh) return;
  const auto first = text::position(*known->second.source, known->second.begin);
  report({where, "the id '" + id + "' is used twice",
          "the first is in line " + std::to_string(first.line) +
              (id.ends_with(".corrected") ? "; the correction of a claim 'a' is 'a.corrected'"
                                          : "")});
}

void Reader::add_ids(const Claim& claim, const text::Span& where) {
  add_id(claim.id, where);
  if (claim.corrected) add_id(claim.id + ".corrected", where);
}

void Reader::claim(const Item& item) {
  add_ids(item.claim, item.name_span);
  try {
    MeantClaim result = meant(item.claim, Scope{}, item.name_span);
    result.comments = item.comments;
    meaning_.items.push_back(std::move(result));
  } catch (const Problem& problem) {
    report(problem.diagnostic);
  } catch (const Broken&) {
  }
}

Meaning mean(const File& file, const Opener& open, const Limits& limits) {
  Meaning meaning;
  meaning.numbers = std::make_shared<Numbers>();
  Reader reader(meaning, open, limits);
  reader.read(file);
  reader.check_using();
  return meaning;
}

MeantAsk mean_question(const File& file, const Opener& open, const Expression& expression,
                       int digits, std::vector<text::Diagnostic>& errors,
                       const Limits& limits) {
  Meaning meaning;
  meaning.numbers = std::make_shared<Numbers>();
  Reader reader(meaning, open, limits);
  reader.read(file);
  errors = std::move(meaning.errors);
  if (!errors.empty()) return {};
  try {
    return reader.question("ask", expression, digits);
  } catch (const Problem& problem) {
    errors.push_back(problem.diagnostic);
  } catch (const Broken&) {
  }
  return {};
}

}  // namespace seam::claims
