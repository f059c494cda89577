#pragma once
/// A scene as discrete element engines take it: shapes, bodies in groups, contacts between groups.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "shapes/shp_file.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// A block of the library as other engines name it.
struct SceneShape {
  ShpShape shape;        ///< principal frame, at the size of the library
  std::string block;     ///< its id in the library
  double density = 0.0;  ///< kg/m^3
};

/// Ground of one zone.
struct SceneZone {
  ShpShape shape;  ///< local frame of the terrain
  TriangleMesh surface;
  std::string zone;  ///< its name in the campaign
};

/// What all scenes of a campaign have in common. The group of a block is the index of its shape,
/// that of a zone `shapes.size()` and its index.
struct SceneContents {
  std::vector<SceneShape> shapes;
  std::vector<SceneZone> zones;

  std::uint32_t zone_group(std::size_t zone) const {
    return static_cast<std::uint32_t>(shapes.size() + zone);
  }
};

/// Steps between two lines of a track of Rockable.
inline constexpr std::size_t kTrackedSteps = 200;

struct SceneBody {
  std::uint32_t shape = 0;  ///< and group
  double scale = 1.0;       ///< of lengths
  RigidState start;
};

/// What bodies of two groups do to each other.
struct SceneContact {
  std::uint32_t first = 0, second = 0;  ///< groups
  double normal = 0.0;                  ///< k_n, N/m
  double tangential = 0.0;              ///< k_t, N/m
  double rolling = 0.0;                 ///< k_r, N m/rad
  GroundParameters parameters;
};

struct Scene {
  std::string name;  ///< "run00001", "realisation0001"
  std::vector<SceneBody> bodies;
  std::vector<SceneContact> contacts;
  double time_step = 0.0;        ///< s, a fixed one that resolves impacts
  double search_margin = 0.0;    ///< m, by which near pairs are listed
  double search_interval = 0.0;  ///< s, in which no block moves farther than half that margin
};

/// Of the scene that begins with this run.
std::string scene_name(const CampaignPlan& prepared, std::uint32_t first);

SceneContents scene_set(const CampaignPlan& prepared);

/// @param first  number of the first run of those that are computed together
Scene build_scene(const CampaignPlan& prepared, const SceneContents& set, std::uint32_t first);

/// Shapes and conf file of Rockable, with the input of its tracker.
void write_rockable_scene(const CampaignPlan& prepared, const SceneContents& set, const Scene& scene,
                          const std::filesystem::path& folder);
std::vector<std::string> check_rockable_limits(const CampaignPlan& prepared);

/// Input file of ExaDEM, with the bodies as a conf file and the terrain as STL files.
void write_exadem_scene(const CampaignPlan& prepared, const SceneContents& set, const Scene& scene,
                        const std::filesystem::path& folder);
std::vector<std::string> check_exadem_limits(const CampaignPlan& prepared);

}  // namespace clast::study_detail
