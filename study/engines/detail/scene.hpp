#pragma once
/// Scenes for other discrete element codes: shapes, bodies and contact parameters.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "shapes/shp_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

struct SceneShape {
  ShpShape shape;        ///< shape in the format of the engine
  std::string block;     ///< id in the library
  double density = 0.0;  ///< kg/m^3
};

struct SceneZone {
  ShpShape shape;  ///< shape of the zone in the local frame of the terrain
  TriangleMesh surface;
  std::string zone;  ///< name of the zone in the campaign
};

/// Shapes and zones that all scenes of a campaign share. The group of a block is the index of its
/// shape. The group of a zone is `shapes.size()` plus its index.
struct SceneContents {
  std::vector<SceneShape> shapes;
  std::vector<SceneZone> zones;

  std::uint32_t zone_group(std::size_t zone) const {
    return static_cast<std::uint32_t>(shapes.size() + zone);
  }
};

/// Number of time steps between two lines of a track written by Rockable.
inline constexpr std::size_t kStepsPerTrackLine = 200;

struct SceneBody {
  std::uint32_t shape = 0;  ///< index of shape and group
  double scale = 1.0;       ///< scale of lengths
  RigidState start;
};

/// Contact parameters of a pair of groups.
struct SceneContact {
  std::uint32_t first = 0, second = 0;  ///< indices of the groups
  double normal = 0.0;                  ///< k_n, N/m
  double tangential = 0.0;              ///< k_t, N/m
  double rolling = 0.0;                 ///< k_r, N m/rad
  GroundParameters parameters;
};

/// Bodies, contacts and time step of one scene.
struct Scene {
  std::string name;  ///< name, such as "run00001" or "realisation0001"
  std::vector<SceneBody> bodies;
  std::vector<SceneContact> contacts;
  double time_step = 0.0;        ///< constant step that resolves impacts, s
  double search_margin = 0.0;    ///< maximum distance of pairs in the neighbour list, m
  double search_interval = 0.0;  ///< interval between neighbour searches, s
};

/// Returns the name of the scene whose first run is `first`.
std::string scene_name(const CampaignPlan& prepared, std::uint32_t first);

/// Collects the shapes and zones that all scenes of a campaign share.
SceneContents collect_scene_contents(const CampaignPlan& prepared);

/// Builds the scene of one run or realisation.
/// @param first  index of the first run
Scene build_scene(const CampaignPlan& prepared, const SceneContents& set, std::uint32_t first);

/// Writes shapes, conf file and tracker input for Rockable.
void write_rockable_scene(const CampaignPlan& prepared, const SceneContents& set,
                          const Scene& scene, const std::filesystem::path& folder);
std::vector<std::string> check_rockable_limits(const CampaignPlan& prepared);

/// Writes the input file of ExaDEM, bodies as a conf file and terrain as STL files.
void write_exadem_scene(const CampaignPlan& prepared, const SceneContents& set, const Scene& scene,
                        const std::filesystem::path& folder);
std::vector<std::string> check_exadem_limits(const CampaignPlan& prepared);

}  // namespace clast::study_detail
