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

/// Returns the SHA-256 of the reference motions, as 64 hexadecimal digits. It is computed once,
/// which takes milliseconds.
const std::string& physics_digest();

/// Describes why runs of two programs cannot be combined; empty if they can, or if a digest is
/// unknown. Example: "this version of clast computes different motions (physics digest 0123456789,
/// here 9876543210)".
std::string describe_physics_difference(const std::string& stored, const std::string& now);

}  // namespace clast
