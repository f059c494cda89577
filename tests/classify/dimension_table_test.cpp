#include "classify/dimension_table.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class Tables : public testing::Test {
 protected:
  DimensionTable read(const std::string& text, const DimensionColumns& columns = {}) {
    const auto path = folder_ / "dims.csv";
    write_text_file(path, text);
    return read_dimension_table(path, columns);
  }
  std::string refusal(const std::string& text, const DimensionColumns& columns = {}) {
    try {
      read(text, columns);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  }

  ScratchFolder folder_;
};

void expect_axes(const MeasuredBlock& block, double L, double I, double S) {
  EXPECT_NEAR(block.axes.L, L, 1e-15);
  EXPECT_NEAR(block.axes.I, I, 1e-15);
  EXPECT_NEAR(block.axes.S, S, 1e-15);
}

TEST_F(Tables, EverySeparatorGivesTheSameBlocks) {
  for (const char* text :
       {"id,L,I,S\nB1,1.5,1.2,0.5\nB2,0.9,0.8,0.7\n", "id;L;I;S\nB1;1.5;1.2;0.5\nB2;0.9;0.8;0.7",
        "id\tL\tI\tS\nB1\t1.5\t1.2\t0.5\nB2\t0.9\t0.8\t0.7\n",
        "id L  I   S\n B1 1.5 1.2 0.5\nB2\t0.9 0.8 0.7\n",
        "id;L;I;S\r\nB1;1,5;1,2;0,5\r\nB2;0,9;0,8;0,7\r\n",
        "\xef\xbb\xbf# taped in May\n\n\"id\",\"L\",\"I\",\"S\"\n"
        "\"B1\",\"1.5\",1.2,+0.5\nB2,9e-1,0.8,0.7\n"}) {
    const DimensionTable table = read(text);
    ASSERT_EQ(table.blocks.size(), 2u) << text;
    EXPECT_TRUE(table.notes.empty()) << text;
    EXPECT_EQ(table.blocks[0].name, "B1");
    expect_axes(table.blocks[0], 1.5, 1.2, 0.5);
    EXPECT_EQ(table.blocks[1].name, "B2");
    expect_axes(table.blocks[1], 0.9, 0.8, 0.7);
  }
}

TEST_F(Tables, MassesAreReadWhereTheyAreAskedFor) {
  const char* text = "L,I,S,m_kg\n3,2,1,50\n3,2,1,\n3,2,1,-4\n4,2,1,70\n";
  const DimensionTable table = read(text, {.mass = "m_kg"});
  ASSERT_EQ(table.blocks.size(), 2u);
  EXPECT_EQ(*table.blocks[0].mass, 50.0);
  EXPECT_EQ(*table.blocks[1].mass, 70.0);
  EXPECT_EQ(table.skipped, 2u);
  ASSERT_EQ(table.notes.size(), 2u);
  EXPECT_EQ(table.notes[0], "row 3 skipped: mass is missing");
  EXPECT_EQ(table.notes[1], "row 4 skipped: mass = -4 is not a mass");
  EXPECT_FALSE(read(text).blocks[0].mass.has_value());
  EXPECT_EQ(read(text).skipped, 0u);
  EXPECT_NE(refusal(text, {.mass = "weight"}).find("weight"), std::string::npos);
}

TEST_F(Tables, ColumnNamesIgnoreCaseAndUnits) {
  for (const char* header :
       {"L_m,I_m,S_m", "l (m),i (m),s (m)", "L [m],I [m],S [m]", "L m,I m,S m"}) {
    const DimensionTable table = read(std::string(header) + "\n3,2,1\n");
    expect_axes(table.blocks.at(0), 3, 2, 1);
    EXPECT_EQ(table.blocks.at(0).name, "row 2");
    EXPECT_TRUE(table.notes.empty());
  }
}

TEST_F(Tables, UnitOfTheTableIsApplied) {
  expect_axes(read("L_cm,I_cm,S_cm\n300,200,100\n", {.unit = 0.01}).blocks.at(0), 3, 2, 1);
  // A unit in the header that is not the one asked for is said, not obeyed.
  const DimensionTable table = read("L_cm,I_cm,S_cm\n300,200,100\n");
  expect_axes(table.blocks.at(0), 300, 200, 100);
  ASSERT_EQ(table.notes.size(), 1u);
  EXPECT_NE(table.notes[0].find("0.01"), std::string::npos);
}

TEST_F(Tables, ColumnsByNumberNeedNoHeader) {
  const DimensionColumns columns{.L = "5", .I = "6", .S = "7"};
  const DimensionTable bare = read("1 2 3 4 0.9 0.8 0.7\n", columns);
  expect_axes(bare.blocks.at(0), 0.9, 0.8, 0.7);
  EXPECT_EQ(bare.blocks.at(0).name, "row 1");
  const DimensionTable headed = read("a b c d e f g\n1 2 3 4 0.9 0.8 0.7\n", columns);
  ASSERT_EQ(headed.blocks.size(), 1u);
  expect_axes(headed.blocks[0], 0.9, 0.8, 0.7);
}

TEST_F(Tables, ColumnsByOtherNames) {
  const DimensionTable table = read("a,b,c\n3,2,1\n", {.L = "A", .I = "B", .S = "C"});
  expect_axes(table.blocks.at(0), 3, 2, 1);
}

TEST_F(Tables, BadRowsAreSkippedAndNoted) {
  const DimensionTable table = read(
      "name,L,I,S\nok,3,2,1\nzero,3,0,1\nminus,3,-2,1\nshort,3,2\ntext,3,two,1\nempty,3,,1\n"
      "tail,3,2,1x\nnan,nan,2,1\ninf,inf,2,1\nlast,6,5,4\n");
  ASSERT_EQ(table.blocks.size(), 2u);
  EXPECT_EQ(table.blocks[1].name, "last");
  ASSERT_EQ(table.notes.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NE(table.notes[i].find("row " + std::to_string(i + 3) + " skipped"), std::string::npos)
        << table.notes[i];
  }
}

TEST_F(Tables, AxesOutOfOrderAreSortedAndNoted) {
  const DimensionTable table = read("L,I,S\n1,2,3\n3,2,1\n");
  expect_axes(table.blocks.at(0), 3, 2, 1);
  ASSERT_EQ(table.notes.size(), 1u);
  EXPECT_NE(table.notes[0].find("row 2"), std::string::npos);
}

TEST_F(Tables, WhatCannotBeReadIsRefused) {
  EXPECT_THROW(read_dimension_table(folder_ / "missing.csv"), InputError);
  EXPECT_NE(refusal("").find("empty"), std::string::npos);
  EXPECT_NE(refusal("# only a remark\n\n").find("empty"), std::string::npos);
  const std::string no_column = refusal("length,width,S\n3,2,1\n");
  EXPECT_NE(no_column.find("\"L\""), std::string::npos) << no_column;
  EXPECT_NE(no_column.find("\"width\""), std::string::npos) << no_column;
  EXPECT_NE(refusal("3,2,1\n").find("1 to 3"), std::string::npos);
  EXPECT_NE(refusal("3,2,1\n", {.L = "1", .I = "2", .S = "9"}).find("\"9\""), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n").find("no usable row"), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n0,0,0\n").find("row 2"), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n3,2,1\n", {.unit = 0.0}).find("unit"), std::string::npos);
}

}  // namespace
}  // namespace clast
