#pragma once
/// A campaign as scenes of other discrete element engines: Rockable and ExaDEM.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/output_folder.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Names of the engines, "rockable" and "exadem".
const std::vector<std::string>& exportable_engines();

struct EngineSceneOptions {
  std::string engine = "rockable";
  /// Numbers of the runs that are written, or of the realisations of a mass; empty: all.
  std::vector<std::uint32_t> runs;

  void check() const;  ///< throws InputError naming the field and its value
};

/// What was written.
struct EngineScenes {
  std::vector<std::string> folders;  ///< one for each scene, "run00001"
  /// What the other engine can't say or does otherwise, in words.
  std::vector<std::string> notes;
};

/// In a folder of scenes: what is what, its first words, and the campaign, byte for byte.
inline constexpr const char* kSceneFile = "SCENE.txt";
inline constexpr const char* kSceneMark = "Scenes of a clast campaign";
inline constexpr const char* kSceneCampaign = "campaign.toml";

/// How folders of scenes are recognised.
FolderKind scene_folder_kind();

/// Writes one scene for each run, or for each realisation of a mass, into `folder`: starts, blocks
/// as sphero-polyhedra with their exact mass properties, the terrain as one surface for each zone,
/// stiffnesses and ground parameters, all in metres in the local frame of the terrain. SCENE.txt
/// there says where that lies on the map, which block has which name, and the notes.
/// @param folder  exists and is empty, such as `OutputFolder::temporary_path`
/// @throws InputError  a run that the campaign doesn't have; blocks that are released one after the
///                     other and stay; a contact law that the engine doesn't have
EngineScenes write_engine_scenes(const CampaignPlan& prepared, const EngineSceneOptions& options,
                                 const std::filesystem::path& folder);

}  // namespace clast
