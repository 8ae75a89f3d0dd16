// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace seam::report {
namespace {

namespace fs = std::filesystem;

class File : public testing::Test {
 protected:
  File() { fs::remove_all(folder); }
  ~File() override { fs::remove_all(folder); }

  static std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  fs::path folder = fs::path(testing::TempDir()) /
                    testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(File, is_written_with_the_folders_it_needs) {
  EXPECT_FALSE(write_file(folder / "a" / "b.txt", std::string_view("x\0y", 3)));
  EXPECT_EQ(bytes_of(folder / "a" / "b.txt"), std::string("x\0y", 3));
}

TEST_F(File, takes_the_place_of_an_earlier_one_and_leaves_nothing_else) {
  EXPECT_FALSE(write_file(folder / "b.txt", "earlier and longer"));
  EXPECT_FALSE(write_file(folder / "b.txt", "later"));
  EXPECT_EQ(bytes_of(folder / "b.txt"), "later");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(File, that_cannot_be_written_gives_a_message_with_its_name) {
  ASSERT_FALSE(write_file(folder / "b.txt", "a file where a folder is wanted"));
  const auto error = write_file(folder / "b.txt" / "c.txt", "x");
  ASSERT_TRUE(error);
  EXPECT_NE(error->message.find("b.txt/c.txt"), std::string::npos);
  EXPECT_EQ(bytes_of(folder / "b.txt"), "a file where a folder is wanted");
}

TEST_F(File, cannot_take_the_place_of_a_folder) {
  fs::create_directories(folder / "d" / "e");
  EXPECT_TRUE(write_file(folder / "d", "x"));
  EXPECT_TRUE(fs::is_directory(folder / "d" / "e"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace seam::report
