#pragma once
/// Point clouds to grids of mean heights.
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "terrain/detail/raw_surface.hpp"

namespace clast::detail {

/// Mean height per square cell; cells lie on multiples of `cell`.
HeightGrid binned(std::span<const Vec3> points, double cell, const std::filesystem::path& path);

/// Gives empty cells with at least five known neighbours out of eight the mean over the pairs of
/// opposite neighbours (exact on a plane), in two rounds: scattered points leave pinholes even
/// where there are several per cell, real gaps stay.
/// @return  how many cells were filled
std::size_t fill_pinholes(HeightGrid& grid);

/// The cell size for a cloud when none is asked: about four points per cell over the plan box,
/// rounded up to 1, 2 or 5 times a power of ten.
double default_cell(std::span<const Vec3> points);

}  // namespace clast::detail
