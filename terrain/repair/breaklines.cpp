#include "terrain/repair/breaklines.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/zones/zone_cut.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kSnap = 0.25;    // cells
constexpr double kOnLine = 2e-6;  // m: what cutting leaves between a vertex and the line
constexpr double kSameCrossingHeight = 1e-3;  // m: of two lines where they meet

struct Segment {
  Vec3 from, to;
  std::uint32_t line;
};

struct Foot {
  Vec3 point;
  double distance;  ///< in plan, m
};

Foot foot_on(const Segment& segment, const Vec2& at) {
  const Vec3 along = segment.to - segment.from;
  const double length = along.head<2>().squaredNorm();
  const double share =
      length > 0.0
          ? std::clamp((at - segment.from.head<2>()).dot(along.head<2>()) / length, 0.0, 1.0)
          : 0.0;
  const Vec3 point = segment.from + share * along;
  return {point, (point.head<2>() - at).norm()};
}

/// Breaklines in segments, found by place.
class Segments {
 public:
  /// @throws InputError  a line without heights
  explicit Segments(std::span<const MapLine> lines)
      : lines_(lines), segments_(segments_of(lines)), index_(boxes_of(segments_)) {}

  std::optional<Foot> nearest(const Vec2& at, double reach) const {
    std::optional<Foot> best;
    for (const std::uint32_t s : index_.boxes_near(PlanBox{at, at}.expanded(reach))) {
      const Foot foot = foot_on(segments_[s], at);
      if (foot.distance <= reach && (!best || foot.distance < best->distance)) best = foot;
    }
    return best;
  }

  /// @throws InputError  one that passes here at another height than `foot`
  void check_one_height(const Vec2& at, const Foot& foot) const {
    for (const std::uint32_t s : index_.boxes_near(PlanBox{at, at}.expanded(kOnLine))) {
      const Foot other = foot_on(segments_[s], at);
      if (other.distance <= kOnLine &&
          std::abs(other.point.z() - foot.point.z()) > kSameCrossingHeight) {
        throw InputError(lines_[segments_[s].line].name + ": breaklines meet at " +
                         format_map_point(foot.point) + " and at z " +
                         format_significant(other.point.z(), 9) +
                         "; give them the same height there, or move one of them");
      }
    }
  }

  std::vector<std::array<Vec2, 2>> in_plan() const {
    std::vector<std::array<Vec2, 2>> cuts;
    for (const Segment& s : segments_) cuts.push_back({s.from.head<2>(), s.to.head<2>()});
    return cuts;
  }

 private:
  static std::vector<Segment> segments_of(std::span<const MapLine> lines) {
    std::vector<Segment> segments;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      const MapLine& line = lines[i];
      if (!line.has_heights) {
        throw InputError(line.name + ": a breakline needs heights (x, y, z at every corner)");
      }
      for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
        segments.push_back({line.points[k], line.points[k + 1], i});
      }
    }
    return segments;
  }
  static std::vector<PlanBox> boxes_of(const std::vector<Segment>& segments) {
    std::vector<PlanBox> boxes;
    for (const Segment& segment : segments) {
      boxes.emplace_back();
      boxes.back().include(segment.from.head<2>());
      boxes.back().include(segment.to.head<2>());
    }
    return boxes;
  }

  std::span<const MapLine> lines_;
  std::vector<Segment> segments_;
  PlanIndex index_;
};

}  // namespace

void add_breaklines(RawSurface& surface, std::span<const MapLine> lines, double cell,
                    TerrainReport& report) {
  const Segments segments(lines);
  TriangleMesh& mesh = surface.mesh;
  for (Vec3& vertex : mesh.vertices) {
    const std::optional<Foot> foot = segments.nearest(vertex.head<2>(), kSnap * cell);
    if (foot) vertex = foot->point;
  }
  insert_edges_along_segments(mesh, segments.in_plan());
  std::size_t on_lines = 0;
  for (Vec3& vertex : mesh.vertices) {
    const Vec2 at = vertex.head<2>();
    const std::optional<Foot> foot = segments.nearest(at, kOnLine);
    if (!foot) continue;
    ++on_lines;
    segments.check_one_height(at, *foot);
    vertex.z() = foot->point.z();
  }
  if (on_lines == 0) {
    throw InputError(lines.front().name +
                     ": no breakline lies over the ground; convert both to one map system");
  }
  surface.source_file.resize(mesh.triangles.size(), 0);
  report.notes.push_back(std::to_string(lines.size()) + " breaklines run along edges, over " +
                         std::to_string(on_lines) + " vertices");
}

}  // namespace clast::terrain_detail
