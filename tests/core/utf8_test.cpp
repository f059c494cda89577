#include "core/utf8.hpp"

#include <gtest/gtest.h>

namespace clast {
namespace {

// The table of well-formed byte sequences of the Unicode standard, from both sides.
TEST(Utf8, WellFormedTextIsToldFromTheRest) {
  for (const char* good : {"", "B7", "\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
                           "\xee\x80\x80", "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf",
                           "Gr\xc3\xb6\xc3\x9f"
                           "e 5 \xe2\x82\xac"}) {
    EXPECT_TRUE(is_utf8(good)) << good;
  }
  for (const char* bad :
       {"\x80", "\xbf", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xed\xbf\xbf",
        "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "a\xc3", "\xe2\x82",
        "\xf0\x90\x80", "\xc3(", "\xe2(\x80", "\xe2\x82(", "\xf0\x90\x80(",
        "Gr\xf6\xdf"
        "e"}) {
    EXPECT_FALSE(is_utf8(bad)) << bad;
  }
  EXPECT_TRUE(is_utf8(std::string_view("a\0b", 3)));
}

TEST(Utf8, LatinAndWindowsBytesBecomeTheirCharacters) {
  EXPECT_EQ(utf8_from_latin1("Ch\xe2teau, \xb5m, \xff"), "Ch\xc3\xa2teau, \xc2\xb5m, \xc3\xbf");
  // The euro sign, a dash and S with caron are Windows' own.
  EXPECT_EQ(utf8_from_latin1("\x80 \x96 \x8a"), "\xe2\x82\xac \xe2\x80\x93 \xc5\xa0");
  for (int byte = 0; byte < 256; ++byte) {
    const std::string one(1, static_cast<char>(byte));
    EXPECT_TRUE(is_utf8(utf8_from_latin1(one))) << byte;
    EXPECT_EQ(is_utf8(one), byte < 0x80) << byte;
  }
}

TEST(Utf8, TextThatIsUtf8StaysAsItIs) {
  EXPECT_EQ(to_utf8("Ch\xc3\xa2teau"), "Ch\xc3\xa2teau");
  EXPECT_EQ(to_utf8("Ch\xe2teau"), "Ch\xc3\xa2teau");
}

}  // namespace
}  // namespace clast
