// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certificate/json.h"
#include "certificate/to_json.h"
#include "check/judge.h"
#include "text/standard_streams.h"

// Judges certificates anew from their files. A claim is *established* when its own
// certificate says proven, the judge agrees, and all that it uses is established: the least
// such set, so that claims which use each other in a circle establish nothing.

namespace {

using namespace seam;
using certificate::Certificate;
using certificate::Verdict;

constexpr int exit_invalid = 3, exit_usage = 64, exit_no_input = 66, exit_output = 74;

constexpr const char* usage =
    "usage: seamproof-check DIR|FILE...\n"
    "\n"
    "Judges the evidence of certificates again, independently of the program that found it.\n"
    "Of a folder it takes the files *.json in folders named 'certificates'; where there is\n"
    "none, all files *.json. Prints a line for each certificate:\n"
    "\n"
    "  Valid|Conditional|Invalid  CLAIM  VERDICT  DIGEST  [reason]\n"
    "\n"
    "DIGEST is the start of the SHA-256 of the statement that was judged.\n"
    "Exit status: 0 all accepted, 3 some invalid, 64 wrong usage, 66 missing input.\n";

enum class Answer { valid, conditional, invalid };

/// A certificate of a folder, judged.
struct Judged {
  std::filesystem::path file;
  Certificate certificate;
  check::Judgement judgement;
  std::string digest;
  std::string fault;  ///< why it could not be read
};

using Claim = std::pair<std::filesystem::path, std::string>;  // folder and id

/// Of each claim in a folder: whether it is established.
using Established = std::map<Claim, bool>;

std::vector<std::filesystem::path> certificates_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> all, certificates;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".json") continue;
    all.push_back(entry.path());
    if (entry.path().parent_path().filename() == "certificates")
      certificates.push_back(entry.path());
  }
  return certificates.empty() ? all : certificates;
}

// At most one byte more than a certificate may have: a file need not have an end.
std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw certificate::FormatError("the file cannot be opened");
  std::string bytes;
  std::vector<char> block(std::size_t{1} << 16);
  do {
    file.read(block.data(), std::ssize(block));
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
  } while (file && bytes.size() <= certificate::max_bytes);
  return bytes;
}

Judged judged(const std::filesystem::path& path) {
  Judged result;
  result.file = path;
  try {
    result.certificate = certificate::read(bytes_of(path));
    result.digest = certificate::digest(result.certificate.statement).substr(0, 16);
    result.judgement = check::judge(result.certificate.statement, result.certificate.evidence);
  } catch (const std::exception& error) {
    result.fault = error.what();
  }
  return result;
}

Claim claim(const Judged& judged, const std::string& id) {
  return {judged.file.parent_path(), id};
}

// Grows from nothing, so it ends; a claim with two certificates needs both.
Established establish(const std::vector<Judged>& all) {
  Established established;
  for (const Judged& judged : all)
    if (judged.fault.empty() && !judged.certificate.correction)
      established[claim(judged, judged.certificate.claim)] = false;
  for (bool grows = true; grows;) {
    Established next;
    for (const Judged& judged : all) {
      const Certificate& mine = judged.certificate;
      if (!judged.fault.empty() || mine.correction) continue;
      const bool is_proven = mine.verdict == Verdict::proven &&
                             judged.judgement.verdict == Verdict::proven &&
                             std::ranges::all_of(mine.using_claims, [&](const auto& id) {
                               const auto used = established.find(claim(judged, id));
                               return used != established.end() && used->second;
                             });
      const auto place = next.emplace(claim(judged, mine.claim), true).first;
      place->second = place->second && is_proven;
    }
    grows = next != established;
    established = std::move(next);
  }
  return established;
}

