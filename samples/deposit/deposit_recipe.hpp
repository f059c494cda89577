#pragma once
/// Recipe of a virtual deposit: what lies there and how it is scanned. Equal recipes give equal
/// files.
#include <cstddef>
#include <cstdint>
#include <string>

namespace clast {

/// Arrangement of the blocks.
enum class DepositKind {
  kHeap,       ///< a heap on a level floor; blocks touch and hide each other
  kScattered,  ///< one loose layer on a level floor
  kSlope,      ///< scattered and clustered blocks on a slope of 25 degrees
  kNatural     ///< isolated rocks, partly buried, on rough ground with soil against their flanks
};
/// Parses the name of a kind: "heap", "scattered", "slope" or "natural".
/// @throws InputError  if the name is unknown; the message lists the kinds
DepositKind parse_deposit_kind(const std::string& name);
std::string name_of(DepositKind kind);

/// Places from which a deposit is scanned.
enum class ScanStations {
  kDrone,  ///< vertical and oblique views from above, merged and subsampled to an even spacing
  kTripod  ///< panoramic views from 2 m above the ground; uneven spacing, shadows
};
/// Parses the name of the places: "drone" or "tripod".
/// @throws InputError  if the name is unknown; the message lists both
ScanStations parse_scan_stations(const std::string& name);
std::string name_of(ScanStations stations);

/// Intermediate axis I of the smallest block, m.
inline constexpr double kSmallestBlock = 0.25;

struct DepositRecipe {
  DepositKind kind = DepositKind::kHeap;
  std::size_t blocks = 200;  ///< number of released blocks
  std::uint64_t seed = 1;
  double size_ratio = 8.0;           ///< I of the largest block over I of the smallest
  double spacings_per_block = 20.0;  ///< I of the smallest block over the spacing of the points
  /// Standard deviation of the noise along the line of sight over the spacing.
  double noise = 0.2;
  /// Depth of the fines over the local height of the deposit; 0: none.
  double fines = 0.0;
  ScanStations stations = ScanStations::kDrone;

  /// Returns the spacing of the points, m: 1/sqrt(points per area).
  double spacing() const { return kSmallestBlock / spacings_per_block; }
  void check() const;  ///< throws InputError naming the field and its value
};

}  // namespace clast
