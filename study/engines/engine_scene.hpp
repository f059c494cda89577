#pragma once
/// Export of a campaign as scenes for other discrete element codes: Rockable and ExaDEM.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/output_folder.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Returns the engines: "rockable" and "exadem".
const std::vector<std::string>& exportable_engines();

struct EngineSceneOptions {
  std::string engine = "rockable";
  /// Indices of the exported runs, or realisations of multi-block releases. If empty, all.
  std::vector<std::uint32_t> runs;

  void check() const;  ///< throws InputError naming the field and its value
};

struct EngineScenes {
  std::vector<std::string> folders;  ///< one folder per scene, such as "run00001"
  /// Limitations and differences of the other engine, as sentences.
  std::vector<std::string> notes;
};

/// Names of the description and of the copy of the campaign in a folder of scenes, and the first
/// words of the description.
inline constexpr const char* kSceneDescriptionFile = "SCENE.txt";
inline constexpr const char* kSceneDescriptionMark = "Scenes of a clast campaign";
inline constexpr const char* kSceneCampaignFile = "campaign.toml";

FolderKind scene_folder_kind();

/// Writes one scene per run, or per realisation of multi-block releases. A scene contains starts,
/// blocks as sphero-polyhedra with exact mass properties, the terrain as one surface per zone,
/// stiffness and ground parameters. Positions are in metres in the local frame of the terrain.
/// SCENE.txt states the map position, block names and notes.
/// @param folder  existing, empty folder, such as `OutputFolder::temporary_path`
/// @throws InputError  if a run does not exist, blocks are persistent and released one after the
///                     other, or the engine lacks the contact law
EngineScenes write_engine_scenes(const CampaignPlan& prepared, const EngineSceneOptions& options,
                                 const std::filesystem::path& folder);

}  // namespace clast
