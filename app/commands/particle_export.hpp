#pragma once
/// Command `clast export LIBRARY --to ENGINE`.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "particles/particle_export.hpp"

namespace clast {

struct ParticleExportArgs {
  ParticleExportOptions options;
  std::string error;   ///< "volume=0.01,inertia=0.02,surface=0.02"
  std::string levels;  ///< "0.05,0.02"
  std::string shape;   ///< if empty, that of the engine
  std::string report;  ///< folder of pages; if empty, none are written
  std::size_t equal_spheres = 0, parts = 0, part_vertices = 0;  ///< 0 if not given
};

/// Options of particles, without that of the engine.
void add_particle_options(CLI::App& command, ParticleExportArgs& args);

/// Names of the options of `add_particle_options`.
const std::vector<std::string>& particle_option_names();

/// Exports blocks of a library and prints a summary.
/// @param ids  if empty, all blocks
void run_particle_export(const std::string& library, const std::vector<std::string>& ids,
                         const std::filesystem::path& folder, ParticleExportArgs args);

}  // namespace clast
