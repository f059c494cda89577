#include "core/number_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast {
namespace {

TEST(NumberRange, HoldsItsEndsAndNoMore) {
  constexpr NumberRange range{1e-2, 1e3, "m/s^2"};
  for (const double value : {1e-2, 9.81, 1e3}) EXPECT_TRUE(range.holds(value)) << value;
  for (const double value : {0.0, -9.81, 0.0099, 1000.1, 1e-300, 1e308, double(INFINITY),
                             -double(INFINITY), std::nan("")}) {
    EXPECT_FALSE(range.holds(value)) << value;
  }
  EXPECT_EQ(range.words(), "from 0.01 to 1000 m/s^2");
}

TEST(NumberRange, ZeroIsAllowedWhereItMeansSomething) {
  constexpr NumberRange none{1e-6, 1e6, "m", "none is filled"}, plain{1e-6, 100.0, "", ""};
  EXPECT_TRUE(none.holds(0.0) && none.holds(-0.0) && plain.holds(0.0));
  EXPECT_FALSE(none.holds(1e-300) || plain.holds(std::nan("")));
  EXPECT_EQ(none.words(), "0 (none is filled), or from 1e-06 to 1e+06 m");
  EXPECT_EQ(plain.words(), "0, or from 1e-06 to 100");
}

}  // namespace
}  // namespace clast
