// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json.h"

#include <gtest/gtest.h>

#include "sample.h"

namespace seam::report {
namespace {

TEST(Json, a_claim_has_the_fields_of_the_contract_in_its_order) {
  ClaimRun claim;
  claim.id = "a.smooth";
  claim.printed.verdict = Verdict::refuted;
  claim.expected = Verdict::refuted;
  claim.printed.witness = "u = 0";
  claim.printed.method = {"normal form"};
  claim.printed.obligations.resize(3);
  claim.printed.certificate = "certificates/a.smooth.json";
  FileRun file;
  file.file = "a.seam";
  file.paper = "Paper";
  file.sha256 = "00";
  file.items = {claim};
  EXPECT_EQ(json({"seamproof 0.1.0", {file}}), R"({
 "schema_version": 1,
 "tool": "seamproof 0.1.0",
 "libraries": [],
 "files": [
  {
   "file": "a.seam",
   "sha256": "00",
   "paper": "Paper",
   "claims": [
    {
     "id": "a.smooth",
     "verdict": "refuted",
     "expected": "refuted",
     "as_expected": true,
     "corrected": null,
     "reason": null,
     "detail": null,
     "witness": "u = 0",
     "method": ["normal form"],
     "obligations": 3,
     "certificate": "certificates/a.smooth.json",
     "using": [],
     "findings": [{"status":"open"},{"status":"open"},{"status":"open"}]
    }
   ],
   "asks": [],
   "items": [{"claim":"a.smooth"}]
  }
 ],
 "summary": {"claims":1,"proven":0,"refuted":1,"conditional":0,"undecided":0,"as_expected":1}
}
)");
}

TEST(Json, holds_no_times) {
  report::Run late = sample();
  for (ItemRun& item : late.files[0].items) {
    if (auto* claim = std::get_if<ClaimRun>(&item)) claim->seconds += 1;
    if (auto* ask = std::get_if<AskRun>(&item)) ask->seconds += 1;
  }
  EXPECT_EQ(json(late), json(sample()));
}

TEST(Json, bytes_that_are_not_text_are_replaced) {
  FileRun file;
  file.file = "\xFF.seam";
  EXPECT_NE(json({"", {file}}).find("\"\xEF\xBF\xBD.seam\""), std::string::npos);
}

}  // namespace
}  // namespace seam::report
