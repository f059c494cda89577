#pragma once
/// Point clouds that name the block of every point, as PLY files.
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Points and the block of each.
struct LabelledCloud {
  std::vector<Vec3> points;           ///< m
  std::vector<std::uint32_t> blocks;  ///< 0: no block; 1, 2, ...
};

/// Writes points as binary little-endian PLY. Coordinates are floats if these hold them exactly,
/// otherwise doubles.
/// @param blocks  written as the integer property `block`; if empty, only points are written
/// @throws InputError  if the file cannot be written
void write_labelled_cloud(const std::filesystem::path& path, std::span<const Vec3> points,
                          std::span<const std::uint32_t> blocks);

/// Reads a PLY file whose vertices have the property `block`.
/// @throws InputError  if the file is not such a PLY file, or a block is not a whole number from 0
LabelledCloud read_labelled_cloud(const std::filesystem::path& path);

}  // namespace clast
