#pragma once
/// Small PLY files for the samples: float vertices, as scanners and photogrammetry write them.
#include <filesystem>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Writes binary little-endian PLY with float coordinates rounded to `grid` (m). The rounding is
/// far coarser than differences between mathematics libraries, so that bytes are equal.
void write_float_ply(const std::filesystem::path& path, const TriangleMesh& mesh, double grid,
                     const std::string& comment);

}  // namespace clast
