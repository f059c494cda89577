#pragma once
/// Animation for ParaView.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes an animation for ParaView. FOLDER/animation.pvd refers to one frame_NNNN.vtp with the
/// blocks per stored time, and to one terrain_N.vtp per results file. Blocks are cores with
/// vertices moved outwards by the radius. Points are map coordinates in doubles; cell data are
/// file, run and speed_m_s.
/// @param count  number of runs, selected evenly from those with a trajectory
/// @return the .pvd file; empty if no run has a trajectory
/// @throws InputError  if the folder cannot be written
std::filesystem::path write_animation(const std::filesystem::path& folder,
                                      const Comparison& comparison, std::size_t count);

}  // namespace clast
