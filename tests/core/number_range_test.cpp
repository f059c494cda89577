#include "core/number_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast {
namespace {

TEST(NumberRange, HoldsItsEndsAndNoMore) {
  constexpr NumberRange range{1e-2, 1e3, "m/s^2"};
  for (const double value : {1e-2, 9.81, 1e3}) EXPECT_TRUE(range.contains(value)) << value;
  for (const double value : {0.0, -9.81, 0.0099, 1000.1, 1e-300, 1e308, double(INFINITY),
                             -double(INFINITY), std::nan("")}) {
    EXPECT_FALSE(range.contains(value)) << value;
  }
  EXPECT_EQ(range.describe(), "from 0.01 to 1000 m/s^2");
}

TEST(NumberRange, ZeroIsAllowedWhereItMeansSomething) {
  constexpr NumberRange none{1e-6, 1e6, "m", "none is filled"}, plain{1e-6, 100.0, "", ""};
  EXPECT_TRUE(none.contains(0.0) && none.contains(-0.0) && plain.contains(0.0));
  EXPECT_FALSE(none.contains(1e-300) || plain.contains(std::nan("")));
  EXPECT_EQ(none.describe(), "0 (none is filled), or from 1e-06 to 1e+06 m");
  EXPECT_EQ(plain.describe(), "0, or from 1e-06 to 100");
}

}  // namespace
}  // namespace clast
