#pragma once
/// Small PLY files for the samples: float vertices, as scanners and photogrammetry write them.
#include <cstdint>
#include <filesystem>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Appends four bytes, the lowest first.
void append_word(std::string& bytes, std::uint32_t word);

/// Writes binary little-endian PLY with float coordinates rounded to `grid` (m). It is far coarser
/// than the differences between mathematics libraries, so that all machines write equal bytes.
void write_float_ply(const std::filesystem::path& path, const TriangleMesh& mesh, double grid,
                     const std::string& comment);

}  // namespace clast
