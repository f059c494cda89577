#pragma once
/// Seeded random numbers with equal bits on all machines. Functions take a generator as argument.
#include <cstdint>

#include "core/types.hpp"

namespace clast {

/// SplitMix64 generator (Steele, Lea & Flood 2014) with one 64-bit state; any seed is valid.
/// @cite steele2014
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next_bits();
  /// Returns a uniform number in [0, 1) with 53 random bits.
  double uniform();
  /// Returns a uniform number in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Returns a standard normal number, by Marsaglia's polar method.
  double normal();
  /// Returns a uniform integer in [0, count); count > 0.
  std::uint64_t uniform_index(std::uint64_t count) { return next_bits() % count; }
  /// Returns a uniform point on the unit sphere.
  Vec3 unit_vector();
  /// Returns a uniform random rotation (Shoemake 1992).
  /// @cite shoemake1992
  Quat rotation();

 private:
  std::uint64_t state_;
};

}  // namespace clast
