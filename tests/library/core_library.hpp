#pragma once
/// Libraries of cores for tests of campaigns.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "library/block_library.hpp"
#include "library/make_block.hpp"

namespace clast {

/// Writes a library of blocks with these cores and a radius of 0.02 m.
inline void write_core_library(const std::filesystem::path& file,
                               const std::vector<std::pair<std::string, TriangleMesh>>& cores) {
  BlockLibrary library;
  for (const auto& [id, mesh] : cores) {
    BlockSource source;
    source.file = id + ".obj";
    source.sha256 = std::string(64, '0');
    BlockOptions options;
    options.core = true;
    options.radius = 0.02;
    library.add(make_block(id, mesh, mesh, source, options));
  }
  library.write(file);
}

}  // namespace clast
