// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/export.h"

#include "certificate/to_json.h"
#include "embedded/SeamNumber.h"
#include "embedded/SeamPieces.h"
#include "embedded/SeamRing.h"
#include "embedded/SeamSign.h"

namespace seam::coq {
namespace {

using certificate::Certificate;
using certificate::Goal;

/// Fit for a comment of Coq, which looks for comments and strings in it.
std::string in_comment(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const char before = result.empty() ? ' ' : result.back();
    if ((before == '(' && c == '*') || (before == '*' && c == ')')) result += ' ';
    result += c == '"' ? '\'' : c;
  }
  return result;
}

std::string goal_text(const Goal& goal) {
  if (goal.kind == Goal::Kind::obligation) return std::to_string(goal.obligation + 1);
  std::string parts;
  for (const Goal& part : goal.parts) parts += (parts.empty() ? "" : ", ") + goal_text(part);
  switch (goal.kind) {
    case Goal::Kind::any:
      return "one of (" + parts + ")";
    case Goal::Kind::negation:
      return "not (" + parts + ")";
    case Goal::Kind::suffices:
      return "what follows from (" + parts + ")";
    default:
      return "all of (" + parts + ")";
  }
}

std::string heading(const Certificate& certificate, const std::string& says) {
  std::string guards;
  for (const int guard : certificate.statement.guards)
    guards += (guards.empty() ? "" : ", ") + std::to_string(guard + 1);
  return "(* " + in_comment(certificate.claim) + (certificate.correction ? ", corrected" : "") +
         ", " + certificate::spelling(certificate.verdict) + ":\n   " + in_comment(says) +
         "\n   The claim: " + goal_text(certificate.statement.goal) +
         (guards.empty() ? "" : "\n   It has a meaning if: " + guards) +
         "\n   The numbers are those of the obligations. *)\n\n" +
         "From Coq Require Import Reals List.\n" +
         "Require Import SeamRing SeamNumber SeamSign SeamPieces.\n" +
         "Import ListNotations.\nLocal Open Scope R_scope.\n";
}

}  // namespace

Exported write_file(const Certificate& certificate, const std::vector<Shown>& shown,
                    const std::string& says) {
  Exported exported{heading(certificate, says), {}};
  std::string proven;
  for (std::size_t i = 0; i < certificate.statement.obligations.size(); ++i) {
    const std::string name = "obligation_" + std::to_string(i + 1);
    Theorem theorem =
        write_theorem(certificate, i, i < shown.size() ? shown[i] : Shown::open, name);
    if (theorem.text.empty()) {
      exported.text += "\n(* Obligation " + std::to_string(i + 1) +
                       " is not exported: " + theorem.kind + ", " + theorem.left_out + ". *)\n";
    } else {
      exported.text += "\n" + theorem.text;
      proven += "  generalize " + name + "; intros _.\n";
      theorem.text.clear();
    }
    exported.obligations.push_back(std::move(theorem));
  }
  if (!proven.empty())
    exported.text += "\n(* What all of this rests on. *)\nTheorem theorems : True.\nProof.\n" +
                     proven + "  exact I.\nQed.\nPrint Assumptions theorems.\n";
  return exported;
}

std::vector<std::pair<std::string, std::string>> library() {
  return {{"SeamRing.v", std::string(embedded::SeamRing)},
          {"SeamNumber.v", std::string(embedded::SeamNumber)},
          {"SeamSign.v", std::string(embedded::SeamSign)},
          {"SeamPieces.v", std::string(embedded::SeamPieces)}};
}

}  // namespace seam::coq
