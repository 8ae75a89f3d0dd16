// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/terminal.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace seam::report {
namespace {

constexpr std::size_t longest_detail = 160;  // code points; the JSON output has all of it

const char* escape_sequence(Verdict verdict) {
  switch (verdict) {
    case Verdict::proven:
      return "\033[32m";
    case Verdict::refuted:
      return "\033[31m";
    case Verdict::conditional:
      return "\033[34m";
    case Verdict::undecided:
      break;
  }
  return "\033[33m";
}

std::string painted(const std::string& text, Verdict verdict, bool colour) {
  return colour ? escape_sequence(verdict) + text + "\033[0m" : text;
}

// On one line, without control characters, at most so many code points.
std::string one_line(std::string_view text) {
  std::string result;
  std::size_t points = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool starts_point = (byte & 0xC0) != 0x80;
    if (starts_point && ++points > longest_detail) return result + "…";
    result += byte < 0x20 || byte == 0x7F ? ' ' : c;
  }
  return result;
}

std::string padded(std::string word, std::size_t width) {
  word.resize(std::max(width, word.size()), ' ');
  return word;
}

std::string mark(Verdict verdict, bool colour, std::size_t width = 0) {
  return painted(std::string(shape(verdict)) + " " + padded(word(verdict), width), verdict,
                 colour);
}

std::string time(double seconds) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "  %.2f s", seconds);
  return buffer;
}

// The reason or the witness.
std::string because(const Outcome& outcome) {
  if (outcome.verdict == Verdict::refuted) return one_line(outcome.witness);
  if (outcome.reason.empty()) return one_line(outcome.detail);
  return one_line(outcome.reason +
                  (outcome.detail.empty() ? std::string() : ": " + outcome.detail));
}

void append(std::string& line, const std::string& part) {
  if (!part.empty()) line += "  " + part;
}

// The methods, the number of obligations, and where the evidence is from.
std::string how(const ClaimRun& claim) {
  std::string methods;
  std::size_t obligations = 0;
  bool is_stored = true;
  for (const Outcome* outcome :
       {&claim.printed, claim.corrected ? &*claim.corrected : nullptr}) {
    if (!outcome) continue;
    obligations += outcome->obligations.size();
    is_stored = is_stored && outcome->is_stored;
    for (const std::string& method : outcome->method)
      if (methods.find(method) == std::string::npos)
        methods += (methods.empty() ? "" : ", ") + method;
  }
  return "[" + methods + (methods.empty() ? "" : "; ") + std::to_string(obligations) +
         (obligations == 1 ? " obligation; " : " obligations; ") +
         (is_stored ? "stored]" : "searched]");
}

}  // namespace

const char* shape(Verdict verdict) {
  switch (verdict) {
    case Verdict::proven:
      return "✓";
    case Verdict::refuted:
      return "✗";
    case Verdict::conditional:
      return "◐";
    case Verdict::undecided:
      break;
  }
  return "?";
}

bool wants_colour(Colour choice, bool is_terminal, const char* no_color) {
  if (choice != Colour::automatic) return choice == Colour::always;
  return is_terminal && (!no_color || *no_color == '\0');
}

std::string line(const ClaimRun& claim, bool colour, Detail detail) {
  std::string result = mark(claim.printed.verdict, colour, 11) + "  " + claim.id;
  if (claim.printed.verdict != Verdict::proven) append(result, because(claim.printed));
  if (claim.corrected) {
    append(result, "corrected: " + mark(claim.corrected->verdict, colour));
    if (claim.corrected->verdict != Verdict::proven) append(result, because(*claim.corrected));
  }
  if (claim.printed.verdict != claim.expected)
    append(result, std::string("(expected: ") + word(claim.expected) + ")");
  for (const Outcome* outcome : {&claim.printed, claim.corrected ? &*claim.corrected : nullptr})
    if (outcome && !outcome->alarm.empty())
      append(result, "SOUNDNESS ALARM, the checker objects: " + one_line(outcome->alarm));
  if (detail == Detail::full) append(result, how(claim));
  result += time(claim.seconds) + "\n";
  const ObligationRun* closest =
      detail == Detail::full ? closest_to_failing(claim.printed) : nullptr;
  return closest ? result + "    slack " + one_line(in_words(closest->slack)) + "\n" : result;
}

std::string line(const AskRun& ask, bool colour) {
  if (ask.decimal.empty())
    return mark(Verdict::undecided, colour, 11) + "  " + ask.id + "  " + one_line(ask.detail) +
           time(ask.seconds) + "\n";
  std::string result = "= " + padded("value", 11) + "  " + ask.id + "  " + ask.decimal;
  if (!ask.closed_form.empty()) append(result, "= " + one_line(ask.closed_form));
  return result + time(ask.seconds) + "\n";
}

std::string line(const Summary& summary, bool colour) {
  const auto count = [&](int n, Verdict verdict) {
    const std::string text = std::to_string(n) + " " + word(verdict);
    return n > 0 ? painted(text, verdict, colour) : text;
  };
  return std::to_string(summary.claims) + (summary.claims == 1 ? " claim: " : " claims: ") +
         count(summary.proven, Verdict::proven) + ", " +
         count(summary.refuted, Verdict::refuted) + ", " +
         count(summary.conditional, Verdict::conditional) + ", " +
         count(summary.undecided, Verdict::undecided) + "; " +
         std::to_string(summary.as_expected) + " as expected\n";
}

namespace {

// The claims that are proven with the least slack above 0.
std::string closest(const Run& run) {
  constexpr std::size_t most = 5;
  std::vector<std::pair<const ObligationRun*, const ClaimRun*>> all;
  for (const FileRun& file : run.files)
    for (const ClaimRun* claim : claims(file))
      if (const ObligationRun* found = closest_to_failing(claim->printed))
        all.emplace_back(found, claim);
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return is_closer(a.first->slack, b.first->slack);
  });
  if (all.size() > most) all.resize(most);
  std::string result = all.empty() ? "" : "closest to failing:\n";
  for (const auto& [obligation, claim] : all)
    result += "    " + claim->id + "  slack " + one_line(in_words(obligation->slack)) + "\n";
  return result;
}

}  // namespace

std::string warnings(const Run& run) {
  std::string result;
  for (const FileRun& file : run.files)
    for (const WarningRun& warning : file.warnings) {
      result += path_of(file, warning.included) + ":" + std::to_string(warning.line) + ":" +
                std::to_string(warning.column) + ": warning: " + one_line(warning.message) +
                " [" + warning.rule + "]\n";
      if (!warning.hint.empty()) result += "  hint: " + one_line(warning.hint) + "\n";
    }
  return result;
}

std::string terminal(const Run& run, bool colour, Detail detail) {
  std::string result;
  for (const FileRun& file : run.files)
    for (const ItemRun& item : file.items) {
      if (const auto* claim = std::get_if<ClaimRun>(&item))
        result += line(*claim, colour, detail);
      if (const auto* ask = std::get_if<AskRun>(&item)) result += line(*ask, colour);
      if (const auto* table = std::get_if<TableRun>(&item))
        for (const TableRun::Row& row : table->rows)
          for (const ClaimRun& cell : row.cells) result += line(cell, colour, detail);
    }
  if (detail == Detail::full) result += closest(run);
  return result + line(summarize(run), colour);
}

}  // namespace seam::report
