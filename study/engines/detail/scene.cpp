#include "study/engines/detail/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/number_text.hpp"
#include "library/block_export.hpp"
#include "mesh/sub_mesh.hpp"

namespace clast::study_detail {
namespace {

constexpr std::size_t kMaxNameLength = 15;  ///< that ExaDEM keeps of a shape
/// Steps per half period of the lightest block on its contact spring.
constexpr double kStepsPerContact = 350.0;
constexpr double kSceneMarginFraction = 0.05;  ///< of S of the smallest block
constexpr double kMinMargin = 0.01;            ///< m

/// "00042"
std::string padded(std::uint32_t number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

std::string zone_name(std::size_t zone) { return "ground" + std::to_string(zone + 1); }

/// The id itself where other engines can read it and no other shape has it.
std::string shape_name(const std::string& id, std::set<std::string>& used) {
  const bool readable = !id.empty() && id.size() <= kMaxNameLength &&
                        std::all_of(id.begin(), id.end(), [](unsigned char c) {
                          return std::isalnum(c) || c == '_' || c == '-';
                        });
  std::string name = id;
  for (std::size_t i = 1; !readable || used.contains(name); ++i) {
    name = "block" + std::to_string(i);
    if (!used.contains(name)) break;
  }
  used.insert(name);
  return name;
}

/// A box along the axes, as engines need one for their search.
OrientedBox box_along_axes(const Bounds& bounds, double radius) {
  OrientedBox box;
  box.centre = 0.5 * (bounds.low + bounds.high);
  box.lengths = bounds.high - bounds.low + 2.0 * radius * Vec3::Ones();
  box.axes = Mat3::Identity();
  return box;
}

SceneZone scene_zone(const Terrain& terrain, std::size_t zone, double radius) {
  SceneZone result;
  result.zone = terrain.zone_names[zone];
  std::vector<bool> keep(terrain.zone.size());
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = terrain.zone[i] == zone;
  result.surface = extract_triangles(terrain.surface, keep);
  if (result.surface.triangles.empty()) return result;
  result.shape.name = zone_name(zone);
  result.shape.body = make_sphero_polyhedron(result.surface, radius);
  result.shape.is_surface = true;
  // A surface has neither; engines that divide by them must find numbers.
  result.shape.volume = 1.0;
  result.shape.inertia_per_mass = Vec3::Ones();
  result.shape.box = box_along_axes(bounds(result.surface), radius);
  return result;
}

/// Speed that a block can't exceed: from its start to the lowest ground, m/s.
double fastest(const CampaignPlan& prepared, const SceneBody& body) {
  const double lowest = bounds(prepared.header.terrain.surface).low.z();
  const double fall = std::max(0.0, body.start.position.z() - lowest);
  return std::sqrt(body.start.velocity.squaredNorm() + 2.0 * prepared.campaign.gravity * fall);
}

void add_contacts(const CampaignPlan& prepared, const SceneContents& set, std::uint32_t first,
                  std::uint32_t count, Scene& scene) {
  std::set<std::uint32_t> shapes;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const RunRecord& run = prepared.runs[i];
    const std::uint32_t shape = scene.bodies[i - first].shape;
    if (!shapes.insert(shape).second) continue;
    const std::vector<GroundParameters>& zones = prepared.header.ground_sets[run.ground_set].zones;
    const ContactStiffness& k = run.stiffness;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
      scene.contacts.push_back({set.zone_group(zone), shape, k.normal, k.tangential,
                                zones[zone].rolling_stiffness(k.normal, k.rolling), zones[zone]});
    }
  }
  if (!prepared.header.persistent_blocks) return;
  const GroundParameters& between = prepared.header.persistent_blocks->between_blocks;
  const ContactStiffness& k = prepared.runs[first].stiffness;
  for (auto a = shapes.begin(); a != shapes.end(); ++a) {
    for (auto b = a; b != shapes.end(); ++b) {
      scene.contacts.push_back({*a, *b, k.normal, k.tangential,
                                between.rolling_stiffness(k.normal, k.rolling), between});
    }
  }
}

}  // namespace

std::string scene_name(const CampaignPlan& prepared, std::uint32_t first) {
  return prepared.header.persistent_blocks
             ? "realisation" + padded(first / prepared.header.runs_per_realisation(), 4)
             : "run" + padded(first, 5);
}

SceneContents collect_scene_contents(const CampaignPlan& prepared) {
  SceneContents set;
  const Terrain& terrain = prepared.header.terrain;
  std::set<std::string> used;
  for (std::size_t zone = 0; zone < terrain.zone_names.size(); ++zone) {
    used.insert(zone_name(zone));
  }
  for (const Block& block : prepared.choice.library) {
    set.shapes.push_back({to_shp_shape(block), block.id, block.density});
    set.shapes.back().shape.name = shape_name(block.id, used);
  }
  for (std::size_t zone = 0; zone < terrain.zone_names.size(); ++zone) {
    set.zones.push_back(scene_zone(terrain, zone, prepared.campaign.terrain_radius));
  }
  return set;
}

Scene build_scene(const CampaignPlan& prepared, const SceneContents& set, std::uint32_t first) {
  const std::uint32_t together = prepared.header.runs_per_realisation();
  Scene scene;
  scene.name = scene_name(prepared, first);
  double speed = 0.0, step = prepared.runs[first].stiffness.time_step;
  double smallest = prepared.bodies[prepared.runs[first].block].size();
  for (std::uint32_t i = first; i < first + together; ++i) {
    const RunRecord& run = prepared.runs[i];
    const CampaignBlock& block = prepared.choice.blocks[run.block];
    const RigidBody body = prepared.bodies[run.block];
    scene.bodies.push_back({static_cast<std::uint32_t>(block.library), block.scale, run.start});
    speed = std::max(speed, fastest(prepared, scene.bodies.back()));
    smallest = std::min(smallest, body.size());
    step = std::min(step, kPi * std::sqrt(body.mass / run.stiffness.normal) / kStepsPerContact);
  }
  scene.time_step = step;
  scene.search_margin = std::max(kMinMargin, kSceneMarginFraction * smallest);
  scene.search_interval = std::max(step, 0.5 * scene.search_margin / std::max(speed, 1.0));
  add_contacts(prepared, set, first, together, scene);
  return scene;
}

}  // namespace clast::study_detail
