#include "core/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.hpp"

namespace clast {
namespace {

TEST(NumberText, WholeTextIsRead) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number("-2e-3"), -0.002);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("inf"), std::numeric_limits<double>::infinity());
  ASSERT_TRUE(parse_number("nan"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(NumberText, AnythingElseIsNoNumber) {
  for (const char* text :
       {"", "+", "-", "+-1", "++1", " 1", "1 ", "1,5", "1.5m", "0x10", "1e", "five", "1e999"}) {
    EXPECT_FALSE(parse_number(text)) << "\"" << text << "\"";
  }
}

TEST(NumberText, SignificantDigitsAreKept) {
  EXPECT_EQ(format_significant(0.0254, 4), "0.0254");
  EXPECT_EQ(format_significant(2.0 / 3.0, 3), "0.667");
  EXPECT_EQ(format_significant(1250.0, 4), "1250");
  EXPECT_EQ(format_significant(1e8, 3), "1e+08");
  EXPECT_EQ(format_significant(-12345.6, 3), "-1.23e+04");
  EXPECT_EQ(format_significant(0.0, 4), "0");
  EXPECT_EQ(format_significant(std::numeric_limits<double>::infinity(), 4), "inf");
}

TEST(NumberText, SeventeenDigitsComeBackAsTheSameNumber) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-300.0, 300.0));
    EXPECT_EQ(parse_number(format_significant(value, 17)), value);
  }
}

TEST(NumberText, RoundedNumbersKeepTheirZeros) {
  EXPECT_EQ(format_rounded(2.0, 3), "2.00");
  EXPECT_EQ(format_rounded(9.996, 3), "10.0");
  EXPECT_EQ(format_rounded(123456.0, 3), "123456");
  EXPECT_EQ(format_rounded(9999999.6, 3), "1.00e+07");
  EXPECT_EQ(format_rounded(0.00012345, 3), "0.000123");
  EXPECT_EQ(format_rounded(0.000012345, 3), "1.23e-05");
  EXPECT_EQ(format_rounded(0.0, 3), "0");
  EXPECT_EQ(format_rounded(std::numeric_limits<double>::infinity(), 3), "inf");
}

TEST(NumberText, DecimalsHaveNoMinusBeforeZero) {
  EXPECT_EQ(format_decimals(-0.04, 1), "0.0");
  EXPECT_EQ(format_decimals(-0.06, 1), "-0.1");
  EXPECT_EQ(format_decimals(1e300, 1).size(), 303u);
  EXPECT_EQ(format_percent(0.0312), "3.1 %");
  EXPECT_EQ(format_percent(0.0312, 0), "3 %");
}

TEST(NumberText, PlacesAreToTheCentimetreOnAMap) {
  EXPECT_EQ(format_map_point({652013.25, 5203000.0, 0.0}), "x 652013.250, y 5203000.000, z 0.000");
  EXPECT_EQ(format_point({0.5, -1.0, 0.0}), "(0.5, -1, 0)");
  EXPECT_EQ(format_point({888600.125, 6671300.254, 200.0}), "(888600.125, 6671300.25, 200)");
}

}  // namespace
}  // namespace clast
