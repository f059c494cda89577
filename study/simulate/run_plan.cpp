#include "study/simulate/run_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "study/campaign/named_seed.hpp"
#include "study/campaign/release_points.hpp"
#include "study/simulate/campaign_checks.hpp"
#include "study/simulate/detail/block_distribution.hpp"
#include "study/simulate/detail/measured_bodies.hpp"
#include "study/simulate/detail/member_settings.hpp"
#include "study/simulate/detail/multi_block_placement.hpp"
#include "study/simulate/detail/run_starts.hpp"

namespace clast::study_detail {

namespace {

// Points in the local frame, each over the terrain.
std::vector<Vec3> local_points(const Campaign& campaign, const ReleaseSet& release,
                               const TerrainSurface& surface, const MapFrame& frame) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < release.points.size(); ++i) {
    Vec3 map = release.points[i];
    // A plan position has no height of its own, and 0 can be far from the local origin.
    if (release.drop_height) map.z() = frame.origin.z();
    const Vec3 point = frame.to_local(map);
    if (!surface.covers(point.x(), point.y())) {
      const Vec3 low = frame.to_map(surface.extent().low);
      const Vec3 high = frame.to_map(surface.extent().high);
      const auto range = [&](int axis) {
        return format_decimals(low[axis], 3) + " to " + format_decimals(high[axis], 3);
      };
      const bool inside =
          map.x() > low.x() && map.x() < high.x() && map.y() > low.y() && map.y() < high.y();
      throw InputError(campaign.file.string() + ": " + format_release_set_name(release) +
                       "release point " + std::to_string(i + 1) + " at x " +
                       format_decimals(map.x(), 3) + ", y " + format_decimals(map.y(), 3) +
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
    // Vertices at the border of the terrain may be beyond it.
    if (const std::optional<double> ground = surface.height_at(point.x(), point.y(), sky)) {
      clearance = std::min(clearance, point.z() - body.shape.radius - *ground);
    }
  }
  if (std::isfinite(clearance)) state.position.z() += drop_height - clearance;
}

/// A height of fall is measured under core vertices: on a slope, or over an edge, a rounded block
/// can be in the ground all the same. It then starts in touch.
void clear_ground(const CampaignPlan& prepared, const GroundOverlapBody& measured,
                  const ReleaseSet& release, std::size_t point_of_set, RunRecord& run) {
  const TerrainSurface& surface = *prepared.surface;
  const std::optional<double> depth =
      find_depth_in_ground(measured.overlap, surface, measured.body, run.start);
  if (!depth) return;
  if (release.drop_height &&
      lift_to_touch_ground(measured.overlap, surface, measured.body, run.start)) {
    return;
  }
  const std::string table = release.name.empty() ? "[release]" : "[[release]] " + release.name;
  throw SimulationError(
      "run " + std::to_string(run.run) + ", block " + prepared.header.blocks[run.block].id + ", " +
      format_release_set_name(release) + "release point " + std::to_string(point_of_set + 1) +
      ", orientation " + std::to_string(run.orientation + 1) + ": starts " +
      format_decimals(*depth, 3) + " m inside the ground, with its centre at " +
      format_map_point(prepared.header.frame.to_map(run.start.position)) +
      (release.drop_height ? "; raise " + table + " height_m"
                           : "; raise the release point or use " + table + " height_m"));
}

/// Makes the runs of a campaign one by one.
class Planner {
 public:
  explicit Planner(CampaignPlan& prepared)
      : prepared_(prepared),
        settings_(sample_member_settings(prepared.campaign)),
        bodies_(*prepared.surface, prepared.bodies) {
    for (const ReleaseSet& release : prepared.campaign.releases) {
      points_.push_back(
          local_points(prepared.campaign, release, *prepared.surface, prepared.header.frame));
    }
  }

  const std::vector<std::vector<Vec3>>& points() const { return points_; }

  /// The release sets of a block, in order.
  void plan_block(std::uint32_t block) {
    const Campaign& campaign = prepared_.campaign;
    const CampaignBlock& chosen = prepared_.choice.blocks[block];
    const std::uint32_t members = campaign.ensemble.members;
    std::uint32_t point = 0;
    for (std::size_t set = 0; set < campaign.releases.size(); ++set) {
      const ReleaseSet& release = campaign.releases[set];
      for (std::size_t of_set = 0; of_set < points_[set].size(); ++of_set, ++point) {
        const std::vector<Quat> orientations =
            release.fresh_orientations
                ? sample_run_orientations(release, chosen.id, std::to_string(of_set),
                                          release.orientations.size())
                : release.orientations;
        for (std::uint32_t turn = 0; turn < orientations.size(); ++turn) {
          RunRecord run;
          for (std::uint32_t member = 0; member < members; ++member) {
            if (member < settings_.size()) {  // else it starts as the one before
              run = start_of(block, set, of_set, member, orientations[turn]);
              run.point = point;
              run.orientation = turn;
              clear(set, of_set, run);
            }
            run.ground_set = static_cast<std::uint32_t>(chosen.group) * members + member;
            add(run);
          }
        }
      }
    }
  }

  /// The run of this number among those that `plan_block` makes of all blocks.
  RunRecord planned_run(std::uint32_t number) {
    const Campaign& campaign = prepared_.campaign;
    std::size_t each = 0;  // of a block
    for (std::size_t set = 0; set < points_.size(); ++set) each += runs_of_set(set);
    const auto block = static_cast<std::uint32_t>(number / each);
    std::size_t rest = number % each, set = 0, point = 0;
    for (; rest >= runs_of_set(set); ++set) {
      rest -= runs_of_set(set);
      point += points_[set].size();
    }
    const ReleaseSet& release = campaign.releases[set];
    const std::size_t turns = release.orientations.size();
    const std::size_t member = rest % campaign.ensemble.members;
    const std::size_t turn = rest / campaign.ensemble.members % turns;
    const std::size_t of_set = rest / campaign.ensemble.members / turns;
    const CampaignBlock& chosen = prepared_.choice.blocks[block];
    const Quat orientation =
        release.fresh_orientations
            ? sample_run_orientations(release, chosen.id, std::to_string(of_set), turns)[turn]
            : release.orientations[turn];
    RunRecord run = start_of(block, set, of_set, member, orientation);
    run.run = number;
    run.point = static_cast<std::uint32_t>(point + of_set);
    run.orientation = static_cast<std::uint32_t>(turn);
    run.ground_set = static_cast<std::uint32_t>(chosen.group * campaign.ensemble.members + member);
    clear_ground(prepared_, bodies_.of(block), release, of_set, run);
    return run;
  }

  /// All blocks of a realisation of masses, in a drawn order or as they are in place, mass by mass.
  void plan_mass(std::uint32_t realisation) {
    const Campaign& campaign = prepared_.campaign;
    const std::string name = "realisation " + std::to_string(realisation);
    Random random(derive_seed(campaign.releases.front().seed, name));
    if (!mass_) mass_.emplace(prepared_);
    const std::vector<std::vector<std::uint32_t>> blocks =
        distribute_blocks(prepared_, order_of(realisation, random));
    std::vector<std::size_t> counts;
    for (const std::vector<std::uint32_t>& of_mass : blocks) counts.push_back(of_mass.size());
    mass_->begin(name, counts);
    for (std::size_t mass = 0; mass < blocks.size(); ++mass) {
      for (const std::uint32_t block : blocks[mass]) {
        RunRecord run;
        run.block = block;
        run.point = static_cast<std::uint32_t>(mass);
        run.start = mass_->place(mass, block, bodies_.of(block), random);
        run.ground_set = realisation % campaign.ensemble.members;
        add(run);
      }
    }
    const std::vector<MultiBlockStart> placed = mass_->placed();
    prepared_.masses.insert(prepared_.masses.end(), placed.begin(), placed.end());
  }

  /// The blocks of a realisation in the order of their release; points and orientations are drawn.
  void plan_realisation(std::uint32_t realisation) {
    const Campaign& campaign = prepared_.campaign;
    const ReleaseSet& release = campaign.releases.front();
    const std::string name = "realisation " + std::to_string(realisation);
    Random random(derive_seed(release.seed, name));
    for (const std::uint32_t block : order_of(realisation, random)) {
      const std::uint64_t point = random.uniform_index(points_.front().size());
      const std::uint64_t turn = random.uniform_index(release.orientations.size());
      const Quat orientation =
          release.fresh_orientations
              ? sample_run_orientations(release, prepared_.choice.blocks[block].id, name, 1).front()
              : release.orientations[turn];
      const std::uint32_t member = realisation % campaign.ensemble.members;
      RunRecord run = start_of(block, 0, point, member, orientation);
      run.point = static_cast<std::uint32_t>(point);
      run.orientation = release.fresh_orientations ? 0 : static_cast<std::uint32_t>(turn);
      run.ground_set = member;
      clear(0, point, run);
      add(run);
    }
  }

 private:
  std::vector<std::uint32_t> order_of(std::uint32_t realisation, Random& random) const {
    const std::uint32_t each = prepared_.header.persistent_blocks->blocks_per_realisation;
    std::vector<std::uint32_t> order(each);
    std::iota(order.begin(), order.end(), prepared_.campaign.blocks.draw ? realisation * each : 0);
    if (!prepared_.campaign.persistent_blocks->random_order) return order;
    for (std::size_t left = order.size(); left > 1; --left) {
      std::swap(order[left - 1], order[random.uniform_index(left)]);
    }
    return order;
  }

  RunRecord start_of(std::uint32_t block, std::size_t set, std::size_t of_set, std::size_t member,
                     const Quat& orientation) {
    const ReleaseStartSettings& start =
        settings_[std::min(member, settings_.size() - 1)].starts[set];
    const ReleaseSet& release = prepared_.campaign.releases[set];
    const Block& source = prepared_.choice.library[prepared_.choice.blocks[block].library];
    RunRecord run;
    run.block = block;
    run.start.position = points_[set][of_set];
    run.start.orientation = release.in_principal_frame
                                ? orientation
                                : (orientation * source.source_from_body().rotation).normalized();
    run.start.velocity = start.velocity;
    run.start.angular_velocity = start.angular_velocity;
    if (start.drop_height) {
      place_above_ground(*prepared_.surface, bodies_.of(block).body, *start.drop_height, run.start);
    }
    return run;
  }

  std::size_t runs_of_set(std::size_t set) const {
    return points_[set].size() * prepared_.campaign.releases[set].orientations.size() *
           prepared_.campaign.ensemble.members;
  }

  void clear(std::size_t set, std::size_t of_set, RunRecord& run) {
    run.run = static_cast<std::uint32_t>(prepared_.runs.size());
    clear_ground(prepared_, bodies_.of(run.block), prepared_.campaign.releases[set], of_set, run);
  }

  void add(RunRecord run) {
    run.run = static_cast<std::uint32_t>(prepared_.runs.size());
    prepared_.runs.push_back(run);
  }

  CampaignPlan& prepared_;
  std::vector<EnsembleMemberSettings> settings_;
  std::vector<std::vector<Vec3>> points_;  ///< of each release set, local frame
  GroundOverlapBodyCache bodies_;
  std::optional<MultiBlockPlacement> mass_;
};

/// Run numbers have eight digits in the results.
void check_count(const Campaign& campaign, std::size_t blocks) {
  constexpr double kMaxRuns = 99'999'999.0;
  double count = static_cast<double>(blocks);
  if (campaign.persistent_blocks) {
    if (!campaign.blocks.draw) count *= campaign.persistent_blocks->realisations;
  } else {
    double per_block = 0.0;
    for (const ReleaseSet& release : campaign.releases) {
      per_block += static_cast<double>(release.points.size()) *
                   static_cast<double>(release.orientations.size());
    }
    count *= per_block * campaign.ensemble.members;
  }
  if (count <= kMaxRuns) return;
  throw InputError(campaign.file.string() + ": asks for " +
                   std::to_string(static_cast<std::uint64_t>(count)) +
                   " runs; split it into campaigns of at most 99999999");
}

/// Mean start of all runs of a release point.
Vec3 mean_start(const std::vector<RunRecord>& runs, std::uint32_t point) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const RunRecord& run : runs) {
    if (run.point != point) continue;
    sum += run.start.position;
    count += 1.0;
  }
  return sum / count;
}

}  // namespace

