#pragma once
/// Made-up scans of blocks on a ground, of which every point is known to be rock, ground or stray.
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

/// A sloping ground with gravel.
class FieldGround {
 public:
  /// @param slope   rise along x
  /// @param gravel  standard deviation of the height of closely packed gravel, m
  /// @param stones  half balls of 1 to 2.5 cm lying on it
  /// @param half    half the side of the square that holds them, m
  FieldGround(double slope, double gravel, int stones, double half, std::uint64_t seed)
      : slope_(slope), gravel_(gravel) {
    Random random(seed);
    for (int i = 0; i < 24; ++i) {
      const double angle = random.uniform(0.0, 2.0 * kPi), length = random.uniform(0.03, 0.08);
      waves_.push_back({2.0 * kPi / length * Vec2(std::cos(angle), std::sin(angle)),
                        random.uniform(0.0, 2.0 * kPi)});
    }
    for (int i = 0; i < stones; ++i) {
      stones_.push_back(
          {random.uniform(-half, half), random.uniform(-half, half), random.uniform(0.01, 0.025)});
    }
  }

  double at(double x, double y) const {
    double height = slope_ * x;
    for (const Wave& wave : waves_) {
      height += gravel_ * std::sqrt(2.0 / static_cast<double>(waves_.size())) *
                std::sin(wave.vector.dot(Vec2(x, y)) + wave.phase);
    }
    double stone = 0.0;
    for (const Vec3& s : stones_) {
      const double rest = s.z() * s.z() - (x - s.x()) * (x - s.x()) - (y - s.y()) * (y - s.y());
      if (rest > stone * stone) stone = std::sqrt(rest);
    }
    return height + stone;
  }

 private:
  struct Wave {
    Vec2 vector;
    double phase;
  };
  double slope_, gravel_;
  std::vector<Wave> waves_;
  std::vector<Vec3> stones_;  ///< x, y, radius
};

struct FieldScene {
  std::vector<Vec3> points;
  std::vector<int> owner;  ///< number of the block, -1 ground, -2 stray
};

/// What a field scan is made of.
struct FieldCounts {
  int per_block = 40000;
  int ground = 40000;
  int strays = 0;
  double noise = 0.0;  ///< standard deviation of every coordinate, m
  double half = 1.0;   ///< half the side of the square of ground, m
  /// Rock that faces down by more than this (z of its normal) is seen by nobody. Of rendered photo
  /// sets in rings around a block, 90 % of what faces down by 0.3 to 0.6 was found, 11 % beyond.
  double steepest = -0.6;
};

/// Points on the blocks where they stand out of the ground, and on the ground where no block is.
/// The blocks must be where they belong, in z too.
inline FieldScene field_scene(const std::vector<TriangleMesh>& blocks, const FieldGround& ground,
                              const FieldCounts& counts, std::uint64_t seed) {
  Random random(seed);
  FieldScene scene;
  const auto add = [&](const Vec3& p, int owner) {
    const Vec3 noise(random.normal(), random.normal(), random.normal());
    scene.points.push_back(p + counts.noise * noise);
    scene.owner.push_back(owner);
  };
  for (int k = 0; k < static_cast<int>(blocks.size()); ++k) {
    const TriangleMesh& mesh = blocks[static_cast<std::size_t>(k)];
    const SurfaceSampler surface(mesh);
    for (int i = 0; i < counts.per_block;) {
      const auto [triangle, p] = surface.draw(random);
      const Vec3 normal = unit_normal(mesh, triangle);
      if (p.z() < ground.at(p.x(), p.y()) || normal.z() < counts.steepest) continue;
      add(p, k);
      ++i;
    }
  }
  std::vector<TriangleTree> trees;
  trees.reserve(blocks.size());
  for (const TriangleMesh& mesh : blocks) trees.emplace_back(mesh);
  for (int i = 0; i < counts.ground;) {
    const double x = random.uniform(-counts.half, counts.half);
    const double y = random.uniform(-counts.half, counts.half);
    const Vec3 p(x, y, ground.at(x, y));
    bool hidden = false;
    for (const TriangleTree& tree : trees) hidden |= tree.signed_distance(p) < 0.0;
    if (hidden) continue;
    add(p, -1);
    ++i;
  }
  Bounds box;
  for (const Vec3& p : scene.points) box.include(p);
  for (int i = 0; i < counts.strays; ++i) {
    const Vec3 share(random.uniform(), random.uniform(), random.uniform());
    scene.points.push_back(box.low + share.cwiseProduct(box.high - box.low));
    scene.owner.push_back(-2);
  }
  return scene;
}

/// The rock moved so that its lowest point lies at `depth` times its height below the ground under
/// (x, y).
inline TriangleMesh buried_at(TriangleMesh rock, double x, double y, double depth,
                              const FieldGround& ground) {
  const Bounds box = bounds(rock);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double height = box.high.z() - box.low.z();
  const Vec3 shift(x - middle.x(), y - middle.y(), ground.at(x, y) - depth * height - box.low.z());
  for (Vec3& vertex : rock.vertices) vertex += shift;
  return rock;
}

}  // namespace clast
