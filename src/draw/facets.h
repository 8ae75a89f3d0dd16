// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "draw/rounded_patch.h"
#include "report/run.h"

// What drawings of patches, meshes and functions are made of.
namespace seam::draw {

/// A value to colour by, at a point of a sheet.
using Colouring = std::function<double(const Jet&, double u, double v)>;

/// A piece of a surface over the triangle or the unit square.
struct Sheet {
  RoundedPatch::Shape shape = RoundedPatch::Shape::triangle;
  std::function<Jet(double u, double v)> jet;
};

/// Two faces with a common edge; `alike` if both have their outside on the same side of it.
struct Neighbours {
  int face = 0, other = 0;
  bool alike = true;
};

/// Facets of a figure by the face (patch, polygon) that they are cut from: no two faces share
/// points.
class Facets {
 public:
  explicit Facets(report::FigureRun& figure) : figure_(figure) {}

  /// Begins the next face; what follows belongs to it.
  void begin_face();
  int point(const Vector& at, const Vector& normal);
  void triangle(int a, int b, int c) { figure_.triangles.push_back({a, b, c}); }

  /// A face that is a sheet, each side of its domain cut into so many parts.
  void add(const Sheet&, int cuts, const Colouring&);

  /// Turns faces alike where they are neighbours, and outwards where they close up: there the
  /// signed volume is positive. `has_free_edge`: by face. Whether all close up is left in the
  /// figure.
  void turn(const std::vector<Neighbours>&, const std::vector<bool>& has_free_edge);

 private:
  struct First {
    std::size_t point, triangle;
  };
  void turn(std::size_t face);
  double volume(std::size_t face) const;
  First end(std::size_t face) const;

  report::FigureRun& figure_;
  std::vector<First> faces_;
};

/// How often to cut the sides of each of so many sheets.
int cuts_of(std::size_t sheets, RoundedPatch::Shape);

/// A side of a domain as a line of samples; sides are numbered from 1 as those of a patch.
report::FigureRun::Line side_line(const Sheet&, int side, int cuts,
                                  report::FigureRun::Line::Kind);

/// Adds a sentence to the note of a figure, unless it is there.
void note(report::FigureRun&, const std::string& sentence);

/// Leaves out facets and pieces of lines where something has no value that can be drawn.
void leave_out_undefined(report::FigureRun&);

}  // namespace seam::draw
