#pragma once
/// Places of a scan at which its points lie on one surface or on two.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// A place of a surface, and the one or two sheets (parallel surfaces) on which the points lie.
struct SurfacePlace {
  Vec3 position = Vec3::Zero();  ///< in the middle of the sheets
  Vec3 normal = Vec3::UnitZ();   ///< unit, outward
  double scatter = 0.0;          ///< standard deviation of the points about their sheet, m
  double distance = 0.0;         ///< between two sheets, m; 0 if there is one
  double distance_error = 0.0;   ///< standard error of the distance, m
  std::vector<std::uint32_t> inner = {}, outer = {};  ///< points of two sheets; empty for one
};

/// Fits one and two parallel quadrics to the points around evenly spread places. There are two
/// sheets if their distance is several times the scatter, and if the points of both are mixed along
/// the surface, unlike those of the two sides of a ledge.
/// @param normals  unit, outward, one per point
std::vector<SurfacePlace> examine_places(std::span<const Vec3> points,
                                         std::span<const Vec3> normals);

}  // namespace clast::reconstruct_detail
