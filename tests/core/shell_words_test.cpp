// Suggested commands do in a shell what they say.
#include "core/shell_words.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace clast {
namespace {

TEST(ShellWords, PlainOnesStayAsTheyAre) {
  EXPECT_EQ(format_shell_command(
                {"clast", "simulate", "a-b_c/1.toml", "-o", "out=2,3.h5", "--shard", "1/4"}),
            "clast simulate a-b_c/1.toml -o out=2,3.h5 --shard 1/4");
  EXPECT_EQ(format_shell_command({"\xC3\xA9"
                                  "boulis.toml"}),
            "\xC3\xA9"
            "boulis.toml");
}

TEST(ShellWords, OthersAreQuoted) {
  EXPECT_EQ(format_shell_command({"my campaign.toml"}), "'my campaign.toml'");
  EXPECT_EQ(format_shell_command({""}), "''");
  EXPECT_EQ(format_shell_command({"it's.toml"}), "'it'\\''s.toml'");
  EXPECT_EQ(format_shell_command({"a\tb"}), "$'a\\x09b'");
}

/// What bash makes of a command that prints its words, each between two marks.
std::string words_in_bash(const std::vector<std::string>& words) {
  std::vector<std::string> all = {"printf", "<%s>"};
  all.insert(all.end(), words.begin(), words.end());
  std::string command = format_shell_command(all), script;
  for (const char character : command) {
    script += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  FILE* pipe = ::popen(("bash -c '" + script + "'").c_str(), "r");
  std::string out;
  for (int character; (character = std::fgetc(pipe)) != EOF;) out += static_cast<char>(character);
  ::pclose(pipe);
  return out;
}

// Every character of a byte, alone and among others.
TEST(ShellWords, ComeBackFromAShell) {
  for (int byte = 1; byte < 256; ++byte) {
    const std::string word = "a" + std::string(1, static_cast<char>(byte)) + "b";
    EXPECT_EQ(words_in_bash({word, std::string(1, static_cast<char>(byte))}),
              "<" + word + "><" + std::string(1, static_cast<char>(byte)) + ">")
        << byte;
  }
  EXPECT_EQ(words_in_bash({"$(touch x)", "`id`", "~", "*", "a\\'b\n", "#c", "!!", "&", ";"}),
            "<$(touch x)><`id`><~><*><a\\'b\n><#c><!!><&><;>");
}

}  // namespace
}  // namespace clast
