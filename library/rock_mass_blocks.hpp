#pragma once
/// From a rock mass and its joints to a library of the blocks it consists of.
#include <span>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "library/make_block.hpp"
#include "shapes/joint_sets.hpp"

namespace clast {

struct RockMassOptions {
  std::vector<JointSet> joints;
  CuttingOptions cutting;
  BlockOptions block;              ///< radius and density
  std::string prefix = "J";        ///< of the ids, which are numbered: "J0001"
  unsigned threads = 0;            ///< 0: one per core; changes no bit of the result
  ProgressCallback progress = {};  ///< blocks made, from any thread, one at a time
};

/// The blocks of one or more masses, in their frame.
struct RockMassBlocks {
  std::vector<Block> blocks;
  double volume = 0.0;                ///< of the masses, m^3
  double block_volume = 0.0;          ///< of the blocks, m^3
  std::vector<std::string> failures;  ///< blocks, or all of a mass, that could not be made, and why
};

/// Cuts the mass and makes a block of every piece.
/// @param source  file and hash; the joints are added to its options
/// @throws GeometryError, InputError  as `cut_by_joints`
RockMassBlocks cut_rock_mass(const TriangleMesh& mass, const BlockSource& source,
                             const RockMassOptions& options);

/// The same of several masses that do not overlap, each cut by joints of its own places; their
/// blocks are numbered in a row.
/// @throws GeometryError, InputError  as `cut_by_joints`; where some masses can be cut, what keeps
///                                    others from it is among the failures
/// @pre there is a mass
RockMassBlocks cut_rock_masses(std::span<const TriangleMesh> masses, const BlockSource& source,
                                 const RockMassOptions& options);

}  // namespace clast