std::pair<Answer, std::string> answer(const Judged& judged, const Established& established) {
  if (!judged.fault.empty()) return {Answer::invalid, judged.fault};
  const Certificate& certificate = judged.certificate;
  const Verdict found = judged.judgement.verdict;
  const bool is_conditional = certificate.verdict == Verdict::conditional;
  if (found != (is_conditional ? Verdict::proven : certificate.verdict))
    return {Answer::invalid,
            std::string("the evidence shows: ") + certificate::spelling(found) +
                (found == Verdict::undecided ? ", " + judged.judgement.reason : "")};
  if (found == Verdict::undecided) return {Answer::valid, judged.judgement.reason};
  if (found == Verdict::refuted) return {Answer::valid, ""};
  for (const std::string& id : certificate.using_claims) {
    const auto used = established.find(claim(judged, id));
    if (used == established.end())
      return {Answer::conditional, "rests on " + id + ", which is not among the files"};
    if (used->second) continue;
    const std::string reason = "rests on " + id + ", which is not proven";
    return {is_conditional ? Answer::conditional : Answer::invalid, reason};
  }
  if (is_conditional) return {Answer::invalid, "all that it rests on is proven"};
  return {Answer::valid, ""};
}

// Text out of a file may not steer the terminal: no control characters, of one byte or of
// two (U+0080 to U+009F).
std::string printable(std::string text) {
  unsigned char before = 0;
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 127 || (before == 0xC2 && byte < 0xA0)) c = '?';
    before = byte;
  }
  return text;
}

std::string line(const Judged& judged, Answer answer, const std::string& reason) {
  const std::string word = answer == Answer::valid         ? "Valid"
                           : answer == Answer::conditional ? "Conditional"
                                                           : "Invalid";
  const Certificate& certificate = judged.certificate;
  std::string text = word + "  ";
  if (judged.fault.empty())
    text += certificate.claim + (certificate.correction ? " (corrected)  " : "  ") +
            certificate::spelling(certificate.verdict) + "  " + judged.digest;
  else
    text += judged.file.string() + "  -  -";
  return printable(text + (reason.empty() ? "" : "  [" + reason + "]"));
}

int judge_all(const std::set<std::filesystem::path>& files) {
  std::vector<Judged> all;
  all.reserve(files.size());
  for (const auto& file : files) all.push_back(judged(file));
  const Established established = establish(all);
  std::map<Answer, int> counts;
  for (const Judged& judged : all) {
    const auto [verdict, reason] = answer(judged, established);
    ++counts[verdict];
    std::cout << line(judged, verdict, reason) << '\n';
  }
  std::cout << all.size() << (all.size() == 1 ? " certificate: " : " certificates: ")
            << counts[Answer::valid] << " valid, " << counts[Answer::conditional]
            << " conditional, " << counts[Answer::invalid] << " invalid\n";
  return counts[Answer::invalid] > 0 ? exit_invalid : 0;
}

int run(const std::vector<std::string>& arguments) {
  std::set<std::filesystem::path> files;
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      std::cout << usage;
      return 0;
    }
    if (argument == "--version") {
      std::cout << "seamproof-check " SEAMPROOF_VERSION "\n";
      return 0;
    }
    if (argument.starts_with("-")) {
      std::cerr << "seamproof-check: unknown option " << printable(argument) << '\n' << usage;
      return exit_usage;
    }
  }
  if (arguments.empty()) {
    std::cerr << usage;
    return exit_usage;
  }
  try {
    for (const std::string& argument : arguments) {
      const auto found = std::filesystem::is_directory(argument)
                             ? certificates_in(argument)
                             : std::vector<std::filesystem::path>{argument};
      if (found.empty() || !std::filesystem::exists(argument)) {
        std::cerr << "seamproof-check: no certificate in " << printable(argument) << '\n';
        return exit_no_input;
      }
      files.insert(found.begin(), found.end());
    }
    return judge_all(files);
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "seamproof-check: " << printable(error.what()) << '\n';
    return exit_no_input;
  }
}

}  // namespace

int main(int count, char** words) {
  seam::text::hold_standard_streams();
  const int status = run({words + 1, words + count});
  const std::string failure = seam::text::end_of_output();
  if (failure.empty()) return status;
  std::cerr << "seamproof-check: " << failure;
  return exit_output;
}
