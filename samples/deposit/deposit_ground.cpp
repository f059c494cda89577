#include "samples/deposit/deposit_ground.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "mesh/triangle_tree.hpp"
#include "samples/deposit/settling.hpp"

namespace clast {
namespace {

constexpr double kReliefExponent = 0.8;
constexpr int kWavesPerOctave = 7;
constexpr double kPlanMargin = 0.4;  // m

// Of all grounds, in spacings.
constexpr double kGravel = 0.3;           // standard deviation of the height of each vertex
constexpr double kShortestWave = 3.0;     // of the relief
constexpr double kPebbleRadius = 3.0;     // largest
constexpr double kPebbleDistance = 18.0;  // mean one

// Of the floor.
constexpr double kFloorRelief = 0.012;  // m, of the longest waves
constexpr double kFloorWave = 1.5;      // m
constexpr double kTopCell = 0.1;        // m, of the height over which fines are spread
constexpr int kSmoothing = 5;           // cells; fines are even over twice as many

// Of natural ground.
constexpr double kNaturalRelief = 0.10;  // m, of the longest waves
constexpr double kNaturalWave = 4.0;     // m
constexpr double kAreaPerRock = 7.0;     // area in plan over L I
constexpr double kLeastRise = 10.0;      // spacings
constexpr double kFilletReach = 0.10;    // of the soil against a rock over I
constexpr double kLargestFillet = 0.12;  // its height over the rise of the rock

/// A height for each node of a grid in plan.
struct HeightField {
  Vec2 low = Vec2::Zero();
  double cell = 1.0;  ///< m
  int columns = 0, rows = 0;
  std::vector<double> heights;  ///< row by row

  HeightField(const ScannedPlan& plan, double cell_size)
      : low(plan.low),
        cell(cell_size),
        columns(static_cast<int>(std::ceil((plan.high.x() - plan.low.x()) / cell_size)) + 1),
        rows(static_cast<int>(std::ceil((plan.high.y() - plan.low.y()) / cell_size)) + 1),
        heights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0) {}

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  Vec2 place(int column, int row) const { return low + cell * Vec2(column, row); }

  /// Bilinear between nodes, that of the border outside.
  double at(const Vec2& place) const {
    const Vec2 scaled = (place - low) / cell;
    const double x = std::clamp(scaled.x(), 0.0, columns - 1.001);
    const double y = std::clamp(scaled.y(), 0.0, rows - 1.001);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    return (1.0 - v) * ((1.0 - u) * heights[index(i, j)] + u * heights[index(i + 1, j)]) +
           v * ((1.0 - u) * heights[index(i, j + 1)] + u * heights[index(i + 1, j + 1)]);
  }
};

void fill_heights(HeightField& field, unsigned threads,
                  const std::function<double(const Vec2&)>& height) {
  parallel_for(static_cast<std::size_t>(field.rows), threads, [&](std::size_t j) {
    const int row = static_cast<int>(j);
    for (int i = 0; i < field.columns; ++i) {
      field.heights[field.index(i, row)] = height(field.place(i, row));
    }
  });
}

/// Adds pebbles, half buried balls, and gravel that no scan resolves.
void add_grains(HeightField& field, double spacing, Random& random) {
  const double area = field.cell * field.cell * field.columns * field.rows;
  const double distance = kPebbleDistance * spacing;
  for (int left = static_cast<int>(area / (distance * distance)); left > 0; --left) {
    const double radius = kPebbleRadius * spacing * std::sqrt(random.uniform(0.1, 1.0));
    const int i = static_cast<int>(random.uniform_index(static_cast<std::uint64_t>(field.columns)));
    const int j = static_cast<int>(random.uniform_index(static_cast<std::uint64_t>(field.rows)));
    const int reach = static_cast<int>(radius / field.cell);
    for (int y = std::max(0, j - reach); y <= std::min(field.rows - 1, j + reach); ++y) {
      for (int x = std::max(0, i - reach); x <= std::min(field.columns - 1, i + reach); ++x) {
        const double aside = (field.place(x, y) - field.place(i, j)).squaredNorm();
        const double rise = radius * radius - aside;
        if (rise > 0.0) field.heights[field.index(x, y)] += 0.7 * std::sqrt(rise);
      }
    }
  }
  for (double& height : field.heights) height += kGravel * spacing * random.normal();
}

TriangleMesh mesh_of(const HeightField& field) {
  TriangleMesh mesh;
  mesh.vertices.reserve(field.heights.size());
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i) {
      const Vec2 place = field.place(i, j);
      mesh.vertices.emplace_back(place.x(), place.y(), field.heights[field.index(i, j)]);
    }
  }
  mesh.triangles.reserve(2 * field.heights.size());
  for (int j = 0; j + 1 < field.rows; ++j) {
    for (int i = 0; i + 1 < field.columns; ++i) {
      const auto a = static_cast<std::uint32_t>(field.index(i, j));
      const auto d = static_cast<std::uint32_t>(field.index(i, j + 1));
      mesh.triangles.push_back({a, a + 1, d + 1});
      mesh.triangles.push_back({a, d + 1, d});
    }
  }
  return mesh;
}

/// Box blur, three times in both directions: nearly a Gaussian.
void smooth(HeightField& field, int reach) {
  for (int pass = 0; pass < 6; ++pass) {
    const bool along_rows = pass % 2 == 0;
    const std::vector<double> before = field.heights;
    for (int j = 0; j < field.rows; ++j) {
      for (int i = 0; i < field.columns; ++i) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int x = std::clamp(along_rows ? i + k : i, 0, field.columns - 1);
          const int y = std::clamp(along_rows ? j : j + k, 0, field.rows - 1);
          sum += before[field.index(x, y)];
        }
        field.heights[field.index(i, j)] = sum / (2 * reach + 1);
      }
    }
  }
}

/// Height of the blocks above the floor, smoothed over a few blocks.
HeightField smoothed_tops(const ScannedPlan& plan, std::span<const DepositBlock> blocks,
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
  smooth(tops, kSmoothing);
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
Quat draw_lying_rotation(const DepositBlock& block, Random& random) {
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

ScannedPlan find_scanned_plan(std::span<const DepositBlock> blocks, std::span<const Pose> poses) {
  Bounds box;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const Vec3& vertex : blocks[b].surface.vertices) box.include(poses[b] * vertex);
  }
  const Vec2 margin = Vec2::Constant(kPlanMargin);
  return {box.low.head<2>() - margin, box.high.head<2>() + margin};
}

TriangleMesh make_floor_ground(const DepositRecipe& recipe, std::span<const DepositBlock> blocks,
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
  return mesh_of(field);
}

NaturalScene make_natural_scene(const DepositRecipe& recipe, std::span<const DepositBlock> blocks,
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
    const DepositBlock& block = blocks[b];
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
  scene.ground = mesh_of(field);
  return scene;
}

}  // namespace clast
