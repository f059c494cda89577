/// Every closed real mesh with triangles deleted at random, over many seeds.
#include <gtest/gtest.h>
#include <limits>

#include <array>
#include <cmath>
#include <iostream>

#include "core/parallel.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_io.hpp"
#include "reconstruct/field_scan.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/reference_meshes.hpp"
#include "tests/support/torn_mesh.hpp"

namespace clast {
namespace {

constexpr std::array<double, 5> kFractions = {0.01, 0.05, 0.1, 0.2, 0.3};
constexpr std::size_t kTornSeeds = 60;
/// A mesh of more triangles costs a second a seed: it has fewer.
constexpr std::size_t kFine = 10000, kSeedsOfFine = 5;
/// Below this a triangle is a visible share of the block: what is missing is bracketed.
constexpr std::size_t kCoarseTriangles = 400;

struct Torn {
  double volume_error = 0.0, box_error = 0.0;
  bool in_range = false, bracketed = false;
};

Torn tear(const TriangleMesh& rock, double rock_volume, const Vec3& sides, double share,
          std::uint64_t seed) {
  const FieldBlock block = extract_field_blocks(without_triangles(rock, share, seed), "torn")[0];
  Torn torn;
  const double volume = solid_mass_properties(block.scan.mesh, 1.0).volume;
  const Vec3 lengths = smallest_box(block.scan.mesh.vertices).lengths;
  torn.volume_error = volume / rock_volume - 1.0;
  torn.box_error = (lengths.cwiseQuotient(sides) - Vec3::Ones()).cwiseAbs().maxCoeff();
  torn.bracketed = block.underside.has_value();
  const RepairReport& report = block.scan.report;
  const double low = torn.bracketed ? block.underside->lower_volume : volume - report.volume_below;
  const double high =
      torn.bracketed
          ? block.underside->upper_volume.value_or(std::numeric_limits<double>::infinity())
          : volume + report.volume_above;
  torn.in_range = rock_volume > low * (1.0 - 1e-9) && rock_volume < high * (1.0 + 1e-9);
  return torn;
}

class TornScans : public testing::TestWithParam<const char*> {};

TEST_P(TornScans, KeepTheirVolumeAndTheirBox) {
  const TriangleMesh rock = read_scan(data_file(GetParam())).mesh;
  const double volume = solid_mass_properties(rock, 1.0).volume;
  const Vec3 sides = smallest_box(rock.vertices).lengths;
  const std::size_t seeds = rock.triangles.size() > kFine ? kSeedsOfFine : kTornSeeds;
  const bool coarse = rock.triangles.size() < kCoarseTriangles;
  std::vector<Torn> torn(seeds);
  parallel_for(seeds, 0, [&](std::size_t i) {
    torn[i] = tear(rock, volume, sides, kFractions[i % kFractions.size()], i);
  });
  double worst_volume = 0.0, worst_box = 0.0;
  std::size_t bracketed = 0;
  for (std::size_t i = 0; i < seeds; ++i) {
    SCOPED_TRACE("seed " + std::to_string(i) + " share " +
                 std::to_string(kFractions[i % kFractions.size()]));
    bracketed += torn[i].bracketed;
    if (torn[i].bracketed) {
      EXPECT_TRUE(coarse) << "a torn surface is taken for an unseen side";
      EXPECT_TRUE(torn[i].in_range);
      continue;
    }
    worst_volume = std::max(worst_volume, std::abs(torn[i].volume_error));
    worst_box = std::max(worst_box, torn[i].box_error);
    EXPECT_LT(torn[i].box_error, 0.02);
    if (std::abs(torn[i].volume_error) > 0.01) {
      EXPECT_TRUE(torn[i].in_range) << torn[i].volume_error;
    }
  }
  EXPECT_LE(bracketed, seeds / 20);
  std::cout << GetParam() << ": " << seeds << " seeds, volume within " << 100.0 * worst_volume
            << " %, box within " << 100.0 * worst_box << " %, " << bracketed << " bracketed\n";
}

INSTANTIATE_TEST_SUITE_P(Meshes, TornScans,
                         testing::Values("meshes/chrono_curiosity_rock1.obj",
                                         "meshes/ibois_stone_0.ply", "meshes/eesd_test_stone.stl",
                                         "meshes/chrono_offroad_rock4.obj", "meshes/ryugu_test.obj",
                                         "meshes/eros007790.tab", "meshes/rockable_rock.stl",
                                         "meshes/eesd_stone01.stl", "meshes/eesd_stone14.stl",
                                         "meshes/eesd_stone15.stl", "meshes/eesd_stone18.stl",
                                         "meshes/eesd_S02.stl", "authume/blocks/SP1A.stl",
                                         "authume/blocks/SP2A.stl", "authume/blocks/SP2B.stl",
                                         "authume/blocks/SP3A.stl"));

}  // namespace
}  // namespace clast
