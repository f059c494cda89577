#pragma once
/// Checks of release positions and block sizes against a terrain.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// Returns the horizontal distance from a map position to the nearest edge of border or hole, m.
double border_distance(const Terrain& terrain, const Vec2& position);

/// Checks that positions are over the terrain.
/// @param positions  map coordinates
/// @param name  source of the positions for messages: "points.xyz"
/// @throws InputError  if one is outside; the message gives the first and the terrain's extent
void check_positions_over_terrain(const Terrain& terrain, std::span<const Vec3> positions,
                                  const std::string& name);

/// Checks that no position is farther from the terrain than the terrain's size. If one is, it is
/// probably in another map system.
/// @param positions  map coordinates
/// @param name  description of the positions for messages: "the barrier"
/// @throws InputError  if one is too far; the message gives the first and the terrain's extent
void check_positions_near_terrain(const Terrain& terrain, std::span<const Vec2> positions,
                                  const std::string& name);

/// Returns a warning of positions closer to the border than `distance`, where blocks may leave.
std::optional<std::string> border_warning(const Terrain& terrain, std::span<const Vec3> positions,
                                          double distance);

/// Returns a warning if edges are much longer or much shorter than the blocks. With long edges, the
/// ground is smoother than in reality; with short ones, runs take long.
/// @param smallest, largest  block diameters, m
std::optional<std::string> edge_length_warning(const Terrain& terrain, double smallest,
                                               double largest);

}  // namespace clast
