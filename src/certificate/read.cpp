// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <array>
#include <utility>

#include "certificate/fault.h"
#include "certificate/json.h"
#include "certificate/read_parts.h"

// Brackets are counted before anything is parsed, so that no text can make the parser or
// the functions below recurse deeply. Every object must have exactly the members that
// are read from it; indices are checked at the end, by `fault`.

namespace seam::certificate {
namespace {

constexpr int max_nesting = 2 * max_goal_depth + 40;

void demand_shallow(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > max_nesting) throw FormatError("brackets are nested too deeply");
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

Json parsed(std::string_view text) {
  if (text.size() > max_bytes) throw FormatError("longer than 64 MiB");
  demand_shallow(text);
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    throw FormatError(error.what());
  }
}

Verdict read_verdict(const Reader& in) {
  return read_spelling(in, std::array{Verdict::proven, Verdict::refuted, Verdict::conditional,
                                      Verdict::undecided});
}

}  // namespace

Certificate read(std::string_view text) {
  const Json document = parsed(text);
  const Reader in(document);
  in.members({"format", "claim", "correction", "verdict", "using", "statement", "evidence"});
  if (in["format"].text() != "seamproof certificate 1")
    in["format"].fail("'seamproof certificate 1'");
  Certificate certificate{
      in["claim"].text(),  in["correction"].truth(),        read_verdict(in["verdict"]),
      in["using"].texts(), read_statement(in["statement"]), read_evidence(in["evidence"])};
  const std::string found = fault(certificate.statement, certificate.evidence);
  if (!found.empty()) throw FormatError(found);
  return certificate;
}

}  // namespace seam::certificate
