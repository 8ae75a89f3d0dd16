// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <map>

#include "certificate/json.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/progress.h"
#include "cli/results.h"
#include "coq/export.h"
#include "coq/names.h"

// Certificates are not judged here: Coq judges them. What the results say of an obligation
// only chooses which theorem is attempted.

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

/// Exported obligations by kind, and others by kind and reason.
struct Counts {
  std::map<std::string, int> exported;
  std::map<std::pair<std::string, std::string>, int> left_out;
  int files = 0;
};

Verified verified(const std::string& file, const VerifyOptions& options) {
  ProgressLine progress(false);
  return verify(file, options,
                [&](int done, int all, const std::string& id) { progress(done, all, id); });
}

Verified stored(const fs::path& folder) {
  Verified result{results_in(folder).files.front(), {}, Verified::Extent::selection};
  for (const report::ClaimRun* claim : report::claims(result.run))
    for (const report::Outcome* outcome :
         {&claim->printed, claim->corrected ? &*claim->corrected : nullptr}) {
      if (outcome == nullptr || outcome->certificate.empty()) continue;
      const fs::path path = folder / "certificates" / fs::path(outcome->certificate).filename();
      try {
        result.certificates[outcome->certificate] = certificate::read(open(path)->bytes);
      } catch (const certificate::FormatError& error) {
        throw Failure{bad_file, path.string() + ": error: " + error.what() + "\n"};
      }
    }
  return result;
}

void refuse_unknown(const std::vector<std::string>& patterns, const report::FileRun& run) {
  std::vector<std::string> ids;
  for (const report::ClaimRun* claim : report::claims(run)) ids.push_back(claim->id);
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(ids, [&](const auto& id) { return selected(id, {pattern}); }))
      continue;
    const std::string near = text::nearest(pattern, ids);
    throw Failure{usage, "no claim is named '" + pattern + "'" +
                             (near.empty() ? "" : "; did you mean '" + near + "'?") + "\n"};
  }
}

std::vector<coq::Shown> shown(const report::Outcome& outcome) {
  std::vector<coq::Shown> result;
  for (const report::ObligationRun& obligation : outcome.obligations)
    switch (obligation.status) {
      case report::ObligationRun::Status::holds:
        result.push_back(coq::Shown::holds);
        break;
      case report::ObligationRun::Status::fails:
        result.push_back(coq::Shown::fails);
        break;
      case report::ObligationRun::Status::open:
        result.push_back(coq::Shown::open);
    }
  return result;
}

void count(const coq::Exported& exported, Counts& counts) {
  ++counts.files;
  for (const coq::Theorem& theorem : exported.obligations)
    if (theorem.left_out.empty())
      ++counts.exported[theorem.kind];
    else
      ++counts.left_out[{theorem.kind, theorem.left_out}];
}

void print(const Counts& counts) {
  int exported = 0, left_out = 0;
  for (const auto& [kind, number] : counts.exported) {
    std::cout << number << " " << kind << ": exported\n";
    exported += number;
  }
  for (const auto& [what, number] : counts.left_out) {
    std::cout << number << " " << what.first << ": not exported, " << what.second << "\n";
    left_out += number;
  }
  std::cout << counts.files << " files, " << exported << " theorems, " << left_out
            << " obligations not exported\n";
}

/// The order in which Coq compiles, for its own tools and for `make`.
void write_project(const fs::path& out, const std::vector<std::string>& files) {
  std::string project = "-Q . \"\"\n";
  for (const std::string& file : files) project += file + "\n";
  write(out / "_CoqProject", project);
  write(out / "Makefile",
        "all: Makefile.coq\n\t$(MAKE) -f Makefile.coq\n\nMakefile.coq: _CoqProject\n"
        "\tcoq_makefile -f _CoqProject -o Makefile.coq\n\n.PHONY: all\n");
}

}  // namespace

int export_coq(const std::string& from, const std::string& to, const VerifyOptions& options) {
  const Verified source = has_results(from) ? stored(from) : verified(from, options);
  if (!options.claims.empty()) refuse_unknown(options.claims, source.run);
  const fs::path out(to);
  std::vector<std::string> files;
  coq::Names names;
  for (const auto& [name, text] : coq::library()) {
    write(out / name, text);
    files.push_back(name);
    names.fresh(fs::path(name).stem().string());
  }
  Counts counts;
  for (const report::ClaimRun* claim : report::claims(source.run)) {
    if (!options.claims.empty() && !selected(claim->id, options.claims)) continue;
    for (const report::Outcome* outcome :
         {&claim->printed, claim->corrected ? &*claim->corrected : nullptr}) {
      if (outcome == nullptr) continue;
      const auto found = source.certificates.find(outcome->certificate);
      if (found == source.certificates.end()) continue;
      const coq::Exported exported =
          coq::write_file(found->second, shown(*outcome), outcome->text);
      const std::string id = claim->id + (found->second.correction ? "_corrected" : "");
      files.push_back(names.fresh(coq::as_identifier(id)) + ".v");
      write(out / files.back(), exported.text);
      count(exported, counts);
    }
  }
  write_project(out, files);
  print(counts);
  return ok;
}

}  // namespace seam::cli
