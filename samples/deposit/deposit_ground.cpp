#include "samples/deposit/deposit_ground.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_tree.hpp"
#include "samples/deposit/height_field.hpp"
#include "samples/deposit/settling.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {
namespace {

constexpr double kReliefExponent = 0.8;
constexpr int kWavesPerOctave = 7;
constexpr double kPlanMargin = 0.4;  // m

constexpr double kShortestWave = 3.0;  // of the relief, spacings

// Constants of the floor.
constexpr double kFloorRelief = 0.012;  // m, of the longest waves
constexpr double kFloorWave = 1.5;      // m
constexpr double kTopCell = 0.1;        // m, of the height over which fines are spread
constexpr int kSmoothing = 5;           // cells; fines are even over twice as many

// Constants of natural ground.
constexpr double kNaturalRelief = 0.10;  // m, of the longest waves
constexpr double kNaturalWave = 4.0;     // m
constexpr double kAreaPerRock = 7.0;     // area in plan over L I
constexpr double kLeastRise = 10.0;      // spacings
constexpr double kFilletReach = 0.10;    // of the soil against a rock over I
constexpr double kLargestFillet = 0.12;  // its height over the rise of the rock

/// Height of the blocks above the floor, smoothed over a few blocks.
HeightField smoothed_tops(const ScannedPlan& plan, std::span<const VirtualBlock> blocks,
                          std::span<const Pose> poses, double slope) {
  HeightField tops(plan, kTopCell);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const Vec3& vertex : blocks[b].surface.vertices) {
      const Vec3 point = poses[b] * vertex;
      const int i = static_cast<int>(std::lround((point.x() - tops.low.x()) / tops.cell));
      const int j = static_cast<int>(std::lround((point.y() - tops.low.y()) / tops.cell));
      if (i < 0 || j < 0 || i >= tops.columns || j >= tops.rows) continue;
      double& top = tops.heights[tops.index(i, j)];
      top = std::max(top, point.z() + std::tan(slope) * point.x());
    }
  }
  smooth_heights(tops, kSmoothing);
  return tops;
}

/// A rock near which soil is heaped.
struct Fillet {
  const TriangleTree* tree;
  Pose body_from_world;
  Vec2 centre;
  double radius, height, reach;
};

/// Draws a pose with S near the vertical, as most single rocks lie.
Quat draw_lying_rotation(const VirtualBlock& block, Random& random) {
  const Mat3 axes = smallest_box(block.surface.vertices).axes;
  Mat3 upright;  // S up, L along x
  upright.row(0) = axes.col(0).transpose();
  upright.row(1) = axes.col(1).transpose();
  upright.row(2) = axes.col(2).transpose();
  const double azimuth = random.uniform(0.0, 2.0 * kPi), tilt = random.uniform(0.0, 0.35);
  const double towards = random.uniform(0.0, 2.0 * kPi);
  const Quat yaw(Eigen::AngleAxisd(azimuth, Vec3::UnitZ()));
  const Quat lean(Eigen::AngleAxisd(tilt, Vec3(std::cos(towards), std::sin(towards), 0.0)));
  return (lean * yaw * Quat(upright)).normalized();
}

}  // namespace

GroundRelief::GroundRelief(double height, double longest, double shortest, Random& random) {
  for (double wave = longest; wave >= shortest; wave /= 2.0) {
    for (int i = 0; i < kWavesPerOctave; ++i) {
      const double angle = random.uniform(0.0, 2.0 * kPi);
      const double length = wave * random.uniform(0.75, 1.5);
      waves_.push_back(
          {2.0 * kPi / length * Vec2(std::cos(angle), std::sin(angle)),
           random.uniform(0.0, 2.0 * kPi),
           height * std::pow(wave / longest, kReliefExponent) * std::sqrt(2.0 / kWavesPerOctave)});
    }
  }
}

double GroundRelief::at(const Vec2& place) const {
  double sum = 0.0;
  for (const Wave& wave : waves_)
    sum += wave.height * std::cos(wave.vector.dot(place) + wave.phase);
  return sum;
}

