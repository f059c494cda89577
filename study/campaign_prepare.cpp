#include <algorithm>
#include <cmath>
#include <limits>

#include "classify/schemes.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "dem/ground_overlap.hpp"
#include "study/campaign_runner.hpp"
#include "study/detail/campaign_checks.hpp"
#include "study/detail/ground_sets.hpp"
#include "study/detail/named_seed.hpp"
#include "study/detail/run_stiffness.hpp"
#include "study/release_points.hpp"

namespace clast {

using namespace study_detail;
namespace {

BlockSummary summary_of(const CampaignBlock& chosen, const Block& block, const RigidBody& body,
                        const std::vector<BlockGroup>& groups) {
  const double scale = chosen.scale;
  const Axes axes{scale * block.axes().L, scale * block.axes().I, scale * block.axes().S};
  return {chosen.id,
          body.mass,
          axes,
          shape_class("garcia", axes),
          shape_class("sneed-folk", axes),
          shape_class("zingg", axes),
          block.id,
          chosen.group > 0 ? groups[chosen.group - 1].name : "",
          scale,
          scale * scale * scale * block.mass.volume,
          static_cast<std::uint32_t>(chosen.library),
          body.moments};
}

// Points in the local frame, each over the terrain.
std::vector<Vec3> local_points(const Campaign& campaign, const ReleasePlan& release,
                               const TerrainSurface& surface, const MapFrame& frame) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < release.points.size(); ++i) {
    Vec3 map = release.points[i];
    // A plan position has no height of its own, and 0 can be far from the local origin.
    if (release.drop_height) map.z() = frame.origin.z();
    const Vec3 point = frame.local(map);
    if (!surface.covers(point.x(), point.y())) {
      const Vec3 low = frame.map(surface.extent().low);
      const Vec3 high = frame.map(surface.extent().high);
      const auto range = [&](int axis) {
        return with_decimals(low[axis], 3) + " to " + with_decimals(high[axis], 3);
      };
      const bool inside =
          map.x() > low.x() && map.x() < high.x() && map.y() > low.y() && map.y() < high.y();
      throw InputError(campaign.file.string() + ": " + set_name(release) + "release point " +
                       std::to_string(i + 1) + " at x " + with_decimals(map.x(), 3) + ", y " +
                       with_decimals(map.y(), 3) +
                       (inside ? " is over a hole in the terrain" : " is off the terrain") +
                       ", which lies in x " + range(0) + ", y " + range(1) +
                       " m on the map, z up; check the point, the map frame and \"up\"");
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
std::optional<double> depth_in_ground(const GroundOverlap& ground_overlap,
                                      const TerrainSurface& surface, const RigidBody& body,
                                      const RigidState& state) {
  const double overlap = ground_overlap.deepest(state);
  // What the dynamics will refuse.
  if (overlap > ReleaseSettings{}.start_overlap * body.smallest_side) return overlap;
  // A block that is buried whole touches no face of the ground.
  const Vec3& centre = state.position;
  const double abyss = surface.extent().low.z() - 1.0;
  const std::optional<double> ground = surface.height(centre.x(), centre.y(), abyss);
  if (ground && centre.z() < *ground) return *ground - lowest_point(body, state);
  return std::nullopt;
}

void check_clear_of_ground(const PreparedCampaign& prepared, const GroundOverlap& ground_overlap,
                           const ReleasePlan& release, std::size_t point_of_set,
                           const RunRecord& run) {
  const std::optional<double> depth =
      depth_in_ground(ground_overlap, *prepared.surface, prepared.bodies[run.block], run.start);
  if (!depth) return;
  const std::string table = release.name.empty() ? "[release]" : "[[release]] " + release.name;
  throw SimulationError(
      "run " + std::to_string(run.run) + ", block " + prepared.header.blocks[run.block].id + ", " +
      set_name(release) + "release point " + std::to_string(point_of_set + 1) + ", orientation " +
      std::to_string(run.orientation + 1) + ": starts " + with_decimals(*depth, 3) +
      " m inside the ground, with its centre at " +
      place_on_map(prepared.header.frame.map(run.start.position)) +
      (release.drop_height ? "; raise " + table + " height_m"
                           : "; raise the release point or use " + table + " height_m"));
}

// Random orientations of one block at one point of a set. Their seed is made from names, not from
// places in the campaign, so that they do not depend on what else runs.
std::vector<Quat> fresh_orientations(const ReleasePlan& release, const std::string& block,
                                     std::size_t point) {
  std::uint64_t seed = release.orientation_seed;
  for (const std::string& name : {release.name, block, std::to_string(point)}) {
    seed = named_seed(seed, name);
  }
  return random_orientations(release.orientations.size(), seed);
}

// The release sets of a block, in order; `run` counts over the whole campaign.
void plan_block(const std::vector<std::vector<Vec3>>& points, std::uint32_t block,
                PreparedCampaign& prepared) {
  const Campaign& campaign = prepared.campaign;
  const CampaignBlock& chosen = prepared.choice.blocks[block];
  const Quat source_from_body = prepared.choice.library[chosen.library].source_from_body().rotation;
  const std::uint32_t members = campaign.ensemble.members;
  const GroundOverlap ground_overlap(*prepared.surface, prepared.bodies[block]);
  std::uint32_t point = 0;
  for (std::size_t set = 0; set < campaign.releases.size(); ++set) {
    const ReleasePlan& release = campaign.releases[set];
    for (std::size_t of_set = 0; of_set < points[set].size(); ++of_set, ++point) {
      const std::vector<Quat> orientations = release.fresh_orientations
                                                 ? fresh_orientations(release, chosen.id, of_set)
                                                 : release.orientations;
      for (std::uint32_t turn = 0; turn < orientations.size(); ++turn) {
        RunRecord run;
        run.run = static_cast<std::uint32_t>(prepared.runs.size());
        run.block = block;
        run.point = point;
        run.orientation = turn;
        run.start.position = points[set][of_set];
        run.start.orientation = release.in_principal_frame
                                    ? orientations[turn]
                                    : (orientations[turn] * source_from_body).normalized();
        run.start.velocity = release.velocity;
        run.start.angular_velocity = release.angular_velocity;
        if (release.drop_height) {
          place_above_ground(*prepared.surface, prepared.bodies[block], *release.drop_height,
                             run.start);
        }
        check_clear_of_ground(prepared, ground_overlap, release, of_set, run);
        for (std::uint32_t member = 0; member < members; ++member) {
          run.run = static_cast<std::uint32_t>(prepared.runs.size());
          run.ground_set = static_cast<std::uint32_t>(chosen.group) * members + member;
          prepared.runs.push_back(run);
        }
      }
    }
  }
}

void plan_runs(PreparedCampaign& prepared) {
  const Campaign& campaign = prepared.campaign;
  // Run numbers have eight digits in the results.
  constexpr double kMostRuns = 99'999'999.0;
  double per_block = 0.0;
  std::vector<std::vector<Vec3>> points;
  for (const ReleasePlan& release : campaign.releases) {
    points.push_back(local_points(campaign, release, *prepared.surface, prepared.header.frame));
    per_block += static_cast<double>(release.points.size()) *
                 static_cast<double>(release.orientations.size());
  }
  const double count =
      static_cast<double>(prepared.bodies.size()) * per_block * campaign.ensemble.members;
  if (count > kMostRuns) {
    throw InputError(campaign.file.string() + ": asks for " +
                     std::to_string(static_cast<std::uint64_t>(count)) +
                     " runs; split it into campaigns of at most 99999999");
  }
  for (std::uint32_t block = 0; block < prepared.bodies.size(); ++block) {
    plan_block(points, block, prepared);
  }
  CampaignResults& header = prepared.header;
  header.planned_runs = static_cast<std::uint32_t>(prepared.runs.size());
  for (std::size_t set = 0; set < campaign.releases.size(); ++set) {
    header.release_sets.push_back(campaign.releases[set].name);
    for (std::size_t i = 0; i < points[set].size(); ++i) {
      header.set_of_point.push_back(static_cast<std::uint32_t>(set));
    }
  }
  // Those of the first block's first orientation are the first with their point.
  for (const RunRecord& run : prepared.runs) {
    if (run.point == header.release_points.size()) {
      header.release_points.push_back(run.start.position);
    }
  }
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
  for (const ReleasePlan& release : campaign.releases) {
    for (const auto& file : release.files) header.inputs.push_back(with_digest(file));
  }
  header.program_version = version();
  for (std::size_t i = 0; i < prepared.bodies.size(); ++i) {
    const CampaignBlock& chosen = prepared.choice.blocks[i];
    header.blocks.push_back(summary_of(chosen, prepared.choice.library[chosen.library],
                                       prepared.bodies[i], campaign.groups));
  }
  for (const Block& block : prepared.choice.library) {
    header.shapes.push_back(rigid_body(block).shape);
  }
  const Vec2 origin = terrain.frame.origin.head<2>();
  for (Barrier barrier : campaign.barriers) {
    for (Vec2& point : barrier.through) point -= origin;
    header.barriers.push_back(barrier);
  }
  header.zone_names = terrain.zone_names;
  header.ground_sets = ground_sets(campaign, terrain.zone_names);
  header.ground = central_ground(campaign, terrain.zone_names);
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
  prepared.choice = choose_blocks(campaign);
  for (const CampaignBlock& block : prepared.choice.blocks) {
    prepared.bodies.push_back(
        scaled(rigid_body(prepared.choice.library[block.library]), block.scale));
  }
  prepared.header = header_of(prepared, read_terrain(campaign.terrain));
  CampaignResults& header = prepared.header;
  check_sizes(prepared);
  prepared.surface.emplace(terrain_surface(header.terrain, campaign.terrain_radius));

  plan_runs(prepared);
  check_falls(prepared);
  std::vector<std::string> warnings = settle_stiffness(prepared);
  header.warnings = campaign_warnings(prepared);
  header.warnings.insert(header.warnings.begin(), warnings.begin(), warnings.end());
  return prepared;
}

}  // namespace clast
