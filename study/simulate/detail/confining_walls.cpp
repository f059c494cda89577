#include "study/simulate/detail/confining_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/motion/box_body.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast::study_detail {
namespace {

/// Places along a side at which the ground is looked for.
constexpr int kGroundSamples = 65;
/// Density of fixed bodies, which has no effect but must not be 0, kg/m^3.
constexpr double kDensity = 1000.0;

/// A heap at its start and the outline around it.
struct Heap {
  std::vector<Vec2> outline;       ///< local frame, as given, no corner twice
  double sense = 1.0;              ///< 1 where it goes round to the left, else -1
  std::size_t first = 0, end = 0;  ///< of the runs
  double thickness = 0.0;          ///< of the faces: no block is larger, m
  double low = 0.0, high = 0.0;    ///< of the faces, m

  Vec2 corner(std::size_t i) const { return outline[i % outline.size()]; }
  Vec2 along(std::size_t side) const { return (corner(side + 1) - corner(side)).normalized(); }
  Vec2 outwards(std::size_t side) const {
    const Vec2 way = along(side);
    return sense * Vec2(way.y(), -way.x());
  }
};

std::vector<Vec2> local_outline(const MultiBlockRelease& mass, const Vec3& origin) {
  std::vector<Vec2> outline;
  for (const Vec2& corner : mass.polygon) {
    const Vec2 local = corner - origin.head<2>();
    if (outline.empty() || local != outline.back()) outline.push_back(local);
  }
  if (outline.front() == outline.back()) outline.pop_back();
  return outline;
}

double lowest_ground(const Heap& heap, const TerrainSurface& ground) {
  double lowest = std::numeric_limits<double>::infinity();
  const double sky = ground.extent().high.z() + ground.radius() + 1.0;
  for (std::size_t side = 0; side < heap.outline.size(); ++side) {
    for (int i = 0; i < kGroundSamples; ++i) {
      const double share = i / (kGroundSamples - 1.0);
      const Vec2 place = (1.0 - share) * heap.corner(side) + share * heap.corner(side + 1);
      const std::optional<double> here = ground.height_at(place.x(), place.y(), sky);
      if (here) lowest = std::min(lowest, *here);
    }
  }
  return lowest;
}

Heap heap_of(const CampaignPlan& prepared, std::span<const RunRecord> runs, std::uint32_t mass) {
  Heap heap;
  heap.outline = local_outline(prepared.campaign.persistent_blocks->masses[mass],
                               prepared.header.frame.origin);
  heap.sense = signed_area(heap.outline) < 0.0 ? -1.0 : 1.0;
  const auto is_of_mass = [&](const RunRecord& run) { return run.point == mass; };
  const auto first = std::find_if(runs.begin(), runs.end(), is_of_mass);
  const auto end = std::find_if_not(first, runs.end(), is_of_mass);
  heap.first = static_cast<std::size_t>(first - runs.begin());
  heap.end = static_cast<std::size_t>(end - runs.begin());
  heap.low = std::numeric_limits<double>::infinity();
  heap.high = -heap.low;
  for (const RunRecord& run : runs.subspan(heap.first, heap.end - heap.first)) {
    const double radius = prepared.bodies[run.block].bounding_radius();
    heap.thickness = std::max(heap.thickness, 2.0 * radius);
    heap.low = std::min(heap.low, run.start.position.z() - radius);
    heap.high = std::max(heap.high, run.start.position.z() + radius);
  }
  heap.low = std::min(heap.low, lowest_ground(heap, *prepared.surface)) - heap.thickness;
  heap.high += heap.thickness;
  return heap;
}

/// Largest protrusion of blocks over a side of the outline, m; 0 if there is none.
double reach_over(const CampaignPlan& prepared, std::span<const RunRecord> runs, const Heap& heap,
                  std::size_t side) {
  const Vec2 outwards = heap.outwards(side);
  double reach = 0.0;
  for (const RunRecord& run : runs.subspan(heap.first, heap.end - heap.first)) {
    const SpheroPolyhedron shape = prepared.bodies[run.block].shape;
    const Pose place = run.start.world_from_body();
    for (const Vec3& vertex : shape.vertices) {
      const Vec2 point = (place * vertex).head<2>();
      reach = std::max(reach, outwards.dot(point - heap.corner(side)) + shape.radius);
    }
  }
  return reach;
}

/// Length by which a face extends beyond a corner to meet the next one, m.
/// @param reach  that no face is farther out
double beyond_corner(const Heap& heap, std::size_t corner, double reach) {
  const std::size_t sides = heap.outline.size();
  const Vec2 in = heap.along((corner + sides - 1) % sides), out = heap.along(corner);
  // Tangent of half the angle by which the outline turns there.
  const double turn =
      std::sqrt(std::max(0.0, 1.0 - in.dot(out)) / std::max(1e-12, 1.0 + in.dot(out)));
  return heap.thickness + 2.0 * reach * turn;
}

void add_faces(const CampaignPlan& prepared, std::span<const RunRecord> runs, std::uint32_t mass,
               ConfiningWalls& faces) {
  const Heap heap = heap_of(prepared, runs, mass);
  const MultiBlockRelease& plan = prepared.campaign.persistent_blocks->masses[mass];
  std::vector<double> reaches;
  for (std::size_t side = 0; side < heap.outline.size(); ++side) {
    reaches.push_back(reach_over(prepared, runs, heap, side));
  }
  const double reach = *std::max_element(reaches.begin(), reaches.end());
  for (std::size_t side = 0; side < heap.outline.size(); ++side) {
    const Vec2 way = heap.along(side), outwards = heap.outwards(side);
    const Vec2 from = heap.corner(side) - beyond_corner(heap, side, reach) * way;
    const Vec2 to =
        heap.corner(side + 1) + beyond_corner(heap, (side + 1) % heap.outline.size(), reach) * way;
    const Vec2 middle = 0.5 * (from + to) + (reaches[side] + 0.5 * heap.thickness) * outwards;
    ConfiningWall wall;
    wall.shape = faces.shapes.size();
    wall.pose.position = {middle.x(), middle.y(), 0.5 * (heap.low + heap.high)};
    wall.pose.orientation =
        Quat(Eigen::AngleAxisd(std::atan2(-outwards.y(), -outwards.x()), Vec3::UnitZ()));
    wall.first = heap.first;
    wall.end = heap.end;
    wall.removed_at = plan.release_time + static_cast<double>(side) * plan.face_interval;
    faces.confining_walls.push_back(wall);
    const Vec3 sides(heap.thickness, (to - from).norm(), heap.high - heap.low);
    faces.shapes.push_back(make_box_body(sides, 0.0, kDensity * sides.prod()));
  }
}

}  // namespace

ConfiningWalls build_confining_walls(const CampaignPlan& prepared,
                                     std::span<const RunRecord> runs) {
  ConfiningWalls faces;
  const std::vector<MultiBlockRelease>& masses = prepared.campaign.persistent_blocks->masses;
  for (std::uint32_t mass = 0; mass < masses.size(); ++mass) {
    if (masses[mass].settle) add_faces(prepared, runs, mass, faces);
  }
  return faces;
}

}  // namespace clast::study_detail
