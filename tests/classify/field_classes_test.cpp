#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "classify/dimension_table.hpp"
#include "classify/population.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

// The 89 stopped blocks of the Authume quarry with their taped axes.
TEST(FieldClasses, AuthumePopulationIsAsPublished) {
  std::vector<Axes> blocks;
  for (const char* file : {"authume/field/Endpoints_P1.txt", "authume/field/Endpoints_P2.txt"}) {
    const DimensionTable table =
        read_dimension_table(test_data(file), {.L = "5", .I = "6", .S = "7"});
    for (const MeasuredBlock& block : table.blocks) blocks.push_back(block.axes);
  }
  ASSERT_EQ(blocks.size(), 89u);
  const auto garcia = class_shares(blocks, "garcia");
  EXPECT_EQ(garcia[0].count, 46u);
  EXPECT_EQ(garcia[1].count, 43u);
  std::map<std::string, std::size_t> counts;
  for (const ClassShare& share : class_shares(blocks, "sneed-folk")) {
    if (share.count > 0) counts[share.name] = share.count;
  }
  const std::map<std::string, std::size_t> expected = {{"C", 28}, {"CP", 6}, {"CB", 22}, {"CE", 24},
                                                       {"B", 3},  {"E", 5},  {"VE", 1}};
  EXPECT_EQ(counts, expected);
}

// Two sands of the Sand Atlas: its "flatness" is S/I and its "elongation" I/L.
TEST(FieldClasses, SandAtlasRatiosAreReproduced) {
  int grains = 0;
  for (const char* file :
       {"meshes/sandatlas_ottawa-0000008.csv", "meshes/sandatlas_hostun-0000005.csv"}) {
    std::istringstream lines(read_text_file(test_data(file)));
    std::string line;
    std::getline(lines, line);  // headings
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::vector<double> values;
      for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
      const auto indices = form_indices({values.at(3), values.at(4), values.at(5)});
      EXPECT_NEAR(indices.at("S/I"), values.at(8), 1e-15) << line;
      EXPECT_NEAR(indices.at("I/L"), values.at(9), 1e-15) << line;
      ++grains;
    }
  }
  EXPECT_EQ(grains, 175 + 54);
}

}  // namespace
}  // namespace clast
