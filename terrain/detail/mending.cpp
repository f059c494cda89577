#include "terrain/detail/mending.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/error.hpp"
#include "terrain/detail/fins.hpp"
#include "terrain/detail/triangle_links.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kWeldDistance = 1e-6;  // m
constexpr double kLeastHeight = 1e-9;   // m, of a triangle over its longest edge
constexpr double kWallShare = 1e-6;     // of plan area in area, under which a piece is a wall
constexpr std::uint32_t kNone = 0xffffffffu;

using Triangle = TriangleMesh::Triangle;

/// Points by the cube they are in, as chains in a table; only ever asked for the first point near
/// a place, so that the order of its chains can't show.
class PointTable {
 public:
  explicit PointTable(std::size_t count)
      : heads_(std::bit_ceil(2 * count + 1), kNone), next_(count, kNone) {}

  void add(std::uint32_t index, const Vec3& point) {
    std::uint32_t& head = heads_[slot(cube(point))];
    next_[index] = head;
    head = index;
  }

  /// The smallest index within the welding distance of `point`, or kNone.
  std::uint32_t nearest(const Vec3& point, const std::vector<Vec3>& points) const {
    const Cube low = cube(point - Vec3::Constant(kWeldDistance));
    const Cube high = cube(point + Vec3::Constant(kWeldDistance));
    std::uint32_t found = kNone;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          for (std::uint32_t i = heads_[slot({x, y, z})]; i != kNone; i = next_[i]) {
            if (i < found && (points[i] - point).squaredNorm() <= kWeldDistance * kWeldDistance) {
              found = i;
            }
          }
        }
      }
    }
    return found;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  static constexpr double kCube = 16.0 * kWeldDistance;  // a search mostly stays in one cube

  static Cube cube(const Vec3& point) {
    Cube result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[axis] =
          static_cast<std::int64_t>(std::floor(point[static_cast<Eigen::Index>(axis)] / kCube));
    }
    return result;
  }
  std::size_t slot(const Cube& cube) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : cube) {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
  }

  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
};

bool is_degenerate(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() >= kLeastHeight * longest) || longest == 0.0;
}

}  // namespace

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) number[corner] = 0;
  }
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    mesh.vertices[count] = mesh.vertices[v];
    number[v] = count++;
  }
  mesh.vertices.resize(count);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
}

void weld(RawSurface& surface, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  PointTable table(mesh.vertices.size());
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const std::uint32_t known = table.nearest(mesh.vertices[v], mesh.vertices);
    number[v] = known == kNone ? v : known;
    if (known == kNone) {
      table.add(v, mesh.vertices[v]);
    } else {
      ++report.welded_vertices;
    }
  }
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
}

void drop_useless_triangles(RawSurface& surface, const std::vector<std::string>& files,
                            const std::vector<std::uint16_t>& zone_of_file, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  // Copies lie side by side once sorted by their corners; the first one read is kept.
  std::vector<std::pair<Triangle, std::uint32_t>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> is_copy(mesh.triangles.size(), false);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    const std::uint32_t one = sorted[i - 1].second, two = sorted[i].second;
    is_copy[two] = true;
    const std::uint16_t file = surface.source[one], other = surface.source[two];
    if (zone_of_file[file] != zone_of_file[other] && !is_degenerate(mesh, mesh.triangles[one])) {
      throw GeometryError(files[file] + " and " + files[other] + " both hold the triangle at " +
                          place(centroid(mesh, one)) +
                          " under different zones; cut it out of one of them");
    }
  }
  std::size_t count = 0;
  Vec3 degenerate_at = Vec3::Zero(), copy_at = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool degenerate = is_degenerate(mesh, mesh.triangles[t]);
    if (degenerate) {
      if (report.dropped_degenerate++ == 0) degenerate_at = centroid(mesh, t);
    } else if (is_copy[t]) {
      if (report.dropped_duplicates++ == 0) copy_at = centroid(mesh, t);
    } else {
      mesh.triangles[count] = mesh.triangles[t];
      surface.source[count++] = surface.source[t];
    }
  }
  mesh.triangles.resize(count);
  surface.source.resize(count);
  if (count == 0) throw GeometryError(files[0] + ": no triangle has an area; there is no ground");
  const auto note = [&](std::size_t dropped, const std::string& what, const Vec3& at) {
    if (dropped == 0) return;
    report.notes.push_back(std::to_string(dropped) + what + " were dropped, the first at " +
                           place(at));
  };
  note(report.dropped_degenerate, " triangles without an area", degenerate_at);
  note(report.dropped_duplicates, " copies of triangles", copy_at);
  drop_unused_vertices(mesh);
}

void orient_upwards(RawSurface& surface, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  TriangleLinks links = triangle_links(mesh);
  if (links.crowded_edges > 0 && drop_fins(surface, links, report)) links = triangle_links(mesh);
  report.boundary_edges = links.border_edges;
  if (links.crowded_edges > 0) {
    throw GeometryError("the ground has " + std::to_string(links.crowded_edges) +
                        " edges where more than two triangles meet, the first at " +
                        place(links.crowded_at) +
                        "; surfaces overlap or cross there, remove one of them");
  }

  enum : std::uint8_t { kUnseen, kKept, kTurned };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (state[seed] != kUnseen) continue;
    state[seed] = kKept;
    piece.assign(1, seed);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Triangle& triangle = mesh.triangles[piece[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = links.across[piece[i]][k];
        if (other == kNoTriangle) continue;
        const Triangle& beside = mesh.triangles[other];
        const std::size_t side = side_between(beside, triangle[k], triangle[(k + 1) % 3]);
        const bool same_way = beside[side] == triangle[k];
        const std::uint8_t wanted = (state[piece[i]] == kTurned) != same_way ? kTurned : kKept;
        if (state[other] == kUnseen) {
          state[other] = wanted;
          piece.push_back(other);
        } else if (state[other] != wanted) {
          throw GeometryError("the ground at " + place(centroid(mesh, other)) +
                              " is twisted into itself and has no upper side; cut it there");
        }
      }
    }
    ++report.components;
    double plan = 0.0, area = 0.0;
    for (const std::uint32_t t : piece) {
      const Triangle& corners = mesh.triangles[t];
      const Vec3 a = mesh.vertices[corners[1]] - mesh.vertices[corners[0]];
      const Vec3 b = mesh.vertices[corners[2]] - mesh.vertices[corners[0]];
      const Vec3 normal = a.cross(b);
      plan += state[t] == kTurned ? -normal.z() : normal.z();
      area += normal.norm();
    }
    if (std::abs(plan) < kWallShare * area) {
      report.notes.push_back("a piece of " + std::to_string(piece.size()) + " triangles at " +
                             place(centroid(mesh, seed)) +
                             " stands upright and touches no other ground; which side is rock was "
                             "taken as in the file");
    } else if (plan < 0.0) {
      for (const std::uint32_t t : piece) state[t] = state[t] == kTurned ? kKept : kTurned;
    }
  }
  Vec3 first_turned = Vec3::Zero();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (state[t] != kTurned) continue;
    if (report.turned_triangles++ == 0) first_turned = centroid(mesh, t);
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  if (report.turned_triangles > 0) {
    report.notes.push_back(std::to_string(report.turned_triangles) +
                           " triangles faced into the ground and were turned, the first at " +
                           place(first_turned));
  }
}

}  // namespace clast::terrain_detail