void plan_runs(CampaignPlan& prepared) {
  const Campaign& campaign = prepared.campaign;
  CampaignHeader& header = prepared.header;
  check_count(campaign, prepared.bodies.size());
  Planner planner(prepared);
  if (campaign.persistent_blocks) {
    const std::size_t each = prepared.bodies.size() /
                             (campaign.blocks.draw ? campaign.persistent_blocks->realisations : 1);
    const bool at_once = !campaign.persistent_blocks->masses.empty();
    header.persistent_blocks = {static_cast<std::uint32_t>(each),
                                campaign.persistent_blocks->between_blocks, at_once};
    for (std::uint32_t i = 0; i < campaign.persistent_blocks->realisations; ++i) {
      at_once ? planner.plan_mass(i) : planner.plan_realisation(i);
    }
  } else {
    for (std::uint32_t i = 0; i < prepared.bodies.size(); ++i) planner.plan_block(i);
  }
  header.planned_runs = static_cast<std::uint32_t>(prepared.runs.size());
  for (std::size_t set = 0; set < campaign.releases.size(); ++set) {
    header.release_sets.push_back(campaign.releases[set].name);
    for (const Vec3& point : planner.points()[set]) {
      header.set_of_point.push_back(static_cast<std::uint32_t>(set));
      header.release_points.push_back(point);
    }
  }
  if (!prepared.masses.empty()) {
    // A mass counts as released from its middle.
    for (std::uint32_t mass = 0; mass < campaign.persistent_blocks->masses.size(); ++mass) {
      header.set_of_point.push_back(mass);
      header.release_points.push_back(mean_start(prepared.runs, mass));
    }
    return;
  }
  // Release points are the starts of their first runs; points without a run are unchanged.
  for (auto run = prepared.runs.rbegin(); run != prepared.runs.rend(); ++run) {
    header.release_points[run->point] = run->start.position;
  }
}

std::vector<RunRecord> plan_selected_runs(CampaignPlan& prepared,
                                          std::span<const std::uint32_t> numbers) {
  Planner planner(prepared);
  std::vector<RunRecord> runs;
  for (const std::uint32_t number : numbers) runs.push_back(planner.planned_run(number));
  return runs;
}

}  // namespace clast::study_detail
