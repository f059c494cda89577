// What the choice of box does to the classes of real stones.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "classify/box_convention.hpp"
#include "classify/certainty.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/solid.hpp"
#include "reconstruct/scan.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

Axes axes_of(const OrientedBox& box) { return {box.lengths[0], box.lengths[1], box.lengths[2]}; }

/// Of all stones by one convention, against the smallest box.
struct Tally {
  int stones = 0;
  double sum = 0.0, largest = 0.0;  ///< of volume over that of the smallest box
  int other_class = 0, other_shape = 0;
};

TEST(BoxConventions, DecideTheClassOfRealStones) {
  std::map<std::string, Tally> tallies;
  for (const ReferenceRow& row : mesh_reference()) {
    if (row.at("kind") != "mesh" || row.at("obb_volume_best").empty()) continue;
    if (row.at("volume_meaningful") != "True" || row.at("nonmanifold_edges") != "0") continue;
    const TriangleMesh mesh = read_scan(test_data("meshes/" + row.at("file"))).mesh;
    const SpheroPolyhedron body = make_sphero_polyhedron(mesh, 0.0);
    const PrincipalFrame frame = principal_frame(solid_mass_properties(mesh, 1.0));
    const OrientedBox smallest = smallest_box(body);
    for (const BoxConvention convention : kBoxConventions) {
      const OrientedBox box = box_by_convention(body, frame, convention);
      const double ratio = box.volume() / smallest.volume();
      EXPECT_GE(ratio, 1.0 - 1e-9) << row.at("file") << " " << name_of(convention);
      const Axes mine = axes_of(box), theirs = axes_of(smallest);
      Tally& tally = tallies[name_of(convention)];
      ++tally.stones;
      tally.sum += ratio;
      tally.largest = std::max(tally.largest, ratio);
      tally.other_class += sneed_folk_class(mine) != sneed_folk_class(theirs);
      tally.other_shape += garcia_class(mine) != garcia_class(theirs);
    }
  }
  for (const auto& [name, tally] : tallies) {
    std::cout << name << ": " << tally.stones << " stones, volume / smallest "
              << tally.sum / tally.stones << " (at most " << tally.largest
              << "), Sneed & Folk class "
              << "differs for " << tally.other_class << ", compact or elongated for "
              << tally.other_shape << "\n";
  }
  // An independent program found, on 23 stones of which these are a part, means of 1.15, 1.17 and
  // 1.30, and that each of the three changes classes.
  const auto mean = [&](const char* name) { return tallies[name].sum / tallies[name].stones; };
  EXPECT_EQ(tallies["smallest"].other_class, 0);
  for (const char* name : {"pca", "inertia", "feret"}) {
    EXPECT_GT(mean(name), 1.05) << name;
    EXPECT_GT(tallies[name].other_class + tallies[name].other_shape, 0) << name;
  }
  EXPECT_GT(mean("feret"), mean("pca"));
  EXPECT_GT(mean("feret"), mean("inertia"));
}

/// A published core with its radius, and s_c by two conventions.
struct Core {
  const char* block;
  double radius;            ///< m
  double smallest_rounded;  ///< s_c of the smallest box of the rounded body, about
  double inertia_bare;      ///< s_c of the inertia box of the core without its radius
  const char* sneed_folk;   ///< of the smallest box
  double printed;           ///< s_c in the paper, beside ours and not aimed at
};
void PrintTo(const Core& core, std::ostream* out) { *out << core.block; }

class AuthumeBoxes : public testing::TestWithParam<Core> {
 protected:
  SpheroPolyhedron body(double radius) const {
    const std::string file = std::string("authume/blocks/") + GetParam().block + ".stl";
    return make_sphero_polyhedron(read_scan(test_data(file)).mesh, radius);
  }
};

// The paper prints 0.27, 0.22 and 0.74, which is neither; two of the three are the inertia boxes of
// the bare cores.
TEST_P(AuthumeBoxes, ConventionDecidesTheElongation) {
  const Core& core = GetParam();
  const Axes axes = axes_of(smallest_box(body(core.radius)));
  EXPECT_NEAR(elongation_index(axes), core.smallest_rounded, 0.01);
  EXPECT_EQ(garcia_class(axes), core.smallest_rounded > 0.3 ? "elongated" : "compact");
  const SpheroPolyhedron bare = body(0.0);
  const PrincipalFrame frame = principal_frame(solid_mass_properties(core_mesh(bare), 1.0));
  const Axes inertia = axes_of(box_by_convention(bare, frame, BoxConvention::kInertia));
  EXPECT_NEAR(elongation_index(inertia), core.inertia_bare, 0.005);
  const double error = 0.01 * axes.L;
  const ClassCertainty certainty = assess_class_certainty("sneed-folk", axes, error);
  std::cout << core.block << ": smallest box " << axes.L << " " << axes.I << " " << axes.S
            << ", s_c " << elongation_index(axes) << ", " << certainty.name << ", "
            << describe_certainty(certainty) << "; inertia box of the core, s_c "
            << elongation_index(inertia) << "; the paper prints " << core.printed << "\n";
  EXPECT_TRUE(contains(core.sneed_folk, certainty.name));
  // SP2A lies on the line between C and CB: any error at all allows the other.
  if (std::string(core.block) == "SP2A") {
    EXPECT_FALSE(certainty.is_certain);
    EXPECT_LT(certainty.distance, 1e-3);
  }
  // SP3A is next to the line between B and E, which the error of a tape crosses.
  if (std::string(core.block) == "SP3A") {
    EXPECT_TRUE(certainty.near_limit);
    const ClassCertainty taped = assess_class_certainty("sneed-folk", axes, kTapeError);
    EXPECT_FALSE(taped.is_certain);
    EXPECT_EQ(
        std::count(taped.other_possible_classes.begin(), taped.other_possible_classes.end(), "E"),
        1);
  }
}

INSTANTIATE_TEST_SUITE_P(Cores, AuthumeBoxes,
                         testing::Values(Core{"SP1A", 0.027, 0.18, 0.269, "CB", 0.27},
                                         Core{"SP2A", 0.049, 0.14, 0.213, "C CB", 0.22},
                                         Core{"SP3A", 0.005, 0.66, 0.626, "B", 0.74}));

}  // namespace
}  // namespace clast
