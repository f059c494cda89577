#pragma once
/// Animation for ParaView.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes FOLDER/animation.pvd for ParaView, one frame_NNNN.vtp with the block positions per stored
/// time (core with vertices moved outwards by the radius), and terrain_N.vtp per results file. Map
/// coordinates in doubles; cell data: file, run, speed_m_s.
/// @param count  number of runs, spread evenly over those with a trajectory
/// @return the .pvd file; empty if no run has a trajectory
/// @throws InputError  if the folder cannot be written
std::filesystem::path write_animation(const std::filesystem::path& folder,
                                      const Comparison& comparison, std::size_t count);

}  // namespace clast
