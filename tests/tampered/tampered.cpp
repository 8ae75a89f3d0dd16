// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "certificate/to_json.h"
#include "changes.h"
#include "outcome.h"

// tampered QUESTIONS CAP LONGEST FOLDER...: changes every certificate of the folders that has
// LONGEST bytes or fewer. Of the changes of one kind in one part of a certificate CAP are made,
// evenly spread. Writes to QUESTIONS, a line each, the changed certificates that still decide a
// statement: the same by other evidence, or another. The evidence of the next certificates is
// put under each statement, too.

namespace {

using namespace seam;
using tampered::Change;
using tampered::Json;
using tampered::Original;
using tampered::Outcome;

struct Row {
  std::map<Outcome::Kind, long> counts;
  double seconds = 0;
};
using Table = std::map<std::string, Row>;

class Campaign {
 public:
  Campaign(const std::string& questions, std::size_t cap) : questions_(questions), cap_(cap) {}

  void folder(const std::filesystem::path& folder, std::uintmax_t longest) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".json" && entry.file_size() <= longest)
        files.push_back(entry.path().string());
    std::ranges::sort(files);
    std::vector<Original> all;
    for (const std::string& file : files) all.push_back(tampered::original(file));
    for (std::size_t i = 0; i < all.size(); ++i) {
      change(all[i]);
      for (std::size_t k = 1; k < all.size() && k <= std::min(cap_, std::size_t{8}); ++k)
        exchange(all[i], all[(i + k) % all.size()]);
    }
    certificates_ += all.size();
  }

  int report() const {
    std::cout << certificates_ << " certificates\n";
    print("kind of change", by_kind_);
    print("part", by_part_);
    return wrong_ > 0 ? 1 : 0;
  }

 private:
  std::ofstream questions_;
  std::size_t cap_;
  std::size_t certificates_ = 0;
  long wrong_ = 0;
  Table by_kind_, by_part_;

  void change(const Original& original) {
    std::map<std::pair<std::string, std::string>, std::vector<Change>> groups;
    for (Change& change : tampered::changes(original.json))
      groups[{change.kind, change.part}].push_back(std::move(change));
    for (const auto& [name, group] : groups) {
      const std::size_t n = std::min(cap_, group.size());
      for (std::size_t i = 0; i < n; ++i) {
        const Change& change = group[i * group.size() / n];
        Json changed = original.json;
        change.apply(changed.at(change.place));
        judge(original, changed, change.kind, change.part, change.place.to_string());
      }
    }
  }

  void exchange(const Original& original, const Original& other) {
    Json changed = original.json;
    changed["evidence"] = other.json["evidence"];
    judge(original, changed, "evidence of another claim", "evidence", other.file);
    changed = original.json;
    changed["evidence"]["proofs"] = other.json["evidence"]["proofs"];
    judge(original, changed, "proofs of another claim", "evidence", other.file);
    changed = original.json;
    changed["statement"]["obligations"] = other.json["statement"]["obligations"];
    judge(original, changed, "obligations of another claim", "statement", other.file);
  }

  void judge(const Original& original, const Json& changed, const std::string& kind,
             const std::string& part, const std::string& place) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = tampered::outcome(original, changed);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (outcome.kind == Outcome::Kind::unchanged) return;
    for (Row* row : {&by_kind_[kind], &by_part_[part]}) {
      ++row->counts[outcome.kind];
      row->seconds += passed.count();
    }
    if (outcome.kind == Outcome::Kind::wrong) {
      ++wrong_;
      std::cout << "WRONG: " << original.file << ", " << kind << " at " << place << ": "
                << outcome.reason << '\n';
    }
    if (outcome.shown == certificate::Verdict::undecided) return;
    questions_ << Json{{"file", original.file},
                       {"kind", kind},
                       {"part", part},
                       {"place", place},
                       {"shown", spelling(outcome.shown)},
                       {"certificate", changed}}
               << '\n';
  }

  static void print(const std::string& head, const Table& table) {
    std::cout
        << "\n| " << head
        << " | mutants | unreadable | rejected | accepted, same statement | accepted, other "
           "statement | wrong | seconds |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | "
           "---: |\n";
    Row sum;
    for (const auto& [name, row] : table) {
      line(name, row);
      for (const auto& [kind, count] : row.counts) sum.counts[kind] += count;
      sum.seconds += row.seconds;
    }
    line("all", sum);
  }

  static void line(const std::string& name, const Row& row) {
    using enum Outcome::Kind;
    long all = 0;
    for (const auto& [kind, count] : row.counts) all += count;
    std::cout << "| " << name << " | " << all;
    for (const auto kind : {unreadable, rejected, same_statement, other_statement, wrong}) {
      const auto found = row.counts.find(kind);
      std::cout << " | " << (found == row.counts.end() ? 0 : found->second);
    }
    std::cout << " | " << std::fixed << std::setprecision(1) << row.seconds << " |\n";
  }
};

}  // namespace

int main(int count, char** words) {
  if (count < 5) {
    std::cerr << "usage: tampered QUESTIONS CAP LONGEST FOLDER...\n";
    return 64;
  }
  try {
    Campaign campaign(words[1], std::stoul(words[2]));
    for (int i = 4; i < count; ++i) campaign.folder(words[i], std::stoul(words[3]));
    return campaign.report();
  } catch (const std::exception& error) {
    std::cerr << "tampered: " << error.what() << '\n';
    return 70;
  }
}
