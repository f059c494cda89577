#pragma once
/// Animation for ParaView.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes an animation of runs for ParaView: one file with the blocks per stored time, and one
/// terrain per results file, in map coordinates.
/// @param count  number of runs, selected evenly from those with a trajectory
/// @return the .pvd file; empty if no run has a trajectory
/// @throws InputError  if the folder cannot be written
std::filesystem::path write_animation(const std::filesystem::path& folder,
                                      const Comparison& comparison, std::size_t count);

}  // namespace clast
