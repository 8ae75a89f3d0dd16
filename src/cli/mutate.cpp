// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mutate.h"

#include <algorithm>

#include "claims/excerpt.h"
#include "claims/mutation_sample.h"
#include "cli/aside.h"
#include "cli/files.h"
#include "cli/outputs.h"
#include "cli/supervisor.h"
#include "cli/trial.h"

// Of each claim an excerpt is made, the claim with what it rests on, and that is what is
// mutated. The mutant is written as text and read again, so what is decided is what a reader
// would see. Each is read and decided by a process of its own: a mutant may need any time, any
// memory.

namespace seam::cli {
namespace {

using claims::Excerpt;
using claims::Mutation;
using report::MutantRun;
using report::MutatedClaim;
using report::TrialOutcome;
using Fate = MutantRun::Fate;

/// A text in which a claim is decided.
struct Attempt {
  std::size_t claim;  ///< of the selected ones
  std::string text;
  std::vector<std::string> known = {};  ///< digests whose verdict is known
};

std::vector<Aside> try_all(const std::vector<Attempt>& attempts,
                           const std::vector<Excerpt>& excerpts, const VerifyOptions& options,
                           const std::function<void(std::size_t)>& done) {
  VerifyOptions alone = options;
  alone.jobs = 1;
  // Reading it, and deciding two statements.
  const AsideLimits limits{options.jobs, 3 * options.timeout + 5, options.memory};
  return do_aside(
      attempts.size(),
      [&](std::size_t i) {
        const Attempt& attempt = attempts[i];
        return write_trial(
            try_claim(attempt.text, excerpts[attempt.claim].here, alone, attempt.known));
      },
      limits, done);
}

TrialOutcome outcome_of(const TrialStatement& s) {
  return {s.verdict, s.reason, s.digest};
}

MutatedClaim claim_of(const std::string& id, const Aside& aside) {
  MutatedClaim claim;
  claim.id = id;
  if (aside.end != Aside::End::done) {
    claim.why_not = "it took too long, or too much memory";
    return claim;
  }
  const Trial trial = read_trial(aside.text);
  if (!trial.error.empty()) {
    claim.why_not = trial.error;
    claim.is_error = true;
    return claim;
  }
  claim.printed = outcome_of(trial.statements[0]);
  if (trial.statements.size() > 1) claim.corrected = outcome_of(trial.statements[1]);
  if (claim.printed.verdict == report::Verdict::undecided)
    claim.why_not = "it is undecided: " + claim.printed.reason;
  return claim;
}

// The verdict on a statement that was decided before, unchanged.
TrialOutcome known_or_decided(const TrialStatement& s, const MutatedClaim& claim) {
  if (!s.digest.empty() && s.digest == claim.printed.digest) return claim.printed;
  if (!s.digest.empty() && claim.corrected && s.digest == claim.corrected->digest)
    return *claim.corrected;
  return outcome_of(s);
}

bool is_out_of_limits(const TrialOutcome& o) {
  return o.reason == "time" || o.reason == "memory";
}

void judge(MutantRun& mutant, const MutatedClaim& claim, const Trial& trial) {
  mutant.error = trial.error;
  mutant.fate = Fate::error;
  if (!trial.error.empty()) return;
  mutant.printed = known_or_decided(trial.statements[0], claim);
  if (trial.statements.size() > 1)
    mutant.corrected = known_or_decided(trial.statements[1], claim);
  const auto same = [&](auto member) {
    return mutant.printed.*member == claim.printed.*member &&
           (!claim.corrected || mutant.corrected.value_or(TrialOutcome{}).*member ==
                                    claim.corrected.value_or(TrialOutcome{}).*member);
  };
  if (same(&TrialOutcome::digest))
    mutant.fate = Fate::unchanged;
  else if (is_out_of_limits(mutant.printed) ||
           (mutant.corrected && is_out_of_limits(*mutant.corrected)))
    mutant.fate = Fate::unknown;
  else
    mutant.fate = same(&TrialOutcome::verdict) ? Fate::survived : Fate::verdict;
}

MutantRun described(const claims::File& file, const Mutation& mutation) {
  const claims::Difference difference = claims::difference(file, mutation);
  const text::Position place = text::position(*difference.where.source, difference.where.begin);
  MutantRun run;
  run.kind = mutation.word();
  run.file = difference.where.source->name;
  run.line = place.line;
  run.column = place.column;
  run.before = difference.before;
  run.after = difference.after;
  return run;
}

// `mutant000017`
std::string name_of(std::size_t number) {
  const std::string digits = std::to_string(number);
  return "mutant" + std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

void keep(MutantRun& mutant, const std::string& name, const std::string& text,
          const Trial& trial, std::map<std::string, std::string>& files) {
  const bool is_decided = std::ranges::any_of(trial.statements, [](const TrialStatement& s) {
    return s.verdict == report::Verdict::proven || s.verdict == report::Verdict::refuted;
  });
  if (!is_decided) return;
  mutant.kept = name + ".seam";
  files[mutant.kept] = text;
  for (std::size_t i = 0; i < trial.statements.size(); ++i)
    if (!trial.statements[i].certificate.empty())
      files[name + (i == 0 ? ".json" : ".corrected.json")] = trial.statements[i].certificate;
}

// How many mutants each claim gets; where there are fewer than claims, those that are drawn.
std::vector<std::size_t> shares(std::size_t claims, const MutateOptions& options) {
  std::vector<std::size_t> result(claims, static_cast<std::size_t>(options.per_claim));
  if (options.per_claim > 0 || claims == 0) return result;
  const std::size_t count = static_cast<std::size_t>(options.count);
  std::vector<std::size_t> order(claims);
  for (std::size_t i = 0; i < claims; ++i) order[i] = i;
  claims::Random random(options.seed);
  for (std::size_t i = claims; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  for (std::size_t i = 0; i < claims; ++i)
    result[order[i]] = count / claims + (i < count % claims ? 1 : 0);
  return result;
}

// Claims that are not changed need not be decided.
void drop_without_share(std::vector<Excerpt>& excerpts, std::vector<std::size_t>& share) {
  std::vector<Excerpt> kept;
  for (std::size_t i = 0; i < excerpts.size(); ++i)
    if (share[i] > 0) kept.push_back(std::move(excerpts[i]));
  excerpts = std::move(kept);
  std::erase(share, 0U);
}

}  // namespace

Mutated mutate(const std::filesystem::path& path, const MutateOptions& options,
               const VerifyOptions& search, const Progress& progress) {
  const claims::File file = claims::with_included(parsed(path), opener_beside(path));
  std::vector<Excerpt> excerpts = claims::excerpts(file);
  std::erase_if(excerpts, [&](const Excerpt& e) { return !selected(e.id, search.claims); });
  if (excerpts.empty()) throw Failure{usage, "no claim of the file is selected\n"};
  std::vector<std::size_t> share = shares(excerpts.size(), options);
  drop_without_share(excerpts, share);

  std::vector<Attempt> attempts;
  for (std::size_t i = 0; i < excerpts.size(); ++i)
    attempts.push_back({i, claims::format(excerpts[i].file)});
  const auto tell = [&](std::size_t done) {
    progress(static_cast<int>(done), static_cast<int>(attempts.size()), "claims unchanged");
  };
  std::vector<Aside> results = try_all(attempts, excerpts, search, tell);

  Mutated mutated;
  mutated.run = {tool_name(), path.filename().string(), options.seed, {}};
  std::vector<MutatedClaim>& claims_run = mutated.run.claims;
  for (std::size_t i = 0; i < excerpts.size(); ++i)
    claims_run.push_back(claim_of(excerpts[i].id, results[i]));

  // An excerpt that cannot be read comes of a file that cannot be read; this says why.
  if (std::ranges::any_of(claims_run, [](const MutatedClaim& c) { return c.is_error; }))
    meant(path, limits(search, path.string()));

  attempts.clear();
  std::vector<MutantRun> mutants;
  for (std::size_t i = 0; i < excerpts.size(); ++i) {
    const MutatedClaim& claim = claims_run[i];
    if (!claim.why_not.empty()) continue;
    std::vector<std::string> known = {claim.printed.digest};
    if (claim.corrected) known.push_back(claim.corrected->digest);
    const std::uint64_t seed = claims::seed_of(options.seed, claim.id);
    for (const Mutation& mutation : claims::sample(excerpts[i].file, share[i], seed)) {
      attempts.push_back(
          {i, claims::format(claims::mutated(excerpts[i].file, mutation)), known});
      mutants.push_back(described(excerpts[i].file, mutation));
    }
  }
  results = try_all(attempts, excerpts, search, [&](std::size_t done) {
    progress(static_cast<int>(done), static_cast<int>(attempts.size()), "mutants");
  });

  for (std::size_t m = 0; m < mutants.size(); ++m) {
    MutantRun& mutant = mutants[m];
    MutatedClaim& claim = claims_run[attempts[m].claim];
    if (results[m].end == Aside::End::done) {
      const Trial trial = read_trial(results[m].text);
      judge(mutant, claim, trial);
      keep(mutant, name_of(m + 1), attempts[m].text, trial, mutated.files);
    } else if (results[m].end == Aside::End::failed) {
      mutant.error = "internal error: " + results[m].text;
    }
    claim.mutants.push_back(std::move(mutant));
  }
  return mutated;
}

}  // namespace seam::cli
