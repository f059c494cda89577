#pragma once
/// Sobol low-discrepancy sequence.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast {

/// Maximum number of dimensions of a `SobolSequence`, limited by the tabulated direction numbers.
inline constexpr std::size_t kMaxSobolDimensions = 21;

/// Sobol sequence with the direction numbers of Joe and Kuo. In each dimension, the first 2^k
/// points have exactly one coordinate in each of 2^k equal parts of [0, 1). If each of d dimensions
/// is divided in halves, each of the 2^d parts of the cube has exactly one of the first 2^d points.
/// @cite sobol1967, joe2008
class SobolSequence {
 public:
  /// Makes the unscrambled sequence, which starts at the origin.
  /// @throws InputError  if `dimensions` is 0 or above `kMaxSobolDimensions`
  explicit SobolSequence(std::size_t dimensions);
  /// Makes a sequence scrambled by a random linear matrix and a digital shift, which keep its
  /// uniformity. Each point is uniform in the cube. Coordinates are scrambled independently, so
  /// that their values do not depend on `dimensions`.
  /// @cite matousek1998
  SobolSequence(std::size_t dimensions, std::uint64_t seed);

  /// Returns the next point, with coordinates in [0, 1).
  std::vector<double> next_point();

 private:
  static constexpr std::size_t kBits = 52;
  std::vector<std::uint64_t> directions_;  ///< `kBits` numbers per dimension
  std::vector<std::uint64_t> point_;       ///< integers in units of 2^-52
  std::uint64_t count_ = 0;
};

}  // namespace clast
