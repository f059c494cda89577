#include "terrain/repair/surface_holes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"

namespace clast::terrain_detail {
namespace {

using Triangle = TriangleMesh::Triangle;

constexpr double kMinLeft = 1e-9;   // of the area that is left to fill
constexpr double kSteepLoop = 0.2;  // cosine to the vertical: steeper than 78 degrees

/// Vertices of a hole in the order of the border sides around it; side k is from vertex k.
struct Loop {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> triangles;  ///< behind every side
  Vec3 area = Vec3::Zero();              ///< vector of the loop, twice
  double length = 0.0;                   ///< around, m
  Vec3 normal = Vec3::Zero();            ///< mean of the triangles behind it, not unit
  Bounds box;
};

struct Side {
  std::uint32_t triangle;
  std::size_t side;
};

/// The border side that leaves the end of a border side, around the fan of triangles there.
std::optional<Side> next_side(const TriangleMesh& mesh, const TriangleNeighbours& links, Side at) {
  const std::uint32_t end = mesh.triangles[at.triangle][(at.side + 1) % 3];
  Side next{at.triangle, (at.side + 1) % 3};
  // Around a vertex there are no more triangles than in all.
  for (std::size_t steps = 0; steps <= mesh.triangles.size(); ++steps) {
    const std::uint32_t other = links.neighbour[next.triangle][next.side];
    if (other == kNoIndex) return next;
    const Triangle& corners = mesh.triangles[other];
    const std::size_t k =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), end) - corners.begin());
    if (k == 3) return std::nullopt;
    next = {other, k};
  }
  return std::nullopt;
}

/// The part of a path from `begin` on, taken off it.
Loop cut_off(Loop& path, std::size_t begin, std::vector<std::uint32_t>& place_on_path) {
  Loop loop;
  const auto first = static_cast<std::ptrdiff_t>(begin);
  loop.vertices.assign(path.vertices.begin() + first, path.vertices.end());
  loop.triangles.assign(path.triangles.begin() + first, path.triangles.end());
  path.vertices.resize(begin);
  path.triangles.resize(begin);
  for (const std::uint32_t vertex : loop.vertices) place_on_path[vertex] = kNoIndex;
  return loop;
}

void measure(const TriangleMesh& mesh, Loop& loop) {
  const Vec3& origin = mesh.vertices[loop.vertices[0]];
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Vec3 a = mesh.vertices[loop.vertices[i]] - origin;
    const Vec3 b = mesh.vertices[loop.vertices[(i + 1) % loop.vertices.size()]] - origin;
    loop.area += a.cross(b);
    loop.length += (b - a).norm();
    loop.normal +=
        (b - a).norm() * doubled_area_vector(mesh, mesh.triangles[loop.triangles[i]]).normalized();
    loop.box.include(a + origin);
  }
}

std::vector<Loop> border_loops(const TriangleMesh& mesh, const TriangleNeighbours& links) {
  std::vector<Loop> loops;
  std::vector<std::uint8_t> seen(mesh.triangles.size(), 0);  // a bit per side
  std::vector<std::uint32_t> place_on_path(mesh.vertices.size(), kNoIndex);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!links.is_border_side(t, k) || (seen[t] >> k & 1)) continue;
      // Loops that touch in a vertex are taken apart there.
      Loop path;
      std::optional<Side> at = Side{t, k};
      while (at && !(seen[at->triangle] >> at->side & 1)) {
        seen[at->triangle] |= static_cast<std::uint8_t>(1u << at->side);
        const std::uint32_t vertex = mesh.triangles[at->triangle][at->side];
        if (place_on_path[vertex] != kNoIndex) {
          loops.push_back(cut_off(path, place_on_path[vertex], place_on_path));
        }
        place_on_path[vertex] = static_cast<std::uint32_t>(path.vertices.size());
        path.vertices.push_back(vertex);
        path.triangles.push_back(at->triangle);
        at = next_side(mesh, links, *at);
      }
      Loop rest = cut_off(path, 0, place_on_path);
      if (at) loops.push_back(std::move(rest));
    }
  }
  for (Loop& loop : loops) measure(mesh, loop);
  return loops;
}

