#pragma once
/// Start positions and orientations of single runs.
#include <optional>
#include <string>
#include <vector>

#include "dem/search/ground_overlap.hpp"
#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// Computes the overlap of a block with the ground at its start, m. Empty if there is none.
std::optional<double> find_depth_in_ground(const GroundOverlap& ground_overlap,
                                           const TerrainSurface& surface, const RigidBody& body,
                                           const RigidState& state);

/// Lifts a block out of the ground until it just touches the ground. It is lifted by at most four
/// times its largest diameter.
/// @return false if this height is not sufficient; the state is then unchanged
bool lift_to_touch_ground(const GroundOverlap& ground_overlap, const TerrainSurface& surface,
                          const RigidBody& body, RigidState& state);

/// Draws random orientations of one block at one release point or in one realisation. Other blocks
/// and runs have no influence.
/// @param where  index of the point, or name of the realisation
std::vector<Quat> sample_run_orientations(const ReleaseSet& release, const std::string& block,
                                          const std::string& where, std::size_t count);

}  // namespace clast::study_detail
