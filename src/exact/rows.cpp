// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rows.h"

#include <flint/fmpz_vec.h>

#include "exact/contract.h"
#include "exact/flint.h"

namespace seam::exact {

struct Rows::Block {
  fmpz* it;
  fmpz* sum;
  slong size, width;
  Block(slong s, slong w) : it(_fmpz_vec_init(s)), sum(_fmpz_vec_init(w)), size(s), width(w) {}
  ~Block() {
    _fmpz_vec_clear(it, size);
    _fmpz_vec_clear(sum, width);
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
};

Multiplier::Multiplier(const TowerPtr& tower, const Coordinates& number) : scalar_(number[0]) {
  for (std::size_t i = 1; i < number.size(); ++i) is_scalar_ = is_scalar_ && number[i] == 0;
  if (is_scalar_) return;
  const RingPtr ring = Ring::make(tower, {});
  const Polynomial x = ring->number(number);
  const int size = dimension(tower);
  for (int column = 0; column < size; ++column) {
    Coordinates unit(size);
    unit[column] = 1;
    const auto image = (x * ring->number(unit)).numerators();
    const Coordinates& c = image.terms.begin()->second;
    for (int row = 0; row < size; ++row)
      if (c[row] != 0) entries_.push_back({row, column, c[row]});
  }
}

Rows::Rows(TowerPtr tower, int count)
    : tower_(std::move(tower)),
      count_(count),
      width_(dimension(tower_)),
      block_(std::make_unique<Block>(static_cast<slong>(count) * width_, width_)) {}

Rows::~Rows() = default;

Rows::Rows(const Rows& other) : Rows(other.tower_, other.count_) {
  _fmpz_vec_set(block_->it, other.block_->it, block_->size);
}

Coordinates Rows::at(int index) const {
  Coordinates result;
  for (int i = 0; i < width_; ++i)
    result.push_back(flint::integer(block_->it + static_cast<slong>(index) * width_ + i));
  return result;
}

void Rows::set(int index, const Coordinates& number) {
  require(std::ssize(number) == width_, "Rows::set: wrong number of coordinates");
  for (int i = 0; i < width_; ++i)
    fmpz_set_mpz(block_->it + static_cast<slong>(index) * width_ + i, number[i].get_mpz_t());
}

Sign Rows::sign(int index) const {
  if (_fmpz_vec_is_zero(block_->it + static_cast<slong>(index) * width_, width_) != 0)
    return Sign::zero;
  return exact::sign(tower_, at(index));
}

Ball Rows::ball(int index) const {
  return exact::ball(tower_, at(index));
}

void Rows::combine(int target, const std::vector<Term>& terms) {
  fmpz* sum = block_->sum;
  _fmpz_vec_zero(sum, width_);
  flint::Fmpz value;
  for (const auto& [source, multiplier] : terms) {
    const fmpz* row = block_->it + static_cast<slong>(source) * width_;
    if (multiplier->is_scalar_) {
      fmpz_set_mpz(value.it, multiplier->scalar_.get_mpz_t());
      _fmpz_vec_scalar_addmul_fmpz(sum, row, width_, value.it);
    } else {
      for (const auto& entry : multiplier->entries_) {
        fmpz_set_mpz(value.it, entry.value.get_mpz_t());
        fmpz_addmul(sum + entry.row, value.it, row + entry.column);
      }
    }
  }
  _fmpz_vec_set(block_->it + static_cast<slong>(target) * width_, sum, width_);
}

}  // namespace seam::exact
