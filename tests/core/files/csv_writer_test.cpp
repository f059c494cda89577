#include "core/files/csv_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast {
namespace {

TEST(CsvWriter, QuotesOnlyWhatNeedsIt) {
  CsvWriter csv;
  csv.write_header("a,b,c");
  csv.write_cell("plain");
  csv.write_cell("with, comma");
  csv.write_cell("12\" pipe");
  csv.end_row();
  EXPECT_EQ(csv.take_text(), "a,b,c\nplain,\"with, comma\",\"12\"\" pipe\"\n");
}

TEST(CsvWriter, WhatASpreadsheetWouldRunIsTextInIt) {
  CsvWriter csv;
  for (const char* text :
       {"=1+1", "+A1", "-cmd", "@SUM(A1)", "\tx", "\rx", "'=1", "-5", "+2e3", "a=b"}) {
    csv.write_cell(text);
  }
  csv.write_cell(-5.0);
  EXPECT_EQ(csv.take_text(),
            "\"'=1+1\",\"'+A1\",\"'-cmd\",\"'@SUM(A1)\",\"'\tx\",\"'\rx\",\"''=1\",-5,+2e3,a=b,-5");
}

TEST(CsvWriter, ZeroHasNoSign) {
  CsvWriter csv;
  csv.write_cell(-0.0);
  csv.write_cell(0.0);
  csv.write_cell(-1e-300);
  EXPECT_EQ(csv.take_text(), "0,0,-1e-300");
}

TEST(CsvWriter, NumbersReadBackToTheSameBitsAndUnknownOnesAreEmpty) {
  CsvWriter csv;
  csv.write_cell(0.1);
  csv.write_cell(1.0 / 3.0);
  csv.write_cell(std::nan(""));
  csv.write_cell(INFINITY);
  csv.write_count(12345678901234ULL);
  csv.write_empty_cells(2);
  csv.end_row();
  EXPECT_EQ(csv.take_text(), "0.1,0.3333333333333333,,,12345678901234,,\n");
  EXPECT_EQ(csv.take_text(), "");
}

}  // namespace
}  // namespace clast
