#pragma once
/// A heap of blocks on a disc, and its slope: what stays when the wall around them is removed.
#include "tests/support/granular_blocks.hpp"
#include "tests/support/granular_deposit.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {

/// Shapes of the blocks, five sizes of each; middle ones have the volume of a ball 1 m in diameter.
enum class HeapShape { kBall, kCompact, kElongated };

struct HeapScene {
  HeapShape shape = HeapShape::kCompact;
  double friction = 0.5;
  std::uint64_t seed = 1;
  double step_factor = 1.0;       ///< on the steps of `auto`
  double stiffness_factor = 1.0;  ///< on that with 1 % of a diameter under the whole filling
  double radius = 5.0;            ///< of the disc, m; the number of blocks grows with its cube
  double elongation = 1.7;        ///< of the elongated ones: longest axis over the middle one
};

struct Heap {
  double slope = 0.0;         ///< degrees
  std::size_t blocks = 0;     ///< that stayed
  double touching = 0.0;      ///< largest overlap, m
  double energy_error = 0.0;  ///< of the balance, relative
};

inline std::vector<RigidBody> heap_sizes(const HeapScene& scene) {
  if (scene.shape == HeapShape::kCompact) return block_sizes();
  return five_sizes([&](double scale) {
    return scene.shape == HeapShape::kBall
               ? ball(kBlockDensityRange * kPi / 6.0 * scale * scale * scale, 0.5 * scale)
               : convex_block(0.5 * scale * Vec3(scene.elongation, 1.0, 0.9), 0.05 * scale);
  });
}

/// The upper surface of blocks over places on a grid around the z axis, m; where none lies it is at
/// z = 0.
class UpperSurface {
 public:
  explicit UpperSurface(double radius) : cells_(static_cast<int>(radius * kPerMetre)) {
    for (int i = -cells_; i <= cells_; ++i) {
      for (int j = -cells_; j <= cells_; ++j) {
        const Vec2 place(static_cast<double>(i) / kPerMetre, static_cast<double>(j) / kPerMetre);
        if (place.norm() <= radius) places_.push_back({place, 0.0});
      }
    }
  }

  /// @param body  a ball, or a core of triangles under a rounding that is thin beside it
  void add(const RigidBody& body, const RigidState& state) {
    const Pose pose = state.world_from_body();
    const double rounding = body.shape.radius;
    for (Place& place : places_) {
      if ((place.at - pose.translation.head<2>()).norm() > body.bounding_radius()) continue;
      for (const SpheroPolyhedron::Face& triangle : body.shape.faces) {
        const double top = height_in(pose * body.shape.vertices[triangle[0]],
                                     pose * body.shape.vertices[triangle[1]],
                                     pose * body.shape.vertices[triangle[2]], place.at);
        place.top = std::max(place.top, top + rounding);
      }
      if (body.shape.faces.empty()) {
        const double aside = (pose.translation.head<2>() - place.at).squaredNorm();
        const double below = std::max(0.0, rounding * rounding - aside);
        place.top = std::max(place.top, pose.translation.z() + std::sqrt(below));
      }
    }
  }

  /// Against the distance from the axis, by least squares.
  double gradient() const {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Place& place : places_) {
      const double distance = place.at.norm();
      n += 1.0;
      x += distance;
      y += place.top;
      xx += distance * distance;
      xy += distance * place.top;
    }
    return (n * xy - x * y) / (n * xx - x * x);
  }

 private:
  static constexpr int kPerMetre = 4;
  struct Place {
    Vec2 at;
    double top;
  };

  /// Height of a triangle over a place in plan; far below all where it is not there.
  static double height_in(const Vec3& a, const Vec3& b, const Vec3& c, const Vec2& at) {
    const auto twice_area = [](const Vec2& u, const Vec2& v) {
      return u.x() * v.y() - u.y() * v.x();
    };
    const Vec2 p = a.head<2>() - at, q = b.head<2>() - at, r = c.head<2>() - at;
    const double of_a = twice_area(q, r), of_b = twice_area(r, p), of_c = twice_area(p, q);
    const double all = of_a + of_b + of_c;
    if (!(all > 0.0 && of_a >= 0.0 && of_b >= 0.0 && of_c >= 0.0)) return -1e300;
    return (of_a * a.z() + of_b * b.z() + of_c * c.z()) / all;
  }

  int cells_;
  std::vector<Place> places_;
};

