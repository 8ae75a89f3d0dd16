// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/figure.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "report/drawing.h"
#include "report/escape.h"
#include "report/mathematics.h"
#include "report/style.h"

// Thousands of facets by way of TikZ take TeX seconds. So each is a call of one macro with nine
// numbers, which go to the page as they are (the system layer of PGF).

namespace seam::report {
namespace {

constexpr const char* facet_macro =
    "\\makeatletter\\def\\SeamFacet#1 #2 #3 #4 #5 #6 #7 #8 #9 {\\pgfsys@color@rgb{#1}{#2}{#3}"
    "\\pgfsys@moveto{#4bp}{#5bp}\\pgfsys@lineto{#6bp}{#7bp}\\pgfsys@lineto{#8bp}{#9bp}"
    "\\pgfsys@closepath\\pgfsys@fillstroke}\\makeatother\n";

std::string number(double x, const char* format) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, x);
  return buffer.data();
}

std::string length(double x) {
  return number(std::round(100 * x) / 100 + 0.0, "%.4g");
}

std::string channel(double x) {
  return number(std::round(1000 * x) / 1000 + 0.0, "%.3g");
}

std::string place(const Drawing::Place& at) {
  return "(" + length(at[0]) + "," + length(at[1]) + ")";
}

std::string rgb(const Colour& c) {
  return channel(c[0]) + "," + channel(c[1]) + "," + channel(c[2]);
}

class Writer {
 public:
  std::string operator()(const Drawing::Polygon& polygon) const {
    const auto& corners = polygon.corners;
    std::string result;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      result += "\\SeamFacet ";
      for (const double x : polygon.fill) result += channel(x) + " ";
      for (const auto& [x, y] : {corners[0], corners[i], corners[i + 1]})
        result += length(x) + " " + length(y) + " ";
      result += "\n";
    }
    return result;
  }
  std::string operator()(const Drawing::Stroke& stroke) const {
    const StrokeStyle style = style_of(stroke.kind);
    std::string result = "\\definecolor{SeamStroke}{rgb}{" + rgb(style.colour) +
                         "}\\draw[SeamStroke,line width=" + length(style.width) + "bp] ";
    for (const Drawing::Place& at : stroke.points)
      result += (&at == stroke.points.data() ? "" : "--") + place(at);
    return result + ";\n";
  }
  std::string operator()(const Drawing::Mark& mark) const {
    return "\\draw[red!75!black,line width=1.5bp] " + place(mark.at) +
           " circle[radius=4bp] node[right=6bp,inner sep=1bp,fill=white,font=\\scriptsize] {" +
           escape(mark.label) + "};\n";
  }
  std::string operator()(const Drawing::Text& text) const {
    using Anchor = Drawing::Text::Anchor;
    const char* anchor = text.anchor == Anchor::left    ? "base west"
                         : text.anchor == Anchor::right ? "base east"
                                                        : "base";
    return "\\node[inner sep=0pt,anchor=" + std::string(anchor) + ",font=\\scriptsize] at " +
           place(text.at) + " {" +
           (text.latex.empty() ? escape(text.text) : "$" + mathematics(text.latex) + "$") +
           "};\n";
  }
};

std::string tikz(const Drawing& drawn) {
  std::string result = facet_macro +
                       ("\\begin{tikzpicture}[x=1bp,y=1bp,line join=round,line cap=round,"
                        "line width=0.4bp]\n\\useasboundingbox (0,0) rectangle " +
                        place({drawn.width, drawn.height})) +
                       ";\n";
  const Writer writer;
  bool in_facets = false;  // whose colours are kept in a group
  for (const Drawing::Part& part : drawn.parts) {
    const bool facet = std::holds_alternative<Drawing::Polygon>(part);
    if (facet != in_facets) result += facet ? "\\begin{scope}\n" : "\\end{scope}\n";
    in_facets = facet;
    result += std::visit(writer, part);
  }
  return result + (in_facets ? "\\end{scope}\n" : "") + "\\end{tikzpicture}";
}

}  // namespace

std::string picture(const FigureRun& figure) {
  const Drawing drawn = drawing(figure);
  if (drawn.parts.empty()) return "";
  return "\\begin{center}" + tikz(drawn) + "\\end{center}\n";
}

std::string page(const FigureRun& figure) {
  const Drawing drawn = drawing(figure);
  return "\\documentclass{article}\n\\pdfinfoomitdate=1 \\pdfsuppressptexinfo=-1 "
         "\\pdftrailerid{}\n\\usepackage[T1]{fontenc}\n\\usepackage[utf8]{inputenc}\n"
         "\\usepackage{lmodern,amsmath,amssymb,tikz}\n" +
         std::string(style) + "\\begin{document}\n\\pdfpagewidth=" + length(drawn.width) +
         "bp \\pdfpageheight=" + length(drawn.height) +
         "bp \\pdfhorigin=0pt \\pdfvorigin=0pt\n\\shipout\\hbox{" + tikz(drawn) +
         "}\n\\end{document}\n";
}

}  // namespace seam::report
