// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certificate/evidence.h"

// A finished run as plain data: all that any report says, and nothing to be decided
// any more. `latex` is mathematics without dollar signs; all other text is plain UTF-8.
namespace seam::report {

using certificate::Verdict;

/// By how much an inequality that was proven holds: the least value of what is measured lies
/// between two decimals, rounded outward. Certain, but shown by no certificate.
struct Slack {
  std::string low;
  std::string high;     ///< empty: no point was found that is certain to lie in the domain
  std::string at;       ///< where it is `high` at most: `u = 1/2`; empty: of a number
  std::string of;       ///< `the difference of the sides`; empty: the formula itself
  std::string unknown;  ///< why it was not computed

  bool empty() const { return low.empty() && unknown.empty(); }
};

/// One obligation that a statement was turned into, as the checker left it.
struct ObligationRun {
  enum class Status { holds, fails, open };
  std::string about;   ///< `equal tangent planes along the seam`; may be empty
  std::string kind;    ///< `zero`, `sign`, `solutions`, `gluing`, `distinct`
  std::string latex;   ///< what it says; may be empty
  std::string text;    ///< the same for a terminal; may be empty
  bool guard = false;  ///< says only that the formulas mean something
  Status status = Status::open;
  std::string evidence;  ///< in a line: `subdivision, 37 pieces`
  Slack slack = {};      ///< of an inequality that holds
};

/// A statement and what became of it.
struct Outcome {
  std::string latex;  ///< the statement, from its own syntax tree
  std::string text;   ///< the statement as canonical source text
  Verdict verdict = Verdict::undecided;
  std::string reason;   ///< undecided: `time memory effort unsupported degenerate assumption`
  std::string detail;   ///< undecided, conditional: a sentence
  std::string witness;  ///< refuted: `u = 0: (0, 0, -144) != (0, 0, 0)`
  std::string alarm;    ///< the checker's objection to the prover's evidence; empty: none
  std::vector<std::string> method;  ///< `normal form`, `subdivision`
  std::vector<ObligationRun> obligations;
  std::string digest;       ///< of what was judged
  std::string certificate;  ///< path, relative to the report's folder; empty: none written
  bool is_stored = false;   ///< the evidence is that of an earlier run; never in a file
};

/// What the checker confirmed of something that is said beside the claims.
struct Confirmation {
  std::string digest;       ///< of the statement that was judged
  std::string certificate;  ///< path, relative to the report's folder; empty: none written
  std::string alarm;        ///< the checker's objection to evidence for it; empty: none

