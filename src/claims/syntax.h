// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "text/source.h"

// The tree of a .seam file, as written: nothing is resolved, simplified or reordered.
namespace seam::claims {

/// An expression or a statement. `text` and `children` by kind:
struct Expression {
  enum class Kind {
    // values
    number,  ///< text: `0.25`, `17`, as spelled
    name,    ///< text: in its one spelling (Greek letters spelled out: `gamma_f1`)
    string,  ///< text: without the quotes
    negate,  ///< [x]
    binary,  ///< text: + - * / ^ ; [left, right]
    call,    ///< [callee, argument...]: `f(x, y)`, `D2(p)(u, 0)`; callee is any value
    named,   ///< text: name; [value]: an argument `u = 1/3` inside a call
    index,   ///< [value, index...]: `v[1]`, `M[1, 2]`
    tuple,   ///< (x, y, z), two or more
    list,    ///< [a, b, c], any number
    matrix,  ///< [a, b; c, d]: children are lists, one a row, two or more rows
    each,   ///< `E for i in R`: [E, binding...]; inside a list, or as the argument of sum, max,
            ///< count ...
    range,  ///< a..b: [a, b]
    limit,  ///< `E for n -> infinity`: text: n; [E, target]
    infinity,  ///< the word
    plane,     ///< `plane n d`: [n, d]
    patch,     ///< text: `triangle_patch`, `quad_patch`, `curve`; rows as printed: children are
               ///< lists, one a row
    indexed,   ///< text: the same; [degree, control...]: `triangle_patch 3 { 300: v0; ... }`;
               ///< `rational` adds "rational " in front
    control,   ///< text: `300`; [point]: inside `indexed`
    weighted,  ///< `P:w`: [point, weight], inside a rational patch
    from,      ///< text: `triangle_patch`, ...; [formula]: `quad_patch from (u, v, u*v)`
    read,      ///< text: path
    // statements
    relation,   ///< text: operators between the children, separated by blanks: `< <=`; [a, b,
                ///< c]; operators are = != < <= > >= ~
    truncated,  ///< [relation]: `E ~ 1.58 truncated`
    for_all,    ///< [binding..., statement]: also finite `for k in 0..5: S`
    for_some,   ///< [binding..., statement]
    conjunction,
    disjunction,
    implication,
    equivalence,  ///< [S, T]
    negation,     ///< not S: [S]
    solve,  ///< text: `` (a list follows), `none`, `one` (then a relation side may follow: [..,
            ///< approximation]);
    ///< children: [unknowns (list of names or bindings), statement, condition (list: none or
    ///< one), solutions (list)]
    // inside for_all, for_some, each, solve
    binding  ///< text: `all` (no set given: every real) or `in`; [names (list of name), set (0
             ///< or 1), condition (0 or 1: `where`)]:
    ///<   for_all `for all u`: text `all`, [names]; `u in [0,1]`: text `in`, [names, set];
    ///<   `(u,v) in triangle where S`: [names, set, condition];
    ///<   the set [0, 1] is a `list`, (0, 1) a `tuple`, [0, 1) and (0, 1] are `half_open`
    ,
    half_open  ///< text: `[)` or `(]`; [low, high]
  };
  Kind kind = Kind::number;
  std::string text;
  std::vector<Expression> children;
  text::Span span;
};

/// Equal as trees, wherever they stand.
bool same(const Expression&, const Expression&);

struct Claim {
  std::string id, title, at;  ///< `at "§6"`
  Expression statement;
  std::optional<Expression> corrected;
  std::string expect;  ///< ``, `refuted`, `undecided`
  std::vector<std::string> using_claims;
  std::vector<Expression> hints;  ///< `by bernstein, substitution e2, e3`
};

struct Item {
  enum class Kind {
    paper,
    section,
    let,
    sequence,
    param,
    root,
    include,
    define,
    claim,
    table,
    figure,
    ask
  };
  Kind kind = Kind::let;
  text::Span span;
  text::Span name_span;               ///< of the name or id
  std::vector<std::string> comments;  ///< the comment lines just above, without `# `
  std::string name;  ///< let, sequence, define, root, ask, table, figure: its name or id (of a
                     ///< figure perhaps none); paper, section: the title; include: the path
  std::vector<std::string> parameters;  ///< let f(x, y), define f(x), sequence s(k)
  std::vector<std::string> names;       ///< param a, b, c; figure: `with` these
  std::string by, source, year;         ///< paper
  std::string type;  ///< param: ``, `integer`, `mesh`, `vector 3`, `function`,
                     ///< `vector 3 function of 2`
  std::vector<Expression>
      expressions;  ///< let, define, ask: [body]; figure: [shown] or [shown, colour];
                    ///< sequence: [start, step]; root: [polynomial, interval]; param: [set] or
                    ///< [], then condition in `where`
  std::optional<Expression> where;  ///< param
  std::string option;               ///< ask: digits
  Claim claim;                      ///< claim; also at/title of a table and a figure
  struct Row {
    std::string label;
    Expression value;
    std::vector<Expression> printed;
    std::map<std::size_t, Expression> corrected;  ///< by the number of the cell
    bool truncated = false;
  };
  std::vector<Row> rows;            ///< table
  std::vector<Expression> columns;  ///< table: [binding]
  std::vector<std::string> labels;  ///< table: labelled
};

struct File {
  std::shared_ptr<const text::Source> source;
  std::vector<Item> items;
  std::vector<std::string> closing_comments;
};

/// Reads a file. Never throws on bad text: what could be read is in `file`, what
/// could not is in `errors` (after an error, reading goes on at the next item).
struct Parsed {
  File file;
  std::vector<text::Diagnostic> errors;
};
Parsed parse(std::shared_ptr<const text::Source>);

/// The canonical layout: parse(format(f)) is the same tree, and format is idempotent.
std::string format(const File&);

/// One expression or statement in canonical text.
std::string format(const Expression&);

/// An expression alone, as `seamproof ask` gives it.
struct ParsedExpression {
  Expression expression;
  std::vector<text::Diagnostic> errors;
};
ParsedExpression parse_expression(std::shared_ptr<const text::Source>);

}  // namespace seam::claims
