#pragma once
/// Virtual deposits: blocks of known shape and place, and a scan of them.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "samples/deposit/deposit_block.hpp"
#include "samples/deposit/deposit_scanner.hpp"

namespace clast {

/// A block may be scored if more than this fraction of its surface was seen, and by more points.
inline constexpr double kEligibleFraction = 0.25;
inline constexpr std::size_t kEligiblePoints = 400;

/// True place and size of a block in the deposit.
struct TrueBlock {
  std::size_t block = 0;  ///< number, from 1
  std::string shape;
  Vec3 centre = Vec3::Zero();  ///< centroid of the solid, m
  Vec3 axes = Vec3::Zero();    ///< L, I, S of the smallest box, m
  double volume = 0.0;         ///< m^3
  /// Fraction of the surface near which a point of the block was seen: within a spacing, on a
  /// triangle that faces the same side.
  double visible_fraction = 0.0;
  std::size_t points = 0;

  bool is_eligible() const {
    return visible_fraction > kEligibleFraction && points > kEligiblePoints;
  }
};

/// A deposit with its scan. Blocks that left the floor are not in it.
struct VirtualDeposit {
  DepositScene scene;
  std::vector<TriangleMesh> bodies;  ///< in their places
  std::vector<TrueBlock> blocks;     ///< of `bodies`, in order
  DepositScan scan;
  double largest_overlap = 0.0;  ///< of the surfaces of two blocks, m
};

/// Makes a deposit and scans it. The result does not depend on `threads`.
/// @param scans  real stones from which every second block is made; may be empty
/// @throws InputError  as `DepositRecipe::check`
VirtualDeposit make_deposit(const DepositRecipe& recipe, std::span<const StoneScan> scans,
                            unsigned threads);

/// Writes scan.ply, truth.ply, blocks.csv and stations.csv.
/// @param with_bodies  also write bodies/1.ply, ...
void write_deposit(const VirtualDeposit& deposit, const std::filesystem::path& folder,
                   bool with_bodies);

/// Reads the true blocks of a folder from its blocks.csv.
/// @throws InputError  if the table is missing or lacks columns
std::vector<TrueBlock> read_true_blocks(const std::filesystem::path& folder);

}  // namespace clast
