// Names and text that TOML files are written with: they are read back as they were.
#include "core/files/toml_text.hpp"

#include <gtest/gtest.h>

#include "core/files/toml_reader.hpp"

namespace clast {
namespace {

TEST(TomlText, PlainNamesStayAsTheyAre) {
  EXPECT_EQ(format_toml_key("upper_cliff-2"), "upper_cliff-2");
  EXPECT_EQ(format_toml_key("upper cliff"), "\"upper cliff\"");
  EXPECT_EQ(format_toml_key("a.b"), "\"a.b\"");
  EXPECT_EQ(format_toml_key(""), "\"\"");
  EXPECT_EQ(format_toml_string("it's"), "\"it's\"");
}

TEST(TomlText, IsReadBackAsItWas) {
  for (const std::string& text :
       {std::string("deep \"wet\" meadow"), std::string("C:\\new\\terrain"), std::string("éboulis"),
        std::string("a\nb\tc"), std::string("it's ''' and \"\"\""), std::string("\x01\x1f\x7f")}) {
    const TomlNode file =
        parse_toml(format_toml_key(text) + " = " + format_toml_string(text) + "\n", "text.toml");
    ASSERT_EQ(file.table.size(), 1u) << text;
    EXPECT_EQ(file.table[0].key, text);
    EXPECT_EQ(file.table[0].value.text, text);
  }
}

}  // namespace
}  // namespace clast
