#pragma once
/// Digest of the simulated physics, which distinguishes builds of one version with different
/// motions.
#include <string>

namespace clast {

/// Simulates a fixed set of short reference motions: over ground with every kind of parameter under
/// each contact law, and two blocks colliding on soil with memory. Results have six digits, so that
/// rounding differences of processors do not matter.
/// @param gravity  m/s^2; other values give other motions, for tests
std::string simulate_reference_motions(double gravity = 9.81);

/// Returns the SHA-256 of the reference motions, 64 hexadecimal digits; computed once within
/// milliseconds.
const std::string& physics_digest();

/// Describes why runs of two programs cannot be combined: "blocks move differently in this clast
/// (physics digest 0123456789, here 9876543210)". Empty if they can, or if a digest is unknown.
std::string describe_physics_difference(const std::string& stored, const std::string& now);

}  // namespace clast
