// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/draft.h"

// Coq compares the statement with the value of the formulas that the theorems of the library
// are about: names of values stand for the same in both, so the comparison takes one step a
// node.

namespace seam::coq {
namespace {

/// Lines no longer than a page is wide, as far as there are blanks.
std::string folded(const std::string& text) {
  constexpr std::size_t width = 100;
  std::string result;
  std::size_t column = 0, start = 0;
  while (start < text.size()) {
    std::size_t end = text.find_first_of(" \n", start);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(start, end - start);
    if (column + word.size() > width && column > 4) {
      result += "\n    ";
      column = 4;
    }
    result += word;
    column += word.size();
    if (end < text.size()) {
      result += text[end];
      column = text[end] == '\n' ? 0 : column + 1;
    }
    start = end + 1;
  }
  return result;
}

}  // namespace

std::string list(const std::vector<std::string>& items) {
  std::string result;
  for (const std::string& item : items) result += (result.empty() ? "" : "; ") + item;
  return "[" + result + "]";
}

Draft::Draft(const certificate::Certificate& certificate, std::vector<certificate::Term> terms,
             const std::vector<std::size_t>& generators)
    : formulas_(certificate), terms_(std::move(terms)) {
  generators_ = write_generators(generators, certificate, formulas_, names_);
  std::string line;
  for (const char c : generators_.quantified)
    if (c == '\n') {
      say(line);
      line.clear();
    } else {
      line += c;
    }
  intros_ = generators_.intros;
}

void Draft::prove_intros() {
  if (!intros_.empty()) prove("intros" + intros_ + ".");
  intros_.clear();
}

void Draft::say_shared() {
  for (const certificate::Term term : formulas_.shared(terms_)) {
    const std::string name = names_.fresh("n" + std::to_string(term));
    const Written formula = formulas_.write_definition(term);
    say("let " + name + " := " + formula.text + " in");
    intro(name);
    formulas_.place(term, name);
    definitions_.push_back({name, formula.code, "eq_refl"});
  }
}

void Draft::define(const std::string& name, const Written& formula, const std::string& proof) {
  definitions_.push_back({name, formula.code, proof});
}

std::string Draft::definitions() const {
  std::vector<std::string> codes;
  for (const Definition& definition : definitions_) codes.push_back(definition.code);
  return list(codes);
}

std::string Draft::named() const {
  std::vector<std::string> items;
  for (const Definition& definition : definitions_) items.push_back(definition.name);
  return list(items);
}

std::string Draft::defined() const {
  std::string result = "I";
  for (auto it = definitions_.rbegin(); it != definitions_.rend(); ++it)
    result = "(conj " + it->proof + " " + result + ")";
  return result;
}

std::string Draft::finish(const std::string& name) const {
  std::string statement = statement_;
  statement.pop_back();
  return "Theorem " + name + " :\n" + folded(statement + ".\n") + "Proof.\n" + folded(proof_) +
         "Qed.\n";
}

}  // namespace seam::coq
