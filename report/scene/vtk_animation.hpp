#pragma once
/// Moving blocks for ParaView.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Writes FOLDER/animation.pvd, which ParaView opens with a time slider, one frame_NNNN.vtp for
/// each stored instant with the blocks where they then are (the core, its corners moved out by the
/// radius), and terrain_N.vtp for each results file. Map coordinates, doubles; cell data: file,
/// run, speed_m_s.
/// @param count  runs to show, spread evenly over those with a trajectory
/// @return the .pvd file; empty when no run has a trajectory
/// @throws InputError  the folder can't be written to
std::filesystem::path write_animation(const std::filesystem::path& folder,
                                      const Comparison& comparison, std::size_t count);

}  // namespace clast
