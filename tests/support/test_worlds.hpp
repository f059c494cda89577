#pragma once
/// Scenes of several bodies.
#include "dem/contact/stiffness.hpp"
#include "dem/simulation/world.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {

/// Stiffness k_n = k_t, k_r for an arm of half a metre, and a step of `steps` per radian of the
/// lightest body against a fixed one.
inline WorldSettings stiff_world(const RigidBody& lightest, double stiffness, double steps = 40.0) {
  WorldSettings settings;
  settings.stiffness = stiff_settings(lightest, stiffness, steps).stiffness;
  settings.gravity = 0.0;
  return settings;
}

/// What `auto` takes, on ground and between bodies alike.
/// @param fastest  m/s
inline WorldSettings automatic_world(const std::vector<RigidBody>& shapes,
                                     const GroundParameters& ground, double fastest) {
  WorldSettings settings;
  settings.stiffness = choose_stiffness(shapes, std::span(&ground, 1), fastest, 9.81).stiffness;
  settings.between_bodies = ground;
  return settings;
}

inline RigidState at(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
  RigidState state;
  state.position = position;
  state.velocity = velocity;
  return state;
}

/// A rod of the given length along x with round ends.
inline RigidBody capsule(double mass, double length, double radius) {
  RigidBody body;
  body.shape.vertices = {{-0.5 * length, 0, 0}, {0.5 * length, 0, 0}};
  body.shape.edges = {{0, 1}};
  body.shape.radius = radius;
  body.mass = mass;
  const double across = mass * (length * length / 12.0 + 0.25 * radius * radius);
  body.moments = {0.5 * mass * radius * radius, across, across};
  body.smallest_side = 2.0 * radius;
  return body;
}

/// An ellipsoid of flat triangles: convex, 10 cuts^2 + 2 vertices. Moments are those of the smooth
/// one.
inline RigidBody ellipsoid(double mass, const Vec3& half_axes, double radius, int cuts) {
  RigidBody body;
  body.shape = make_sphero_polyhedron(rock_mesh(cuts, half_axes, 1, 0.0), radius);
  body.mass = mass;
  const Vec3 squares = half_axes.cwiseProduct(half_axes);
  body.moments =
      mass / 5.0 *
      Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  body.smallest_side = 2.0 * (half_axes.minCoeff() + radius);
  return body;
}

/// Adds six fixed slabs that close a cube of the given inner half side; shapes `slab`, `slab` + 1
/// and `slab` + 2 of the world must be `room_slabs`.
inline std::vector<RigidBody> room_slabs(double half) {
  std::vector<RigidBody> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 sides = Vec3::Constant(2.0 * half + 2.0);
    sides[axis] = 1.0;
    slabs.push_back(box(1000.0, sides));
  }
  return slabs;
}
inline void add_room(World& world, std::size_t slab, double half) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec3 place = Vec3::Zero();
      place[axis] = side * (half + 0.5);
      world.add_body(slab + static_cast<std::size_t>(axis), at(place), true);
    }
  }
}

/// A round bowl, 16 m wide.
inline TriangleMesh bowl() {
  TriangleMesh mesh = plane_mesh(8.0, 32);
  for (Vec3& vertex : mesh.vertices) vertex.z() = 0.15 * vertex.head<2>().squaredNorm();
  return mesh;
}

/// Rocks of 10 cuts^2 + 2 vertices in layers above the middle of the terrain, falling onto it.
/// @param side  blocks of a row and rows of a layer
inline World falling_pile(const TerrainSurface& terrain, std::size_t blocks, int cuts,
                          unsigned threads, std::size_t side = 6) {
  std::vector<RigidBody> shapes;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    shapes.push_back(rock(cuts, {0.30, 0.25, 0.20}, 0.01, 2650.0, seed));
  }
  const std::vector<GroundParameters> zones = {{0.05, 0.7, 0.2}};
  WorldSettings settings;
  settings.stiffness = choose_stiffness(shapes, zones, 10.0, 9.81).stiffness;
  settings.between_bodies = {0.05, 0.6, 0.2};
  settings.threads = threads;
  World world(shapes, settings, terrain, zones);
  Random random(5);
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t layer = i / (side * side), place = i % (side * side);
    const double middle = 0.5 * static_cast<double>(side - 1);
    RigidState state;
    state.position = {0.75 * (static_cast<double>(place % side) - middle),
                      0.75 * (static_cast<double>(place / side) - middle),
                      1.5 + 0.72 * static_cast<double>(layer)};
    state.orientation = random.rotation();
    state.velocity = {0.0, 0.0, -2.0};
    world.add_body(i % shapes.size(), state);
  }
  return world;
}

}  // namespace clast
