#pragma once
/// Export of a campaign as scenes for other discrete element codes: Rockable and ExaDEM.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/output_folder.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Returns the names of the engines to which scenes can be exported: "rockable" and "exadem".
const std::vector<std::string>& exportable_engines();

struct EngineSceneOptions {
  std::string engine = "rockable";
  /// Indices of the exported runs, or of realisations with persistent blocks. If empty, all are
  /// exported.
  std::vector<std::uint32_t> runs;

  void check() const;  ///< throws InputError naming the field and its value
};

struct EngineScenes {
  std::vector<std::string> folders;  ///< one folder per scene, such as "run00001"
  /// Sentences about limitations and differences of the other engine.
  std::vector<std::string> notes;
};

/// Name of the description in a folder of scenes.
inline constexpr const char* kSceneDescriptionFile = "SCENE.txt";
inline constexpr const char* kSceneDescriptionMark = "Scenes of a clast campaign";
inline constexpr const char* kSceneCampaignFile = "campaign.toml";

OutputFolderKind scene_folder_kind();

/// Writes scenes for another engine: one per run, or per realisation of blocks that are released at
/// once. A scene contains blocks, terrain, contact parameters and starts, in the local frame of the
/// terrain.
/// @param folder  existing, empty folder
/// @throws InputError  if a run does not exist, blocks are persistent and released one after the
///                     other, or the engine lacks the contact law
EngineScenes write_engine_scenes(const CampaignPlan& prepared, const EngineSceneOptions& options,
                                 const std::filesystem::path& folder);

}  // namespace clast
