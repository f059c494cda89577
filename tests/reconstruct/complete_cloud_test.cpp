/// Clouds that are complete all round come out closed, with the size and class of their block.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/field_scan.hpp"
#include "samples/rock_shapes.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/sampled_cloud.hpp"

namespace clast {
namespace {

struct Body {
  std::string name;
  TriangleMesh mesh;
};

TriangleMesh made(const Vec3& lengths, std::uint64_t seed, double notch = 0.0) {
  return rock({.lengths = lengths,
               .notch = notch,
               .roughness = notch > 0.0 ? 0.006 : 0.012,
               .scan_noise = 0.0,
               .frequency = 20,
               .seed = seed});
}

TriangleMesh plank(const Vec3& sides) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back(sides.cwiseProduct(
        Vec3(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5)));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

std::vector<Body> bodies() {
  std::vector<Body> result;
  for (const char* name :
       {"meshes/eesd_stone01.stl", "meshes/eesd_stone14.stl", "meshes/eesd_stone15.stl",
        "meshes/eesd_stone18.stl", "meshes/eesd_S02.stl", "meshes/eesd_test_stone.stl",
        "meshes/rockable_rock.stl", "meshes/ibois_stone_0.ply", "meshes/chrono_curiosity_rock1.obj",
        "meshes/chrono_offroad_rock4.obj", "meshes/eros007790.tab", "meshes/ryugu_test.obj",
        "authume/blocks/SP1A.stl", "authume/blocks/SP2A.stl", "authume/blocks/SP3A.stl"}) {
    result.push_back({name, read_scan(test_data(name)).mesh});
  }
  result.push_back({"plate", made({1.0, 0.9, 0.14}, 5)});
  result.push_back({"needle", made({1.2, 0.2, 0.15}, 6)});
  result.push_back({"notched", made({1.2, 1.05, 0.62}, 137, 0.6)});
  result.push_back({"plank", plank({1.0, 0.6, 0.15})});
  result.push_back({"cube", plank({1.0, 1.0, 1.0})});
  return result;
}

/// What a cloud may be off by, as shares.
struct Bars {
  double volume = 0.01;
  double side = 0.015;
};

struct Kind {
  std::string name;
  CloudSampling sampling;
  Bars bars;
};

/// No part of the surface is farther than so many spacings from every point: about twice what is
/// usual for points drawn at random, where the density falls to a third.
constexpr double kFarthest = 5.0;

/// Noise is given as a share of L here.
std::vector<Kind> kinds(std::size_t points) {
  const Bars few{0.025, 0.03}, noisy{0.02, 0.03};
  const bool sparse = points < 8000;
  const Bars bars = sparse ? few : Bars{};
  return {{"", {.points = points}, bars},
          {"noise 0.2 %", {.points = points, .noise = 0.002}, sparse ? few : noisy},
          {"noise 0.5 %", {.points = points, .noise = 0.005}, sparse ? few : noisy},
          {"a third on one side", {.points = points, .fall = 1.0 / 3.0}, bars},
          {"2 % outliers", {.points = points, .outliers = 0.02}, bars}};
}

std::string class_of(const Vec3& sides) { return sneed_folk_class({sides[0], sides[1], sides[2]}); }

/// Classes that sides off by up to `share` may have.
bool is_class_within(const std::string& name, const Vec3& sides, double share) {
  for (int corner = 0; corner < 27; ++corner) {
    const Vec3 off(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
    const Vec3 moved = sides.cwiseProduct(Vec3::Ones() + share * off);
    const Axes axes = Axes::sorted(moved[0], moved[1], moved[2]);
    if (sneed_folk_class(axes) == name) return true;
  }
  return false;
}

/// A body may have two boxes of nearly the same volume with other sides; either is right. Of the
/// box found, the sides that the true body has along its axes; none where that is not among the
/// smallest.
std::optional<Vec3> true_sides_along(const OrientedBox& found, const Body& body, double share) {
  const OrientedBox same = box_with_axes(body.mesh.vertices, found.axes);
  const double smallest = smallest_box(body.mesh.vertices).volume();
  if (same.volume() > (1.0 + share) * smallest) return std::nullopt;
  return same.lengths;
}

/// How far the middles of the triangles of `mesh` are from any point at most, in spacings of points
/// that are spread evenly.
double farthest_from_points(const TriangleMesh& mesh, const std::vector<Vec3>& points) {
  const double spacing = std::sqrt(surface_area(mesh) / static_cast<double>(points.size()));
  double farthest = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 middle = centroid(mesh, t);
    double nearest = 1e300;
    for (const Vec3& p : points) nearest = std::min(nearest, (p - middle).squaredNorm());
    farthest = std::max(farthest, nearest);
  }
  return std::sqrt(farthest) / spacing;
}

/// Do the bounds stated of a block hold its true volume (m^3) and sides (m)?
bool holds(const FieldBlock& block, double volume, const Vec3& sides) {
  if (!block.bounds) return false;
  const VolumeBracket& bounds = *block.bounds;
  if (volume < bounds.lower_volume || (bounds.upper_volume && volume > *bounds.upper_volume)) {
    return false;
  }
  return !bounds.sides || ((bounds.sides->lower - sides).maxCoeff() <= 0.0 &&
                           (sides - bounds.sides->upper).maxCoeff() <= 0.0);
}

/// What is wrong with what became of a cloud; none: within its bars.
std::optional<std::string> fault_of(const Body& body, Kind kind, std::uint64_t seed) {
  const Vec3 smallest = smallest_box(body.mesh.vertices).lengths;
  const double truth = solid_mass_properties(body.mesh, 1.0).volume;
  Random random(seed);
  kind.sampling.along = random.unit_vector();
  kind.sampling.noise *= smallest[0];
  try {
    const std::vector<Vec3> points = sampled_cloud(body.mesh, kind.sampling, seed);
    const FieldBlock block = extract_field_blocks(points, body.name)[0];
    const double found = solid_mass_properties(block.scan.mesh, 1.0).volume;
    const OrientedBox box = smallest_box(block.scan.mesh.vertices);
    const Vec3 sides = true_sides_along(box, body, kind.bars.side).value_or(smallest);
    const Vec3 off = box.lengths.cwiseQuotient(sides) - Vec3::Ones();
    const std::string figures = "volume " + format_significant(100.0 * (found / truth - 1.0), 3) +
                                " %, L, I, S " + format_significant(100.0 * off[0], 3) + ", " +
                                format_significant(100.0 * off[1], 3) + ", " +
                                format_significant(100.0 * off[2], 3) + " %, " +
                                class_of(box.lengths) + " for " + class_of(sides);
    if (block.underside) return "a side called unseen; " + figures;
    if (!holds(block, truth, sides)) return "the truth is outside the bounds stated; " + figures;
    const double farthest = farthest_from_points(block.scan.mesh, points);
    if (farthest > kFarthest) return format_significant(farthest, 3) + " spacings off; " + figures;
    if (std::abs(found / truth - 1.0) > kind.bars.volume ||
        off.cwiseAbs().maxCoeff() > kind.bars.side ||
        !is_class_within(class_of(box.lengths), sides, kind.bars.side)) {
      return figures;
    }
  } catch (const Error& error) {
    return error.what();
  }
  return std::nullopt;
}

/// Every case of the given bodies and numbers of points; those beyond their bars, in words.
void check_all(const std::vector<Body>& all, const std::vector<std::size_t>& counts,
               std::size_t most_beyond) {
  std::size_t cases = 0, beyond = 0, unobserved = 0;
  for (const Body& body : all) {
    for (const std::size_t points : counts) {
      for (const Kind& kind : kinds(points)) {
        ++cases;
        const std::optional<std::string> fault = fault_of(body, kind, 3);
        if (!fault) continue;
        ++beyond;
        unobserved += fault->starts_with("a side called unseen");
        std::cout << body.name << ", " << points << " points, " << kind.name << ": " << *fault
                  << std::endl;
      }
    }
  }
  std::cout << cases << " clouds, " << beyond << " beyond their bars, " << unobserved
            << " with a side called unseen\n";
  EXPECT_LE(beyond, most_beyond);
  EXPECT_EQ(unobserved, 0u);
}

// 300 clouds. Beyond the bars lie the plank and the needle with noise as large as a thirtieth of
// their thickness, outliers as close to a sharp edge as the next point, and ridges and tips
// narrower than the points are apart: docs/accuracy.md, Ground and clouds.
TEST(CompleteCloud, OfEveryBodyComesOutClosedWithItsSizeAndClass) {
  check_all(bodies(), {2000, 8000, 30000}, 36);
}

TEST(CompleteCloud, OfStonesComesOutClosedWithItsSizeAndClass) {
  std::vector<Body> some;
  for (Body& body : bodies()) {
    for (const char* name : {"stone14", "stone18", "S02", "eros", "ryugu", "SP1A", "SP2A"}) {
      if (body.name.find(name) != std::string::npos) some.push_back(std::move(body));
    }
  }
  ASSERT_EQ(some.size(), 7u);
  // Known: L of Ryugu, whose ridge is narrower than the points are apart (1.9 % short, three of
  // five clouds), and of stone 18 where the density falls to a third at its tip (1.9 %).
  check_all(some, {8000}, 4);
}

}  // namespace
}  // namespace clast
