#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "classify/schemes.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "study/campaign_runner.hpp"
#include "terrain/terrain_fit.hpp"

namespace clast {
namespace {

// Quaternions closer than this are one rotation.
constexpr double kSameRotation = 1e-9;

std::string metres(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string place(const Vec3& map) {
  return "(" + metres(map.x()) + ", " + metres(map.y()) + ", " + metres(map.z()) + ")";
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::vector<Block> selected_blocks(const Campaign& campaign) {
  const BlockSelection& selection = campaign.blocks;
  const BlockLibrary library = BlockLibrary::read(selection.library);
  std::vector<Block> blocks;
  for (const std::string& id : selection.ids) blocks.push_back(library.block(id));
  if (!selection.ids.empty()) return blocks;
  for (const Block& block : library.blocks()) {
    if (selection.scheme.empty() ||
        shape_class(selection.scheme, block.axes()) == selection.shape_class) {
      blocks.push_back(block);
    }
  }
  if (blocks.empty()) {
    throw InputError(campaign.file.string() + ": [blocks] selects no block of " +
                     selection.library.string() +
                     (selection.scheme.empty()
                          ? "; the library is empty"
                          : "; none is " + selection.shape_class + " by " + selection.scheme));
  }
  return blocks;
}

BlockSummary summary_of(const Block& block) {
  const Axes axes = block.axes();
  return {block.id,
          block.mass.mass,
          axes,
          shape_class("garcia", axes),
          shape_class("sneed-folk", axes),
          shape_class("zingg", axes),
          rigid_body(block).shape};
}

// Parameters in the order of the terrain's zones; every zone has some and all are used.
std::vector<GroundParameters> ground_by_zone(const Campaign& campaign,
                                             const std::vector<std::string>& zones) {
  std::vector<std::string> tables;
  for (const auto& [name, parameters] : campaign.ground) tables.push_back("[ground." + name + "]");
  std::vector<GroundParameters> ground;
  for (const std::string& zone : zones) {
    const auto found = campaign.ground.find(zone);
    if (found == campaign.ground.end()) {
      throw InputError(campaign.file.string() + ": terrain zone \"" + zone +
                       "\" has no parameters; add [ground." + zone + "] to " + listed(tables));
    }
    ground.push_back(found->second);
  }
  for (const auto& [name, parameters] : campaign.ground) {
    if (std::find(zones.begin(), zones.end(), name) == zones.end()) {
      throw InputError(campaign.file.string() + ": [ground." + name +
                       "] belongs to no zone of the terrain; its zones are " + listed(zones));
    }
  }
  return ground;
}

// Points in the local frame, each over the terrain.
std::vector<Vec3> local_points(const Campaign& campaign, const TerrainSurface& surface,
                               const MapFrame& frame) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < campaign.release.points.size(); ++i) {
    Vec3 map = campaign.release.points[i];
    // A plan position has no height of its own, and 0 can be far from the local origin.
    if (campaign.release.drop_height) map.z() = frame.origin.z();
    const Vec3 point = frame.local(map);
    if (!surface.covers(point.x(), point.y())) {
      const Vec3 low = frame.map(surface.extent().low);
      const Vec3 high = frame.map(surface.extent().high);
      const bool inside =
          map.x() > low.x() && map.x() < high.x() && map.y() > low.y() && map.y() < high.y();
      throw InputError(campaign.file.string() + ": release point " + std::to_string(i + 1) +
                       " at x " + metres(map.x()) + ", y " + metres(map.y()) +
                       (inside ? " is over a hole in the terrain" : " is off the terrain") +
                       ", which lies in x " + metres(low.x()) + " to " + metres(high.x()) + ", y " +
                       metres(low.y()) + " to " + metres(high.y()) +
                       " m on the map, z up; check the point, the map frame and `up`");
    }
    points.push_back(point);
  }
  return points;
}

// Lifts a block so that its lowest skin point is `drop_height` above the uppermost ground. Lowest
// is meant over the ground, of the points straight under core vertices: on a slope the point of
// smallest z is often not the first to touch, and for a level edge it is not even unique.
void place_above_ground(const TerrainSurface& surface, const RigidBody& body, double drop_height,
                        RigidState& state) {
  const double sky = surface.extent().high.z() + surface.radius() + 1.0;
  const Pose world_from_body = state.world_from_body();
  double clearance = std::numeric_limits<double>::infinity();
  for (const Vec3& vertex : body.shape.vertices) {
    const Vec3 point = world_from_body * vertex;
    // At the rim of the terrain a vertex can be beside it.
    if (const std::optional<double> ground = surface.height(point.x(), point.y(), sky)) {
      clearance = std::min(clearance, point.z() - body.shape.radius - *ground);
    }
  }
  if (std::isfinite(clearance)) state.position.z() += drop_height - clearance;
}

// How deep a block is in the ground, m; none when it is clear of it.
std::optional<double> depth_in_ground(const TerrainSurface& surface, const RigidBody& body,
                                      const RigidState& state) {
  const std::optional<double> gap = ground_gap(surface, body, state, body.smallest_side);
  // What the dynamics will refuse.
  if (gap && *gap < -ReleaseSettings{}.start_overlap * body.smallest_side) return -*gap;
  // A block that is buried whole touches no face of the ground.
  const Vec3& centre = state.position;
  const double abyss = surface.extent().low.z() - 1.0;
  const std::optional<double> ground = surface.height(centre.x(), centre.y(), abyss);
  if (ground && centre.z() < *ground) return *ground - lowest_point(body, state);
  return std::nullopt;
}

void check_clear_of_ground(const PreparedCampaign& prepared, const RunRecord& run) {
  const std::optional<double> depth =
      depth_in_ground(*prepared.surface, prepared.bodies[run.block], run.start);
  if (!depth) return;
  const bool by_height = prepared.campaign.release.drop_height.has_value();
  throw SimulationError("block " + prepared.blocks[run.block].id + ", release point " +
                        std::to_string(run.point + 1) + ", orientation " +
                        std::to_string(run.orientation + 1) + ": starts " + metres(*depth) +
                        " m inside the ground, with its centre at " +
                        place(prepared.header.frame.map(run.start.position)) +
                        (by_height ? "; raise [release] height_m"
                                   : "; raise the release point or use [release] height_m"));
}

void plan_runs(const std::vector<Vec3>& points, PreparedCampaign& prepared) {
  const ReleasePlan& release = prepared.campaign.release;
  // Run numbers have eight digits in the results.
  constexpr double kMostRuns = 99'999'999.0;
  const double count = static_cast<double>(prepared.blocks.size()) *
                       static_cast<double>(points.size()) *
                       static_cast<double>(release.orientations.size());
  if (count > kMostRuns) {
    throw InputError(prepared.campaign.file.string() + ": asks for " +
                     std::to_string(static_cast<std::uint64_t>(count)) +
                     " runs; split it into campaigns of at most 99999999");
  }
  for (std::uint32_t block = 0; block < prepared.blocks.size(); ++block) {
    const Quat source_from_body = prepared.blocks[block].source_from_body().rotation;
    for (std::uint32_t point = 0; point < points.size(); ++point) {
      for (std::uint32_t turn = 0; turn < release.orientations.size(); ++turn) {
        RunRecord run;
        run.run = static_cast<std::uint32_t>(prepared.runs.size());
        run.block = block;
        run.point = point;
        run.orientation = turn;
        run.start.position = points[point];
        run.start.orientation = release.orientations[turn];
        if (!release.in_principal_frame) {
          run.start.orientation = (release.orientations[turn] * source_from_body).normalized();
        }
        run.start.velocity = release.velocity;
        run.start.angular_velocity = release.angular_velocity;
        if (release.drop_height) {
          place_above_ground(*prepared.surface, prepared.bodies[block], *release.drop_height,
                             run.start);
        }
        check_clear_of_ground(prepared, run);
        prepared.runs.push_back(run);
      }
    }
  }
}

// No block can be faster: all energy of its start, and the fall to the lowest ground, in its speed.
double fastest_speed(const PreparedCampaign& prepared) {
  double highest = prepared.surface->extent().low.z();
  for (const RunRecord& run : prepared.runs) {
    highest = std::max(highest, run.start.position.z());
  }
  const double fall = highest - prepared.surface->extent().low.z();
  double spin = 0.0;
  for (const RigidBody& body : prepared.bodies) {
    spin = std::max(spin, body.moments.maxCoeff() / body.mass);
  }
  const ReleasePlan& release = prepared.campaign.release;
  return std::sqrt(release.velocity.squaredNorm() + spin * release.angular_velocity.squaredNorm() +
                   2.0 * prepared.campaign.gravity * fall);
}

std::size_t distinct_rotations(const std::vector<Quat>& orientations) {
  std::vector<Quat> distinct;
  for (const Quat& orientation : orientations) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const Quat& other) {
      return std::min((orientation.coeffs() - other.coeffs()).norm(),
                      (orientation.coeffs() + other.coeffs()).norm()) < kSameRotation;
    });
    if (!known) distinct.push_back(orientation);
  }
  return distinct.size();
}

