#pragma once
/// Blocks of jointed rock masses.
#include <span>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "library/make_block.hpp"
#include "shapes/joint_sets.hpp"

namespace clast {

struct RockMassOptions {
  std::vector<JointSet> joints;
  JointCuttingOptions cutting;
  BlockOptions block;        ///< radius and density
  std::string prefix = "J";  ///< prefix of the numbered ids, such as "J0001"
  unsigned threads = 0;      ///< number of threads; 0: one per core; does not affect the result
  ProgressCallback progress =
      {};  ///< called for each finished block, from any thread, one call at a time
};

/// Blocks cut from one or more rock masses, in the frame of the masses.
struct RockMassBlocks {
  std::vector<Block> blocks;
  double volume = 0.0;                ///< total volume of the masses, m^3
  double block_volume = 0.0;          ///< total volume of the blocks, m^3
  std::vector<std::string> failures;  ///< blocks or masses that could not be made, with reasons
};

/// Cuts a mass by joints and makes a block of each part.
/// @param source  file and digest; the joints are added to its options
/// @throws GeometryError, InputError  if `cut_by_joints` throws
RockMassBlocks cut_rock_mass(const TriangleMesh& mass, const BlockSource& source,
                             const RockMassOptions& options);

/// Cuts disjoint masses, each with its own joint positions, and numbers blocks consecutively.
/// @throws GeometryError, InputError  if no mass can be cut; if some can be cut, the reasons for
///                                    the others are in `failures`
/// @pre `masses` is not empty
RockMassBlocks cut_rock_masses(std::span<const TriangleMesh> masses, const BlockSource& source,
                               const RockMassOptions& options);

}  // namespace clast
