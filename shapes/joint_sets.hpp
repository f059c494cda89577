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
  double spacing = 1.0;            ///< mean spacing along the normal, m
  double spacing_deviation = 0.0;  ///< standard deviation of the log-normal spacing, m

  Vec3 normal() const;  ///< unit normal, pointing up (+z)
};

/// Parses "DIP/DIP_DIRECTION/SPACING[/SCATTER]" in degrees and metres: "65/095/1.2/0.3".
/// @throws InputError  if the text is invalid or a value is out of range: dip 0 to 90, direction 0
///                     to 360, spacing 1e-3 to 1000 m, scatter 0 to 3 times the spacing
JointSet parse_joint_set(const std::string& text);

struct JointCuttingOptions {
  double min_volume = 1e-3;        ///< smallest volume of a block, m^3; smaller cells are omitted
  std::size_t max_blocks = 10000;  ///< largest number of blocks; more are an error
  std::uint64_t seed = 1;          ///< seed of the random joint positions
};

/// Blocks cut from a rock mass by joint sets.
struct JointedRockMass {
  double volume = 0.0;               ///< volume of the mass, m^3
  std::vector<TriangleMesh> blocks;  ///< convex, closed, outward, disjoint, inside the mass
  double block_volume = 0.0;         ///< total volume of the blocks, m^3
  /// Returns the volume of the mass that belongs to no block: omitted cells and parts cut at curved
  /// surfaces.
  double lost_volume() const { return volume - block_volume; }
};

/// Cuts a mass by joints. The position of the first joint of a set is uniform within one spacing.
/// The others follow at random spacings. Blocks are the cells between joints. Cells that the
/// surface intersects are clipped by planes, so that they are convex and inside the mass. Some
/// volume is lost there if the surface is concave.
/// @param mass  closed, outward-facing; vertices in m, z up, y north
/// @throws GeometryError  if the mass is not closed or has no volume
/// @throws InputError  if there is no joint set, if there are more blocks than allowed, or if none
///                     is large enough
JointedRockMass cut_by_joints(const TriangleMesh& mass, std::span<const JointSet> sets,
                              const JointCuttingOptions& options = {});

}  // namespace clast
