#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "classify/certainty.hpp"
#include "classify/dimension_table.hpp"
#include "classify/population.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// The 89 stopped blocks of the Authume quarry with their taped axes.
std::vector<Axes> authume_blocks() {
  std::vector<Axes> blocks;
  for (const char* file : {"authume/field/Endpoints_P1.txt", "authume/field/Endpoints_P2.txt"}) {
    const DimensionTable table =
        read_dimension_table(test_data(file), {.L = "5", .I = "6", .S = "7"});
    for (const MeasuredBlock& block : table.blocks) blocks.push_back(block.axes);
  }
  return blocks;
}

TEST(FieldClasses, AuthumePopulationIsAsPublished) {
  const std::vector<Axes> blocks = authume_blocks();
  ASSERT_EQ(blocks.size(), 89u);
  const auto garcia = class_fractions(blocks, "garcia");
  EXPECT_EQ(garcia[0].count, 46u);
  EXPECT_EQ(garcia[1].count, 43u);
  std::map<std::string, std::size_t> counts;
  for (const ClassFraction& share : class_fractions(blocks, "sneed-folk")) {
    if (share.count > 0) counts[share.name] = share.count;
  }
  const std::map<std::string, std::size_t> expected = {{"C", 28}, {"CP", 6}, {"CB", 22}, {"CE", 24},
                                                       {"B", 3},  {"E", 5},  {"VE", 1}};
  EXPECT_EQ(counts, expected);
}

// Every class that 21^3 axes within the tape's error have is said to be possible, for every block
// and scheme; and what survives by the one survives by the other, but for classes that take up less
// than the grid's step.
TEST(FieldClasses, EveryClassWithinTheErrorOfTheTapeIsNamed) {
  constexpr int kSteps = 21;
  std::size_t missed = 0, said_only = 0, pairs = 0;
  for (const Axes& axes : authume_blocks()) {
    std::vector<std::set<std::string>> said;
    for (const std::string& scheme : scheme_names()) {
      const ClassCertainty certainty = assess_class_certainty(scheme, axes, kTapeError);
      said.emplace_back(certainty.other_possible_classes.begin(),
                        certainty.other_possible_classes.end());
      said.back().insert(certainty.name);
      said.back().erase("neither");  // a line: a grid hits it only by chance
      EXPECT_EQ(certainty.is_certain, certainty.other_possible_classes.empty());
    }
    std::vector<std::set<std::string>> seen(said.size());
    const auto at = [](double axis, int k) {
      return axis + kTapeError * (2.0 * k / (kSteps - 1) - 1.0);
    };
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        for (int k = 0; k < kSteps; ++k) {
          const Axes drawn = Axes::sorted(at(axes.L, i), at(axes.I, j), at(axes.S, k));
          for (std::size_t n = 0; n < said.size(); ++n) {
            seen[n].insert(shape_class(scheme_names()[n], drawn));
          }
        }
      }
    }
    for (std::size_t n = 0; n < said.size(); ++n) {
      seen[n].erase("neither");
      for (const std::string& name : seen[n]) missed += !said[n].count(name);
      for (const std::string& name : said[n]) said_only += !seen[n].count(name);
      pairs += said[n].size();
    }
  }
  EXPECT_EQ(missed, 0u);
  EXPECT_LT(said_only, pairs / 50);
}

}  // namespace
}  // namespace clast
