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

/// Deposit of one realisation. Positions are those of centres of mass, in map coordinates;
/// deposited blocks are those at rest that were not removed.
struct DepositMeasures {
  std::uint32_t file = 0;         ///< index into Comparison::results
  std::uint32_t realisation = 0;  ///< from 0
  std::size_t blocks = 0;         ///< number of released blocks
  std::size_t lying = 0;          ///< number of deposited blocks
  std::size_t left_terrain = 0;   ///< number of blocks that left the terrain
  double mass = 0.0;              ///< of the deposited blocks, kg
  double volume = 0.0;            ///< solid volume of the deposited blocks, without voids, m^3
  /// Centre of mass of the deposited blocks at their starts and at rest. All following members are
  /// NaN if no block is deposited.
  Vec3 first_centre = Vec3::Constant(NAN);
  Vec3 centre = Vec3::Constant(NAN);
  Vec3 crest = Vec3::Constant(NAN);  ///< highest start of all blocks
  Vec3 toe = Vec3::Constant(NAN);    ///< stop position farthest from the crest, horizontally
  double area = NAN;                 ///< covered area in plan, m^2
  double bulk_volume = NAN;          ///< volume between ground and block tops, m^3
  double thickness = NAN;            ///< largest height of a block top above the ground, m
  // Of all blocks where a rock mass started, held or settled; not a number for blocks that were
  // released one after the other.
  double first_volume = NAN;       ///< solid volume, without voids, m^3
  double first_bulk_volume = NAN;  ///< volume between ground and block tops, m^3
  /// Dissipation by mechanism; empty if the results do not contain it.
  std::optional<EnergyFractions> energy;
};

/// Returns the height-length ratio H/L: drop over horizontal distance.
/// @cite heim1932
double height_length_ratio(const Vec3& from, const Vec3& to);

/// Deposits of all realisations of a comparison.
struct DepositResults {
  std::vector<DepositMeasures> realisations;  ///< by file; empty without persistent blocks
  /// Layers: deposit thickness, mean and largest over the realisations, and the fraction of
  /// realisations with a block in the cell. The cell size is at most a third of the mean S,
  /// rounded.
  MapRasterSet rasters;
};

/// Measures the deposits of all realisations. Block tops are the heights of the block surfaces over
/// the centre of each cell.
DepositResults measure_deposits(const Comparison& comparison);

}  // namespace clast
