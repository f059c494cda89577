#pragma once
/// Selection of points that cover a set evenly.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Returns the ascending indices of the first points of all cells of a grid.
/// @param cell  side of the cells, m
std::vector<std::uint32_t> choose_one_per_cell(std::span<const Vec3> points, double cell);

/// Returns the ascending indices of at most `count` points, one of each cell of a grid, whose cells
/// are as small as this number allows. All points if they are no more than `count`.
std::vector<std::uint32_t> choose_even_subset(std::span<const Vec3> points, std::size_t count);

}  // namespace clast::reconstruct_detail