std::vector<std::string> warnings_of(const PreparedCampaign& prepared) {
  std::vector<std::string> warnings = prepared.stiffness.warnings;
  const std::vector<Quat>& orientations = prepared.campaign.release.orientations;
  // Random sets have no duplicates, and comparing each with each would take long for large ones.
  if (prepared.campaign.release.orientation_source != "random") {
    const std::size_t distinct = distinct_rotations(orientations);
    if (distinct < orientations.size()) {
      warnings.push_back(
          prepared.campaign.release.orientation_source + ": " +
          std::to_string(orientations.size()) + " orientations, of which " +
          std::to_string(distinct) +
          " are different rotations; all are run, so repeated ones count more than once");
    }
  }
  const Bounds& ground = prepared.surface->extent();
  for (const Barrier& barrier : prepared.header.barriers) {
    const Vec2 low = barrier.from.cwiseMin(barrier.to), high = barrier.from.cwiseMax(barrier.to);
    if ((high.array() < ground.low.head<2>().array()).any() ||
        (low.array() > ground.high.head<2>().array()).any()) {
      warnings.push_back("barrier " + barrier.name +
                         " lies off the terrain, so nothing can cross it; from and to are x, y of "
                         "the z-up map");
    }
  }
  const auto warn = [&](const std::optional<std::string>& warning) {
    if (warning) warnings.push_back(*warning);
  };
  double smallest = 1e300, largest = 0.0;
  for (const RigidBody& body : prepared.bodies) {
    smallest = std::min(smallest, body.smallest_side);
    largest = std::max(largest, body.smallest_side);
  }
  warn(cell_size_warning(prepared.header.terrain, smallest, largest));
  if (prepared.campaign.border_distance) {
    warn(border_warning(prepared.header.terrain, prepared.campaign.release.points,
                        *prepared.campaign.border_distance));
  }
  for (const Block& block : prepared.blocks) {
    for (const std::string& warning : block.warnings) {
      warnings.push_back("block " + block.id + ": " + warning);
    }
  }
  return warnings;
}