/// Loops that run the other way round than an outer border. Of upright loops and of slits, whose
/// sides may overlap, either way may be the hole's: they are holes where their component has a
/// larger loop, which is then the outer one.
std::vector<bool> which_are_holes(const TriangleNeighbours& links, const std::vector<Loop>& loops,
                                  double slit) {
  const std::vector<std::uint32_t> component = manifold_components(links);
  const auto size = [](const Loop& loop) { return (loop.box.high - loop.box.low).norm(); };
  std::map<std::uint32_t, double> largest;
  for (const Loop& loop : loops) {
    double& known = largest[component[loop.triangles[0]]];
    known = std::max(known, size(loop));
  }
  std::vector<bool> holes;
  for (const Loop& loop : loops) {
    const bool upright = std::abs(loop.area.z()) < kSteepLoop * loop.area.norm();
    const bool narrow = loop.area.norm() <= slit * loop.length;
    const bool inner = size(loop) < largest[component[loop.triangles[0]]];
    holes.push_back(loop.area.dot(loop.normal) < 0.0 || ((upright || narrow) && inner));
  }
  return holes;
}

/// Ears cut off the loop, shortest diagonal first; none when it crosses itself. Seen from above, so
/// that no new triangle overhangs, and where the loop is steep along its area vector.
std::optional<std::vector<Triangle>> ears(const TriangleMesh& mesh, const Loop& loop) {
  // Border sides have the mesh on their left, so the triangles that fill it run against them.
  std::vector<std::uint32_t> ring(loop.vertices.rbegin(), loop.vertices.rend());
  const Vec3 along = -loop.area.normalized();
  const Vec3 up = along.z() > kSteepLoop ? Vec3::UnitZ() : along;
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return up.dot((mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]));
  };
  double left = -up.dot(loop.area);  // twice the area still to be filled, seen along `up`
  std::vector<Triangle> result;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    std::size_t best = n;
    double shortest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
      // The remainder must not be collinear: hole corners are often in rows.
      const double cut = turn(a, b, c);
      if (!(cut > 0.0 && left - cut > kMinLeft * left)) continue;
      const bool holds_another = std::any_of(ring.begin(), ring.end(), [&](std::uint32_t p) {
        return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
               turn(c, a, p) >= 0.0;
      });
      const double length = (mesh.vertices[a] - mesh.vertices[c]).norm();
      if (holds_another || (best < n && length >= shortest)) continue;
      best = i;
      shortest = length;
    }
    if (best == n) return std::nullopt;
    result.push_back({ring[(best + n - 1) % n], ring[best], ring[(best + 1) % n]});
    left -= turn(result.back()[0], result.back()[1], result.back()[2]);
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  if (!(turn(ring[0], ring[1], ring[2]) > 0.0)) return std::nullopt;
  result.push_back({ring[0], ring[1], ring[2]});
  return result;
}

}  // namespace

void fill_surface_holes(RawSurface& surface, double widest, double slit, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const TriangleNeighbours links = triangle_neighbours(mesh);
  double widest_filled = 0.0, widest_open = 0.0;
  Vec3 filled_at = Vec3::Zero(), open_at = Vec3::Zero();
  const std::vector<Loop> loops = border_loops(mesh, links);
  const std::vector<bool> holes = which_are_holes(links, loops, slit);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!holes[i]) continue;
    const Loop& loop = loops[i];
    const double width = (loop.box.high - loop.box.low).maxCoeff();
    const Vec3 middle = (loop.box.low + loop.box.high) / 2.0;
    const std::optional<std::vector<Triangle>> filling =
        width <= widest ? ears(mesh, loop) : std::nullopt;
    if (!filling) {
      if (report.open_holes++ == 0 || width > widest_open) {
        widest_open = width;
        open_at = middle;
      }
      continue;
    }
    if (report.filled_holes++ == 0 || width > widest_filled) {
      widest_filled = width;
      filled_at = middle;
    }
    mesh.triangles.insert(mesh.triangles.end(), filling->begin(), filling->end());
    surface.source_file.insert(surface.source_file.end(), filling->size(),
                               surface.source_file[loop.triangles[0]]);
    report.boundary_edges -= loop.vertices.size();
  }
  if (report.filled_holes > 0) {
    report.notes.push_back(
        std::to_string(report.filled_holes) + " holes were filled, the widest, " +
        format_significant(widest_filled, 3) + " m, around " + format_map_point(filled_at));
  }
  if (report.open_holes > 0) {
    report.notes.push_back(std::to_string(report.open_holes) + " holes remain open, the widest, " +
                           format_significant(widest_open, 3) + " m, around " +
                           format_map_point(open_at) +
                           "; a block that reaches a hole leaves the terrain; fill = " +
                           format_significant(widest_open * 1.01, 3) + " m fills them");
  }
}

}  // namespace clast::terrain_detail
