// Two tables of sand grains with their own ratios, as published.
#include <gtest/gtest.h>

#include <charconv>
#include <sstream>

#include "classify/dimension_table.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// The shortest digits that read back to the same bits, which is how the tables were printed.
std::string printed(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

class SandAtlas : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Tables, SandAtlas,
                         testing::Values("meshes/sandatlas_hostun-0000005.csv",
                                         "meshes/sandatlas_ottawa-0000008.csv"));

TEST_P(SandAtlas, FlatnessAndElongationAreReproducedToTheLastDigit) {
  const DimensionTable table =
      read_dimension_table(test_data(GetParam()), {.L = "Major Axis Length",
                                                   .I = "Middle Axis Length",
                                                   .S = "Minor Axis Length",
                                                   .name = "Particle ID"});
  // The published columns, split without the reader under test: the tables hold no quotes.
  std::istringstream lines(read_text_file(test_data(GetParam())));
  std::string line;
  std::getline(lines, line);
  std::size_t row = 0;
  for (; std::getline(lines, line); ++row) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> fields;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
    ASSERT_LT(row, table.blocks.size());
    const MeasuredBlock& grain = table.blocks[row];
    EXPECT_EQ(grain.name, fields.at(0));
    std::map<std::string, double> indices = form_indices(grain.axes_in_table_unit);
    EXPECT_EQ(printed(indices.at("S/I")), fields.at(8)) << line;
    EXPECT_EQ(printed(indices.at("I/L")), fields.at(9)) << line;
    // The header says micrometres.
    EXPECT_NEAR(grain.axes.L, 1e-6 * std::stod(fields.at(3)), 1e-15);
  }
  EXPECT_EQ(row, table.blocks.size());
  EXPECT_EQ(table.skipped_rows, 0u);
}

}  // namespace
}  // namespace clast
