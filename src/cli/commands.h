// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/mutate.h"
#include "cli/outputs.h"
#include "cli/verify.h"

// The commands of `seamproof`, one function each; what a function returns is the exit status.
namespace seam::cli {

int verify_files(const std::vector<std::string>& files, const VerifyOptions&, const Outputs&);
/// The same, except that a folder with results is reported from them and its certificates.
int report_files(const std::vector<std::string>& files, const VerifyOptions&, const Outputs&);
int list_claims(const std::vector<std::string>& files);
int list_obligations(const std::vector<std::string>& files);
int format_files(const std::vector<std::string>& files, bool in_place);
int explain(const std::string& file, const std::string& id, const VerifyOptions&);
int trust(const std::string& file, const std::string& id, const VerifyOptions&);
int ask(const std::string& file, const std::string& expression, int digits,
        const VerifyOptions&);
/// Whether every `\spval` and `\spstatus` of a paper is printed right.
int check_tex(const std::string& paper, const std::vector<std::string>& files,
              const VerifyOptions&);
/// How much each claim notices of small changes of the file.
int mutate_file(const std::string& file, const MutateOptions&, const VerifyOptions&,
                const Outputs&);
/// The certificates of a folder with results, or of a .seam file, as files for Coq.
int export_coq(const std::string& from, const std::string& to, const VerifyOptions&);
int start_file(const std::string& name);

}  // namespace seam::cli
