// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

#include "certificate/json.h"
#include "cli/files.h"
#include "cli/outcome.h"
#include "report/file.h"
#include "report/json.h"
#include "report/latex.h"
#include "report/pdf.h"
#include "report/terminal.h"

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

report::Colour colour_of(const std::string& word) {
  if (word == "always") return report::Colour::always;
  return word == "never" ? report::Colour::never : report::Colour::automatic;
}

// On a terminal a line that is written over; elsewhere a sign of life every 30 seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet) : terminal_(isatty(STDERR_FILENO) != 0 && !quiet) {
    if (!terminal_ && !quiet)
      heartbeat_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
  }
  ~ProgressLine() {
    if (terminal_) std::cerr << "\r\x1b[K";
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(int done, int all, const std::string& id) {
    const std::lock_guard lock(mutex_);
    text_ = std::to_string(done) + " of " + std::to_string(all) + "  " + id;
    if (terminal_) std::cerr << "\r\x1b[K" << text_ << std::flush;
  }

 private:
  void beat(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      wake_.wait_for(lock, stop, std::chrono::seconds(30), [] { return false; });
      if (!stop.stop_requested()) std::cerr << "… " << text_ << std::endl;
    }
  }

  bool terminal_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::string text_ = "reading";
  std::jthread heartbeat_;
};

void write(const fs::path& path, const std::string& bytes) {
  if (const auto error = report::write_file(path, bytes))
    throw Failure{io_error, error->message + "\n"};
}

void write_outputs(const fs::path& folder, const Verified& verified, const std::string& tool,
                   bool pdf) {
  const report::Run run{tool, {verified.run}};
  for (const auto& [name, certificate] : verified.certificates)
    write(folder / name, certificate::write(certificate));
  write(folder / "results.json", report::json(run));
  write(folder / "report.tex", report::latex(run));
  if (!pdf) return;
  if (const auto error = report::typeset(folder / "report.tex"))
    throw Failure{io_error, error->message + "\n"};
}

std::string tool_name() {
  return std::string("seamproof ") + SEAMPROOF_VERSION;
}

// The one claim of a file, with everything it uses.
Verified one_claim(const std::string& file, const std::string& id, VerifyOptions options) {
  const claims::Meaning meaning = meant(file);
  std::vector<std::string> ids;
  std::map<std::string, std::vector<std::string>> uses;
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item)) {
      ids.push_back(claim->claim.id);
      uses[claim->claim.id] = claim->claim.using_claims;
    }
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const auto& cell : row.cells) ids.push_back(cell.claim.id);
  }
  if (std::ranges::find(ids, id) == ids.end()) {
    const std::string near = text::nearest(id, ids);
    throw Failure{usage, "no claim '" + id + "' in " + file +
                             (near.empty() ? "" : "; did you mean '" + near + "'?") + "\n"};
  }
  options.claims = {id};
  for (std::size_t i = 0; i < options.claims.size(); ++i)
    for (const std::string& used : uses[options.claims[i]])
      if (std::ranges::find(options.claims, used) == options.claims.end())
        options.claims.push_back(used);
  return verify(file, options, [](int, int, const std::string&) {});
}

const report::ClaimRun& find(const report::FileRun& run, const std::string& id) {
  for (const report::ClaimRun* claim : report::claims(run))
    if (claim->id == id) return *claim;
  throw Failure{internal, "the claim was lost\n"};
}

const char* status_word(report::ObligationRun::Status status) {
  if (status == report::ObligationRun::Status::holds) return "holds";
  return status == report::ObligationRun::Status::fails ? "fails" : "open";
}

void print_outcome(const char* heading, const report::Outcome& outcome) {
  std::cout << heading << ": " << outcome.text << "\n  " << report::shape(outcome.verdict)
            << " " << report::word(outcome.verdict);
  if (!outcome.witness.empty()) std::cout << ", " << outcome.witness;
  if (!outcome.reason.empty()) std::cout << ", " << outcome.reason << ": " << outcome.detail;
  std::cout << "\n";
  int number = 0;
  for (const auto& o : outcome.obligations) {
    std::cout << "  " << ++number << ". " << status_word(o.status) << "  " << o.kind
              << (o.guard ? " (guard)" : "");
    if (!o.about.empty()) std::cout << "  " << o.about;
    std::cout << "\n     " << o.text << "\n     " << o.evidence << "\n";
  }
}

}  // namespace

