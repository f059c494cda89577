#include "terrain/detail/mending.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "core/error.hpp"

namespace clast::detail {
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

bool is_degenerate(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() >= kLeastHeight * longest) || longest == 0.0;
}

Vec3 centroid(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

/// A side of a triangle, as the edge it lies on.
struct Side {
  std::uint32_t low, high;  ///< vertices of the edge
  std::uint32_t triangle;
  bool forward;  ///< the triangle runs from low to high
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// Neighbours of every triangle over its edges, and whether both run the same way along the edge.
struct Neighbours {
  struct Link {
    std::uint32_t triangle = kNone;
    bool same_way = false;
  };
  std::vector<std::array<Link, 3>> links;
  std::size_t border_edges = 0;
};

Neighbours find_neighbours(const TriangleMesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  Neighbours result;
  result.links.resize(mesh.triangles.size());
  std::vector<std::uint8_t> used(mesh.triangles.size(), 0);
  std::size_t crowded = 0;
  Vec3 crowded_at = Vec3::Zero();
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
    for (end = begin + 1; end < sides.size() && sides[end].low == sides[begin].low &&
                          sides[end].high == sides[begin].high;) {
      ++end;
    }
    if (end - begin == 1) ++result.border_edges;
    if (end - begin > 2 && crowded++ == 0) {
      crowded_at = (mesh.vertices[sides[begin].low] + mesh.vertices[sides[begin].high]) / 2.0;
    }
    if (end - begin != 2) continue;
    const Side &one = sides[begin], &two = sides[begin + 1];
    const bool same_way = one.forward == two.forward;
    result.links[one.triangle][used[one.triangle]++] = {two.triangle, same_way};
    result.links[two.triangle][used[two.triangle]++] = {one.triangle, same_way};
  }
  if (crowded > 0) {
    throw GeometryError("the ground has " + std::to_string(crowded) +
                        " edges where more than two triangles meet, the first at " +
                        place(crowded_at) +
                        "; surfaces overlap or cross there, remove one of them");
  }
  return result;
}

}  // namespace

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
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool degenerate = is_degenerate(mesh, mesh.triangles[t]);
    if (degenerate) {
      ++report.dropped_degenerate;
    } else if (is_copy[t]) {
      ++report.dropped_duplicates;
    } else {
      mesh.triangles[count] = mesh.triangles[t];
      surface.source[count++] = surface.source[t];
    }
  }
  mesh.triangles.resize(count);
  surface.source.resize(count);
  if (count == 0) throw GeometryError(files[0] + ": no triangle has an area; there is no ground");
  drop_unused_vertices(mesh);
}

void orient_upwards(RawSurface& surface, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const Neighbours neighbours = find_neighbours(mesh);
  report.boundary_edges = neighbours.border_edges;

  enum : std::uint8_t { kUnseen, kKept, kTurned };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (state[seed] != kUnseen) continue;
    state[seed] = kKept;
    piece.assign(1, seed);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const Neighbours::Link& link : neighbours.links[piece[i]]) {
        if (link.triangle == kNone) continue;
        const bool turned = (state[piece[i]] == kTurned) != link.same_way;
        const std::uint8_t wanted = turned ? kTurned : kKept;
        if (state[link.triangle] == kUnseen) {
          state[link.triangle] = wanted;
          piece.push_back(link.triangle);
        } else if (state[link.triangle] != wanted) {
          throw GeometryError("the ground at " + place(centroid(mesh, link.triangle)) +
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
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (state[t] != kTurned) continue;
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++report.turned_triangles;
  }
}

}  // namespace clast::detail
