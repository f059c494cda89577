#pragma once
/// Passes of one scan, such as flight strips or two walks round a block, that do not fit.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/point_cloud.hpp"

namespace clast {

/// A part of a scan that does not fit the rest: where both show the surface, it is there twice.
struct PassMisfit {
  Vec3 shift = Vec3::Zero();     ///< movement of the middle of the part that aligns it, m
  Vec3 rotation = Vec3::Zero();  ///< rotation about that middle that aligns it, rad
  double distance = 0.0;         ///< root mean square distance of the two surfaces, m
  double fraction = 0.0;         ///< fraction of the surface that is there twice
  /// Fraction of the places with two surfaces that the movement explains.
  double explained = 0.0;
  std::vector<bool> is_moved;  ///< true for the points of the part, the smaller one
};

/// Finds two parts of a scan that show the same surface at two places.
///
/// Around evenly spread places, one or two parallel surfaces are fitted to the points. The rigid
/// movement that explains most distances of two surfaces is searched among those of random triples
/// of places. It decides which of both surfaces is of which part. Points elsewhere are of the part
/// to which the surface between connects them [grady2006].
/// @param points  points of one block, without ground and outliers, m
/// @return  empty if the surface is nowhere doubled, or if no movement explains the distances
/// @cite grady2006
std::optional<PassMisfit> find_pass_misfit(std::span<const Vec3> points);

/// "on 12 % of the block the surface is there twice, 0.013 m apart: ..."
/// @param unit  metres per unit of the scan
std::string describe_misfit(const PassMisfit& misfit, double unit);

/// Numbers the passes in which points were recorded: their sources, such as flight strips; for one
/// source, the parts of the recording between pauses of 20 s or more.
/// @return  pass of each point, from 0; empty if there is one only
std::vector<std::uint32_t> number_passes(std::span<const PointRecording> recordings);

/// Divides a scan into passes that do not fit each other, at most `most`.
/// @param points  points of one block, without ground and outliers, m
/// @return  pass of each point, from 0; all 0 if no surface is doubled
std::vector<std::uint32_t> divide_into_passes(std::span<const Vec3> points, std::size_t most);

}  // namespace clast
