#pragma once
/// Deposits of persistent blocks in each realisation: positions, runout and thickness.
#include <optional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"
#include "study/compare/realisation_energies.hpp"

namespace clast {

/// True if the block of a run came to rest and was not removed.
bool is_in_deposit(const Comparison& comparison, const RunRow& row);

/// Deposit of one realisation: position, size and thickness. Deposited blocks are those that came
/// to rest and were not removed. Positions are in map coordinates, m.
struct DepositMeasures {
  std::uint32_t file = 0;            ///< index into Comparison::results
  std::uint32_t realisation = 0;     ///< index of the realisation, from 0
  std::size_t blocks = 0;            ///< number of released blocks
  std::size_t deposited_blocks = 0;  ///< number of deposited blocks
  std::size_t left_terrain = 0;      ///< number of blocks that left the terrain
  double mass = 0.0;                 ///< mass of the deposited blocks, kg
  double volume = 0.0;               ///< solid volume of the deposited blocks, without voids, m^3
  /// Common centre of mass of the deposited blocks at their starts. It and the following members
  /// are NaN if no block is deposited.
  Vec3 start_centre = Vec3::Constant(NAN);
  Vec3 centre = Vec3::Constant(NAN);
  Vec3 crest = Vec3::Constant(NAN);  ///< highest start position of all blocks
  Vec3 toe =
      Vec3::Constant(NAN);   ///< stop position with the largest horizontal distance from the crest
  double area = NAN;         ///< covered area in plan, m^2
  double bulk_volume = NAN;  ///< volume between ground and block tops, m^3
  double thickness = NAN;    ///< largest height of a block top above the ground, m
  // Volumes before a simultaneous release; NaN for blocks released one after the other.
  double start_volume = NAN;       ///< solid volume at the start, without voids, m^3
  double start_bulk_volume = NAN;  ///< volume between ground and block tops at the start, m^3
  /// Fractions of the dissipated energy by mechanism; empty if not stored.
  std::optional<EnergyFractions> energy;
};

/// Returns the height-length ratio H/L: vertical drop divided by horizontal distance.
/// @cite heim1932
double height_length_ratio(const Vec3& from, const Vec3& to);

/// Deposits of all realisations of a comparison.
struct DepositResults {
  /// One deposit per realisation, ordered by file; empty without blocks that stay on the terrain.
  std::vector<DepositMeasures> realisations;
  /// Raster layers of deposit thickness (mean and maximum over the realisations) and of the
  /// fraction of realisations with a block in the cell.
  MapRasterSet rasters;
};

/// Measures the deposits of all realisations of a comparison.
DepositResults measure_deposits(const Comparison& comparison);

}  // namespace clast
