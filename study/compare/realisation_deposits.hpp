#pragma once
/// What blocks that stay leave behind, realisation by realisation: where they lie, how far the mass
/// of them came, how high they are piled.
#include <optional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"
#include "study/compare/realisation_energies.hpp"

namespace clast {

/// Did the block of a run among others stay where it came to rest?
bool is_in_deposit(const Comparison& comparison, const RunRow& row);

/// Blocks of one realisation. Places are of centres of mass, on the map; "that lie there" are
/// blocks that came to rest and were not removed.
struct DepositMeasures {
  std::uint32_t file = 0;         ///< index into Comparison::results
  std::uint32_t realisation = 0;  ///< from 0
  std::size_t blocks = 0;
  std::size_t lying = 0;         ///< that lie there
  std::size_t left_terrain = 0;  ///< that left the terrain
  double mass = 0.0;             ///< of the blocks that lie there, kg
  double volume = 0.0;           ///< likewise, without the space between them, m^3
  /// Centre of mass of the blocks that lie there, at their starts and now; not a number where none
  /// lies there, like all that follows.
  Vec3 first_centre = Vec3::Constant(NAN);
  Vec3 centre = Vec3::Constant(NAN);
  Vec3 crest = Vec3::Constant(NAN);  ///< the highest start of all blocks
  Vec3 toe = Vec3::Constant(NAN);    ///< the stop farthest from the crest in plan
  double area = NAN;                 ///< that blocks lie on, in plan, m^2
  double bulk_volume = NAN;          ///< between ground and the top of the blocks, m^3
  double thickness = NAN;            ///< most height of a block's top above the ground, m
  // Of all blocks where a rock mass started, held or settled; not a number for blocks that were
  // released one after the other.
  double first_volume = NAN;       ///< without the space between them, m^3
  double first_bulk_volume = NAN;  ///< between ground and the top of the blocks, m^3
  /// What its energy was dissipated by; none where the results do not know.
  std::optional<EnergyFractions> energy;
};

/// Drop over distance in plan, H/L.
/// @cite heim1932
double height_length_ratio(const Vec3& from, const Vec3& to);

struct DepositResults {
  std::vector<DepositMeasures> realisations;  ///< by file; none where no block stayed
  /// Thickness of the deposit, mean over all realisations and largest, and the share of
  /// realisations with a block there. A cell is at most a third of the mean S, a round number.
  MapRasterSet rasters;
};

/// Tops are those of the blocks' skins over the middle of each cell.
DepositResults measure_deposits(const Comparison& comparison);

}  // namespace clast
