#pragma once
/// How single runs start: against the ground, and turned.
#include <optional>
#include <string>
#include <vector>

#include "dem/search/ground_overlap.hpp"
#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// How deep a block is in the ground, m; none when it is clear of it.
std::optional<double> find_depth_in_ground(const GroundOverlap& ground_overlap,
                                      const TerrainSurface& surface, const RigidBody& body,
                                      const RigidState& state);

/// Lifts a block that is in the ground until it just touches it, by no more than four times its
/// largest diameter.
/// @return  false if that is not enough, and the state stays as it was
bool lift_to_touch(const GroundOverlap& ground_overlap, const TerrainSurface& surface,
                   const RigidBody& body, RigidState& state);

/// Random orientations of one block at one point of a set, or in one realisation. Their seed is
/// made from names, not from places in the campaign, so that they do not depend on what else runs.
/// @param where  number of the point, or name of the realisation
std::vector<Quat> draw_run_orientations(const ReleaseSet& release, const std::string& block,
                                     const std::string& where, std::size_t count);

}  // namespace clast::study_detail
