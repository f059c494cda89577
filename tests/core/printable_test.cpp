#include "core/printable.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/random.hpp"
#include "core/utf8.hpp"

namespace clast {
namespace {

TEST(Printable, LettersOfAnyLanguageStay) {
  for (const char* text :
       {"", "B017", "Ch\xc3\xa2teau", "\xe5\xb2\xa9", "\xf0\x9f\xaa\xa8", "a\\n"}) {
    EXPECT_EQ(escape_nonprintable(text), text);
  }
}

TEST(Printable, WhatATerminalObeysIsEscaped) {
  EXPECT_EQ(escape_nonprintable("red\x1b[31m"), "red\\u001b[31m");
  EXPECT_EQ(escape_nonprintable("B1\rB2\nclast: done\t"), "B1\\rB2\\nclast: done\\t");
  EXPECT_EQ(escape_nonprintable(std::string("a\0b\x7f", 4)), "a\\u0000b\\u007f");
  EXPECT_EQ(escape_nonprintable("\xc2\x9b"
                                "31m"),
            "\\u009b31m");  // CSI in one character
  EXPECT_EQ(escape_nonprintable("gpj.\xe2\x80\xae"
                                "exe"),
            "gpj.\\u202eexe");  // right-to-left override
  EXPECT_EQ(escape_nonprintable("\xe2\x80\xa8\xe2\x81\xa6"), "\\u2028\\u2066");
}

TEST(Printable, BytesThatAreNoUtf8AreShownAsBytes) {
  EXPECT_EQ(escape_nonprintable("Ch\xe2teau"), "Ch\\xe2teau");
  EXPECT_EQ(escape_nonprintable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(escape_nonprintable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a surrogate pair
}

TEST(Printable, OfAnyBytesIsOneLineOfUtf8) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes;
    for (std::size_t k = random.uniform_index(20); k > 0; --k) {
      bytes += static_cast<char>(random.uniform_index(256));
    }
    const std::string shown = escape_nonprintable(bytes);
    EXPECT_TRUE(is_utf8(shown));
    for (const char c : shown) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
    EXPECT_EQ(escape_nonprintable(shown), shown);
  }
}

}  // namespace
}  // namespace clast
