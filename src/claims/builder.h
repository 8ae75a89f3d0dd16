// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "claims/syntax.h"

namespace seam::claims {

/// Thrown to give up the item that is being read.
struct SyntaxError {
  text::Diagnostic diagnostic;
};

/// What the grammar's actions build the tree with: a stack of finished nodes, marks
/// where unfinished ones began, the item so far, and where the reading stands.
///
/// Tokens and the gaps between them alternate; `gap_end` is where the next token
/// begins, [token_begin, token_end) is the one before it.
class Builder {
 public:
  explicit Builder(std::shared_ptr<const text::Source>);

  /// Forgets everything unfinished: what comes is a new item.
  void begin_item(std::size_t at);

  std::size_t offset(const char* place) const {
    return static_cast<std::size_t>(place - source_->bytes.data());
  }
  text::Span span(std::size_t begin, std::size_t end) const { return {source_, begin, end}; }
  std::string_view bytes() const { return source_->bytes; }

  // ---- the text as it passes by
  void gap(std::size_t begin, std::size_t end);
  void comment(std::size_t begin, std::string_view text);

  /// The comments that began before this place, taken out.
  std::vector<std::string> take_comments(std::size_t before);

  bool at_token_end() const { return token_end == gap_end; }
  /// Only blanks stand before the next token on its line.
  bool at_line_begin() const;

  std::string last_token() const {
    return std::string(bytes().substr(token_begin, token_end - token_begin));
  }
  void read_word(std::size_t begin, std::string_view text);
  /// Reads a name; false if the word is reserved.
  bool read_name(std::size_t begin, std::string_view text);

  std::size_t token_begin = 0, token_end = 0, gap_end = 0;
  std::size_t word_begin = 0;
  std::string word;           ///< the last name, id or string, in its one spelling
  std::size_t set_begin = 0;  ///< where the last set began
  int depth = 0;              ///< of nesting

  // ---- the stack of nodes
  struct Node {
    Expression tree;
    int height = 1;
    bool open = false;  ///< a chain of relations that may still grow
  };
  struct Mark {
    std::size_t first;  ///< the node it begins with
    std::size_t row;    ///< the node its current row begins with
    std::size_t rows = 0;
    std::size_t begin;  ///< where in the text
    bool is_set;        ///< it begins a set: there `[0, 1)` may stand
    std::string text;
  };
  std::vector<Node> nodes;
  std::vector<Mark> marks;

  /// Marks the next node, or one `back` before it.
  void mark(std::size_t begin, std::size_t back = 0);
  Mark unmark();
  std::size_t count(const Mark& mark) const { return nodes.size() - mark.first; }

  /// Puts the last `children` nodes under a new one, which ends with the last token.
  void make(Expression::Kind, std::string text, std::size_t children, std::size_t begin);
  void binary(Expression::Kind, std::string_view text);
  void compare(std::string_view operation);
  void truncate(std::size_t at);

  /// One node of all that stands behind the last mark.
  void end_group(Expression::Kind, std::string text, std::size_t begin);
  /// The same, beginning where its first child does.
  void end_call(Expression::Kind);
  /// Ends a row of the bracket that was marked last: its entries become one list.
  void end_row();
  void end_parenthesis(std::size_t begin);
  void end_bracket(std::size_t begin);
  void end_named();
  void end_limit();
  void end_root(std::size_t begin);
  void end_weight(std::size_t begin);
  void end_net();
  void end_patch(Expression::Kind);
  void end_bare_binding(std::size_t begin);
  void end_quantified();
  void end_solve();
  void end_hint();
  bool at_half_open() const;

  Expression take();

  // ---- the item
  Item item;
  void name_item();
  void end_title(std::size_t begin);
  void end_item();
  /// Takes the last name as something a figure is drawn with.
  void draw_with();
  /// Refuses a second clause of the name that was just read.
  void once(std::size_t at);

  // ---- errors
  [[noreturn]] void fail(std::string message, text::Span where, std::string hint = {}) const;
  /// `expected … after '+'`, at the next token.
  [[noreturn]] void expected(std::string_view what) const;
  /// The same for the end of a bracket, which was opened at the last mark.
  [[noreturn]] void expected_close(std::string_view what) const;
  [[noreturn]] void missing_colon() const;
  [[noreturn]] void missing_statement() const;
  [[noreturn]] void unknown_item() const;
  /// Two values side by side: the first begins at `left`, the second at `right`.
  [[noreturn]] void invisible_product(std::size_t left, std::size_t right) const;
  /// What follows a finished item or expression and is no part of it.
  [[noreturn]] void unexpected_rest() const;

  /// The token that begins at the place, as far as a message needs it.
  text::Span token_at(std::size_t place) const;

 private:
  [[noreturn]] void complain(std::string message, std::string hint) const;
  [[noreturn]] void unknown_clause(const text::Span& token) const;
  Expression take_name();

  struct Comment {
    std::size_t begin;
    std::string text;
  };
  std::shared_ptr<const text::Source> source_;
  std::vector<Comment> comments_;
  std::map<std::string, std::size_t> clauses_;
  std::size_t item_begin_ = 0;
};

}  // namespace seam::claims