/// Blocks fall into a ring on a disc of fixed blocks of their own kind and lie still; the ring is
/// removed, and what falls off the disc, until the rest lies still. The slope is that of their
/// upper surface from the axis outwards.
inline Heap heap_on_disc(const HeapScene& scene) {
  constexpr double kGravity = 9.81, kCalm = 1e-3;
  constexpr double kBlocksPerCube = 1.44;  // blocks per m^3 of radius cubed
  const double radius = scene.radius;
  const auto count =
      static_cast<std::size_t>(std::lround(kBlocksPerCube * radius * radius * radius));
  std::vector<RigidBody> shapes = heap_sizes(scene);
  const std::size_t sizes = shapes.size();
  const double reach = largest_reach(shapes);
  Random random(scene.seed);
  const auto filling = loose_filling(count, radius, reach, 0.5, false, random);
  const double top = filling.back().position.z() + reach + 1.0;

  const std::vector<GroundParameters> zones = {{0.1, scene.friction, 0.0}};
  StiffnessOptions options;
  options.multi_block = true;
  options.normal = scene.stiffness_factor * shapes[2].mass * kGravity * radius /
                   (0.01 * ground_stiffness_inputs(zones, ContactLaw()).static_stiffness_ratio);
  WorldSettings settings;
  settings.between_bodies = zones[0];
  settings.stiffness =
      choose_stiffness(shapes, zones, std::sqrt(2.0 * kGravity * top), kGravity, options).stiffness;
  settings.stiffness.time_step *= scene.step_factor;
  settings.stiffness.max_time_step *= scene.step_factor;
  const RingWall ring(radius, -1.0, top, 4);
  shapes.push_back(ring.slab);
  World world(shapes, settings);
  // A rough disc without the order of a lattice, on which balls would stack: fixed blocks of all
  // sizes about half a diameter below it, aside and up and down at random.
  const int cells = static_cast<int>(radius) + 1;
  for (int i = -cells; i <= cells; ++i) {
    for (int j = -cells; j <= cells; ++j) {
      RigidState state;
      state.position = Vec3(i, j, -0.5) + 0.25 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1),
                                                      random.uniform(-1, 1));
      state.orientation = random.rotation();
      if (state.position.head<2>().norm() > radius) continue;
      world.add_body(static_cast<std::size_t>(random.uniform(0.0, 5.0)), state, true);
    }
  }
  const std::size_t first = world.body_count();
  for (std::size_t i = 0; i < filling.size(); ++i) world.add_body(i % sizes, filling[i]);
  BlockNumbers wall;
  for (const RigidState& state : ring.states) wall.push_back(world.add_body(sizes, state, true));

  const auto remove_fallen = [&] {
    for (const std::size_t i : moving_blocks(world)) {
      if (world.state(i).position.z() < -1.5) world.remove_body(i);
    }
  };
  const double fall = std::sqrt(2.0 * top / kGravity);
  advance_until_calm(world, fall, 3.0 * fall + 3.0, 2.0 * kCalm);
  for (const std::size_t slab : wall) world.remove_body(slab);
  const double start = world.time();
  advance_until_calm(world, start + 3.0, start + 12.0, kCalm, remove_fallen);

  Heap heap;
  UpperSurface surface(radius);
  for (const std::size_t i : moving_blocks(world)) {
    surface.add(shapes[(i - first) % sizes], world.state(i));
    ++heap.blocks;
  }
  heap.slope = std::atan(-surface.gradient()) * 180.0 / kPi;
  heap.touching = world.statistics().max_overlap;
  heap.energy_error = world.energy_balance().error;
  return heap;
}

}  // namespace clast
