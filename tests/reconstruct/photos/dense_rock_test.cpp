/// Dense points of the rendered rock, against its mesh; and of the real boulder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>

#include "mesh/mesh_io.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/photos/dense_cloud.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"

namespace clast {
namespace {

constexpr double kLength = 0.7294;  ///< L of the true rock, m

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Errors {
  double mean = 0.0, p95 = 0.0, coverage = 0.0;
};

/// Of the points on the block, and how many faces above the ground with n_z > -0.3 have a point
/// within half a per cent of L.
Errors errors_of(const DenseCloud& cloud, const ToTruth& to_truth) {
  const TriangleMesh rock = read_mesh(test_data("photos/synthetic_rock/gt_rock.ply"));
  const TriangleTree tree(rock);
  std::vector<Vec3> near;
  std::vector<double> distances;
  for (const Vec3& p : cloud.points) {
    const Vec3 position = to_truth * p;
    const double distance = std::sqrt(tree.closest_point(position).squared_distance);
    if (distance < 0.02 * kLength) near.push_back(position);
    // Near the ground its points can't be told from the rock's by distance.
    if (position.z() > 0.06 && distance < 0.02 * kLength) distances.push_back(distance / kLength);
  }
  Errors errors;
  for (const double d : distances) errors.mean += d / static_cast<double>(distances.size());
  std::sort(distances.begin(), distances.end());
  errors.p95 = distances[distances.size() * 95 / 100];
  const reconstruct_detail::PointTree points(near);
  double seen = 0.0, all = 0.0;
  for (const auto& [a, b, c] : rock.triangles) {
    const Vec3 &p = rock.vertices[a], &q = rock.vertices[b], &r = rock.vertices[c];
    const Vec3 across = (q - p).cross(r - p), middle = (p + q + r) / 3.0;
    if (middle.z() < 0.03 || across.z() < -0.3 * across.norm()) continue;
    all += across.norm();
    if (points.nearest_neighbours(middle, 1).front().distance < 0.005 * kLength)
      seen += across.norm();
  }
  errors.coverage = seen / all;
  return errors;
}

/// How deep in the rock the deepest middle of a cube is that photos looked through, in sides of a
/// cube; and that fewer than one in 100,000 are inside at all.
double deepest_cube(const DenseCloud& cloud, const ToTruth& to_truth) {
  const TriangleMesh rock = read_mesh(test_data("photos/synthetic_rock/gt_rock.ply"));
  const TriangleTree tree(rock);
  std::size_t inside = 0, all = 0;
  double deepest = 0.0;
  for (std::size_t i = 0; i < cloud.free_space.is_free_cell.size(); ++i) {
    if (!cloud.free_space.is_free_cell[i]) continue;
    ++all;
    const double depth = -tree.signed_distance(to_truth * cloud.free_space.cell_centre(i));
    inside += depth > 0.0 ? 1 : 0;
    deepest = std::max(deepest, depth / (to_truth.scale * cloud.free_space.side));
  }
  std::cout << all << " cubes were looked through, " << inside << " of them in the rock, by "
            << deepest << " sides at most\n";
  EXPECT_LT(static_cast<double>(inside), 1e-5 * static_cast<double>(all));
  return deepest;
}

// Bars: mean 0.10 % of L, 95th percentile 0.30 %, 98 % coverage, 60 CPU s.
TEST(DenseRock, PointsLieOnTheTrueSurface) {
  for (const bool of_truth : {true, false}) {
    const PhotoModel model = of_truth ? true_model() : colmap_model();
    const double before = cpu_seconds();
    const DenseCloud cloud = compute_dense_cloud(model, {.threads = 2});
    const double spent = cpu_seconds() - before;
    const ToTruth to_truth(model);
    const Errors errors = errors_of(cloud, to_truth);
    std::cout << (of_truth ? "true cameras: " : "COLMAP's cameras: ") << cloud.pairs.size()
              << " pairs, " << cloud.points.size() << " points, radius "
              << to_truth.scale * cloud.region.radius << " m, mean " << 100.0 * errors.mean
              << " %, p95 " << 100.0 * errors.p95 << " %, coverage " << 100.0 * errors.coverage
              << " %, " << spent << " CPU s\n";
    EXPECT_TRUE(cloud.blurred.empty());
    EXPECT_LE(errors.mean, 0.0010);
    EXPECT_LE(errors.p95, 0.0030);
    EXPECT_GE(errors.coverage, 0.98);
    EXPECT_LT(spent, 60.0);
    EXPECT_LT(deepest_cube(cloud, to_truth), 0.5);
  }
}

// Masks of the block alone: no ground, and the same surface.
TEST(DenseRock, MasksLeaveTheBlockAlone) {
  const PhotoModel model = colmap_model();
  const ToTruth to_truth(model);
  const auto masks = test_data("photos/synthetic_rock/masks");
  const DenseCloud cloud =
      compute_dense_cloud(model, {.max_image_side = 500, .masks = masks, .threads = 2});
  const TriangleMesh rock = read_mesh(test_data("photos/synthetic_rock/gt_rock.ply"));
  const TriangleTree tree(rock);
  std::size_t off = 0;
  for (const Vec3& p : cloud.points) {
    off += std::sqrt(tree.closest_point(to_truth * p).squared_distance) > 0.02 * kLength ? 1 : 0;
  }
  std::cout << cloud.points.size() << " points, " << off << " of them off the rock\n";
  EXPECT_GT(cloud.points.size(), 20000u);
  EXPECT_LT(off, cloud.points.size() / 200);
}

// Bar: 90 s from the stored model.
TEST(DenseBoulder, RealPhotosGivePointsAllRound) {
  const PhotoModel model =
      locate_photo_files(read_photo_model(test_data("photos/nlesc_rock/colmap_txt")),
                         test_data("photos/nlesc_rock/images"));
  const double before = cpu_seconds();
  const DenseCloud cloud = compute_dense_cloud(model, {.threads = 2});
  const double spent = cpu_seconds() - before;
  std::cout << cloud.pairs.size() << " pairs, " << cloud.points.size() << " points, " << spent
            << " CPU s\n";
  for (const std::string& note : cloud.notes) std::cout << note << "\n";
  EXPECT_TRUE(cloud.region.from_ground);
  EXPECT_GT(cloud.points.size(), 100000u);
  EXPECT_LT(spent, 90.0);
}

}  // namespace
}  // namespace clast
