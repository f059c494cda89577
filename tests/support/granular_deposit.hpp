#pragma once
/// What is measured of many blocks that lie on each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dem/simulation/world.hpp"

namespace clast {

/// Body numbers, and the shape of each body of the world.
using BlockNumbers = std::vector<std::size_t>;
using BodyShapes = std::vector<const RigidBody*>;

/// Blocks that are neither fixed nor gone.
inline BlockNumbers moving_blocks(const World& world) {
  BlockNumbers blocks;
  for (std::size_t i = 0; i < world.body_count(); ++i) {
    if (!world.is_fixed(i) && !world.is_inactive(i)) blocks.push_back(i);
  }
  return blocks;
}

/// Mean of v^2 over these blocks, m^2/s^2.
inline double mean_square_speed(const World& world) {
  const BlockNumbers blocks = moving_blocks(world);
  double sum = 0.0;
  for (const std::size_t i : blocks) sum += world.state(i).velocity.squaredNorm();
  return blocks.empty() ? 0.0 : sum / static_cast<double>(blocks.size());
}

/// Steps until `earliest` is over and the mean of v^2 is below `calm`, looked at every tenth of a
/// second, or until `latest`.
/// @param each_tenth  called then, too
template <class Each>
void advance_until_calm(World& world, double earliest, double latest, double calm,
                        const Each& each_tenth) {
  constexpr double kBetween = 0.1;  // s
  double next = world.time() + kBetween;
  while (world.time() < latest) {
    world.step();
    if (world.time() < next) continue;
    next += kBetween;
    each_tenth();
    if (world.time() > earliest && mean_square_speed(world) < calm) return;
  }
}
inline void advance_until_calm(World& world, double earliest, double latest, double calm) {
  advance_until_calm(world, earliest, latest, calm, [] {});
}

/// The largest set of blocks with a way from each to each by centres less than `link` apart.
inline BlockNumbers continuous_deposit(const World& world, double link) {
  const BlockNumbers blocks = moving_blocks(world);
  std::vector<char> seen(world.body_count(), 0);
  BlockNumbers largest;
  for (const std::size_t first : blocks) {
    if (seen[first]) continue;
    BlockNumbers found = {first};
    seen[first] = 1;
    for (std::size_t k = 0; k < found.size(); ++k) {
      for (const std::size_t other : blocks) {
        const double apart = (world.state(other).position - world.state(found[k]).position).norm();
        if (seen[other] || apart >= link) continue;
        seen[other] = 1;
        found.push_back(other);
      }
    }
    if (found.size() > largest.size()) largest = std::move(found);
  }
  return largest;
}

/// Largest distance of a point of the body from the z axis, m.
inline double farthest_from_axis(const RigidBody& body, const RigidState& state) {
  double farthest = 0.0;
  for (const Vec3& vertex : body.shape.vertices) {
    const Vec3 place = state.world_from_body() * vertex;
    farthest = std::max(farthest, place.head<2>().norm() + body.shape.radius);
  }
  return farthest;
}

/// Front of blocks around the z axis over the quarter x, y > 0: mean over nine sectors of the
/// farthest point in each, m.
inline double mean_front(const World& world, const BodyShapes& shapes, const BlockNumbers& blocks) {
  std::array<double, 9> fronts{};
  for (const std::size_t i : blocks) {
    const Vec3& place = world.state(i).position;
    const double angle = std::clamp(std::atan2(place.y(), place.x()) / (0.5 * kPi), 0.0, 0.999);
    double& front = fronts[static_cast<std::size_t>(angle * fronts.size())];
    front = std::max(front, farthest_from_axis(*shapes[i], world.state(i)));
  }
  double sum = 0.0;
  for (const double front : fronts) sum += front;
  return sum / fronts.size();
}

}  // namespace clast
