#include "tests/reconstruct/damage_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/repair/repair.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/damage.hpp"

namespace clast {

namespace {

double one_way(const TriangleMesh& from, const TriangleMesh& to) {
  const TriangleTree tree(to);
  double farthest = 0.0;
  std::uint32_t hint = 0;
  for (const Vec3& v : from.vertices) {
    const auto found = tree.closest_point(v, hint);
    hint = found.triangle;
    farthest = std::max(farthest, found.squared_distance);
  }
  return std::sqrt(farthest);
}

}  // namespace

double vertex_hausdorff(const TriangleMesh& a, const TriangleMesh& b) {
  return std::max(one_way(a, b), one_way(b, a));
}

Trial mend_damaged(const TriangleMesh& rock, double intensity, std::uint64_t seed) {
  const DamagedRock dirty = damaged(rock, Damage::of_intensity(intensity), seed);
  Trial trial;
  trial.largest_hole = dirty.largest_hole;
  trial.lost_share = dirty.lost_share;
  try {
    const RepairedMesh repaired = repair_mesh(dirty.mesh);
    const MeshReport report = inspect_mesh(repaired.mesh);
    const double volume = enclosed_volume(repaired.mesh);
    trial.valid = report.is_closed() && report.is_oriented() && report.pinched_vertices == 0 &&
                  report.components == 1 && volume > 0.0 &&
                  find_self_intersections(repaired.mesh).empty();
    trial.volume_error = volume / enclosed_volume(rock) - 1.0;
    trial.hausdorff = vertex_hausdorff(rock, repaired.mesh);
    trial.filled_fraction = repaired.report.filled_fraction;
  } catch (const GeometryError& error) {
    trial.refusal = error.what();
  }
  return trial;
}

std::string table_line(const std::string& name, const std::vector<Trial>& trials) {
  std::size_t valid = 0;
  double volume = 0.0, distance = 0.0, ratio = 0.0, lost = 0.0;
  for (const Trial& trial : trials) {
    valid += trial.valid;
    volume = std::max(volume, std::abs(trial.volume_error));
    distance = std::max(distance, trial.hausdorff);
    ratio = std::max(ratio, trial.hausdorff / trial.largest_hole);
    lost = std::max(lost, trial.lost_share);
  }
  char line[200];
  std::snprintf(line, sizeof line,
                "%-28s %4zu trials %4zu valid  |dV| <= %.3f %%  H <= %.4f m = %.2f hole radii  "
                "area lost <= %.1f %%",
                name.c_str(), trials.size(), valid, 100.0 * volume, distance, ratio, 100.0 * lost);
  return line;
}

}  // namespace clast
