#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "classify/schemes.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "dem/ground_gap.hpp"
#include "study/campaign_runner.hpp"
#include "study/ground_sets.hpp"
#include "study/release_points.hpp"
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

// "release set cliff, " where there are several.
std::string set_name(const ReleasePlan& release) {
  return release.name.empty() ? "" : "release set " + release.name + ", ";
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
      const bool inside =
          map.x() > low.x() && map.x() < high.x() && map.y() > low.y() && map.y() < high.y();
      throw InputError(campaign.file.string() + ": " + set_name(release) + "release point " +
                       std::to_string(i + 1) + " at x " + metres(map.x()) + ", y " +
                       metres(map.y()) +
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
std::optional<double> depth_in_ground(const GroundGap& ground_gap, const TerrainSurface& surface,
                                      const RigidBody& body, const RigidState& state) {
  const double overlap = ground_gap.overlap(state);
  // What the dynamics will refuse.
  if (overlap > ReleaseSettings{}.start_overlap * body.smallest_side) return overlap;
  // A block that is buried whole touches no face of the ground.
  const Vec3& centre = state.position;
  const double abyss = surface.extent().low.z() - 1.0;
  const std::optional<double> ground = surface.height(centre.x(), centre.y(), abyss);
  if (ground && centre.z() < *ground) return *ground - lowest_point(body, state);
  return std::nullopt;
}

void check_clear_of_ground(const PreparedCampaign& prepared, const GroundGap& ground_gap,
                           const ReleasePlan& release, std::size_t point_of_set,
                           const RunRecord& run) {
  const std::optional<double> depth =
      depth_in_ground(ground_gap, *prepared.surface, prepared.bodies[run.block], run.start);
  if (!depth) return;
  const std::string table = release.name.empty() ? "[release]" : "[[release]] " + release.name;
  throw SimulationError(
      "run " + std::to_string(run.run) + ", block " + prepared.header.blocks[run.block].id + ", " +
      set_name(release) + "release point " + std::to_string(point_of_set + 1) + ", orientation " +
      std::to_string(run.orientation + 1) + ": starts " + metres(*depth) +
      " m inside the ground, with its centre at " +
      place(prepared.header.frame.map(run.start.position)) +
      (release.drop_height ? "; raise " + table + " height_m"
                           : "; raise the release point or use " + table + " height_m"));
}

// Random orientations of one block at one point, independent of all others.
std::vector<Quat> fresh_orientations(const ReleasePlan& release, std::uint32_t block,
                                     std::uint32_t point) {
  // Two rounds, so that neighbouring numbers begin unrelated sequences.
  const std::uint64_t by_block = Random(release.orientation_seed + block).next_bits();
  return random_orientations(release.orientations.size(), Random(by_block + point).next_bits());
}

// The release sets of a block, in order; `run` counts over the whole campaign.
void plan_block(const std::vector<std::vector<Vec3>>& points, std::uint32_t block,
                PreparedCampaign& prepared) {
  const Campaign& campaign = prepared.campaign;
  const CampaignBlock& chosen = prepared.choice.blocks[block];
  const Quat source_from_body = prepared.choice.library[chosen.library].source_from_body().rotation;
  const std::uint32_t members = campaign.ensemble.members;
  const GroundGap ground_gap(*prepared.surface, prepared.bodies[block]);
  std::uint32_t point = 0;
  for (std::size_t set = 0; set < campaign.releases.size(); ++set) {
    const ReleasePlan& release = campaign.releases[set];
    for (std::size_t of_set = 0; of_set < points[set].size(); ++of_set, ++point) {
      const std::vector<Quat> orientations = release.fresh_orientations
                                                 ? fresh_orientations(release, block, point)
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
        check_clear_of_ground(prepared, ground_gap, release, of_set, run);
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

// A fall that ends faster than this, m/s, is of wrong heights or gravity, and its time step so
// short that the run would never end.
constexpr double kMostSpeed = 1000.0;

void check_falls(const PreparedCampaign& prepared) {
  const double lowest = prepared.surface->extent().low.z();
  for (const RunRecord& run : prepared.runs) {
    const double height = std::max(0.0, run.start.position.z() - lowest);
    const double speed = std::sqrt(2.0 * prepared.campaign.gravity * height);
    if (!(speed > kMostSpeed)) continue;
    throw InputError(prepared.campaign.file.string() + ": release point " +
                     std::to_string(run.point + 1) + " is " + metres(height) +
                     " m above the lowest ground, where its blocks could arrive with " +
                     metres(speed) +
                     " m/s; at most 1000 m/s make sense: check heights, units "
                     "and gravity_m_s2");
  }
}

// No block can be faster: all energy of its start, and the fall to the lowest ground, in its speed.
double fastest_speed(const PreparedCampaign& prepared) {
  const double lowest = prepared.surface->extent().low.z();
  double spin = 0.0, fastest = 0.0;
  for (const RigidBody& body : prepared.bodies) {
    spin = std::max(spin, body.moments.maxCoeff() / body.mass);
  }
  for (const RunRecord& run : prepared.runs) {
    const double fall = std::max(0.0, run.start.position.z() - lowest);
    fastest = std::max(fastest, run.start.velocity.squaredNorm() +
                                    spin * run.start.angular_velocity.squaredNorm() +
                                    2.0 * prepared.campaign.gravity * fall);
  }
  return std::sqrt(fastest);
}

// Rotations that are the same have the same |w|, so each is compared with its neighbours in that
// order only: a file can hold a million.
std::size_t distinct_rotations(std::vector<Quat> orientations) {
  std::stable_sort(orientations.begin(), orientations.end(),
                   [](const Quat& a, const Quat& b) { return std::abs(a.w()) < std::abs(b.w()); });
  std::vector<Quat> distinct;
  for (const Quat& orientation : orientations) {
    bool known = false;
    for (auto other = distinct.rbegin(); !known && other != distinct.rend(); ++other) {
      if (std::abs(orientation.w()) - std::abs(other->w()) > kSameRotation) break;
      known = std::min((orientation.coeffs() - other->coeffs()).norm(),
                       (orientation.coeffs() + other->coeffs()).norm()) < kSameRotation;
    }
    if (!known) distinct.push_back(orientation);
  }
  return distinct.size();
}

// How many release points lie where an earlier one of their set lies.
std::size_t repeated_points(std::vector<Vec3> points, bool plan_only) {
  for (Vec3& point : points) {
    if (plan_only) point.z() = 0.0;
  }
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return static_cast<std::size_t>(points.end() - std::unique(points.begin(), points.end()));
}

// Blocks at another size than the library's, in words; drawn ones are too many.
void tell_of_scales(const PreparedCampaign& prepared, std::vector<std::string>& warnings) {
  if (prepared.campaign.blocks.draw) return;
  for (const BlockSummary& block : prepared.header.blocks) {
    if (block.scale == 1.0) continue;
    warnings.push_back("block " + block.id + " is scaled by " + metres(block.scale) + " to " +
                       metres(block.mass) + " kg");
  }
}

// A run of so many steps at a microsecond each would last minutes, and days.
constexpr double kManySteps = 1e9;
constexpr double kEndlessSteps = 1e12;

void tell_of_steps(const PreparedCampaign& prepared, std::vector<std::string>& warnings) {
  const double step = prepared.stiffness.stiffness.time_step;
  const double steps = prepared.campaign.max_time / step;
  if (!(steps > kManySteps)) return;
  const std::string told = "the time step of " + with_digits(step, 3) + " s makes up to " +
                           with_digits(steps, 2) + " steps of a run of " +
                           with_digits(prepared.campaign.max_time, 4) + " s";
  if (!(steps < kEndlessSteps)) {
    throw InputError(prepared.campaign.file.string() + ": " + told +
                     ", which would not end; give a softer [contact] stiffness_n_m, a longer "
                     "time_step_s or a shorter [run] max_time_s, or leave both to \"auto\"");
  }
  warnings.push_back(told + "; runs will take long");
}

// Friction angles in degrees that stand where coefficients belong.
void tell_of_friction(const PreparedCampaign& prepared, std::vector<std::string>& warnings) {
  constexpr double kSteepest = 5.0;  // 79 degrees; ground is known up to about 1.2
  for (std::size_t zone = 0; zone < prepared.header.ground.size(); ++zone) {
    const GroundParameters& ground = prepared.header.ground[zone];
    for (const auto& [key, value] : {std::pair("friction", ground.friction),
                                     std::pair("rolling_friction", ground.rolling_friction)}) {
      if (value <= kSteepest) continue;
      const std::string number = with_digits(value, 4);
      warnings.push_back("[ground." + prepared.header.zone_names[zone] + "] " + key + " = " +
                         number + " is a coefficient; the one of an angle of " + number +
                         " degrees is its tangent");
    }
  }
}

std::vector<std::string> warnings_of(const PreparedCampaign& prepared) {
  std::vector<std::string> warnings = prepared.stiffness.warnings;
  tell_of_scales(prepared, warnings);
  tell_of_steps(prepared, warnings);
  tell_of_friction(prepared, warnings);
  for (const ReleasePlan& release : prepared.campaign.releases) {
    const std::size_t repeated = repeated_points(release.points, release.drop_height.has_value());
    if (repeated > 0 && !release.fresh_orientations) {
      warnings.push_back(set_name(release) + std::to_string(repeated) + " of " +
                         std::to_string(release.points.size()) +
                         " release points repeat another; all are run, so they count more than "
                         "once");
    }
    // Random sets have no duplicates, and comparing each with each would take long for large ones.
    if (release.orientation_source == "random") continue;
    const std::size_t distinct = distinct_rotations(release.orientations);
    if (distinct == release.orientations.size()) continue;
    warnings.push_back(
        set_name(release) + release.orientation_source + ": " +
        std::to_string(release.orientations.size()) + " orientations, of which " +
        std::to_string(distinct) +
        " are different rotations; all are run, so repeated ones count more than once");
  }
  const Bounds& ground = prepared.surface->extent();
  for (const Barrier& barrier : prepared.header.barriers) {
    Vec2 low = barrier.through.front(), high = low;
    for (const Vec2& point : barrier.through) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    if ((high.array() < ground.low.head<2>().array()).any() ||
        (low.array() > ground.high.head<2>().array()).any()) {
      warnings.push_back("barrier " + barrier.name +
                         " lies off the terrain, so nothing can cross it; its points are x, y of "
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
    for (const ReleasePlan& release : prepared.campaign.releases) {
      warn(border_warning(prepared.header.terrain, release.points,
                          *prepared.campaign.border_distance));
    }
  }
  for (const Block& block : prepared.choice.library) {
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
  prepared.surface.emplace(terrain_surface(header.terrain, campaign.terrain_radius));

  plan_runs(prepared);
  check_falls(prepared);
  std::vector<GroundParameters> all_ground;
  for (const GroundSet& set : header.ground_sets) {
    all_ground.insert(all_ground.end(), set.zones.begin(), set.zones.end());
  }
  prepared.stiffness = choose_stiffness(prepared.bodies, all_ground, fastest_speed(prepared),
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
