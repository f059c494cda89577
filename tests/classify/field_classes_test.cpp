#include <gtest/gtest.h>

#include <map>
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

}  // namespace
}  // namespace clast
