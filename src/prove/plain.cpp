// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/plain.h"

#include <algorithm>
#include <bit>

// At a point whose positive coordinates are exactly those of a face, the monomials of that face
// are positive and the others are 0. A larger face has the coefficients of a smaller one, so
// the smallest are enough, unless a condition takes a smaller one out of the domain; then all
// are looked at.

namespace seam::prove {

using bernstein::Form;
using certificate::Relation;
using exact::Sign;

namespace {

using Faces = std::vector<Corners>;  // of one factor

// Those inside the domain: all, or the smallest.
Faces faces_inside(const Factor& factor, const std::vector<CornerPtr>& corners, bool all) {
  Faces faces;
  for (int size = 1; size <= static_cast<int>(corners.size()); ++size)
    for (Corners face = 1; face < 1U << corners.size(); ++face) {
      if (std::popcount(face) != size) continue;
      if (!all && std::ranges::any_of(faces, [&](Corners f) { return (f & ~face) == 0; }))
        continue;
      Corners support = 0;
      for (std::size_t i = 0; i < corners.size(); ++i)
        if ((face >> i & 1U) != 0) support |= corners[i]->support;
      if (!is_outside(factor, support)) faces.push_back(face);
    }
  return faces;
}

bool lies_in(const bernstein::Shape& shape, int index, const std::vector<Corners>& face) {
  for (int k = 0; k < shape.factors(); ++k)
    if ((shape.support(index, k) & ~face[k]) != 0) return false;
  return true;
}

bool is_broken_inside(const Form& form, Relation relation, const std::vector<Corners>& face) {
  bool above = false, below = false;
  for (int i = 0; i < form.shape().count() && !(above && below); ++i) {
    if (!lies_in(form.shape(), i, face)) continue;
    const Sign s = form.sign(i);
    above = above || s == Sign::positive;
    below = below || s == Sign::negative;
  }
  if (above && below) return false;
  return !holds(relation, above ? Sign::positive : below ? Sign::negative : Sign::zero);
}

}  // namespace

bool is_plain(const Factors& factors, const Piece& piece, const Form& form, int side,
              bool strict, const std::vector<Condition>& where) {
  const auto against = side > 0 ? Form::Guess::negative : Form::Guess::positive;
  const auto wanted = side > 0 ? Sign::positive : Sign::negative;
  const int count = form.shape().count();
  for (int i = 0; i < count; ++i)
    if (form.guess(i) == against) return false;
  std::vector<int> right;  // coefficients of the wanted sign
  for (int i = 0; i < count; ++i) {
    const Sign s = form.sign(i);
    if (s == wanted)
      right.push_back(i);
    else if (s != Sign::zero)
      return false;
  }
  if (!strict) return true;

  std::vector<Faces> faces;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    faces.push_back(faces_inside(factors[k], piece.corners[k], !where.empty()));
    if (faces.back().empty()) return true;  // no point of the piece is in the domain
  }
  std::vector<std::size_t> choice(faces.size(), 0);
  for (;;) {
    std::vector<Corners> face;
    for (std::size_t k = 0; k < faces.size(); ++k) face.push_back(faces[k][choice[k]]);
    const bool is_met =
        std::ranges::any_of(right, [&](int i) { return lies_in(form.shape(), i, face); });
    bool is_excluded = is_met;
    for (std::size_t i = 0; !is_excluded && i < where.size(); ++i)
      is_excluded = is_broken_inside(piece.where[i], where[i].relation, face);
    if (!is_excluded) return false;
    std::size_t k = 0;
    while (k < choice.size() && ++choice[k] == faces[k].size()) choice[k++] = 0;
    if (k == choice.size()) return true;
  }
}

bool is_broken(const Factors& factors, const Piece& piece, const Form& form,
               Relation relation) {
  const auto plain = [&](int side, bool strict) {
    return is_plain(factors, piece, form, side, strict);
  };
  switch (relation) {
    case Relation::positive:
      return plain(-1, false);
    case Relation::nonnegative:
      return plain(-1, true);
    case Relation::zero:
      return plain(1, true) || plain(-1, true);
    case Relation::nonzero:
      return false;
    case Relation::nonpositive:
      return plain(1, true);
    case Relation::negative:
      return plain(1, false);
  }
  return false;
}

}  // namespace seam::prove
