#pragma once
/// Distinguishes programs of one version in which blocks move differently.
#include <string>

namespace clast {

/// What a block does in a few short motions that stay as they are: over ground with every kind of
/// parameter under each contact law, and two blocks that hit each other on soil with a memory.
/// With six digits, which no order of sums and no processor changes.
/// @param gravity  m/s^2; another one makes other motions, for tests
std::string simulate_reference_motions(double gravity = 9.81);

/// SHA-256 of the standard motions, 64 hexadecimal digits; computed once, in some milliseconds.
const std::string& physics_digest();

/// Why runs can't be joined with those of this program: "blocks move differently in this clast
/// (physics digest 0123456789, here 9876543210)". Empty: they can, or one of both is not known.
std::string describe_physics_difference(const std::string& stored, const std::string& now);

}  // namespace clast
