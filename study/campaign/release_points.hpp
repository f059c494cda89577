#pragma once
/// Release points and orientations, read from files or generated.
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {

/// Reads points from a text table with columns x, y and z in m. Columns are found by their
/// headings. Without headings, there must be three columns.
/// @throws InputError  if the file is missing or empty, or a line is invalid; names file and line
std::vector<Vec3> read_point_table(const std::filesystem::path& file);

/// Reads unit quaternions from a text table with columns w, x, y and z. Their norms may differ from
/// 1 by up to 1e-3; they are normalised.
/// @throws InputError  if `read_points` would throw, or if a norm differs more from 1
std::vector<Quat> read_orientation_table(const std::filesystem::path& file);

/// Converts the orientation of a block from a world with y up to a world with z up.
Quat y_up_to_z_up(const Quat& orientation);

/// Returns `count` equally spaced points on a polyline, including both ends; for 1, its midpoint.
std::vector<Vec3> space_points_on_line(std::span<const Vec3> line, std::size_t count);

/// Returns `count` points distributed uniformly at random over a plan polygon, z = 0.
/// @throws InputError  if the polygon has no area
std::vector<Vec3> sample_points_in_polygon(std::span<const Vec2> polygon, std::size_t count,
                                           std::uint64_t seed);

/// Returns `count` rotations distributed uniformly over all rotations.
std::vector<Quat> sample_random_orientations(std::size_t count, std::uint64_t seed);

}  // namespace clast
