// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/interval.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace seam::check {
namespace {

constexpr int bits = 4;

// Every interval with small ends.
template <typename Visit>
void for_intervals(int size, const Visit& visit) {
  for (int low = -size; low <= size; ++low)
    for (int high = low; high <= size; ++high) visit(Interval{low, high});
}

TEST(Interval, a_product_holds_all_products_and_little_more) {
  for_intervals(6, [](const Interval& a) {
    for_intervals(6, [&](const Interval& b) {
      const Interval c = product(a, b, bits);
      Integer least = a.low * b.low;
      Integer greatest = least;
      for (Integer x = a.low; x <= a.high; ++x)
        for (Integer y = b.low; y <= b.high; ++y) {
          least = std::min<Integer>(least, x * y);
          greatest = std::max<Integer>(greatest, x * y);
        }
      ASSERT_LE(c.low << bits, least);
      ASSERT_GT((c.low + 1) << bits, least);
      ASSERT_GE(c.high << bits, greatest);
      ASSERT_LT((c.high - 1) << bits, greatest);
    });
  });
}

TEST(Interval, a_quotient_holds_all_quotients) {
  for_intervals(6, [](const Interval& a) {
    for_intervals(6, [&](const Interval& b) {
      if (b.holds_zero()) return;
      const Interval c = quotient(a, b, bits);
      for (Integer x = a.low; x <= a.high; ++x)
        for (Integer y = b.low; y <= b.high; ++y) {
          ASSERT_LE(c.low, floor_quotient(y < 0 ? -x << bits : x << bits, abs(y)));
          ASSERT_GE(c.high, ceiling_quotient(y < 0 ? -x << bits : x << bits, abs(y)));
        }
    });
  });
}

TEST(Interval, quotients_are_rounded_down_and_up) {
  for (int a = -20; a <= 20; ++a)
    for (int b = 1; b <= 7; ++b) {
      EXPECT_LE(floor_quotient(a, b) * b, a);
      EXPECT_GT((floor_quotient(a, b) + 1) * b, a);
      EXPECT_GE(ceiling_quotient(a, b) * b, a);
      EXPECT_LT((ceiling_quotient(a, b) - 1) * b, a);
    }
}

TEST(Interval, scaling_by_a_negative_number_exchanges_the_ends) {
  const Interval a = scaled({-1, 2}, -3);
  EXPECT_EQ(a.low, -6);
  EXPECT_EQ(a.high, 3);
}

TEST(Interval, fewer_bits_make_it_no_smaller) {
  for_intervals(40, [](const Interval& a) {
    const Interval b = rescaled(a, 5, 2);
    ASSERT_LE(b.low * 8, a.low);
    ASSERT_GT((b.low + 1) * 8, a.low);
    ASSERT_GE(b.high * 8, a.high);
    ASSERT_LT((b.high - 1) * 8, a.high);
    ASSERT_EQ(rescaled(a, 2, 5).low, a.low * 8);
  });
}

}  // namespace
}  // namespace seam::check
