#include "study/simulate/campaign_checks.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_types.hpp"
#include "study/results/block_scale.hpp"
#include "terrain/terrain_fit.hpp"

namespace clast::study_detail {
namespace {

// Quaternions closer than this are one rotation.
constexpr double kSameRotation = 1e-9;
/// Maximum length of a block over that of the terrain.
constexpr double kMaxFraction = 0.1;

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

// Counts release points at the position of an earlier one of their set.
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
void tell_of_scales(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  if (prepared.campaign.blocks.draw) return;
  for (const BlockSummary& block : prepared.header.blocks) {
    if (block.scale == 1.0) continue;
    warnings.push_back(describe_block_scale(block));
  }
}

// A run of so many steps at a microsecond each would last minutes, and days.
constexpr double kManySteps = 1e9;
constexpr double kEndlessSteps = 1e12;

void tell_of_steps(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  const auto shortest = std::min_element(prepared.runs.begin(), prepared.runs.end(),
                                         [](const RunRecord& a, const RunRecord& b) {
                                           return a.stiffness.time_step < b.stiffness.time_step;
                                         });
  const double step = shortest->stiffness.time_step;
  const double steps = prepared.campaign.max_time / step;
  if (!(steps > kManySteps)) return;
  const std::string cost = "block " + prepared.header.blocks[shortest->block].id +
                           ": the time step of " + format_significant(step, 3) + " s makes up to " +
                           format_significant(steps, 2) + " steps of a run of " +
                           format_significant(prepared.campaign.max_time, 4) + " s";
  if (!(steps < kEndlessSteps)) {
    throw InputError(prepared.campaign.file.string() + ": " + cost +
                     ", which would take too long; give a softer [contact] stiffness_n_m, a longer "
                     "time_step_s or a shorter [run] max_time_s, or leave both to \"auto\"");
  }
  warnings.push_back(cost + "; runs will take long");
}

/// Above this e_n^2, single releases have their impacts balanced, and blocks that stay are refused.
constexpr double kMaxUnbalanced = 0.5;
/// Limit of e_n^2 above which an elastic trial is intended.
constexpr double kElastic = 0.95;

// Friction angles in degrees that stand where coefficients belong.
void tell_of_friction(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  constexpr double kSteepest = 5.0;  // 79 degrees; ground is known up to about 1.2
  for (std::size_t zone = 0; zone < prepared.header.ground.size(); ++zone) {
    const GroundParameters& ground = prepared.header.ground[zone];
    for (const auto& [key, value] : {std::pair("friction", ground.friction),
                                     std::pair("rolling_friction", ground.rolling_friction)}) {
      if (value <= kSteepest) continue;
      const std::string number = format_significant(value, 4);
      warnings.push_back("[ground." + prepared.header.zone_names[zone] + "] " + key + " = " +
                         number + " is a coefficient; that of an angle of " + number +
                         " degrees is its tangent");
    }
  }
}

/// A restitution of speeds, R_n, that stands where one of energy belongs.
void tell_of_restitution(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  double usual = 0.0;
  for (const GroundType& type : typical_ground_types()) {
    usual = std::max(usual, type.energy_restitution.high);
  }
  const auto question = [&](const std::string& table, double value) {
    if (!(value > usual) || value > kElastic) return;
    warnings.push_back(
        "[" + table + "] energy_restitution = " + format_significant(value, 4) +
        " is the fraction of energy that an impact returns, e_n^2; usual ground returns up to " +
        format_significant(usual, 2) +
        ". If it is a coefficient of restitution of velocity, R_n, give its " + "square, " +
        format_significant(value * value, 2));
  };
  const CampaignHeader& header = prepared.header;
  std::pair<double, std::string> largest{0.0, ""};
  if (header.persistent_blocks)
    largest = {header.persistent_blocks->between_blocks.energy_restitution, "contact.blocks"};
  for (std::size_t zone = 0; zone < header.ground.size(); ++zone) {
    double maximum = header.ground[zone].energy_restitution;
    for (const GroundParameterSet& set : header.ground_sets) {
      maximum = std::max(maximum, set.zones[zone].energy_restitution);
    }
    question("ground." + header.zone_names[zone], maximum);
    largest = std::max(largest, {maximum, "ground." + header.zone_names[zone]});
  }
  if (header.persistent_blocks && largest.first > kMaxUnbalanced) {
    throw InputError(prepared.campaign.file.string() + ": [" + largest.second +
                     "] energy_restitution = " + format_significant(largest.first, 4) +
                     " returns more than half of the energy of an impact; persistent blocks or "
                     "those of a rock mass could then gain energy (docs/theory.md, Weights and "
                     "energy). Give at most " +
                     format_significant(kMaxUnbalanced, 2) +
                     ", or release the blocks one at a time");
  }
  if (header.persistent_blocks)
    question("contact.blocks", header.persistent_blocks->between_blocks.energy_restitution);
}

void tell_of_releases(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  for (const ReleaseSet& release : prepared.campaign.releases) {
    const std::size_t repeated = repeated_points(release.points, release.drop_height.has_value());
    if (repeated > 0 && !release.fresh_orientations) {
      warnings.push_back(
          format_release_set_name(release) + std::to_string(repeated) + " of " +
          std::to_string(release.points.size()) +
          " release points repeat another; all are run, so the point counts more than once");
    }
    // Random sets have no duplicates.
    if (release.orientation_source == "random") continue;
    const std::size_t distinct = distinct_rotations(release.orientations);
    if (distinct == release.orientations.size()) continue;
    warnings.push_back(
        format_release_set_name(release) + release.orientation_source + ": " +
        std::to_string(release.orientations.size()) + " orientations, of which " +
        std::to_string(distinct) +
        " are different rotations; all are run, so repeated ones count more than once");
  }
}

/// Counts positions along a barrier where the ground falls to its right minus those where it rises.
int places_that_fall_forward(const Barrier& barrier, const TerrainSurface& surface) {
  constexpr int kPlaces = 20;  ///< on each segment
  const Bounds& ground = surface.extent();
  const double beside = 0.01 * (ground.high - ground.low).head<2>().norm(), top = ground.high.z();
  int forward = 0;
  for (std::size_t i = 0; i + 1 < barrier.vertices.size(); ++i) {
    const Vec2 along = barrier.vertices[i + 1] - barrier.vertices[i];
    const Vec2 left = beside * Vec2(-along.y(), along.x()).normalized();
    for (int k = 0; k < kPlaces; ++k) {
      const Vec2 place = barrier.vertices[i] + (k + 0.5) / kPlaces * along;
      const auto on_left = surface.height_at(place.x() + left.x(), place.y() + left.y(), top);
      const auto on_right = surface.height_at(place.x() - left.x(), place.y() - left.y(), top);
      if (on_left && on_right) forward += *on_left > *on_right ? 1 : -1;
    }
  }
  return forward;
}

void tell_of_barriers(const CampaignPlan& prepared, std::vector<std::string>& warnings) {
  const Bounds& ground = prepared.surface->extent();
  for (const Barrier& barrier : prepared.header.barriers) {
    Vec2 low = barrier.vertices.front(), high = low;
    for (const Vec2& point : barrier.vertices) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    if ((high.array() < ground.low.head<2>().array()).any() ||
        (low.array() > ground.high.head<2>().array()).any()) {
      warnings.push_back(
          "barrier " + barrier.name +
          " is outside the terrain, so no block can cross it; its points are x, y of the z-up map");
    } else if (barrier.counted == CountedDirection::kForward &&
               places_that_fall_forward(barrier, *prepared.surface) < 0) {
      warnings.push_back("barrier " + barrier.name +
                         " counts only crossings from the left of its line to the right, but the "
                         "ground falls the other way; swap its points, or leave direction out to "
                         "count both ways");
    }
  }
}

}  // namespace

std::string format_release_set_name(const ReleaseSet& release) {
  return release.name.empty() ? "" : "release set " + release.name + ", ";
}

std::string describe_unusual_size(const std::string& block, double length, double mass,
                                  double extent) {
  std::string usual;
  if (length > kMaxUsualLength) {
    usual = "blocks are no longer than " + format_significant(kMaxUsualLength, 3) + " m";
  } else if (mass > kMaxUsualMass) {
    usual = "blocks are no heavier than " + format_significant(kMaxUsualMass / 1000.0, 5) + " t";
  } else if (length > kMaxFraction * extent) {
    usual = "a block is no longer than a tenth of the terrain, which is " +
            format_significant(extent, 4) + " m across";
  } else {
    return "";
  }
  return block + " is " + format_significant(length, 3) + " m long and " +
         format_significant(mass / 1000.0, 3) + " t heavy; usually " + usual;
}

void check_block_sizes(const CampaignPlan& prepared) {
  if (prepared.campaign.blocks.any_size) return;
  const Bounds ground = bounds(prepared.header.terrain.surface);
  const double extent = (ground.high - ground.low).head<2>().maxCoeff();
  for (const BlockSummary& block : prepared.header.blocks) {
    const std::string problem = describe_unusual_size(block.id, block.axes.L, block.mass, extent);
    if (problem.empty()) continue;
    throw InputError(prepared.campaign.file.string() + ": [blocks] " + problem +
                     ": check scale and the units of scans and terrain, or set allow_any_size = "
                     "true");
  }
}

void check_fall_speeds(const CampaignPlan& prepared) {
  const double lowest = prepared.surface->extent().low.z();
  for (const RunRecord& run : prepared.runs) {
    const double height = std::max(0.0, run.start.position.z() - lowest);
    const double speed = std::sqrt(2.0 * prepared.campaign.gravity * height);
    if (!(speed > kMaxInitialSpeed)) continue;
    throw InputError(prepared.campaign.file.string() + ": release point " +
                     std::to_string(run.point + 1) + " is " + format_decimals(height, 3) +
                     " m above the lowest ground, where its blocks could arrive with " +
                     format_significant(speed, 4) +
                     " m/s; at most 1000 m/s make sense: check heights, units "
                     "and gravity_m_s2");
  }
}

std::vector<std::string> check_campaign_settings(const CampaignPlan& prepared) {
  std::vector<std::string> warnings;
  tell_of_scales(prepared, warnings);
  tell_of_steps(prepared, warnings);
  tell_of_friction(prepared, warnings);
  tell_of_restitution(prepared, warnings);
  tell_of_releases(prepared, warnings);
  tell_of_barriers(prepared, warnings);
  const auto warn = [&](const std::optional<std::string>& warning) {
    if (warning) warnings.push_back(*warning);
  };
  double smallest = 1e300, largest = 0.0;
  for (const BlockSummary& block : prepared.header.blocks) {
    smallest = std::min(smallest, block.axes.S);
    largest = std::max(largest, block.axes.S);
  }
  warn(edge_length_warning(prepared.header.terrain, smallest, largest));
  if (prepared.campaign.border_distance) {
    for (const ReleaseSet& release : prepared.campaign.releases) {
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

}  // namespace clast::study_detail
