#pragma once
/// Points that fill a unit cube evenly, and stay even when more are added.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast {

/// The most coordinates that a `SobolSequence` has: direction numbers are tabulated up to here.
inline constexpr std::size_t kMaxSobolDimensions = 21;

/// Sobol's sequence with the direction numbers of Joe and Kuo. The first 2^k points have exactly
/// one coordinate of each dimension in each of the 2^k equal parts of [0, 1); the first 2^d of d
/// dimensions have exactly one point in each of the 2^d cubes that halving every side makes (to
/// be relied on up to `kMaxSobolDimensions`).
/// @cite sobol1967, joe2008
class SobolSequence {
 public:
  /// The sequence itself; its first point is the origin.
  /// @throws InputError  no dimension, or more than `kMaxSobolDimensions`
  explicit SobolSequence(std::size_t dimensions);
  /// Scrambled: each coordinate's digits are multiplied by a random triangular matrix and shifted,
  /// which keeps how even the points are. Every point is then uniform over the cube. Coordinates
  /// are scrambled by seeds of their own: those of fewer dimensions are the first of more.
  /// @cite matousek1998
  SobolSequence(std::size_t dimensions, std::uint64_t seed);

  /// The next point, coordinates in [0, 1).
  std::vector<double> next_point();

 private:
  static constexpr std::size_t kBits = 52;
  std::vector<std::uint64_t> directions_;  ///< of each dimension its `kBits`
  std::vector<std::uint64_t> point_;       ///< as whole numbers of 2^-52
  std::uint64_t count_ = 0;
};

}  // namespace clast
