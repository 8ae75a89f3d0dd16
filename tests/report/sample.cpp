// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.h"

#include <cmath>
#include <numbers>

namespace seam::report {
namespace {

using Status = ObligationRun::Status;

ClaimRun smooth() {
  ClaimRun claim;
  claim.id = "icosahedral.smooth";
  claim.title = "the transition is tangent continuous";
  claim.at = "§6";
  claim.printed.latex =
      "\\text{for all } u\\colon\\quad D_2 p(u,0) + D_2 q(u,0) = \\bigl(s\\,(1-u) + "
      "(2-s)\\,u\\bigr)"
      "\\, D_1 p(u,0)";
  claim.printed.verdict = Verdict::proven;
  claim.printed.method = {"normal form"};
  for (int i = 0; i < 3; ++i)
    claim.printed.obligations.push_back({"equal coordinates", "zero",
                                         "3 s (1-u)^3 - 3 (2-s) u (1-u)^2 + s^2 - 5 = 0", "",
                                         false, Status::holds, "the normal form is 0"});
  claim.printed.certificate = "certificates/icosahedral.smooth.json";
  claim.seconds = 0.012;
  return claim;
}

ClaimRun misprint() {
  ClaimRun claim;
  claim.id = "tetrahedral.smooth";
  claim.title = "the identity for the tetrahedral surface";
  claim.at = "§3, p. 4";
  claim.comments = {"The print has 2 - u where the net gives 2(1 - u);",
                    "a factor 2 was lost."};
  claim.printed.latex = "D_2 p(u,0) + D_2 q(u,0) = (2-u)\\, D_1 p(u,0)";
  claim.printed.verdict = Verdict::refuted;
  claim.printed.witness = "u = 0: (0, 0, -144) != (0, 0, 0)";
  claim.printed.method = {"normal form", "evaluation"};
  claim.printed.obligations = {
      {"first coordinate", "zero", "0 = 0", "", false, Status::holds, "the normal form is 0"},
      {"third coordinate", "zero", "", "-144*(1 - u)^2 = 0", false, Status::fails,
       "-144 at u = 0"}};
  claim.printed.certificate = "certificates/tetrahedral.smooth.json";
  claim.corrected = claim.printed;
  claim.corrected->latex = "D_2 p(u,0) + D_2 q(u,0) = 2(1-u)\\, D_1 p(u,0)";
  claim.corrected->verdict = Verdict::proven;
  claim.corrected->witness.clear();
  claim.corrected->obligations = {
      {"", "zero", "", "", false, Status::holds, "the normal form is 0"}};
  claim.corrected->certificate = "certificates/tetrahedral.smooth.corrected.json";
  claim.expected = Verdict::refuted;
  return claim;
}

ClaimRun convex() {
  ClaimRun claim;
  claim.id = "S.convex";
  claim.title = "the surface bounds a convex body";
  claim.printed.latex = "\\mathrm{convex}(S)";
  claim.printed.verdict = Verdict::proven;
  claim.printed.method = {"subdivision", "normal form", "count"};
  claim.predicates = {"convex", "G1", "closed", "regular"};
  for (int i = 0; i < 30; ++i)
    claim.printed.obligations.push_back({"equal tangent planes along a seam", "zero", "", "",
                                         false, Status::holds, "the normal form is 0"});
  for (int i = 0; i < 20; ++i)
    claim.printed.obligations.push_back(
        {"Gauss curvature is positive", "sign",
         "f(u,v) > 0 \\quad\\text{on } u, v \\ge 0,\\ u + v \\le 1", "", false, Status::holds,
         "subdivision, " + std::to_string(i % 6 + 1) + " pieces"});
  claim.printed.obligations.push_back({"the patches close up", "gluing",
                                       "V - E + F = 2, \\quad V = 12, E = 30, F = 20", "",
                                       false, Status::holds, "counted"});
  claim.printed.obligations.push_back(
      {"", "sign", "\\sqrt{5} \\ne 0", "", true, Status::holds, "enclosure"});
  claim.printed.obligations[35].slack = {"0.0123", "0.0125", "u = 1/2, v = 0",
                                         "the difference of the sides", ""};
  claim.printed.obligations[36].slack = {"", "", "", "", "its formula is long"};
  claim.using_claims = {"icosahedral.smooth", "lemma_1"};
  claim.printed.certificate = "certificates/S.convex.json";
  return claim;
}

std::string net(int rows) {
  std::string latex = "\\begin{bmatrix}";
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < 9; ++j)
      latex += (j ? " & " : "") + std::string("\\tfrac{12") + std::to_string(i * 9 + j) +
               "}{7}\\sqrt{5} + 381";
    latex += "\\\\";
  }
  return latex + "\\end{bmatrix}";
}

