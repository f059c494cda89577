// Scenes for Rockable: one file of shapes for all, a folder with input.txt for each.
#include <cmath>

#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "study/engines/detail/scene.hpp"
#include "study/engines/detail/scene_text.hpp"

namespace clast::study_detail {
namespace {

constexpr double kRockableSnapshot = 0.1;  ///< s between conf files, where no trajectory is wanted
constexpr double kTrackedSpin = 0.05;      ///< rad/s, below which a slow block is at rest

std::string contact_lines(const SceneContact& contact) {
  const std::string pair =
      " " + std::to_string(contact.first) + " " + std::to_string(contact.second) + " ";
  const GroundParameters& ground = contact.parameters;
  return "knContact" + pair + format_exact(contact.normal) + "\nen2Contact" + pair +
         format_exact(ground.energy_restitution) + "\nktContact" + pair +
         format_exact(contact.tangential) + "\nmuContact" + pair + format_exact(ground.friction) +
         "\nkrContact" + pair + format_exact(contact.rolling) + "\nmurContact" + pair +
         format_exact(ground.rolling_friction) + "\n\n";
}

std::string bodies_text(const SceneContents& set, const Scene& scene) {
  std::string lines;
  std::size_t fixed_body_count = 0;
  for (std::size_t zone = 0; zone < set.zones.size(); ++zone) {
    if (set.zones[zone].surface.triangles.empty()) continue;
    lines += format_conf_line(set.zones[zone].shape.name, set.zone_group(zone), 1.0, {});
    ++fixed_body_count;
  }
  for (const SceneBody& body : scene.bodies) {
    lines +=
        format_conf_line(set.shapes[body.shape].shape.name, body.shape, body.scale, body.start);
  }
  return "nDriven " + std::to_string(fixed_body_count) + "\nshapeFile ../shapes.shp\nParticles " +
         std::to_string(fixed_body_count + scene.bodies.size()) + "\n" + lines;
}

std::string weights_of(ContactWeighting weighting) {
  switch (weighting) {
    case ContactWeighting::kPatch:
    case ContactWeighting::kOverlap:
      return "OverlapWeight";
    case ContactWeighting::kCount:
      return "NumberWeight";
    case ContactWeighting::kNone:
      break;
  }
  return "None";
}

std::string rockable_input(const CampaignPlan& prepared, const SceneContents& set,
                           const Scene& scene) {
  const Campaign& campaign = prepared.campaign;
  const double interval =
      campaign.trajectory_interval > 0.0 ? campaign.trajectory_interval : kRockableSnapshot;
  std::string text = "Rockable 29-11-2018\n# written by clast; see ../SCENE.txt\n\nt 0\ntmax " +
                     format_exact(campaign.max_time) + "\ndt " + format_exact(scene.time_step) +
                     "\ninterVerlet " + format_exact(scene.search_interval) + "\ninterConf " +
                     format_exact(interval) + "\nDVerlet " +
                     format_exact(2.0 * scene.search_margin) + "\ndVerlet " +
                     format_exact(scene.search_margin) + "\n\n";
  for (std::size_t i = 0; i < set.shapes.size(); ++i) {
    text += "density " + std::to_string(i) + " " + format_exact(set.shapes[i].density) + "\n";
  }
  for (std::size_t zone = 0; zone < set.zones.size(); ++zone) {
    text += "density " + std::to_string(set.zone_group(zone)) + " 2650\n";
  }
  text += "\ngravity 0 0 " + format_exact(-campaign.gravity) +
          "\n\nforceLaw Avalanche\nContactPartnership " + weights_of(campaign.weighting) +
          "\nAddOrRemoveInteractions OBBtree\nUpdateNL bruteForce\nIntegrator velocityVerlet\n\n";
  for (const SceneContact& contact : scene.contacts) text += contact_lines(contact);
  return text + "precision 17\niconf 0\n" + bodies_text(set, scene);
}

}  // namespace

void write_rockable_scene(const CampaignPlan& prepared, const SceneContents& set,
                          const Scene& scene, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / scene.name);
  write_output(folder / scene.name / "input.txt", rockable_input(prepared, set, scene), {});
  if (scene.bodies.size() != 1) return;
  std::size_t block = 0;
  for (const SceneZone& zone : set.zones) block += zone.surface.triangles.empty() ? 0 : 1;
  write_output(folder / scene.name / "dataExtractors.txt",
               "TrackRockfall " + std::to_string(block) + " " +
                   format_exact(std::sqrt(2.0 * prepared.campaign.rest_energy)) + " " +
                   format_exact(kTrackedSpin) + " track.txt " + std::to_string(kStepsPerTrackLine) +
                   "\n",
               {});
}

namespace {

/// Depths to which blocks can go that are more than the radii which meet there.
std::string depth_note(const CampaignPlan& prepared) {
  std::size_t deep = 0;
  double missing = 0.0;
  for (const RunRecord& run : prepared.runs) {
    const double radii = prepared.bodies[run.block].shape.radius + prepared.campaign.terrain_radius;
    if (run.impact_depth <= radii) continue;
    ++deep;
    missing = std::max(missing, run.impact_depth - radii);
  }
  const std::string rule =
      "Faces of the ground act on both sides: a block whose core goes through one is pushed out "
      "below. ";
  if (deep == 0) return rule + "The radii here are larger than the deepest impact.";
  const double wanted = prepared.campaign.terrain_radius + missing;
  return rule + "In " + format_count(deep, "run") + " of " + std::to_string(prepared.runs.size()) +
         " an impact at the highest possible speed would do so; [terrain] radius_m = " +
         format_decimals(std::ceil(100.0 * wanted) / 100.0, 2) + " would prevent it.";
}

}  // namespace

std::vector<std::string> check_rockable_limits(const CampaignPlan& prepared) {
  const Campaign& campaign = prepared.campaign;
  std::vector<std::string> notes = {
      depth_note(prepared),
      "In Rockable inner edges of flat ground deflect blocks (up to 5 % of their speed), and "
      "restitution on meshes is lower than stated; in clast they do not.",
      "Mass weights and history of contacts belong to a pair of bodies, and each zone is a body.",
      "A block that leaves the box around the ground, or comes to rest, ends its run (track.txt); "
      "barriers are not counted.",
      "dt is a fixed step of 1/350 of half a contact's period, for the loading with k_n."};
  if (campaign.weighting == ContactWeighting::kPatch) {
    notes.push_back(
        "Rockable has no weights by contact patch: OverlapWeight is used, the weights by overlap "
        "of clast.");
  }
  return notes;
}

}  // namespace clast::study_detail
