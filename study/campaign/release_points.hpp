#pragma once
/// Where and how blocks are released: point and orientation files, and sets made by rule.
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {

/// A table of points, "x y z" in m (`core/files/number_table.hpp`): columns by the names of a
/// heading (x or easting, y or northing, z, height or elevation), else three a row.
/// @throws InputError  missing or empty file, or a bad line: file, line and what was found
std::vector<Vec3> read_points(const std::filesystem::path& file);

/// Rotations, "w x y z" (or qw, q0, ... in a heading), read like points. Norms within 1e-3 of 1 are
/// set to 1.
/// @throws InputError  as `read_points`, or a norm further from 1
std::vector<Quat> read_orientations(const std::filesystem::path& file);

/// A rotation world_from_source whose world has y up, in one with z up (`core/files/resolve_up_axis.hpp`).
Quat y_up_to_z_up(const Quat& orientation);

/// `count` points at equal distances along a polyline, both ends included; the middle for one.
std::vector<Vec3> space_points_on_line(std::span<const Vec3> line, std::size_t count);

/// `count` points spread evenly at random over a plan polygon, z = 0.
/// @throws InputError  the polygon has no area
std::vector<Vec3> sample_points_in_polygon(std::span<const Vec2> polygon, std::size_t count,
                                    std::uint64_t seed);

/// `count` rotations, uniform over all rotations.
std::vector<Quat> draw_random_orientations(std::size_t count, std::uint64_t seed);

}  // namespace clast
