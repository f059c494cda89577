#pragma once
/// Seeded random numbers with the same bits on every machine. Every draw comes from a generator
/// that is passed in.
#include <cstdint>

#include "core/types.hpp"

namespace clast {

/// SplitMix64 (Steele, Lea & Flood 2014): one 64-bit state, any seed is good.
/// @cite steele2014
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next_bits();
  /// Uniform in [0, 1), 53 random bits.
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal, by the polar method of Marsaglia.
  double normal();
  /// Uniform integer in [0, count); count > 0.
  std::uint64_t uniform_index(std::uint64_t count) { return next_bits() % count; }
  /// Uniform on the unit sphere.
  Vec3 unit_vector();
  /// Uniform over all rotations (Shoemake 1992).
  /// @cite shoemake1992
  Quat rotation();

 private:
  std::uint64_t state_;
};

}  // namespace clast
