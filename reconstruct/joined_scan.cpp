#include "reconstruct/joined_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/angle.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/detail/block_points.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/registration/joined_surface.hpp"
#include "reconstruct/registration/passes.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

std::string describe_fit(const Registration& fit, const std::vector<ScanToRegister>& scans,
                         const std::string& what) {
  std::string text = "joined from " + std::to_string(scans.size()) + " " + what;
  for (std::size_t s = 0; s < scans.size(); ++s) text += (s == 0 ? ": " : ", ") + scans[s].name;
  text += "; each overlaps the others by " + format_significant(100.0 * fit.overlap, 2) +
          " % or more, and their surfaces lie " + format_significant(fit.deviation, 2) +
          " m apart (root mean square; standard deviation of the points " +
          format_significant(fit.noise, 2) + " m)";
  if (fit.disagreeing_fraction > 0.0) {
    text += "; they disagree by " + format_significant(fit.disagreement, 2) + " m over " +
            format_significant(100.0 * fit.disagreeing_fraction, 2) + " % of the overlap";
  }
  return text;
}

/// Notes the estimated scales with their standard errors and 95 % intervals.
void note_scales(const Registration& fit, const std::vector<ScanToRegister>& scans,
                 std::vector<std::string>& notes) {
  constexpr double kNormal95 = 1.96;
  for (const FoundScale& found : fit.scales) {
    const double reach = kNormal95 * found.standard_error;
    notes.push_back("scale of " + scans[found.scan].name + " was estimated: its lengths times " +
                    format_significant(found.scale, 5) + " +- " +
                    format_significant(found.standard_error, 1) + " (95 % interval " +
                    format_significant(found.scale - reach, 5) + " to " +
                    format_significant(found.scale + reach, 5) + ") are metres");
  }
}

/// Distances of the scans at the vertices of the block.
std::vector<double> distances_at(const std::vector<Vec3>& vertices,
                                 const std::vector<JoinedPoints>& scans) {
  constexpr int kNear = 8;
  std::vector<Vec3> points;
  std::vector<double> distances;
  for (const JoinedPoints& scan : scans) {
    points.insert(points.end(), scan.points.begin(), scan.points.end());
    distances.insert(distances.end(), scan.distances.begin(), scan.distances.end());
  }
  const PointTree tree(points);
  std::vector<double> means;
  for (const Vec3& vertex : vertices) {
    double sum = 0.0, count = 0.0;
    for (const auto& near : tree.nearest_neighbours(vertex, kNear)) {
      if (!std::isfinite(distances[near.point])) continue;
      sum += std::abs(distances[near.point]);
      count += 1.0;
    }
    means.push_back(2.0 * count >= kNear ? sum / count : std::numeric_limits<double>::quiet_NaN());
  }
  return means;
}

/// Adds the two-sided 90 % intervals: fractions of the distances from the estimates to the bounds,
/// chosen on pairs of virtual scans.
void add_intervals(VolumeBracket& bounds, const Vec3& lengths) {
  constexpr double kVolumeFraction = 0.5, kSideFraction = 0.25;
  if (!bounds.upper_volume || !bounds.sides) return;
  const auto towards = [](const auto& estimate, const auto& bound, double fraction) {
    return estimate + fraction * (bound - estimate);
  };
  SizeIntervals intervals;
  const double volume = bounds.estimated_volume;
  intervals.lower_volume = towards(volume, bounds.lower_volume, kVolumeFraction);
  intervals.upper_volume = towards(volume, *bounds.upper_volume, kVolumeFraction);
  intervals.sides.lower = towards(lengths, bounds.sides->lower, kSideFraction);
  intervals.sides.upper = towards(lengths, bounds.sides->upper, kSideFraction);
  bounds.intervals = intervals;
}

/// Properties of one scan of which the passes are joined.
struct PassOrigin {
  std::optional<Plane> ground = {};  ///< ground on which the block lies
  Vec3 centre = Vec3::Zero();        ///< of the block
  bool is_found = false;             ///< true if the passes were found by their surfaces
};

/// Widens the uncertainty if passes that were found by their surfaces disagree even when they are
/// aligned, since points may have been attributed to the wrong pass.
void add_wrong_attribution(const Registration& fit, CloudSurface& surface,
                           std::vector<std::string>& notes) {
  // In 8 trials, passes of known sources disagreed over at most 0.018 of their overlap. In 5
  // trials, passes that were found disagreed over 0.045 or more, and volumes were off by up to 4 %.
  constexpr double kMostDisagreeing = 0.03;
  constexpr double kVolumePerDisagreement = 0.5;
  if (fit.disagreeing_fraction <= kMostDisagreeing) return;
  const double volume = kVolumePerDisagreement * fit.disagreement * surface_area(surface.mesh);
  surface.uncertainty.volume_below += volume;
  surface.uncertainty.volume_above += volume;
  surface.uncertainty.extent_error += fit.disagreement;
  notes.push_back(
      "points may have been attributed to the wrong pass, and the bounds are wider: the passes "
      "were found by their surfaces, and disagree even when they are aligned; sources or times of "
      "the points in a LAS file, or one file for each pass, would distinguish them");
}

