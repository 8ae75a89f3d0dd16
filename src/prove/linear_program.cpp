// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/linear_program.h"

#include <algorithm>

// The simplex method in fractions. A first problem lets a further unknown t stand on the left
// of each row with the factor -1: it has a solution, and the rows alone have one where the
// least t is 0. Always the first column that improves is taken, and of the rows that bound it
// first the one whose unknown comes first (Bland's rule): no set of basic unknowns comes back,
// so it ends; the number of steps is bounded besides.

namespace seam::prove {
namespace {

using exact::Rational;
using Row = std::vector<Rational>;

constexpr int most_steps = 2000;

class Tableau {
 public:
  // Columns: the unknowns, t, one slack a row, the bound.
  Tableau(const std::vector<Row>& rows, const Row& bounds)
      : unknowns_(rows.front().size()), width_(unknowns_ + 1 + rows.size() + 1) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row row(width_);
      std::ranges::copy(rows[i], row.begin());
      row[unknowns_] = -1;
      row[unknowns_ + 1 + i] = 1;
      row.back() = bounds[i];
      rows_.push_back(std::move(row));
      basic_.push_back(unknowns_ + 1 + i);
    }
  }

  bool run() {
    const auto least = std::ranges::min_element(
        rows_, [](const Row& a, const Row& b) { return a.back() < b.back(); });
    if (least->back() < 0) {
      pivot(static_cast<std::size_t>(least - rows_.begin()), unknowns_);
      Row objective(width_);
      objective[unknowns_] = -1;
      if (!maximise(std::move(objective)) || value(unknowns_) != 0) return false;
      leave();
    }
    for (Row& row : rows_) row[unknowns_] = 0;  // t stays out
    Row objective(width_);
    objective[unknowns_ - 1] = 1;
    maximise(std::move(objective));
    return true;
  }

  Rational value(std::size_t column) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (basic_[i] == column) return rows_[i].back();
    return 0;
  }

 private:
  void pivot(std::size_t row, std::size_t column) {
    const Rational scale = 1 / rows_[row][column];
    for (Rational& entry : rows_[row])
      if (entry != 0) entry *= scale;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (i != row) eliminate(rows_[i], row, column);
    basic_[row] = column;
  }
  void eliminate(Row& target, std::size_t row, std::size_t column) const {
    const Rational factor = target[column];
    if (factor == 0) return;
    for (std::size_t j = 0; j < width_; ++j)
      if (rows_[row][j] != 0) target[j] -= factor * rows_[row][j];
  }

  // t is basic and 0: any other column takes its place.
  void leave() {
    const auto place = std::ranges::find(basic_, unknowns_);
    if (place == basic_.end()) return;
    const auto row = static_cast<std::size_t>(place - basic_.begin());
    for (std::size_t j = 0; j + 1 < width_; ++j)
      if (j != unknowns_ && rows_[row][j] != 0) return pivot(row, j);
  }

  // False where it has no bound, or steps ran out.
  bool maximise(Row objective) {
    for (std::size_t i = 0; i < rows_.size(); ++i) eliminate(objective, i, basic_[i]);
    for (int step = 0; step < most_steps; ++step) {
      std::size_t column = 0;
      while (column + 1 < width_ && objective[column] <= 0) ++column;
      if (column + 1 == width_) return true;
      std::optional<std::size_t> best;
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i][column] <= 0) continue;
        if (best) {
          const Rational left = rows_[i].back() * rows_[*best][column];
          const Rational right = rows_[*best].back() * rows_[i][column];
          if (left > right || (left == right && basic_[i] > basic_[*best])) continue;
        }
        best = i;
      }
      if (!best) return false;
      pivot(*best, column);
      eliminate(objective, *best, column);
    }
    return false;
  }

  std::size_t unknowns_, width_;
  std::vector<Row> rows_;
  std::vector<std::size_t> basic_;
};

}  // namespace

std::optional<std::vector<Rational>> linear_program(std::vector<Row> rows, Row bounds) {
  if (rows.empty() || rows.front().empty()) return std::nullopt;
  Tableau tableau(rows, bounds);
  if (!tableau.run()) return std::nullopt;
  std::vector<Rational> result;
  for (std::size_t j = 0; j < rows.front().size(); ++j) result.push_back(tableau.value(j));
  return result;
}

}  // namespace seam::prove
