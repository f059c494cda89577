#pragma once
/// Command `clast export CAMPAIGN --to ENGINE`.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace clast {

struct SceneExportArgs {
  std::string engine;  ///< name of the engine
  std::string runs;    ///< indices of the runs, such as "0-15,20"; empty for all
};

void add_scene_options(CLI::App& command, SceneExportArgs& args);

/// Exports the scenes of a campaign and prints their folders and notes.
void export_scenes(const std::filesystem::path& campaign, const std::filesystem::path& folder,
                   bool replace, const SceneExportArgs& args);

}  // namespace clast
