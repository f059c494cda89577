#pragma once
/// Rock masses cut into blocks by joint sets.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shapes/convex_cell.hpp"

namespace clast {

/// Parallel joints that cut through the whole mass.
struct JointSet {
  double dip = 0.0;                ///< steepest descent below the horizontal, rad, 0 to pi/2
  double dip_direction = 0.0;      ///< of the steepest descent, clockwise from north (+y), rad
  double spacing = 1.0;            ///< mean distance along the normal, m
  double spacing_deviation = 0.0;  ///< standard deviation of the distances, which are log-normal, m

  Vec3 normal() const;  ///< unit, upwards, z up
};

/// A joint set as geologists write it, "DIP/DIP_DIRECTION/SPACING" or with "/SCATTER": degrees and
/// metres, "65/095/1.2/0.3".
/// @throws InputError  anything else, or out of range: dip 0 to 90, direction 0 to 360, spacing
///                     1e-3 to 1000 m, scatter 0 to 3 times the spacing
JointSet parse_joint_set(const std::string& text);

struct CuttingOptions {
  double least_volume = 1e-3;       ///< smaller pieces are left out, m^3
  std::size_t most_blocks = 10000;  ///< more are refused
  std::uint64_t seed = 1;           ///< of the joints' places
};

/// What joints cut from a mass.
struct JointedMass {
  double volume = 0.0;               ///< of the mass, m^3
  std::vector<TriangleMesh> blocks;  ///< convex, closed, outward, disjoint, inside the mass
  double block_volume = 0.0;         ///< of all blocks, m^3
  /// Pieces below the least volume, and what the mass is curved by within a block.
  double lost_volume() const { return volume - block_volume; }
};

/// The first joint of a set lies anywhere within one spacing, the others follow at drawn distances.
/// The cells between the joints are the blocks. One that the surface of the mass passes through
/// loses what is outside, by planes that have the surface there on their outer side: it stays
/// convex and inside, and a little is lost where the surface is hollow.
/// @param mass  closed, outward, m, z up, y north
/// @throws GeometryError  the mass is not closed or has no volume
/// @throws InputError     no joint set, more blocks than allowed, or none that is large enough
JointedMass cut_by_joints(const TriangleMesh& mass, std::span<const JointSet> sets,
                          const CuttingOptions& options = {});

}  // namespace clast
