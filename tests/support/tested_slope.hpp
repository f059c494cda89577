#pragma once
/// The slope that speed and steps are tested on: 36 degrees down to a level foot where blocks come
/// to rest, in cells of 0.5 m, nodes moved by up to 0.3 cells in plan and scattered by 0.10 m in
/// height. A larger one is the same slope extended to all sides: each node draws its own numbers.
#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/random.hpp"
#include "dem/contact/stiffness.hpp"
#include "tests/support/test_bodies.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {

inline constexpr double kTestedSlope = 36.0 * kRadiansPerDegree;
inline const std::vector<GroundParameters> kTestedZones = {{0.01, 0.70, 0.18}};

/// @param cells  per side, even: 2 cells^2 triangles centred on the origin, falling along +x to the
///               foot at x = 0
inline TriangleMesh tested_slope(int cells) {
  constexpr double kSize = 0.5, kShift = 0.3, kRoughness = 0.10;
  TriangleMesh mesh;
  for (int j = -cells / 2; j <= cells / 2; ++j) {
    for (int i = -cells / 2; i <= cells / 2; ++i) {
      Random random((static_cast<std::uint64_t>(i + 100000) << 32) +
                    static_cast<std::uint64_t>(j + 100000));
      const double x = kSize * (i + random.uniform(-kShift, kShift));
      const double y = kSize * (j + random.uniform(-kShift, kShift));
      mesh.vertices.emplace_back(
          x, y, -std::tan(kTestedSlope) * std::min(x, 0.0) + kRoughness * random.normal());
    }
  }
  mesh.triangles = halved_squares(cells);
  return mesh;
}

/// The rock that is released on it, of about 600 kg.
/// @param cuts  per edge of the icosahedron that it is made from: 10 cuts^2 + 2 vertices
inline RigidBody tested_rock(int cuts) { return rock(cuts, {0.42, 0.36, 0.30}, 0.02, 2700.0, 3); }

/// Its starts: above the upper part of the smallest slope, in random orientations.
inline RigidState tested_start(std::uint64_t number) {
  Random random(100 + number);
  RigidState start;
  start.orientation = random.rotation();
  start.position = {-12.0, random.uniform(-2.0, 2.0), 12.0 * std::tan(kTestedSlope) + 2.5};
  return start;
}

/// `auto` stiffness and step for it.
inline ReleaseSettings tested_settings(const RigidBody& body) {
  ReleaseSettings settings;
  settings.stiffness = choose_stiffness(std::span(&body, 1), kTestedZones, 30.0, 9.81).stiffness;
  return settings;
}

}  // namespace clast