std::string with_digest(const std::filesystem::path& file) {
  return file.string() + " " + sha256_of_file(file);
}

CampaignResults header_of(const PreparedCampaign& prepared, Terrain terrain) {
  const Campaign& campaign = prepared.campaign;
  CampaignResults header;
  header.campaign_text = campaign.text;
  header.campaign_sha256 = campaign.sha256;
  header.inputs.push_back(with_digest(campaign.blocks.library));
  header.inputs.insert(header.inputs.end(), terrain.sources.begin(), terrain.sources.end());
  for (const auto& file : campaign.release.files) header.inputs.push_back(with_digest(file));
  header.program_version = version();
  for (const Block& block : prepared.blocks) header.blocks.push_back(summary_of(block));
  const Vec2 origin = terrain.frame.origin.head<2>();
  for (Barrier barrier : campaign.barriers) {
    barrier.from -= origin;
    barrier.to -= origin;
    header.barriers.push_back(barrier);
  }
  header.zone_names = terrain.zone_names;
  header.ground = ground_by_zone(campaign, terrain.zone_names);
  header.law = campaign.stiffness.law;
  header.weights = campaign.weights;
  header.frame = terrain.frame;
  header.downslope = campaign.downslope;
  header.terrain = std::move(terrain);
  return header;
}

}  // namespace

RigidBody rigid_body(const Block& block) {
  return {.shape = transformed(block.body, block.source_from_body().inverse()),
          .mass = block.mass.mass,
          .moments = block.principal.moments,
          .smallest_side = block.axes().S};
}

PreparedCampaign prepare_campaign(const Campaign& campaign) {
  PreparedCampaign prepared;
  prepared.campaign = campaign;
  prepared.blocks = selected_blocks(campaign);
  for (const Block& block : prepared.blocks) prepared.bodies.push_back(rigid_body(block));
  prepared.header = header_of(prepared, read_terrain(campaign.terrain));
  CampaignResults& header = prepared.header;
  prepared.surface.emplace(terrain_surface(header.terrain, campaign.terrain_radius));

  plan_runs(local_points(campaign, *prepared.surface, header.frame), prepared);
  header.planned_runs = static_cast<std::uint32_t>(prepared.runs.size());
  for (std::size_t point = 0; point < campaign.release.points.size(); ++point) {
    const std::size_t first = point * campaign.release.orientations.size();
    header.release_points.push_back(prepared.runs[first].start.position);
  }

  prepared.stiffness = choose_stiffness(prepared.bodies, header.ground, fastest_speed(prepared),
                                        campaign.gravity, campaign.stiffness);
  header.stiffness = prepared.stiffness.stiffness;
  header.warnings = warnings_of(prepared);
  prepared.settings = {.stiffness = header.stiffness,
                       .law = campaign.stiffness.law,
                       .weights = campaign.weights,
                       .gravity = campaign.gravity,
                       .max_time = campaign.max_time,
                       .rest_energy = campaign.rest_energy,
                       .rest_duration = campaign.rest_duration};
  prepared.settings.check();
  return prepared;
}

}  // namespace clast
