// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <map>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/one_claim.h"
#include "cli/paper.h"
#include "cli/printed_number.h"
#include "cli/supervisor.h"
#include "cli/true_digits.h"
#include "report/terminal.h"

// Each printed value becomes the statement `value ~ digits`, which is decided like a claim;
// each printed verdict is compared with that of the claim.

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

using certificate::Verdict;

struct Claims {
  fs::path file;
  std::unique_ptr<claims::NamedNumbers> numbers;
  std::vector<std::string> ids;
};

Claims read(const fs::path& file, const VerifyOptions& options) {
  const claims::Limits limits = cli::limits(options, file.string());
  Claims result{
      file,
      std::make_unique<claims::NamedNumbers>(parsed(file), opener_beside(file), limits),
      {}};
  if (!result.numbers->errors().empty()) meant(file, limits);  // which says them all
  result.ids = result.numbers->claim_ids();
  return result;
}

// `paper.tex:12:8`
std::string place_of(const text::Span& where) {
  const auto place = text::position(*where.source, where.begin);
  return where.source->name + ":" + std::to_string(place.line) + ":" +
         std::to_string(place.column);
}

// What is said of one mention.
struct Answer {
  Verdict verdict = Verdict::undecided;
  std::string alarm;
  std::string remark;  // the true digits, the reason, the true verdict
};

class Checking {
 public:
  Checking(const std::vector<fs::path>& files, const VerifyOptions& options)
      : options_(options) {
    for (const fs::path& file : files) all_.push_back(read(file, options));
  }

  int run(const Paper& paper) {
    for (const Unread& unread : paper.unread)
      std::cerr << place_of(unread.where) << ": not read: '" << unread.name
                << "' is not in the folder of the paper\n";
    errors_ = paper.errors;
    for (const Mention& mention : paper.mentions) {
      if (mention.kind == Mention::Kind::value) value(mention);
      if (mention.kind == Mention::Kind::status) status(mention);
      if (mention.kind == Mention::Kind::known_status) state(mention);
    }
    for (const auto& error : errors_) std::cerr << text::render(error);
    std::cout << count_ << " printed, " << right_ << " right, " << wrong_ << " wrong, "
              << count_ - right_ - wrong_ << " undecided\n";
    if (has_alarm_) return alarm;
    if (!errors_.empty()) return bad_file;
    return wrong_ > 0 ? 1 : right_ < count_ ? 2 : ok;
  }

 private:
  // The files in which something goes by the name; complains unless it is just one.
  const Claims* only(const Mention& mention, const char* what, auto knows, auto names) {
    std::vector<const Claims*> found;
    std::vector<std::string> known;
    for (const Claims& claims : all_) {
      if (knows(claims)) found.push_back(&claims);
      const auto more = names(claims);
      known.insert(known.end(), more.begin(), more.end());
    }
    if (found.size() == 1) return found.front();
    if (!found.empty()) {
      complain(mention, "'" + mention.id + "' is in " + found[0]->file.string() + " and in " +
                            found[1]->file.string());
      return nullptr;
    }
    const bool is_claim = std::ranges::any_of(all_, [&](const Claims& claims) {
      return std::ranges::find(claims.ids, mention.id) != claims.ids.end();
    });
    const std::string near = text::nearest(mention.id, known);
    complain(mention,
             is_claim ? "the claim '" + mention.id + "' compares no number"
                      : std::string("no ") + what + " is named '" + mention.id + "'",
             near.empty() || is_claim ? "" : "did you mean '" + near + "'?");
    return nullptr;
  }

  void value(const Mention& mention) {
    const Claims* claims = only(
        mention, "value", [&](const Claims& c) { return c.numbers->knows(mention.id); },
        [](const Claims& c) { return c.numbers->names(); });
    if (!claims) return;
    const auto number = printed_number(mention.argument);
    if (!number)
      return complain(mention, "'" + mention.argument + "' is no number that can be checked",
                      "write 0.2857, -0.2857, 0.28\\ldots or 1.5\\times10^{-3}, without dollar "
                      "signs and commas");
    const auto [known, is_new] =
        answers_.try_emplace({mention.id, claims::text(*number)}, Answer{});
    if (is_new) known->second = answer(*claims->numbers, mention.id, *number);
    tell(mention, known->second, known->second.verdict);
  }

