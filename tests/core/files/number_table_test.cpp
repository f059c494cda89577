#include "core/files/number_table.hpp"

#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class NumberTables : public testing::Test {
 protected:
  std::vector<std::vector<double>> read(const std::string& text) {
    write_text_file(folder_ / "p.csv", text);
    std::vector<std::vector<double>> rows;
    for (const NumericRow& row : read_numeric_table(folder_ / "p.csv", kPoints)) {
      rows.push_back(row.values);
    }
    return rows;
  }
  /// The message behind "p.csv:".
  std::string refused(const std::string& text) {
    const std::string message = refusal([&] { read(text); });
    const std::size_t at = message.find("p.csv");
    return at == std::string::npos ? message : message.substr(at);
  }

  const NumericTableSpec kPoints{
      {{"x"}, {"y"}, {"z", "height"}}, {-1e8, 1e8, "m"}, "three numbers"};
  ScratchFolder folder_;
};

TEST_F(NumberTables, EveryTableOfTheSamePointsIsReadAlike) {
  const std::vector<std::vector<double>> points = {{1.5, 2.0, 3.25}, {4.0, 5.5, 6.0}};
  for (const char* text :
       {"1.5 2 3.25\n4 5.5 6\n", "1.5,2,3.25\n4,5.5,6\n", "1.5, 2, 3.25\n4, 5.5, 6\n",
        "1,5;2;3,25\n4;5,5;6\n", "1,5\t2\t3,25\n4\t5,5\t6\n", "1,5 2 3,25\n4 5,5 6\n",
        "\xef\xbb\xbfx;y;z\r\n1,5;2;3,25\r\n4;5,5;6\r\n",
        "x y z\n# May\n\n1.5 2 3.25 # edge\n4 5.5\t6\n",
        "\"X_m\",\"Y_m\",\"Height\"\n\"1.5\",2,3.25\n4,5.5,6\n",
        "\"x\",\"y\",\"z\"\n\"1.5\",\"2\",\"3.25\"\n\"4\",\"5.5\",\"6\"\n",
        "points, as surveyed\n1.5 2 3.25\n4 5.5 6\n", "id,z,y,x\nP1,3.25,2,1.5\nP2,6,5.5,4\n",
        "Point id\tx\ty\tz\nP 1\t1,5\t2\t3,25\nP 2\t4\t5,5\t6\n"}) {
    EXPECT_EQ(read(text), points) << text;
  }
}

TEST_F(NumberTables, HeadingsNameAllColumnsOrAreRefused) {
  const std::vector<std::vector<double>> points = {{1.5, 2.0, 3.25}};
  EXPECT_EQ(read("Nr;Y (m);X (m);Z [m]\n7;2;1.5;3.25\n"), points);
  EXPECT_EQ(read("\"y\",\"x\",\"height\"\n2,1.5,3.25\n"), points);
  for (const char* text :
       {"a,b,c\n1,2,3\n", "b;c;a\n1;2;3\n", "u v w\n1 2 3\n", "x\ty\tdepth\n1\t2\t3\n"}) {
    EXPECT_TRUE(contains(refused(text),
                         "p.csv:1: its heading does not name the columns; each line must be three "
                         "numbers; give the columns these names"))
        << text;
  }
  EXPECT_TRUE(contains(refused("x (ft),y (ft),z (ft)\n1,2,3\n"),
                       "p.csv:1: \"x (ft)\" is in ft; lengths of this table must be in m"));
  EXPECT_TRUE(contains(refused("id,x,y,z\nP1,1,2,3\nMean,1,2,3\n"),
                       "p.csv:3: \"Mean\" is a sum of other rows; remove that row"));
}

TEST_F(NumberTables, WhatIsNotThatIsRefusedWithFileAndLine) {
  // Decimal commas between commas: (1.5, 2.5, 3.5).
  EXPECT_TRUE(contains(refused("x,y,z\n1,5,2,5,3,5\n"), "p.csv:2: 6 numbers; where commas are"));
  EXPECT_TRUE(contains(refused("1,5,2,5,3,5\n"), "p.csv:1: 6 numbers; where commas are decimal"));
  EXPECT_TRUE(contains(refused("x,y,z\n\"1,5\",2,3\n"), "p.csv:2: \"1,5\" is not a number; where"));
  EXPECT_TRUE(
      contains(refused("1 2 3\n1 2\n"), "p.csv:2: 2 numbers; a line must be three numbers"));
  EXPECT_TRUE(
      contains(refused("1;2;3\n1,2,3\n"), "p.csv:2: 1 number; a line must be three numbers"));
  EXPECT_TRUE(
      contains(refused("1 2 nan\n"), "p.csv:1: nan is not a number from -1e+08 to 1e+08 m"));
  EXPECT_TRUE(contains(refused("1 2 1e308\n"), "p.csv:1: 1e308 is not a number from"));
  EXPECT_TRUE(contains(refused("x,y,z\n"), "p.csv: has no line of numbers"));
}

}  // namespace
}  // namespace clast