int verify_files(const std::vector<std::string>& arguments, const VerifyOptions& options,
                 const Outputs& outputs) {
  const std::vector<fs::path> files = seam_files(arguments);
  const bool colour = report::wants_colour(colour_of(outputs.colour),
                                           isatty(STDOUT_FILENO) != 0, std::getenv("NO_COLOR"));
  report::Run run{tool_name(), {}};
  for (const fs::path& file : files) {
    ProgressLine progress(outputs.quiet);
    Verified verified = verify(file, options, [&](int done, int all, const std::string& id) {
      progress(done, all, id);
    });
    if (!outputs.out.empty()) {
      const fs::path folder =
          files.size() == 1 ? fs::path(outputs.out) : fs::path(outputs.out) / file.stem();
      write_outputs(folder, verified, run.tool, outputs.pdf);
    }
    run.files.push_back(std::move(verified.run));
  }
  const bool nothing =
      std::ranges::all_of(run.files, [](const auto& f) { return report::claims(f).empty(); });
  if (nothing && !options.claims.empty()) throw Failure{usage, "no claim has such an id\n"};
  if (!outputs.json.empty() && outputs.json != "-") write(outputs.json, report::json(run));
  if (outputs.json == "-") {
    std::cout << report::json(run);
  } else if (!outputs.quiet) {
    std::cout << report::terminal(run, colour);
  }
  for (const auto& file : run.files)
    for (const report::ClaimRun* claim : report::claims(file))
      for (const report::Outcome* outcome :
           {&claim->printed, claim->corrected ? &*claim->corrected : nullptr})
        if (outcome && !outcome->alarm.empty())
          std::cerr << "soundness alarm: " << claim->id
                    << ": the checker did not accept the evidence: " << outcome->alarm << "\n";
  return report::exit_status(run, outputs.allow_undecided);
}

int list_claims(const std::vector<std::string>& files) {
  for (const fs::path& file : seam_files(files)) {
    const claims::File parsed_file = parsed(file);
    for (const auto& item : parsed_file.items)
      if (item.kind == claims::Item::Kind::claim || item.kind == claims::Item::Kind::table)
        std::cout << (item.claim.id.empty() ? item.name : item.claim.id) << "\n";
  }
  return ok;
}

int list_obligations(const std::vector<std::string>& files) {
  for (const fs::path& file : seam_files(files)) {
    const claims::Meaning meaning = meant(file);
    const auto print = [](const std::string& id, const claims::Lowered& lowered) {
      const std::string digest =
          lowered.exported ? certificate::digest(lowered.exported->statement).substr(0, 16)
                           : "unsupported     ";
      std::cout << digest << "  " << id << "\n";
    };
    const auto print_claim = [&](const claims::MeantClaim& claim) {
      print(claim.claim.id, claim.printed);
      if (claim.corrected) print(claim.claim.id + " (corrected)", *claim.corrected);
    };
    for (const auto& item : meaning.items) {
      if (const auto* claim = std::get_if<claims::MeantClaim>(&item)) print_claim(*claim);
      if (const auto* table = std::get_if<claims::MeantTable>(&item))
        for (const auto& row : table->rows)
          for (const auto& cell : row.cells) print_claim(cell);
    }
  }
  return ok;
}

int format_files(const std::vector<std::string>& files, bool in_place) {
  for (const fs::path& file : seam_files(files)) {
    const std::string text = claims::format(parsed(file));
    if (in_place)
      write(file, text);
    else
      std::cout << text;
  }
  return ok;
}

int explain(const std::string& file, const std::string& id, const VerifyOptions& options) {
  const Verified verified = one_claim(file, id, options);
  const report::ClaimRun& claim = find(verified.run, id);
  std::cout << id << (claim.title.empty() ? "" : "  \"" + claim.title + "\"")
            << (claim.at.empty() ? "" : "  at " + claim.at) << "\n";
  for (const std::string& comment : claim.comments) std::cout << "  # " << comment << "\n";
  print_outcome("statement", claim.printed);
  if (claim.corrected) print_outcome("corrected", *claim.corrected);
  for (const std::string& used : claim.using_claims)
    std::cout << "rests on " << used << ": "
              << report::word(find(verified.run, used).printed.verdict) << "\n";
  return ok;
}

