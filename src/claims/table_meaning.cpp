// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/ids.h"
#include "claims/item_reader.h"

// A cell of a table is a claim: the expression of its row for the value of its column, compared
// with what is printed. Where the values of the columns take too long, there are as many
// columns as values in the first row, and each cell says why it was not read.

namespace seam::claims {
void Reader::table(const Item& item) {
  MeantTable result{item.claim, item.comments, item.labels, {}};
  result.heading.id = item.claim.id.empty() ? item.name : item.claim.id;
  evaluator_.sides.clear();
  try {
    std::vector<Value> columns = {Value{Scalar(0)}};
    std::string variable;
    std::optional<Lowered> unread;
    if (!item.columns.empty()) {
      const Expression& binding = item.columns[0];
      std::optional<std::vector<Value>> set;
      try {
        within_limits(item.span, "", "the columns", [&] {
          if (set_of(binding) && !condition_of(binding))
            set = evaluator_.finite_set(*set_of(binding), Scope{});
        });
      } catch (const Unsupported& unsupported) {
        if (unsupported.reason == "unsupported" || item.rows.empty()) throw;
        unread = Lowered{std::nullopt, unsupported.what(), unsupported.reason, {}};
        set.emplace(item.rows.front().printed.size(), Value{Scalar(0)});
      }
      if (!set || set->empty()) fail(binding, "a table runs over a finite set");
      columns = *set;
      evaluator_.standing = evaluator_.sides;
      variable = binding.children[0].children[0].text;
    }
    if (!item.labels.empty() && item.labels.size() != columns.size())
      report({item.name_span,
              "expected " + std::to_string(columns.size()) + " labels, found " +
                  std::to_string(item.labels.size()),
              {}});
    for (std::size_t r = 0; r < item.rows.size(); ++r) {
      const Item::Row& row = item.rows[r];
      MeantTable::Row meant_row{row.label, row.value, {}};
      if (row.printed.size() != columns.size())
        fail(row.value, "this row has " + std::to_string(row.printed.size()) +
                            " printed values, expected " + std::to_string(columns.size()));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        Scope scope;
        if (!variable.empty()) scope.values[variable] = columns[k];
        Claim cell;
        const Named named = claims::cell(item, r, k);
        cell.id = named.id;
        cell.title = named.title;
        cell.at = item.claim.at;
        const auto compared = [&](const Expression& printed) -> Expression {
          Expression rounded{
              Expression::Kind::relation, "~", {row.value, printed}, row.value.span};
          if (!row.truncated) return rounded;
          return {Expression::Kind::truncated, {}, {std::move(rounded)}, row.value.span};
        };
        cell.statement = compared(row.printed[k]);
        if (const auto right = row.corrected.find(k); right != row.corrected.end())
          cell.corrected = compared(right->second);
        add_ids(cell, row.value.span);
        places_[cell.id] = {scope, evaluator_.standing};
        try {
          meant_row.cells.push_back(unread ? MeantClaim{cell,
                                                        {},
                                                        row.printed[k].span,
                                                        *unread,
                                                        cell.corrected ? unread : std::nullopt}
                                           : meant(cell, scope, row.printed[k].span));
        } catch (const Problem& problem) {
          report(problem.diagnostic);
        } catch (const Broken&) {
        }
      }
      result.rows.push_back(std::move(meant_row));
    }
  } catch (const Problem& problem) {
    report(problem.diagnostic);
  } catch (const Unsupported& unsupported) {
    report(
        {item.name_span, std::string("the columns of this table: ") + unsupported.what(), {}});
  } catch (const symbolic::NumberLimit& limit) {
    report({item.name_span, std::string("the columns of this table: ") + limit.what(), {}});
  } catch (const Broken&) {
  }
  evaluator_.standing.clear();
  meaning_.items.push_back(std::move(result));
}

}  // namespace seam::claims
