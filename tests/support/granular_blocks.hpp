#pragma once
/// Blocks for granular scenes, where they start, and the walls that hold them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {

constexpr double kBlockDensityRange = 2600.0;  ///< kg/m^3

/// A convex body of 12 vertices and 20 faces, rounded: an icosahedron stretched to the half axes.
inline RigidBody convex_block(const Vec3& half_axes, double radius) {
  return body_of(make_sphero_polyhedron(rock_mesh(1, half_axes, 1, 0.0), radius),
                 kBlockDensityRange, 2.0 * (half_axes.minCoeff() + radius));
}

/// Blocks of five sizes, 0.85 to 1.15 times the middle one, which has the volume of a ball 1 m in
/// diameter.
/// @param of_scale  a block, its lengths times a number
template <class OfScale>
std::vector<RigidBody> five_sizes(const OfScale& of_scale) {
  const double unit = std::cbrt(of_scale(1.0).mass / (kBlockDensityRange * kPi / 6.0));
  std::vector<RigidBody> shapes;
  for (const double size : {0.85, 0.925, 1.0, 1.075, 1.15}) shapes.push_back(of_scale(size / unit));
  return shapes;
}

/// Compact ones.
inline std::vector<RigidBody> block_sizes() {
  return five_sizes(
      [](double scale) { return convex_block(0.5 * scale * Vec3(1.1, 1.0, 0.9), 0.05 * scale); });
}

/// Mean volume when all of them are equally frequent, m^3.
inline double mean_volume(const std::vector<RigidBody>& shapes) {
  double sum = 0.0;
  for (const RigidBody& shape : shapes) sum += shape.mass / kBlockDensityRange;
  return sum / static_cast<double>(shapes.size());
}

/// Largest distance of a point from the centre, m.
inline double largest_reach(const std::vector<RigidBody>& shapes) {
  double reach = 0.0;
  for (const RigidBody& shape : shapes) reach = std::max(reach, shape.bounding_radius());
  return reach;
}

/// A vertical wall of slabs along a circle about the z axis: a quarter of it over x, y > 0, or all.
struct RingWall {
  static constexpr int kSlabsPerQuarter = 6;
  RigidBody slab;
  std::vector<RigidState> states;

  /// @param radius  of the circle with the area inside the ring
  RingWall(double radius, double bottom, double top, int quarters) {
    constexpr double kThickness = 1.0;  // m
    const double half = 0.25 * kPi / kSlabsPerQuarter;
    const double inner = radius * std::sqrt(half / std::tan(half));
    slab = box(1000.0, {kThickness, 2.0 * (inner + kThickness) * std::tan(half), top - bottom});
    for (int i = 0; i < quarters * kSlabsPerQuarter; ++i) {
      const double angle = (2 * i + 1) * half;
      RigidState state;
      state.position = {(inner + 0.5 * kThickness) * std::cos(angle),
                        (inner + 0.5 * kThickness) * std::sin(angle), 0.5 * (bottom + top)};
      state.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
      states.push_back(state);
    }
  }
};

/// Places on a grid inside a circle about the z axis, clear of each other and of the wall, layer by
/// layer from `floor` upwards; orientations at random.
/// @param quarter  x, y > 0 alone, clear of these planes too
inline std::vector<RigidState> loose_filling(std::size_t count, double radius, double reach,
                                             double floor, bool quarter, Random& random) {
  const double clear = 1.02 * reach, spacing = 2.05 * reach;
  const double within = 0.985 * radius - clear;
  const int cells = static_cast<int>(within / spacing) + 1;
  std::vector<Vec3> layer;
  for (int i = quarter ? 0 : -cells; i <= cells; ++i) {
    for (int j = quarter ? 0 : -cells; j <= cells; ++j) {
      const Vec3 place(i * spacing + (quarter ? clear : 0.0), j * spacing + (quarter ? clear : 0.0),
                       floor + clear);
      if (place.head<2>().norm() <= within) layer.push_back(place);
    }
  }
  std::vector<RigidState> states;
  for (std::size_t i = 0; i < count; ++i) {
    RigidState state;
    state.position = layer.at(i % layer.size());
    state.position.z() += spacing * static_cast<double>(i / layer.size());
    state.orientation = random.rotation();
    states.push_back(state);
  }
  return states;
}

}  // namespace clast
