#include "study/simulate/detail/run_starts.hpp"

#include <algorithm>

#include "dem/simulation/release.hpp"
#include "study/campaign/named_seed.hpp"
#include "study/campaign/release_points.hpp"

namespace clast::study_detail {
namespace {

/// A block that is lifted to its touch is no deeper in the ground than this share of its S.
constexpr double kStartTouch = 1e-6;
/// The highest lift, in bounding radii: a ball that touches a slope of 83 degrees under its centre.
constexpr double kMaxLift = 8.0;
/// The first lift that is tried, share of S; then twice as much, and so on.
constexpr double kFirstLift = 0.01;

}  // namespace

std::optional<double> find_depth_in_ground(const GroundOverlap& ground_overlap,
                                           const TerrainSurface& surface, const RigidBody& body,
                                           const RigidState& state) {
  const double overlap = ground_overlap.max_overlap(state);
  // The simulation would refuse this overlap.
  if (overlap > MotionSettings{}.start_overlap * body.smallest_side) return overlap;
  // A block that is buried whole touches no face of the ground.
  const Vec3& centre = state.position;
  const double abyss = surface.extent().low.z() - 1.0;
  const std::optional<double> ground = surface.height_at(centre.x(), centre.y(), abyss);
  if (ground && centre.z() < *ground) return *ground - lowest_height(body, state);
  return std::nullopt;
}

bool lift_to_touch_ground(const GroundOverlap& ground_overlap, const TerrainSurface& surface,
                          const RigidBody& body, RigidState& state) {
  const double size = body.smallest_side, maximum = kMaxLift * body.bounding_radius();
  const auto lifted_by = [&](double lift) {
    RigidState lifted = state;
    lifted.position.z() += lift;
    return lifted;
  };
  const auto in_ground = [&](double lift) {
    const RigidState lifted = lifted_by(lift);
    return ground_overlap.max_overlap(lifted) > 0.0 ||
           find_depth_in_ground(ground_overlap, surface, body, lifted).has_value();
  };
  double below = 0.0, above = kFirstLift * size;
  while (in_ground(above)) {
    if (above >= maximum) return false;
    below = above;
    above = std::min(2.0 * above, maximum);
  }
  while (above - below > kStartTouch * size) {
    const double middle = 0.5 * (below + above);
    (in_ground(middle) ? below : above) = middle;
  }
  state = lifted_by(below);
  return true;
}

std::vector<Quat> sample_run_orientations(const ReleaseSet& release, const std::string& block,
                                          const std::string& where, std::size_t count) {
  std::uint64_t seed = release.orientation_seed;
  for (const std::string& name : {release.name, block, where}) seed = derive_seed(seed, name);
  return sample_random_orientations(count, seed);
}

}  // namespace clast::study_detail
