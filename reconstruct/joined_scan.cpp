#include "reconstruct/joined_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/detail/block_points.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/registration/joined_surface.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

std::string describe_fit(const Registration& fit, const std::vector<ScanToJoin>& scans) {
  std::string text = "joined from " + std::to_string(scans.size()) + " scans";
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

}  // namespace

JoinedScan join_scans(const std::vector<ScanToJoin>& scans, const std::string& name,
                      const FieldScanOptions& options, const RegistrationOptions& registration) {
  std::vector<ScanToRegister> to_register;
  std::vector<std::string> notes;
  for (const ScanToJoin& scan : scans) {
    FieldScanOptions own = options;
    own.scan = scan.scan;
    BlockPoints block = extract_block_points(scan.raw, scan.name, own);
    for (const std::string& note : block.notes) notes.push_back(scan.name + ": " + note);
    to_register.push_back({scan.name, std::move(block.points), block.ground});
  }
  JoinedScan joined;
  joined.registration =
      with_error_context(name, [&] { return register_scans(to_register, registration); });
  const Registration& fit = joined.registration;
  JoinedSurface surface =
      with_error_context(name, [&] { return join_surfaces(to_register, fit, options.surface); });
  notes.insert(notes.begin(), describe_fit(fit, scans));
  notes.insert(notes.end(), fit.notes.begin(), fit.notes.end());
  notes.insert(notes.end(), surface.notes.begin(), surface.notes.end());
  FieldScanOptions closing = options;
  closing.scan.unit = 1.0;
  closing.scan.up = "z";
  joined.block = close_block({.surface = std::move(surface.cloud.mesh),
                              .uncertainty = &surface.cloud.uncertainty,
                              .notes = std::move(notes)},
                             name, closing);
  joined.scans = std::move(surface.scans);
  joined.distances = distances_at(joined.block.scan.mesh.vertices, joined.scans);
  return joined;
}

}  // namespace clast
