#include "study/detail/run_starts.hpp"

#include "dem/release.hpp"
#include "study/detail/named_seed.hpp"
#include "study/release_points.hpp"

namespace clast::study_detail {

std::optional<double> depth_in_ground(const GroundOverlap& ground_overlap,
                                      const TerrainSurface& surface, const RigidBody& body,
                                      const RigidState& state) {
  const double overlap = ground_overlap.deepest(state);
  // What the dynamics will refuse.
  if (overlap > ReleaseSettings{}.start_overlap * body.smallest_side) return overlap;
  // A block that is buried whole touches no face of the ground.
  const Vec3& centre = state.position;
  const double abyss = surface.extent().low.z() - 1.0;
  const std::optional<double> ground = surface.height(centre.x(), centre.y(), abyss);
  if (ground && centre.z() < *ground) return *ground - lowest_point(body, state);
  return std::nullopt;
}

std::vector<Quat> fresh_orientations(const ReleasePlan& release, const std::string& block,
                                     const std::string& where, std::size_t count) {
  std::uint64_t seed = release.orientation_seed;
  for (const std::string& name : {release.name, block, where}) seed = named_seed(seed, name);
  return random_orientations(count, seed);
}

}  // namespace clast::study_detail
