#pragma once
/// Digest of the simulated physics. It differs between builds that give different motions.
#include <string>

namespace clast {

/// Simulates a fixed set of short reference motions and returns their results as text. Single
/// blocks move over ground with every kind of parameter, under each contact law; two blocks collide
/// on soil with memory. Results are rounded to six digits, so that rounding differences between
/// processors do not matter.
/// @param gravity  m/s^2; tests pass other values to get other motions
std::string simulate_reference_motions(double gravity = 9.81);

/// Returns the SHA-256 of the results of `simulate_reference_motions`, as 64 hexadecimal digits.
/// They are simulated once, which takes milliseconds.
const std::string& physics_digest();

/// Describes why runs of two program versions cannot be combined. Empty if they compute the same
/// motions, or if a digest is unknown.
std::string describe_physics_difference(const std::string& stored, const std::string& now);

}  // namespace clast
