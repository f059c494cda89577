#pragma once
/// One scan of a body in several passes, each displaced and rotated a little against the others.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

/// Lengths are relative to the largest extent of the body.
struct StripRecipe {
  std::size_t passes = 2;      ///< two to four
  std::size_t points = 12000;  ///< of all passes
  double noise = 0.001;        ///< standard deviation of every coordinate
  double shift = 0.015;        ///< displacement of each pass but the first
  double rotation = 0.0;       ///< of each pass but the first, rad
  double overlap = 0.5;        ///< angle by which neighbouring passes overlap, rad
};

struct StripScan {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> passes;  ///< pass of each point, from 0
  std::vector<Pose> true_from_scan;   ///< pose that corrects each pass; the identity for the first
  double size = 0.0;                  ///< largest extent of the body, m
};

/// Sectors about a random axis, one for each pass. The points of all passes are mixed.
inline StripScan make_strips(const TriangleMesh& body, const StripRecipe& recipe, Random& random) {
  StripScan scan;
  const Bounds box = bounds(body);
  scan.size = (box.high - box.low).maxCoeff();
  const Vec3 middle = 0.5 * (box.low + box.high);
  std::vector<Pose> scan_from_true;
  for (std::size_t k = 0; k < recipe.passes; ++k) {
    Pose moved{Vec3::Zero(), Quat::Identity()};
    const Vec3 towards = random.unit_vector(), about = random.unit_vector();
    if (k > 0) {
      moved.rotation = Quat(Eigen::AngleAxisd(recipe.rotation, about));
      moved.translation = recipe.shift * scan.size * towards + middle - moved.rotation * middle;
    }
    scan_from_true.push_back(moved);
    scan.true_from_scan.push_back(moved.inverse());
  }
  const SurfaceSampler sampler(body);
  const Quat sectors = random.rotation();
  const double width = 2.0 * kPi / static_cast<double>(recipe.passes);
  while (scan.points.size() < recipe.points) {
    const Vec3 p = sampler.draw(random).point;
    const Vec3 from_middle = sectors * (p - middle);
    const double azimuth = std::atan2(from_middle.y(), from_middle.x());
    for (std::size_t k = 0; k < recipe.passes; ++k) {
      const double off = std::remainder(azimuth - width * static_cast<double>(k), 2.0 * kPi);
      if (std::abs(off) > 0.5 * (width + recipe.overlap)) continue;
      const Vec3 noise(random.normal(), random.normal(), random.normal());
      scan.points.push_back(scan_from_true[k] * p + recipe.noise * scan.size * noise);
      scan.passes.push_back(static_cast<std::uint32_t>(k));
    }
  }
  return scan;
}

}  // namespace clast
