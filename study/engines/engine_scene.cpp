#include "study/engines/engine_scene.hpp"

#include <algorithm>
#include <fstream>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "shapes/shp_file.hpp"
#include "study/engines/detail/scene.hpp"
#include "study/engines/detail/scene_text.hpp"

namespace clast {

using namespace study_detail;
namespace {

bool is_rockable(const EngineSceneOptions& options) {
  return options.engine == exportable_engines().front();
}

/// The first runs of the scenes that are asked for.
std::vector<std::uint32_t> first_runs(const CampaignPlan& prepared,
                                      const EngineSceneOptions& options) {
  const std::uint32_t together = prepared.header.runs_per_realisation();
  const auto count = static_cast<std::uint32_t>(prepared.runs.size() / together);
  std::vector<std::uint32_t> first;
  for (const std::uint32_t run : options.runs) {
    if (run >= count) {
      throw InputError(prepared.campaign.file.string() + ": has no " +
                       (prepared.header.persistent_blocks ? "realisation " : "run ") +
                       std::to_string(run) + "; they are numbered from 0 to " +
                       std::to_string(count - 1));
    }
    first.push_back(run * together);
  }
  for (std::uint32_t run = 0; options.runs.empty() && run < count; ++run) {
    first.push_back(run * together);
  }
  return first;
}

void check_campaign_fits(const CampaignPlan& prepared, const EngineSceneOptions& options) {
  const std::string file = prepared.campaign.file.string();
  if (prepared.header.persistent_blocks && !prepared.header.persistent_blocks->at_once) {
    throw InputError(file +
                     ": its blocks are released one after the other, each after the previous ones "
                     "have stopped, which a scene can't express; export a [[mass]], or the "
                     "campaign without sequence = \"stay\"");
  }
  if (prepared.header.persistent_blocks &&
      prepared.campaign.persistent_blocks->settling_time() > 0.0) {
    throw InputError(
        file +
        ": its masses settle behind confining walls first, which a scene can't express; leave "
        "settle out");
  }
  if (prepared.header.persistent_blocks &&
      prepared.campaign.persistent_blocks->last_release_time() > 0.0) {
    throw InputError(file +
                     ": its masses are released at different times, which a scene can't express; "
                     "leave release_time_s out, or export a campaign for each");
  }
  if (is_rockable(options) &&
      !std::holds_alternative<EnergyRestitutionLaw>(prepared.campaign.stiffness.law)) {
    throw InputError(file + ": the contact law " + name_of(prepared.campaign.stiffness.law) +
                     " is not supported for Rockable; use energy-restitution");
  }
}

std::string scene_text(const CampaignPlan& prepared, const EngineSceneOptions& options,
                       const SceneContents& set, const EngineScenes& scenes) {
  std::string text = std::string(kSceneDescriptionMark) + " for " + options.engine +
                     ", written by clast " + prepared.header.program_version + "\n\ncampaign " +
                     prepared.campaign.file.string() + "\nsha256 " + prepared.campaign.sha256 +
                     "\n";
  for (const std::string& input : prepared.header.inputs) text += "input " + input + "\n";
  text += "\nSI units, z up, in the local frame of the terrain: map = scene + (" +
          format_exact(prepared.header.terrain.frame.origin) + ") m\n\nshapes, groups and blocks\n";
  for (std::size_t i = 0; i < set.shapes.size(); ++i) {
    text += "  " + set.shapes[i].shape.name + "  group " + std::to_string(i) + "  block " +
            set.shapes[i].block + ", " + format_significant(set.shapes[i].density, 6) + " kg/m^3\n";
  }
  for (std::size_t zone = 0; zone < set.zones.size(); ++zone) {
    if (set.zones[zone].surface.triangles.empty()) continue;
    text += "  " + set.zones[zone].shape.name + "  group " + std::to_string(set.zone_group(zone)) +
            "  ground zone " + set.zones[zone].zone + "\n";
  }
  text += "\nwhat differs from clast\n";
  for (const std::string& note : scenes.notes) text += "- " + note + "\n";
  text += "\n" + format_count(scenes.folders.size(), "scene") + ": " + scenes.folders.front() +
          (scenes.folders.size() > 1 ? " to " + scenes.folders.back() : "") + "\n";
  return text;
}

}  // namespace

const std::vector<std::string>& exportable_engines() {
  static const std::vector<std::string> kEngines = {"rockable", "exadem"};
  return kEngines;
}

void EngineSceneOptions::check() const {
  const std::vector<std::string>& known = exportable_engines();
  if (std::find(known.begin(), known.end(), engine) != known.end()) return;
  throw InputError("`engine` \"" + engine + "\" is unknown; use rockable or exadem");
}

OutputFolderKind scene_folder_kind() {
  return {"scenes", kSceneDescriptionFile, kSceneDescriptionMark,
          [](const std::filesystem::path& file) {
            const std::string first = file.begin()->string();
            return first.starts_with("run") || first.starts_with("realisation") ||
                   first.starts_with("ground") || first == "shapes.shp" ||
                   first == kSceneDescriptionFile || first == kSceneCampaignFile;
          }};
}

EngineScenes write_engine_scenes(const CampaignPlan& prepared, const EngineSceneOptions& options,
                                 const std::filesystem::path& folder) {
  options.check();
  check_campaign_fits(prepared, options);
  const std::vector<std::uint32_t> runs = first_runs(prepared, options);
  const SceneContents set = collect_scene_contents(prepared);
  EngineScenes scenes;
  scenes.notes =
      is_rockable(options) ? check_rockable_limits(prepared) : check_exadem_limits(prepared);
  std::vector<ShpShape> shapes;
  for (const SceneShape& shape : set.shapes) shapes.push_back(shape.shape);
  if (is_rockable(options)) {
    for (const SceneZone& zone : set.zones) {
      if (!zone.surface.triangles.empty()) shapes.push_back(zone.shape);
    }
  }
  write_shp(folder / "shapes.shp", shapes);
  for (const std::uint32_t first : runs) {
    const Scene scene = build_scene(prepared, set, first);
    (is_rockable(options) ? write_rockable_scene : write_exadem_scene)(prepared, set, scene,
                                                                       folder);
    scenes.folders.push_back(scene.name);
  }
  write_output(folder / kSceneCampaignFile, prepared.campaign.text, {});
  write_output(folder / kSceneDescriptionFile, scene_text(prepared, options, set, scenes), {});
  return scenes;
}

}  // namespace clast