ScannedPlan find_scanned_plan(std::span<const VirtualBlock> blocks, std::span<const Pose> poses) {
  Bounds box;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const Vec3& vertex : blocks[b].surface.vertices) box.include(poses[b] * vertex);
  }
  const Vec2 margin = Vec2::Constant(kPlanMargin);
  return {box.low.head<2>() - margin, box.high.head<2>() + margin};
}

TriangleMesh make_floor_ground(const DepositRecipe& recipe, std::span<const VirtualBlock> blocks,
                               std::span<const Pose> poses, unsigned threads) {
  Random random(recipe.seed + 2);
  const double spacing = recipe.spacing(), slope = floor_slope(recipe.kind);
  const ScannedPlan plan = find_scanned_plan(blocks, poses);
  const HeightField tops = smoothed_tops(plan, blocks, poses, slope);
  const GroundRelief relief(kFloorRelief, kFloorWave, kShortestWave * spacing, random);
  const GroundRelief patches(1.0, 3.0, 1.0, random);
  HeightField field(plan, spacing);
  fill_heights(field, threads, [&](const Vec2& place) {
    // Not below the floor on which the blocks came to rest.
    const double soil = std::max(0.0, relief.at(place) + kFloorRelief);
    const double depth =
        recipe.fines * tops.at(place) * std::clamp(1.0 + 0.25 * patches.at(place), 0.4, 1.6);
    return soil + depth - std::tan(slope) * place.x();
  });
  add_grains(field, spacing, random);
  return make_mesh(field);
}

NaturalScene make_natural_scene(const DepositRecipe& recipe, std::span<const VirtualBlock> blocks,
                                unsigned threads) {
  Random random(recipe.seed + 1);
  const double spacing = recipe.spacing();
  const GroundRelief relief(kNaturalRelief, kNaturalWave, kShortestWave * spacing, random);
  double area = 0.0;
  std::vector<std::size_t> by_size(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    area += kAreaPerRock * blocks[b].axes[0] * blocks[b].axes[1];
    by_size[b] = b;
  }
  std::stable_sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) {
    return blocks[a].axes[0] > blocks[b].axes[0];
  });

  NaturalScene scene;
  scene.poses.resize(blocks.size());
  std::vector<Fillet> fillets;
  std::vector<TriangleTree> trees;
  trees.reserve(blocks.size());
  double half = 0.5 * std::sqrt(area);
  for (const std::size_t b : by_size) {
    const VirtualBlock& block = blocks[b];
    const Quat rotation = draw_lying_rotation(block, random);
    Bounds box;
    for (const Vec3& vertex : block.surface.vertices) box.include(rotation * vertex);
    const double radius = 0.5 * (box.high - box.low).head<2>().norm();
    Vec2 centre;
    const auto is_free = [&] {
      return std::none_of(fillets.begin(), fillets.end(), [&](const Fillet& other) {
        return (other.centre - centre).norm() < other.radius + radius;
      });
    };
    do {
      centre = half * Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      half *= 1.002;  // a place is found in the end
    } while (!is_free());
    const double height = box.high.z() - box.low.z();
    const double buried = std::min(random.uniform(0.08, 0.5) * height,
                                   std::max(0.0, height - 1.5 * kLeastRise * spacing));
    Pose& pose = scene.poses[b];
    pose.rotation = rotation;
    pose.translation = {centre.x(), centre.y(), relief.at(centre) - buried - box.low.z()};
    trees.emplace_back(block.surface);
    fillets.push_back({&trees.back(), pose.inverse(), centre, radius,
                       kLargestFillet * random.uniform() * (height - buried),
                       kFilletReach * block.axes[1]});
  }

  HeightField field(find_scanned_plan(blocks, scene.poses), spacing);
  fill_heights(field, threads, [&](const Vec2& place) {
    double height = relief.at(place), heaped = 0.0;
    for (const Fillet& fillet : fillets) {
      if ((place - fillet.centre).norm() > fillet.radius + 4.0 * fillet.reach) continue;
      const Vec3 point = fillet.body_from_world * Vec3(place.x(), place.y(), height);
      const double distance = std::max(0.0, fillet.tree->signed_distance(point));
      heaped = std::max(heaped, fillet.height * std::exp(-distance / fillet.reach));
    }
    return height + heaped;
  });
  add_grains(field, spacing, random);
  scene.ground = make_mesh(field);
  return scene;
}

}  // namespace clast
