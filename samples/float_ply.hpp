#pragma once
/// Small PLY files for the samples: float vertices, as scanners and photogrammetry write them.
#include <filesystem>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Writes binary little-endian PLY with float coordinates rounded to `grid` (m). It is far coarser
/// than the differences between mathematics libraries, so that all machines write equal bytes.
void write_float_ply(const std::filesystem::path& path, const TriangleMesh& mesh, double grid,
                     const std::string& comment);

}  // namespace clast
