#pragma once
/// Cutting of rock masses into blocks by joint sets.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shapes/convex_cell.hpp"

namespace clast {

/// Joint set: parallel, persistent joints.
struct JointSet {
  double dip = 0.0;                ///< rad, 0 to pi/2
  double dip_direction = 0.0;      ///< clockwise from north (+y), rad
  double spacing = 1.0;            ///< mean normal spacing, m
  double spacing_deviation = 0.0;  ///< standard deviation of the log-normal spacing, m

  Vec3 normal() const;  ///< unit, upwards, z up
};

/// Parses a joint set "DIP/DIP_DIRECTION/SPACING" with optional "/SCATTER" in degrees and metres:
/// "65/095/1.2/0.3".
/// @throws InputError  if the text is invalid or out of range: dip 0 to 90, direction 0 to 360,
///                     spacing 1e-3 to 1000 m, scatter 0 to 3 times the spacing
JointSet parse_joint_set(const std::string& text);

struct CuttingOptions {
  double least_volume = 1e-3;       ///< smaller pieces are omitted, m^3
  std::size_t most_blocks = 10000;  ///< more blocks are an error
  std::uint64_t seed = 1;           ///< of the joint positions
};

/// Blocks cut from a rock mass.
struct JointedMass {
  double volume = 0.0;               ///< of the mass, m^3
  std::vector<TriangleMesh> blocks;  ///< convex, closed, outward, disjoint, inside the mass
  double block_volume = 0.0;         ///< of all blocks, m^3
  /// Returns the volume of omitted pieces and of curved surface parts cut off flat.
  double lost_volume() const { return volume - block_volume; }
};

/// Cuts a mass by joints. The first joint of a set is uniform within one spacing; the others follow
/// at random spacings. Blocks are the cells between joints. Cells intersected by the surface are
/// clipped by planes that keep them convex and inside the mass, so that some volume is lost where
/// the surface is concave.
/// @param mass  closed, outward, m, z up, y north
/// @throws GeometryError  if the mass is not closed or has no volume
/// @throws InputError  if there is no joint set, there are more blocks than allowed, or none is
///                     large enough
JointedMass cut_by_joints(const TriangleMesh& mass, std::span<const JointSet> sets,
                          const CuttingOptions& options = {});

}  // namespace clast
