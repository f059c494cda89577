#pragma once
/// Point clouds to grids of mean heights.
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "terrain/detail/raw_surface.hpp"

namespace clast::detail {

/// Points of text files (.xyz, .txt, .csv, .pts): the columns named x, y, z in a heading, else the
/// first three; separated by blanks, commas, semicolons or tabs; lines that start with # or // are
/// skipped, and so is a first line with nothing but the number of points.
/// @throws InputError  a line that is not a point, with its number; or no points
std::vector<Vec3> read_cloud(const std::filesystem::path& path);

bool is_cloud(const std::filesystem::path& path);

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
