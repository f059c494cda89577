#include "core/files/delimited_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows read_rows(const std::string& content, const TableDialect& rules = {}) {
  const DecodedText table = decode_table_text(content, "t.csv");
  DelimitedTextReader text(table.text, "t.csv", rules);
  Rows rows;
  Record record;
  while (text.read_record(record)) rows.emplace_back(record.fields.begin(), record.fields.end());
  return rows;
}

TEST(DelimitedTextReader, EverySeparatorGivesTheSameRows) {
  const Rows rows = {{"a", "b"}, {"1.5", "x"}};
  for (const char* text : {"a,b\n1.5,x\n", "a;b\n1.5;x", "a\tb\n1.5\tx\n", "a b\n 1.5   x \n",
                           "a,b\r\n1.5,x\r\n", "a,b\r1.5,x\r",
                           "\xef\xbb\xbf"
                           "a,b\n1.5,x\n",
                           "# taped\n\na , \"b\"\n\"1.5\",x\n,\n", "sep=,\r\na,b\r\n1.5,x"}) {
    EXPECT_EQ(read_rows(text), rows) << text;
  }
}

TEST(DelimitedTextReader, ARowOfAnotherNumberOfFieldsIsRefusedWithItsLine) {
  const auto refused = [](const std::string& text) { return refusal([&] { read_rows(text); }); };
  // 50.5 and 20.1, as a program that writes decimal commas separates them with commas.
  EXPECT_EQ(refused("x,y\n50,5,20,1\n"),
            "t.csv:2: has 4 fields, but line 1 has 2; where commas are decimal signs, separate the "
            "columns by semicolons or tabs, or write decimal points");
  EXPECT_TRUE(
      contains(refused("a;b;c\n1;2;3\n\n1;2\n"), "t.csv:4: has 2 fields, but line 1 has 3"));
  EXPECT_TRUE(contains(refused("a b\nB 1 2\n"),
                       "t.csv:2: has 3 fields, but line 1 has 2; columns "
                       "are separated by blanks"));
  EXPECT_TRUE(contains(refused("\"a\nb\",c\n1,2,\n"), "t.csv:3: has 3 fields, but line 1 has 2"));
  EXPECT_EQ(refused("a,b\n1,\n,2\n,\n\"\",\"\"\n"), "");
}

TEST(DelimitedTextReader, DecimalCommasAreReadWhereCommasDoNotSeparate) {
  for (const char separator : {';', '\t', ' '}) {
    EXPECT_EQ(parse_number_field("50,5", separator), 50.5);
    EXPECT_FALSE(parse_number_field("1,234.5", separator) ||
                 parse_number_field("1,2,3", separator));
    EXPECT_FALSE(is_ambiguous_number("50,5", separator));
  }
  EXPECT_EQ(parse_number_field("50.5", ','), 50.5);
  EXPECT_FALSE(parse_number_field("50,5", ','));
  EXPECT_TRUE(is_ambiguous_number("50,5", ','));
  EXPECT_FALSE(is_ambiguous_number("wet, mossy", ',') || is_ambiguous_number("50.5", ','));
}

TEST(DelimitedTextReader, RemarksEndRowsWhereTheyAreAskedFor) {
  EXPECT_EQ(read_rows("1;2 # edge\n#\n3;4\n", {.inline_comments = true}),
            (Rows{{"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(read_rows("id;L\nB #7;2\n"), (Rows{{"id", "L"}, {"B #7", "2"}}));
}

// Texts that a spreadsheet would run are written so that it shows them, and come back as they were.
TEST(DelimitedTextReader, GivesBackWhatCsvTextWrote) {
  std::vector<std::string> texts = {
      "=1+1", "@SUM(A1)", "+A1", "-B2", "'=1+1", "''-x", "\tx",  "=HYPERLINK(\"http://x\";\"y\")",
      "-",    "'",        "'a",  "-5",  "a=b",   "+5e3", "B017", "=a,b"};
  Random random(3);
  const std::string letters = "=+-@'\"1a ,;";
  for (int i = 0; i < 2000; ++i) {
    std::string text = "'";  // something that is not a blank at both ends
    text[0] = letters[random.uniform_index(8)];
    for (std::size_t k = random.uniform_index(5); k > 0; --k)
      text += letters[random.uniform_index(11)];
    texts.push_back(text + "x");
  }
  for (const std::string& text : texts) {
    CsvWriter csv;
    csv.write_cell("name");
    csv.write_cell("other");
    csv.end_row();
    csv.write_cell(text);
    csv.write_cell(1.0);
    csv.end_row();
    EXPECT_EQ(read_rows(csv.take_text()).at(1).at(0), text);
  }
}

}  // namespace
}  // namespace clast