ClaimRun wide() {
  ClaimRun claim;
  claim.id = "D-matrix:1";
  claim.title = "a matrix that is wider than the page";
  claim.at = "(7)";
  claim.printed.latex = "\\mathrm{columns}(M) = " + net(4);
  claim.printed.verdict = Verdict::undecided;
  claim.printed.reason = "effort";
  claim.printed.detail = "20000 pieces and no end";
  claim.printed.obligations = {{"", "sign", "", "", false, Status::open, "20000 pieces"}};
  return claim;
}

ClaimRun breakable() {
  ClaimRun claim;
  claim.id = "sum";
  claim.title = "a formula of several lines, of which the third holds on a condition";
  claim.printed.latex = "0";
  for (int i = 1; i < 30; ++i)
    claim.printed.latex +=
        " + \\frac{" + std::to_string(i) + "\\,u^{" + std::to_string(i) + "}(1-u)}{\\sqrt{5}}";
  claim.printed.latex += " = (0, 1, 2)";
  claim.printed.verdict = Verdict::conditional;
  claim.printed.detail = "rests on lemma_1, which is undecided";
  return claim;
}

ClaimRun hostile() {
  ClaimRun claim;
  claim.id = "hostile_#1";
  claim.title =
      "\\input{/etc/passwd} \\write18{rm} 100% $x$ {a} ~ ^^5c & # _ <\"quoted\"> 汉 \xFF é ß";
  claim.comments = {"\\end{document} % comment", "γ ≤ √2, Bézier, Gauß, α → β, \u0007 \t tab"};
  claim.printed.latex = "\\input{/etc/passwd}";
  claim.printed.verdict = Verdict::refuted;
  claim.printed.witness = std::string(400, '7') + "/" + std::string(120, 'x');
  claim.printed.alarm = "coefficient 3 of piece 12 is negative";
  claim.printed.certificate = "certificates/" + std::string(90, 'a') + ".json";
  return claim;
}

ClaimRun cell(const std::string& id, Verdict verdict) {
  ClaimRun claim;
  claim.id = id;
  claim.printed.latex = "\\max_{(u,v) \\in \\triangle} K(u,v) \\approx 3.24";
  claim.printed.verdict = verdict;
  if (verdict == Verdict::refuted) {
    claim.printed.witness = "3.1999...";
    claim.expected = Verdict::refuted;
  }
  return claim;
}

FigureRun sphere() {
  FigureRun figure;
  figure.title = "A sphere";
  figure.coloured_by = "gauss";
  const auto add = [&](int i, int j) {
    const double theta = std::numbers::pi * i / 24, phi = std::numbers::pi * j / 24;
    figure.points.push_back(
        {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    figure.values.push_back(std::cos(theta));
  };
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 48; ++j) add(i, j);
  figure.normals = figure.points;
  const auto at = [](int i, int j) { return 49 * i + j; };
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 48; ++j) {
      figure.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      figure.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return figure;
}

}  // namespace

Run sample() {
  FileRun file;
  file.file = "sample.seam";
  file.paper = "Smooth Surfaces from Solids & Their Curvature";
  file.by = "A. Author, B. Author";
  file.source = "Proceedings";
  file.year = "1998";
  file.sha256 = std::string(64, 'a');
  TableRun table{"table2", "cubic patches", "Table 2", {"tetrahedron", "octahedron"}, {}, {}};
  table.rows = {{"α1",
                 "\\alpha_1",
                 {cell("table2.1.1", Verdict::proven), cell("table2.1.2", Verdict::proven)},
                 {"1.333333", "1.000000"}},
                {"K_max",
                 "\\max K",
                 {cell("table2.2.1", Verdict::refuted), cell("table2.2.2", Verdict::proven)},
                 {"3.24", "1.69"}}};
  file.items = {
      SectionRun{"1  Definitions"},
      DefinitionRun{"t = \\frac{\\sqrt{5} + 1}{2}", {"The golden section."}},
      DefinitionRun{"p = " + net(3), {}},
      SectionRun{"2  Smoothness"},
      smooth(),
      misprint(),
      convex(),
      sphere(),
      SectionRun{"3  What is hard"},
      wide(),
      breakable(),
      hostile(),
      table,
      AskRun{"K_max", "\\max_{S} K", "max(gauss(S))", "1.250000000000000000000000000000", "5/4",
             "", 0.3},
      AskRun{"K_min", "\\min_{S} K", "min(gauss(S))", "", "", "effort: no enclosure", 0.3}};
  file.warnings = {
      {"unused-definition", "", "'q_1' is never used", "no claim speaks of it", 3, 5}};
  return {"seamproof 0.1.0", {file}};
}

}  // namespace seam::report
