#pragma once
/// Checks of release positions and block sizes against a terrain.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// Returns the horizontal distance from a map position to the nearest border edge, including holes,
/// m.
double border_distance(const Terrain& terrain, const Vec2& position);

/// Checks that positions are over the terrain.
/// @param positions  map coordinates
/// @param name  their origin: "points.xyz"
/// @throws InputError  with the first position outside, and the terrain's extent
void check_over_ground(const Terrain& terrain, std::span<const Vec3> positions,
                       const std::string& name);

/// Checks that positions are closer to the terrain than its size; others are in another map system.
/// @param positions  map coordinates
/// @param name  what they are: "the barrier"
/// @throws InputError  with the first distant position, and the terrain's extent
void check_near_ground(const Terrain& terrain, std::span<const Vec2> positions,
                       const std::string& name);

/// Returns a warning if positions are closer to the border than `distance`, because blocks may
/// leave the survey.
std::optional<std::string> border_warning(const Terrain& terrain, std::span<const Vec3> positions,
                                          double distance);

/// Returns a warning if edges are much longer than the blocks (the contact ground is smoother than
/// the real one) or much shorter (long run times).
/// @param smallest, largest  block diameters, m
std::optional<std::string> cell_size_warning(const Terrain& terrain, double smallest,
                                             double largest);

}  // namespace clast
