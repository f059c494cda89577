// Bodies sampled from the population of a scanned deposit.
#include "library/series_request.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "library/make_block.hpp"
#include "tests/library/deposit_blocks.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

Block sized_rock(const std::string& id, double size) {
  const SpheroPolyhedron body =
      make_sphero_polyhedron(rock_mesh(2, size * Vec3(1.5, 1.0, 0.7), 1, 0.1), 0.02 * size);
  return make_block(id, body, {"rock.ply", std::string(64, 'a'), "", ""}, BlockOptions{});
}

/// Rocks of the sizes and observations of `deposit_of_sizes`.
BlockLibrary deposit_of_rocks() {
  BlockLibrary library;
  for (const Block& seen : deposit_of_sizes()) {
    Block block = sized_rock(seen.id, seen.axes().I);
    const double volume = block.mass.volume;
    const Vec3 lower = 0.9 * block.box.lengths, upper = 1.1 * block.box.lengths;
    block.volume_bracket = VolumeBracket{.lower_volume = 0.7 * volume,
                                         .estimated_volume = volume,
                                         .upper_volume = 1.4 * volume,
                                         .sides = BoxSideBounds{0.8 * lower, 1.2 * upper},
                                         .filled_fraction = 0.4,
                                         .assumption = "the flanks continue"};
    block.volume_bracket->intervals = {0.8 * volume, 1.2 * volume, {lower, upper}};
    block.deposit = seen.deposit;
    library.add(block);
  }
  return library;
}

/// Makes bodies of the forms and sizes of a population.
/// @return their median I in m, and the notes
std::pair<double, std::vector<std::string>> sample_bodies(const BlockLibrary& population,
                                                          const ScratchFolder& folder) {
  VariationSeriesRequest request;
  request.library = folder.path() / "rock.h5";
  request.table = folder.path() / "population.h5";
  request.sampled_count = 20;
  BlockLibrary parent;
  parent.add(sized_rock("R", 1.0));
  parent.write(request.library);
  population.write(request.table);
  const VariationSeriesResult made = make_variation_series(request);
  std::vector<double> sizes;
  for (const Block& block : made.series.blocks) sizes.push_back(block.axes().I);
  std::sort(sizes.begin(), sizes.end());
  return {sizes[sizes.size() / 2], made.notes};
}

TEST(SeriesRequest, SamplesTheDepositAndNotTheBlocksThatShow) {
  const ScratchFolder folder;
  const BlockLibrary deposit = deposit_of_rocks();
  const auto [corrected, notes] = sample_bodies(deposit, folder);
  ASSERT_EQ(notes.size(), 1u);
  const std::string start = "bodies are drawn from a scanned deposit: its 20 found blocks stand";
  EXPECT_TRUE(notes[0].starts_with(start)) << notes[0];

  BlockLibrary apart;
  for (Block block : deposit.blocks()) {
    block.deposit.reset();
    apart.add(block);
  }
  const auto [found, no_notes] = sample_bodies(apart, folder);
  EXPECT_TRUE(no_notes.empty());
  // Small blocks stand for more than large ones.
  EXPECT_LT(corrected, 0.95 * found);
}

}  // namespace
}  // namespace clast
