#pragma once
/// Whether a ground suits the blocks that are thrown on it and the places they start from.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// Horizontal distance from a place on the map to the nearest border edge, of a hole too, m.
double border_distance(const Terrain& terrain, const Vec2& position);

/// Refuses places that are not over the ground.
/// @param places  on the map
/// @param name    of what they are from: "points.xyz"
/// @throws InputError  the first such place, and where the ground is
void check_over_ground(const Terrain& terrain, std::span<const Vec3> positions,
                       const std::string& name);

/// Refuses places from which the ground is farther than it is large: they are in another map
/// system.
/// @param places  on the map
/// @param name    of what they are: "the barrier"
/// @throws InputError  the first such place, and where the ground begins
void check_near_ground(const Terrain& terrain, std::span<const Vec2> positions,
                       const std::string& name);

/// A warning when some of the places are nearer than `distance` to the border: blocks may leave
/// the survey before they are down.
std::optional<std::string> border_warning(const Terrain& terrain, std::span<const Vec3> positions,
                                          double distance);

/// A warning when edges are much longer than the blocks (the ground they meet is smoother than the
/// real one) or much shorter (the run takes longer for nothing).
/// @param smallest, largest  diameters of the blocks, m
std::optional<std::string> cell_size_warning(const Terrain& terrain, double smallest,
                                             double largest);

}  // namespace clast
