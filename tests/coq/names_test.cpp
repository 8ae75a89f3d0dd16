// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/names.h"

#include <gtest/gtest.h>

namespace seam::coq {
namespace {

TEST(Names, AreIdentifiers) {
  EXPECT_EQ(as_identifier("sqrt(5)"), "sqrt_5");
  EXPECT_EQ(as_identifier("u~"), "u");
  EXPECT_EQ(as_identifier("2x"), "x_2x");
  EXPECT_EQ(as_identifier("α"), "x_");
}

TEST(Names, AreDifferentForDifferentSymbols) {
  Names names;
  EXPECT_EQ(names.of("u"), "u");
  EXPECT_EQ(names.of("u~"), "u_1");
  EXPECT_EQ(names.of("u"), "u");
}

TEST(Names, HideNothingOfCoq) {
  Names names;
  EXPECT_EQ(names.of("R"), "R_1");
  EXPECT_EQ(names.of("exists"), "exists_1");
}

}  // namespace
}  // namespace seam::coq
