// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/similarity.h"

#include <algorithm>
#include <utility>

#include "geometry/frame.h"
#include "geometry/nearness.h"
#include "geometry/shape_moments.h"

// A similarity carries the control points of a patch to those of its image, hence all control
// points of one surface (every patch raised to one degree) to those of the other, their centre
// to the centre, and the sum of the squared distances from it is multiplied by scale^2. That
// gives shift and scale. The rest is orthogonal, known from the images of two control points
// that are not parallel, and all pairs are tried. So the search misses no similarity, except of
// surfaces that lie on one line, which it does not find.

namespace seam::geometry {
namespace {

using symbolic::Relation;
using symbolic::Sign;
using symbolic::Zero;

// A surface about its centre.
struct Centred {
  std::vector<Patch> patches;  // all of one degree
  std::vector<Point> points;   // the control points of all patches
  Point centre;
};

Centred centred(const Surface& s, int degree, Numbers& numbers) {
  Centred result;
  for (const Patch& patch : s.patches) {
    result.patches.push_back(elevate(patch, degree));
    for (const auto& row : result.patches.back().rows())
      result.points.insert(result.points.end(), row.begin(), row.end());
  }
  result.centre = centroid(result.points, numbers);
  const auto shifted = [&](const Point& x) { return normal_form(x - result.centre, numbers); };
  for (Patch& patch : result.patches) patch = map(patch, shifted);
  for (Point& point : result.points) point = shifted(point);
  return result;
}

int degree(const Surface& s) {
  int result = 0;
  for (const Patch& patch : s.patches)
    result = std::max({result, patch.degree_u(), patch.degree_v()});
  return result;
}

struct Pair {
  Centred s, t;
};

Pair centred(const Surface& s, const Surface& t, Numbers& numbers) {
  const int common = std::max(degree(s), degree(t));
  return {centred(s, common, numbers), centred(t, common, numbers)};
}

using Matching = std::vector<std::pair<Patch, Patch>>;  // a patch of s, its image in t

// Each patch with the one it is carried to, if that uses up all patches.
std::optional<Matching> match(const Pair& pair, const Formula& scale, const Matrix& m,
                              const Numbers& numbers) {
  std::vector<Patch> left = pair.t.patches;
  Matching result;
  for (const Patch& patch : pair.s.patches) {
    const Patch image =
        map(patch, [&](const Point& x) { return normal_form(scale * (m * x), numbers); });
    bool found = false;
    for (std::size_t k = 0; k < left.size() && !found; ++k)
      if (auto like = parametrised_like(image, left[k], numbers)) {
        result.emplace_back(patch, std::move(*like));
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
        found = true;
      }
    if (!found) return std::nullopt;
  }
  return left.empty() ? std::optional(result) : std::nullopt;
}

struct Found {
  Similarity similarity;
  Matching matching;  // of the centred patches
};

std::optional<Found> find(const Pair& pair, Numbers& numbers) {
  const auto frame = Frame::of(distinct(pair.s.points, numbers), numbers);
  if (!frame) return std::nullopt;
  const Formula from = moments(pair.s.points)[0].value, to = moments(pair.t.points)[0].value;
  if (is_zero(to, numbers)) return std::nullopt;
  const Formula scale = numbers.sqrt(to * numbers.inverse(from));
  const Formula shrink = numbers.inverse(scale);
  std::vector<Point> points = distinct(pair.t.points, numbers);
  for (Point& x : points) x = normal_form(shrink * x, numbers);

  for (const auto& [i, j] : frame->images(points, numbers)) {
    for (const bool mirrored : {false, true}) {
      const Matrix m = frame->carry(points[i], points[j], mirrored, numbers);
      if (auto matching = match(pair, scale, m, numbers)) {
        const Point shift = normal_form(pair.t.centre - scale * (m * pair.s.centre), numbers);
        return Found{{scale, m, shift}, std::move(*matching)};
      }
    }
  }
  return std::nullopt;
}

std::optional<Moment> disagreement(const Pair& pair, bool scaled, const Numbers& numbers) {
  const long patches = std::ssize(pair.s.patches) - std::ssize(pair.t.patches);
  if (patches != 0) return Moment{"number of patches", patches, 0};
  const long points = std::ssize(pair.s.points) - std::ssize(pair.t.points);
  if (points != 0) return Moment{"number of control points", points, 0};
  const auto of_s = moments(pair.s.points), of_t = moments(pair.t.points);
  for (std::size_t k = 0; k < of_s.size(); ++k) {
    const int order = scaled ? of_s[k].degree / 2 : 0;
    const Formula difference = of_s[k].value * power(of_t[0].value, order) -
                               of_t[k].value * power(of_s[0].value, order);
    if (!is_zero(difference, numbers)) return Moment{of_s[k].name, difference, 0};
  }
  return std::nullopt;
}

std::string text(const Similarity& map) {
  const auto list = [](const Point& point) {
    std::string result;
    for (const Formula& x : point) result += (result.empty() ? "" : ", ") + symbolic::text(x);
    return result;
  };
  std::string rows;
  for (const Point& row : map.matrix.rows) rows += (rows.empty() ? "" : "; ") + list(row);
  return "x -> " + symbolic::text(map.scale) + " * [" + rows + "] * x + (" + list(map.shift) +
         ")";
}

Proposition vanishes(const Point& vector, const std::string& about) {
  std::vector<Proposition> parts;
  for (const Formula& x : vector) parts.push_back(atom(Zero{x}, about));
  return all(std::move(parts));
}

Proposition stated(const Found& found, const Pair& pair) {
  const auto& [scale, m, shift] = found.similarity;
  std::vector<Proposition> parts{
      atom(Sign{scale, Relation::positive, {}}, text(found.similarity) + ", of positive scale"),
      vanishes(scale * (m * pair.s.centre) + shift - pair.t.centre, "centre to centre")};
  const Matrix product = transpose(m) * m, unit = identity(3);
  for (int row = 0; row < 3; ++row)
    parts.push_back(vanishes(product.rows[row] - unit.rows[row], "the matrix is orthogonal"));
  for (const auto& [patch, image] : found.matching)
    for (std::size_t j = 0; j < patch.rows().size(); ++j)
      for (std::size_t i = 0; i < patch.rows()[j].size(); ++i)
        parts.push_back(vanishes(scale * (m * patch.rows()[j][i]) - image.rows()[j][i],
                                 "every patch is carried to a patch"));
  return all(std::move(parts));
}

// Without a similarity and without a moment that disagrees, the search alone speaks.
Proposition compared(const Surface& s, const Surface& t, bool scaled, Numbers& numbers) {
  const Pair pair = centred(s, t, numbers);
  if (const auto moment = disagreement(pair, scaled, numbers))
    return atom(Zero{moment->value}, "equal, as a similarity asks: " + moment->name);
  if (const auto found = find(pair, numbers)) return stated(*found, pair);
  return symbolic::falsehood();
}

}  // namespace

std::optional<Similarity> find_similarity(const Surface& s, const Surface& t,
                                          Numbers& numbers) {
  const Pair pair = centred(s, t, numbers);
  if (disagreement(pair, true, numbers)) return std::nullopt;
  const auto found = find(pair, numbers);
  return found ? std::optional(found->similarity) : std::nullopt;
}

Proposition similar(const Surface& s, const Surface& t, Numbers& numbers) {
  return compared(s, t, true, numbers);
}

Proposition congruent(const Surface& s, const Surface& t, Numbers& numbers) {
  return compared(s, t, false, numbers);
}

}  // namespace seam::geometry
