// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "process.h"

namespace seam::test {

namespace fs = std::filesystem;

/// A folder with a few files, in which the programs are run.
class Programs : public testing::Test {
 protected:
  Programs() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("right.seam", "claim a: 1 + 1 = 2\n");
    write("wrong.seam", "claim a: 1 + 1 = 3\n");
    write("known.seam", "claim a: 1 + 1 = 3\n    expect refuted\n");
    write("broken.seam", "claim a: 1 + = 3\n");
    write("hard.seam",
          "param x in [-1, 1]\nparam y in [-1, 1]\nparam z in [-1, 1]\n"
          "claim easy: 1 + 1 = 2\n"
          "claim hard: x^4*y^2 + x^2*y^4 + z^6 - 2.99999999999*x^2*y^2*z^2 + x^8 + y^8"
          " + 1/10^20 > 0\n"
          "claim last: x + 2 > 0\n");
  }
  ~Programs() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  Finished in_folder(const std::string& line) const {
    return run("cd " + quoted(folder_.string()) + " && " + line);
  }
  Finished seamproof(const std::string& words) const {
    return in_folder(quoted(SEAMPROOF) + " " + words);
  }
  Finished check(const std::string& words) const {
    return in_folder(quoted(SEAMPROOF_CHECK) + " " + words);
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("seamproof_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

}  // namespace seam::test