/// Registers scans and makes a block of their points.
/// @param what  noun for the scans in the first note: "scans" or "passes of ..."
/// @param notes  notes on the scans
JoinedScan make_joined(const std::vector<ScanToRegister>& scans, const std::string& what,
                       std::vector<std::string> notes, const PassOrigin& origin,
                       const std::string& name, const FieldScanOptions& options,
                       const RegistrationOptions& registration) {
  JoinedScan joined;
  joined.registration =
      with_error_context(name, [&] { return register_scans(scans, registration); });
  const Registration& fit = joined.registration;
  JoinedSurface surface =
      with_error_context(name, [&] { return join_surfaces(scans, fit, options.surface); });
  notes.insert(notes.begin(), describe_fit(fit, scans, what));
  note_scales(fit, scans, notes);
  notes.insert(notes.end(), fit.notes.begin(), fit.notes.end());
  notes.insert(notes.end(), surface.notes.begin(), surface.notes.end());
  if (origin.is_found) add_wrong_attribution(fit, surface.cloud, notes);
  FieldScanOptions closing = options;
  closing.scan.unit = 1.0;
  closing.scan.up = "z";
  joined.block = close_block({.surface = std::move(surface.cloud.mesh),
                              .ground = origin.ground,
                              .centre = origin.centre,
                              .uncertainty = &surface.cloud.uncertainty,
                              .notes = std::move(notes)},
                             name, closing);
  if (joined.block.bounds) {
    add_intervals(*joined.block.bounds, smallest_box(joined.block.scan.mesh.vertices).lengths);
  }
  joined.scans = std::move(surface.scans);
  joined.distances = distances_at(joined.block.scan.mesh.vertices, joined.scans);
  return joined;
}

/// Notes how far the middle of each pass was moved, and by which angle it was rotated.
void note_movements(const std::vector<ScanToRegister>& passes, const Registration& fit,
                    std::vector<std::string>& notes) {
  for (std::size_t k = 1; k < passes.size(); ++k) {
    Bounds box;
    for (const Vec3& p : passes[k].points) box.include(p);
    const Vec3 middle = 0.5 * (box.low + box.high);
    const Vec3 shift = fit.first_from_scan[k] * middle - middle;
    const double angle = fit.first_from_scan[k].pose.rotation.angularDistance(Quat::Identity());
    notes.push_back(passes[k].name + " was moved by " + format_significant(shift.norm(), 2) +
                    " m, " + format_point(shift) + ", and rotated by " +
                    format_significant(angle * kDegreesPerRadian, 2) + " degrees");
  }
}

constexpr std::size_t kMostPasses = 8;
/// Least number of points of a pass, and least fraction of the points of the block.
constexpr std::size_t kFewestPassPoints = 200;
constexpr double kSmallestPass = 0.02;

/// Points of the passes that show enough of the block, the largest pass first.
std::vector<std::vector<std::uint32_t>> usable_passes(const std::vector<std::uint32_t>& passes,
                                                      std::vector<std::string>& notes) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_pass;
  for (std::uint32_t i = 0; i < passes.size(); ++i) by_pass[passes[i]].push_back(i);
  std::vector<std::vector<std::uint32_t>> sorted;
  for (auto& [pass, points] : by_pass) sorted.push_back(std::move(points));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  const auto least =
      std::max(kFewestPassPoints,
               static_cast<std::size_t>(kSmallestPass * static_cast<double>(passes.size())));
  std::size_t used = 0, left_out = 0;
  while (used < sorted.size() && used < kMostPasses && sorted[used].size() >= least) ++used;
  for (std::size_t k = used; k < sorted.size(); ++k) left_out += sorted[k].size();
  if (left_out > 0) {
    notes.push_back(format_count(left_out, "point") + " left out, of " +
                    format_count(sorted.size() - used, "pass", "passes") +
                    " with fewer points than those used");
  }
  sorted.resize(used);
  return sorted;
}

}  // namespace

JoinedScan join_scans(const std::vector<ScanToJoin>& scans, const std::string& name,
                      const FieldScanOptions& options, const RegistrationOptions& registration) {
  std::vector<ScanToRegister> to_register;
  std::vector<std::string> notes;
  for (const ScanToJoin& scan : scans) {
    FieldScanOptions own = options;
    own.scan = scan.scan;
    BlockPoints block = extract_block_points(scan.raw, scan.name, own, FootPoints::kRemoved);
    for (const std::string& note : block.notes) notes.push_back(scan.name + ": " + note);
    to_register.push_back({scan.name, std::move(block.points), block.ground});
  }
  return make_joined(to_register, "scans", std::move(notes), {}, name, options, registration);
}

std::optional<JoinedScan> align_passes(const ScanToJoin& scan,
                                       const std::vector<std::uint32_t>& passes,
                                       const std::string& name, const FieldScanOptions& options,
                                       const RegistrationOptions& registration) {
  FieldScanOptions own = options;
  own.scan = scan.scan;
  BlockPoints block = extract_block_points(scan.raw, scan.name, own, FootPoints::kKept);
  std::vector<std::uint32_t> of_point;
  if (!passes.empty()) {
    for (const std::uint32_t source : block.sources) of_point.push_back(passes[source]);
  } else {
    of_point = divide_into_passes(block.points, kMostPasses);
  }
  std::vector<std::string> notes = std::move(block.notes);
  const std::vector<std::vector<std::uint32_t>> used = usable_passes(of_point, notes);
  if (used.size() < 2) return {};
  std::vector<ScanToRegister> to_register;
  for (const std::vector<std::uint32_t>& points : used) {
    ScanToRegister one{"pass " + std::to_string(to_register.size() + 1), {}, {}};
    for (const std::uint32_t i : points) one.points.push_back(block.points[i]);
    to_register.push_back(std::move(one));
  }
  RegistrationOptions near = registration;
  near.nearly_aligned = true;
  JoinedScan joined =
      make_joined(to_register, "passes of " + scan.name, std::move(notes),
                  {block.ground, block.centre, passes.empty()}, name, options, near);
  note_movements(to_register, joined.registration, joined.block.scan.notes);
  return joined;
}

}  // namespace clast