  Answer answer(claims::NamedNumbers& numbers, const std::string& name,
                const claims::PrintedNumber& number) const {
    Answer result;
    try {
      const Decided decided = decide(numbers.printed_as(name, number), options_);
      result.verdict = decided.outcome.verdict;
      result.alarm = decided.outcome.alarm;
      if (result.verdict == Verdict::undecided)
        result.remark = decided.outcome.reason + ": " + decided.outcome.detail;
      if (result.verdict != Verdict::refuted) return result;
      const auto right =
          certified(numbers, name, std::max(number.places() - number.exponent, 0),
                    number.truncated, options_);
      result.remark = right ? "true digits: " + claims::text(right->number) : "";
    } catch (const claims::Unsupported& unsupported) {
      result.remark = std::string("unsupported: ") + unsupported.what();
    }
    return result;
  }

  // From here on \spstatus{id} prints this.
  void state(const Mention& mention) {
    const auto [stated, is_new] = stated_.emplace(mention.id, mention.argument);
    if (!is_new && stated->second != mention.argument)
      complain(mention, "the paper states two verdicts on '" + mention.id +
                            "': " + stated->second + " and " + mention.argument);
  }

  void status(const Mention& mention) {
    const Claims* claims = only(
        mention, "claim",
        [&](const Claims& c) { return std::ranges::find(c.ids, mention.id) != c.ids.end(); },
        [](const Claims& c) { return c.ids; });
    if (!claims) return;
    const auto stated = stated_.find(mention.id);
    const std::string printed = !mention.argument.empty() ? mention.argument
                                : stated == stated_.end() ? ""
                                                          : stated->second;
    if (printed.empty())
      return complain(
          mention, "the paper has no verdict on '" + mention.id + "' to print",
          "input seamproof-status.tex, or write \\spstatus{" + mention.id + "}{proven}");
    const auto [known, is_new] = verdicts_.try_emplace(mention.id, Answer{});
    if (is_new) {
      const Verified verified = one_claim(claims->file.string(), mention.id, options_);
      const report::Outcome& outcome = find(verified.run, mention.id).printed;
      known->second = {outcome.verdict, outcome.alarm, ""};
    }
    Answer answer = known->second;
    const std::string actual = report::word(answer.verdict);
    const bool is_decided =
        answer.verdict == Verdict::proven || answer.verdict == Verdict::refuted;
    answer.remark = printed == actual ? "" : "the claim is " + actual;
    tell({mention.kind, mention.id, printed, mention.where}, answer,
         printed == actual ? Verdict::proven
         : is_decided      ? Verdict::refuted
                           : Verdict::undecided);
  }

  // A line for the mention: `✓ proven  paper.tex:12  K_max  3.25`
  void tell(const Mention& mention, const Answer& answer, Verdict verdict) {
    ++count_;
    if (verdict == Verdict::proven) ++right_;
    if (verdict == Verdict::refuted) ++wrong_;
    if (!answer.alarm.empty()) {
      has_alarm_ = true;
      std::cerr << "soundness alarm: " << mention.id
                << ": the checker did not accept the evidence: " << answer.alarm << "\n";
    }
    const char* words[] = {"right", "wrong", "undecided"};
    const int index = verdict == Verdict::proven ? 0 : verdict == Verdict::refuted ? 1 : 2;
    std::cout << report::shape(verdict) << " " << words[index]
              << std::string(11 - std::string(words[index]).size(), ' ')
              << place_of(mention.where) << "  " << mention.id << "  " << mention.argument
              << (answer.remark.empty() ? "" : "  (" + answer.remark + ")") << "\n";
  }

  void complain(const Mention& mention, const std::string& message,
                const std::string& hint = {}) {
    errors_.push_back({mention.where, message, hint});
  }

  const VerifyOptions& options_;
  std::vector<Claims> all_;
  std::map<std::string, std::string> stated_;  // verdicts that the paper's status file has
  std::map<std::pair<std::string, std::string>, Answer> answers_;
  std::map<std::string, Answer> verdicts_;
  std::vector<text::Diagnostic> errors_;
  int count_ = 0, right_ = 0, wrong_ = 0;
  bool has_alarm_ = false;
};

}  // namespace

int check_tex(const std::string& paper, const std::vector<std::string>& files,
              const VerifyOptions& options) {
  const Paper read = read_paper(paper);
  if (read.mentions.empty() && read.errors.empty())
    std::cerr << paper << " has no \\spval and no \\spstatus\n";
  return Checking(seam_files(files), options).run(read);
}

}  // namespace seam::cli