  bool empty() const { return digest.empty() && alarm.empty(); }
};

struct ClaimRun {
  std::string id, title, at;          ///< `at`: `§6`
  std::vector<std::string> comments;  ///< the comment lines above it in the file
  Outcome printed;                    ///< the statement as the paper prints it
  std::optional<Outcome> corrected;
  std::string true_digits = {};        ///< where printed ones are wrong: certified; empty: none
  Confirmation digits_confirmed = {};  ///< that these are the true digits
  Verdict expected = Verdict::proven;  ///< refuted where there is a correction
  std::vector<std::string> using_claims;
  std::vector<std::string> predicates;        ///< names of the predicates it uses: `G1`
  std::vector<std::string> definitions = {};  ///< names of all that it speaks of, in file order
  int line = 0, column = 0;  ///< of the id, or of the cell; from 1 on, in code points
  std::string included =
      {};              ///< the file it stands in, if that is not the run's: `parts/a.seam`
  double seconds = 0;  ///< for the terminal; never in a file
};

struct SectionRun {
  std::string title;
};

/// A `let`, `param`, `root` or `define`: what the claims speak of.
struct DefinitionRun {
  std::string latex;
  std::vector<std::string> comments;
  std::vector<std::string> names = {};
  std::string text = {};      ///< canonical source text
  bool is_parameter = false;  ///< what is said of it holds for every value that it may have
};

/// A printed table; each cell is a claim with the id `tableid.row.column`.
struct TableRun {
  struct Row {
    std::string label, latex;  ///< as printed; the expression
    std::vector<ClaimRun> cells;
    std::vector<std::string> printed = {};  ///< the values as printed, one a cell; may be empty
  };
  std::string id, title, at;
  std::vector<std::string> labels;  ///< of the columns; may be empty
  std::vector<std::string> comments;
  std::vector<Row> rows;
};

/// A picture made of samples: proves nothing, so it may hold rounded numbers.
struct FigureRun {
  using Point = std::array<double, 3>;
  struct Line {
    /// `edge`: of a mesh, or a side of a patch that lies on no seam; `curve`: one that is
    /// itself shown; `contour`: where the value is one of the ticks of the legend.
    enum class Kind { seam, edge, net, curvature, curve, contour };
    Kind kind = Kind::seam;
    std::vector<Point> points;
  };
  struct Mark {  ///< where a claim about the surface is refuted
    Point at{};
    std::string label;  ///< the id of the claim
  };
  std::string id;  ///< may be empty
  std::string title;
  std::string at;           ///< `Fig. 5`; may be empty
  std::string coloured_by;  ///< `gauss`, `mean`, or an expression; empty: nothing
  std::string coloured_by_latex;
  std::string note;     ///< what the drawing leaves out or alters, in sentences; may be empty
  bool closed = false;  ///< only the outside of the facets can be seen
  std::vector<Point> points;
  std::vector<Point> normals;  ///< of length 1, outwards; one a point
  std::vector<double> values;  ///< what it is coloured by, one a point; empty: nothing
  std::vector<std::array<int, 3>> triangles;  ///< into `points`, counterclockwise from outside
  std::vector<Line> lines;
  std::vector<Mark> marks;
};

/// A question and its certified answer.
struct AskRun {
  std::string id, latex, text;
  std::string decimal;      ///< every digit certified; empty: no answer
  std::string closed_form;  ///< plain text; empty: none found
  std::string detail;       ///< why there is no answer
  double seconds = 0;
  Confirmation confirmed = {};
};

using ItemRun = std::variant<SectionRun, DefinitionRun, ClaimRun, TableRun, FigureRun, AskRun>;

/// An error in a file, for which nothing of it could be decided.
struct ErrorRun {
  std::string message, hint;
  int line = 0, column = 0;
  std::string included = {};  ///< the file it stands in, if that is not the run's
};

/// What may be a slip though nothing is wrong with it. It changes no verdict.
struct WarningRun {
  std::string rule;   ///< `nothing-to-show`
  std::string claim;  ///< its id; empty: about no claim
  std::string message, hint;
  int line = 0, column = 0;
  std::string included = {};  ///< the file it stands in, if that is not the run's
};

struct FileRun {
  std::string file;  ///< its name without folders
  std::string paper, by, source, year;
  std::string sha256;          ///< of its bytes
  std::vector<ItemRun> items;  ///< in file order
  std::string path = {};       ///< as it was asked for; in no file that is made to be kept
  std::vector<ErrorRun> errors = {};
  std::vector<WarningRun> warnings = {};
};

struct Run {
  std::string tool;  ///< `seamproof 0.1.0`
  std::vector<FileRun> files;
  std::vector<std::string> libraries = {};  ///< at work in it, with versions: `GiNaC 1.8.6`
};

struct Summary {
  int claims = 0, proven = 0, refuted = 0, conditional = 0, undecided = 0, as_expected = 0;
};

/// The questions of a file in file order.
std::vector<const AskRun*> questions(const FileRun&);
std::vector<AskRun*> questions(FileRun&);

/// The claims of a file in file order, the cells of tables among them.
std::vector<const ClaimRun*> claims(const FileRun&);
std::vector<ClaimRun*> claims(FileRun&);

/// The verdict is the expected one, and the correction, where there is one, is proven.
bool as_expected(const ClaimRun&);

Summary summarize(const FileRun&);
Summary summarize(const Run&);

/// The path of the file in which something stands: the run's own, as it was asked for, or one
/// included from its folder.
std::string path_of(const FileRun&, const std::string& included);

/// The obligation of a proven statement with the least slack above 0; none: there is none.
const ObligationRun* closest_to_failing(const Outcome&);

/// Whether the first is nearer to 0, about; both have a `high`.
bool is_closer(const Slack&, const Slack&);

/// `between 0.012 and 0.013, the latter at u = 1/2`; `0, attained at u = 0`; `1/600`.
std::string in_words(const Slack&);

/// What a claim or its correction asks of the reader.
enum class Concern {
  none,           ///< all is as expected
  undecided,      ///< undecided, or only conditional, against expectation
  contradiction,  ///< decided against expectation
  alarm           ///< the checker objected to the evidence
};
Concern concern(const ClaimRun&);

/// The questions and the true digits whose evidence the checker objected to, by id, and its
/// objection.
std::vector<std::pair<std::string, std::string>> alarms_beside_claims(const FileRun&);

/// `refuted, expected: proven; u = 0: 1 != 0`: what came of it in a line, with the witness or
/// the reason, and the correction where that is what is not as expected.
std::string in_short(const ClaimRun&);

/// The exit status of docs/command-line.md: 3 if the checker objected to any evidence, else 1
/// if a decided claim is not as expected, else 2 if an undecided or conditional one is not (0
/// with `allow_undecided`), else 0.
int exit_status(const Run&, bool allow_undecided = false);

/// `proven`, `refuted`, `conditional`, `undecided`.
const char* word(Verdict);

}  // namespace seam::report