int trust(const std::string& file, const std::string& id, const VerifyOptions& options) {
  const Verified verified = one_claim(file, id, options);
  const report::ClaimRun& claim = find(verified.run, id);
  std::cout << id << ": " << report::word(claim.printed.verdict) << "\n\n"
            << "To believe this you have to believe\n"
            << "- that the statement says what the paper says:\n    " << claim.printed.text
            << "\n"
            << "- that these obligations are what it means (digest "
            << claim.printed.digest.substr(0, 16) << "):\n";
  for (const auto& o : claim.printed.obligations)
    std::cout << "    " << status_word(o.status) << "  " << o.text
              << (o.about.empty() ? "" : "  [" + o.about + "]") << "\n";
  std::cout << "- the meaning of the definitions and predicates it uses (docs/language.md)";
  for (const std::string& predicate : claim.predicates) std::cout << " " << predicate;
  std::cout << "\n- the checker, seamproof-check, its Boost.Multiprecision integers and the "
               "compiler.\n"
            << "You need not believe the prover or its libraries (GiNaC, CLN, FLINT, Arb, GMP) "
               "for the verdict; geometry and the\n"
            << "reading of the file use GMP, FLINT and Arb to build the obligations.\n";
  for (const std::string& used : claim.using_claims)
    std::cout << "It rests on the claim " << used << ": "
              << report::word(find(verified.run, used).printed.verdict) << "\n";
  return ok;
}

int ask(const std::string& file, const std::string& expression, int digits,
        const VerifyOptions& options) {
  const auto source =
      std::make_shared<const text::Source>(text::Source{"question", expression});
  claims::ParsedExpression question = claims::parse_expression(source);
  std::vector<text::Diagnostic> errors = std::move(question.errors);
  claims::MeantAsk meant_ask;
  if (errors.empty())
    meant_ask = claims::mean_question(parsed(file), opener_beside(file), question.expression,
                                      digits, errors);
  if (!errors.empty()) {
    std::string all;
    for (const auto& error : errors) all += text::render(error);
    throw Failure{bad_file, all};
  }
  prove::Budget budget;
  budget.effort = options.effort;
  const auto attempt = [&](const claims::Lowered& lowered) {
    return decide(lowered, meant_ask.expression, budget,
                  [](const symbolic::Formula& f) { return f; });
  };
  Decided decided = attempt(meant_ask.statement);
  const bool is_enclosed =
      decided.outcome.verdict != certificate::Verdict::proven && meant_ask.enclosure;
  if (is_enclosed) decided = attempt(*meant_ask.enclosure);
  if (decided.outcome.verdict != certificate::Verdict::proven) {
    std::cerr << "no certified value: "
              << (decided.outcome.detail.empty()
                      ? "the value that was found could not be confirmed"
                      : decided.outcome.detail)
              << "\n";
    return 2;
  }
  std::cout << meant_ask.decimal << "\n";
  if (!is_enclosed) std::cout << "= " << meant_ask.closed_form << "\n";
  return ok;
}

int start_file(const std::string& name) {
  const fs::path path =
      fs::path(name).extension() == ".seam" ? fs::path(name) : fs::path(name + ".seam");
  if (fs::exists(path)) throw Failure{usage, "'" + path.string() + "' exists already\n"};
  write(path, R"(# A paper's mathematics: definitions first, then its claims.
paper "Title of the paper" by "Its authors"

section "1  An example"

# Numbers are exact: the golden ratio, not a decimal.
let phi = (1 + sqrt(5))/2

claim golden.square "the golden ratio solves x^2 = x + 1" at "p. 1":
    phi^2 = phi + 1

claim golden.digits "its printed digits are rounded correctly" at "p. 1":
    phi ~ 1.618

# A cubic triangle patch, its control points printed in rows.
let p = triangle_patch [
    (0,0,3), (0,2,3), (0,3,2), (0,3,0);
    (2,0,3), (3,3,3), (2,3,0);
    (3,0,2), (3,2,0);
    (3,0,0) ]

claim patch.regular "it has a tangent plane everywhere" at "§1":
    regular(p)
)");
  std::cout << path.string() << "\n";
  return ok;
}

}  // namespace seam::cli
