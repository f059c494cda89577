#pragma once
/// A quarter of a round column of blocks that collapses when the wall around it is removed.
#include "tests/support/granular_blocks.hpp"
#include "tests/support/granular_deposit.hpp"

namespace clast {

/// Diameters are those of the ball with the volume of the middle block, 1 m.
struct ColumnScene {
  double aspect = 1.0;  ///< height over radius, about: what it has when settled is measured
  std::size_t blocks = 100;
  double friction = 0.5;  ///< between blocks and on the floor; planes of symmetry have none
  double energy_restitution = 0.1;
  std::uint64_t seed = 1;
  ContactLaw law = {};
  double stiffness_factor = 1.0;  ///< on that with 1 % of a diameter under the whole column
};

struct Collapse {
  double radius = 0.0;         ///< r0, of the column, m
  double height = 0.0;         ///< h0: twice the height of its centre of mass, m
  double front = 0.0;          ///< of the continuous deposit, m
  double touching = 0.0;       ///< largest overlap when the deposit lay still, m
  std::size_t continuous = 0;  ///< blocks of the continuous deposit
  double energy_error = 0.0;   ///< of the balance, relative

  double aspect() const { return height / radius; }
  double runout() const { return (front - radius) / radius; }
};

/// (r - r0)/r0 of columns of sand, salt, sugar, rice and couscous of the aspect ratio a.
/// @cite lube2004
inline double published_runout(double aspect) {
  return aspect < 1.7 ? 1.24 * aspect : 1.6 * std::sqrt(aspect);
}

/// Floor over the quarter 0 < x, y < side, zone 0, and the planes of symmetry x = 0 and y = 0 as
/// vertical walls, zone 1.
inline TerrainSurface quarter_floor(double side, double wall_height) {
  TriangleMesh mesh;
  const Vec3 up(0.0, 0.0, wall_height), x(side, 0.0, 0.0), y(0.0, side, 0.0);
  mesh.vertices = {Vec3::Zero(), x, x + y, y, up, x + up, y + up};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}, {0, 3, 6}, {0, 6, 4}};
  return TerrainSurface(std::move(mesh), {0, 0, 1, 1, 1, 1});
}

/// Blocks fall into the ring from a loose grid, lie still, the ring is removed, and the deposit
/// lies still. docs/theory.md, Columns, defines the front.
inline Collapse collapse_column(const ColumnScene& scene) {
  constexpr double kGravity = 9.81, kPackedFraction = 0.57, kLink = 1.5, kCalm = 1e-3;
  std::vector<RigidBody> shapes = block_sizes();
  const double reach = largest_reach(shapes), middle_mass = shapes[2].mass;
  const std::size_t sizes = shapes.size();
  Collapse result;
  result.radius = std::cbrt(static_cast<double>(scene.blocks) * mean_volume(shapes) /
                            kPackedFraction / (0.25 * kPi * scene.aspect));
  Random random(scene.seed);
  const auto filling = loose_filling(scene.blocks, result.radius, reach, 0.0, true, random);
  const double top = filling.back().position.z() + reach + 1.0;

  const std::vector<GroundParameters> zones = {{scene.energy_restitution, scene.friction, 0.0},
                                               {scene.energy_restitution, 0.0, 0.0}};
  StiffnessOptions options;
  options.law = scene.law;
  options.multi_block = true;
  options.normal = scene.stiffness_factor * middle_mass * kGravity * scene.aspect * result.radius /
                   (0.01 * ground_stiffness_inputs(zones, scene.law).static_stiffness_ratio);
  WorldSettings settings;
  settings.law = scene.law;
  settings.between_bodies = zones[0];
  settings.stiffness =
      choose_stiffness(shapes, zones, std::sqrt(2.0 * kGravity * top), kGravity, options).stiffness;
  const RingWall ring(result.radius, 0.0, top, 1);
  shapes.push_back(ring.slab);
  const TerrainSurface floor = quarter_floor(4.0 * (1.0 + scene.aspect) * result.radius, top);
  World world(shapes, settings, floor, zones);
  BodyShapes shape_of;
  const auto add = [&](std::size_t shape, const RigidState& state, bool fixed) {
    shape_of.push_back(&shapes[shape]);
    return world.add_body(shape, state, fixed);
  };
  for (std::size_t i = 0; i < filling.size(); ++i) add(i % sizes, filling[i], false);
  BlockNumbers wall;
  for (const RigidState& state : ring.states) wall.push_back(add(sizes, state, true));

  const double fall = std::sqrt(2.0 * top / kGravity);
  advance_until_calm(world, fall, 3.0 * fall + 3.0, 2.0 * kCalm);
  double moment = 0.0, mass = 0.0;
  for (const std::size_t i : moving_blocks(world)) {
    moment += shape_of[i]->mass * world.state(i).position.z();
    mass += shape_of[i]->mass;
  }
  result.height = 2.0 * moment / mass;
  for (const std::size_t slab : wall) world.remove_body(slab);
  const double unit = std::sqrt(result.height / kGravity), start = world.time();
  advance_until_calm(world, start + 4.0 * unit, start + 8.0 * unit, kCalm);
  const BlockNumbers deposit = continuous_deposit(world, kLink);
  result.front = mean_front(world, shape_of, deposit);
  result.continuous = deposit.size();
  result.touching = world.statistics().max_overlap;
  result.energy_error = world.energy_balance().error;
  return result;
}

}  // namespace clast
