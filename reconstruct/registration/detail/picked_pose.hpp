#pragma once
/// Poses from places that a user picked in several scans.
#include <string>
#include <utility>
#include <vector>

#include "reconstruct/registration/registration.hpp"

namespace clast::reconstruct_detail {

/// Checks the numbers of the scans of pairs.
/// @throws InputError  if a pair is of a scan that is not there, or of one scan only
void check_pairs(const std::vector<PickedPair>& pairs, std::size_t scans);

/// Fits the rigid pose that takes the second points of pairs to the first.
/// @param pairs  three or more, m
/// @param name  name of the scan, for messages
/// @param diagonal  of the scan, m
/// @throws InputError  if the places lie on a line, or their distances differ by more than a tenth
///                     of the diagonal
/// @cite umeyama1991
Similarity fit_picked_pairs(const std::vector<std::pair<Vec3, Vec3>>& pairs,
                            const std::string& name, double diagonal);

}  // namespace clast::reconstruct_detail
