#pragma once
/// Passes of one scan, such as flight strips or two walks round a block, that are not aligned.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/point_cloud.hpp"

namespace clast {

/// A part of a scan that does not fit the rest: where both show the surface, it appears twice.
struct PassMisfit {
  Vec3 shift = Vec3::Zero();     ///< movement of the middle of the part that aligns it, m
  Vec3 rotation = Vec3::Zero();  ///< rotation about that middle that aligns it, rad
  double distance = 0.0;         ///< root mean square distance of both surfaces, m
  double fraction = 0.0;         ///< fraction of the surface that appears twice
  /// Fraction of the positions with two surfaces at which the movement explains their distance.
  double explained = 0.0;
  std::vector<bool> is_moved;  ///< true for the points of the part, at most half of all
};

/// Finds two parts of a scan that show the same surface at two places.
///
/// One and two parallel surfaces are fitted to the points around evenly spread positions. The
/// search for the rigid movement that explains most distances between two surfaces starts from
/// random triples of positions. The movement decides which surface belongs to which part; the other
/// points belong to the part with which a continuous surface connects them [grady2006].
/// @param points  points of one block, without ground and outliers, m
/// @return  empty if the surface appears twice at hardly any position, or if no movement explains
///          the distances consistently
/// @cite grady2006
std::optional<PassMisfit> find_pass_misfit(std::span<const Vec3> points);

/// Formats a misfit: "on 12 % of the block the surface appears twice, 0.013 m apart; a part ...".
/// @param unit  metres per unit of the scan
std::string describe_misfit(const PassMisfit& misfit, double unit);

/// Numbers the passes in which points were recorded. Passes are the point sources, such as flight
/// strips; if there is one source, they are the parts of the recording between pauses of 20 s or
/// more.
/// @return  pass of each point, from 0; empty if there is only one pass
std::vector<std::uint32_t> number_passes(std::span<const PointRecording> recordings);

/// Divides a scan into passes that do not fit each other, at most `most`.
/// @param points  points of one block, without ground and outliers, m
/// @return  pass of each point, from 0; all 0 if no misfit is found
std::vector<std::uint32_t> divide_into_passes(std::span<const Vec3> points, std::size_t most);

}  // namespace clast
