#include "particles/convex_parts.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "massprops/moments.hpp"
#include "massprops/solid.hpp"
#include "mesh/geodesic_sphere.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_geometry.hpp"
#include "particles/detail/body_piece.hpp"
#include "particles/detail/outer_hull.hpp"
#include "particles/detail/surface_distance.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {

using namespace particles_detail;

namespace {

constexpr std::size_t kMostParts = 1000, kFewestVertices = 16;
/// Frequencies of geodesic spheres: directions of trial planes (21 axes), and directions in which
/// extreme points are taken for the volume of a trial hull.
constexpr int kPlaneFrequency = 2, kExtremeFrequency = 4;
/// Positions of trial planes, as fractions of the extent of a piece.
constexpr std::array<double, 5> kPositions = {0.3, 0.42, 0.5, 0.58, 0.7};
/// A side of a division has at least this fraction of the volume of the body.
constexpr double kSmallestSide = 1e-5;
/// Distance from a part, relative to L, at which a point of its surface is tested for being covered
/// by another part.
constexpr double kExposureOffset = 1e-4;
/// Height of a triangle over the size of its part below which rounding turns its normal.
constexpr double kThinnest = 1e-8;
/// Squared sine of the angles of faces at a vertex below which it is no corner: 1e-6 rad.
constexpr double kFlatCornerSquare = 1e-12;

/// One direction of each pair of opposite vertices of a geodesic sphere.
std::vector<Vec3> axes_of_sphere(int frequency) {
  std::vector<Vec3> axes;
  for (const Vec3& vertex : geodesic_sphere(frequency).vertices) {
    const bool opposite = std::any_of(
        axes.begin(), axes.end(), [&](const Vec3& axis) { return axis.dot(vertex) < -1.0 + 1e-9; });
    if (!opposite) axes.push_back(vertex);
  }
  return axes;
}

/// Volume of the hull of the points that are extreme in some directions; infinite if they are
/// coplanar.
double rough_hull_volume(const std::vector<Vec3>& points, const std::vector<Vec3>& directions) {
  std::vector<Vec3> extreme;
  for (const Vec3& direction : directions) {
    std::size_t low = 0, high = 0;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double height = direction.dot(points[i]);
      if (height < least) least = height, low = i;
      if (height > most) most = height, high = i;
    }
    extreme.push_back(points[low]);
    extreme.push_back(points[high]);
  }
  try {
    return signed_volume(convex_hull(extreme));
  } catch (const GeometryError&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// A piece of the body with its hull.
struct Part {
  BodyPiece piece;
  TriangleMesh hull;
  double added = 0.0;  ///< volume of the hull beyond the piece, m^3
};

/// Normals of the triangles of a hull; zero for those too thin to have one.
std::vector<Vec3> reliable_normals(const TriangleMesh& hull) {
  const double thinnest = kThinnest * bounds(hull).diagonal();
  std::vector<Vec3> normals;
  for (const TriangleMesh::Triangle& triangle : hull.triangles) {
    const Vec3 area = doubled_area_vector(hull, triangle);
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(
          longest, (hull.vertices[triangle[k]] - hull.vertices[triangle[(k + 1) % 3]]).norm());
    }
    normals.push_back(area.norm() > thinnest * longest ? Vec3(area.normalized()) : Vec3::Zero());
  }
  return normals;
}

/// Hull without vertices that lie within a face or an edge to rounding, where planes cut the body.
TriangleMesh hull_of_corners(const TriangleMesh& hull) {
  const std::vector<Vec3> normals = reliable_normals(hull);
  std::vector<Mat3> sums(hull.vertices.size(), Mat3::Zero());
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    for (const std::uint32_t vertex : hull.triangles[t]) {
      sums[vertex] += normals[t] * normals[t].transpose();
    }
  }
  std::vector<Vec3> corners;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(sums[v], Eigen::EigenvaluesOnly);
    if (solver.eigenvalues()[0] > kFlatCornerSquare) corners.push_back(hull.vertices[v]);
  }
  return convex_hull(corners);
}

/// Planes of the faces of a convex part.
std::vector<Plane> face_planes(const TriangleMesh& part) {
  const std::vector<Vec3> normals = reliable_normals(part);
  std::vector<Plane> planes;
  for (std::size_t t = 0; t < normals.size(); ++t) {
    if (normals[t].isZero(0.0)) continue;
    planes.push_back({normals[t], normals[t].dot(part.vertices[part.triangles[t][0]])});
  }
  return planes;
}

/// @throws GeometryError  if the piece is flat
Part make_part(BodyPiece piece, std::size_t max_vertices) {
  Part part{std::move(piece), {}, 0.0};
  part.hull = hull_of_corners(convex_hull(points_of(part.piece)));
  if (part.hull.vertices.size() > max_vertices) {
    part.hull = outer_hull(part.hull, face_planes(part.hull), part.piece.cell, max_vertices);
  }
  part.added = signed_volume(part.hull) - part.piece.volume;
  return part;
}

class PartDivision {
 public:
  PartDivision(const TriangleMesh& mesh, std::size_t max_vertices)
      : tree_(mesh),
        max_vertices_(max_vertices),
        volume_(signed_volume(mesh)),
        planes_(axes_of_sphere(kPlaneFrequency)),
        extremes_(axes_of_sphere(kExtremeFrequency)) {
    parts_.push_back(make_part(whole_body(mesh), max_vertices));
  }

  double added_volume() const {
    double sum = 0.0;
    for (const Part& part : parts_) sum += part.added;
    return sum / volume_;
  }
  std::size_t size() const { return parts_.size(); }

  /// Divides the part that adds most volume and can be divided. False if there is none.
  bool divide() {
    std::vector<std::size_t> order(parts_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return parts_[a].added > parts_[b].added;
    });
    for (const std::size_t i : order) {
      std::optional<std::array<Part, 2>> halves = best_division(parts_[i]);
      if (!halves) continue;
      parts_[i] = std::move((*halves)[0]);
      parts_.push_back(std::move((*halves)[1]));
      return true;
    }
    return false;
  }

  std::vector<TriangleMesh> hulls() const {
    std::vector<TriangleMesh> result;
    for (const Part& part : parts_) result.push_back(part.hull);
    return result;
  }

 private:
  /// Vertex of the surface that is deepest below the hull.
  Vec3 deepest_point(const Part& part) const {
    const std::vector<Plane> faces = face_planes(part.hull);
    Vec3 deepest = part.piece.cell.centre();
    double most = 0.0;
    for (const auto& triangle : part.piece.surface) {
      double depth = std::numeric_limits<double>::infinity();
      for (const Plane& face : faces) depth = std::min(depth, -face.signed_distance(triangle[0]));
      if (depth > most) most = depth, deepest = triangle[0];
    }
    return deepest;
  }

  std::optional<std::array<Part, 2>> best_division(const Part& part) const {
    const Vec3 deepest = deepest_point(part);
    std::optional<std::array<BodyPiece, 2>> best;
    double least = signed_volume(part.hull);
    for (const Vec3& axis : planes_) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vec3& vertex : part.hull.vertices) {
        low = std::min(low, axis.dot(vertex));
        high = std::max(high, axis.dot(vertex));
      }
      std::vector<double> distances = {axis.dot(deepest)};
      for (const double position : kPositions) distances.push_back(low + position * (high - low));
      for (const double distance : distances) {
        std::optional<std::array<BodyPiece, 2>> sides =
            divided(part.piece, {axis, distance}, tree_);
        if (!sides) continue;
        double sum = 0.0;
        for (const BodyPiece& side : *sides) {
          sum +=
              side.volume < kSmallestSide * volume_ || side.cell.vertices().size() > max_vertices_
                  ? std::numeric_limits<double>::infinity()
                  : rough_hull_volume(points_of(side), extremes_);
        }
        if (sum < least) least = sum, best = std::move(sides);
      }
    }
    if (!best) return std::nullopt;
    return std::array<Part, 2>{make_part(std::move((*best)[0]), max_vertices_),
                               make_part(std::move((*best)[1]), max_vertices_)};
  }

  TriangleTree tree_;
  std::size_t max_vertices_;
  double volume_;
  std::vector<Vec3> planes_, extremes_;
  std::vector<Part> parts_;
};

/// Points of the surfaces of parts that no other part covers.
std::vector<Vec3> exposed_part_points(const std::vector<TriangleMesh>& parts, double spacing,
                                      double offset) {
  std::vector<std::vector<Plane>> faces;
  for (const TriangleMesh& part : parts) faces.push_back(face_planes(part));
  const auto covered = [&](const Vec3& point) {
    return std::any_of(faces.begin(), faces.end(), [&](const std::vector<Plane>& planes) {
      return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
        return plane.signed_distance(point) <= 0.5 * offset;
      });
    });
  };
  std::vector<Vec3> points;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const Vec3& point : sample_body(BodySurface(parts[p], 0.0), spacing)) {
      const bool exposed = std::any_of(faces[p].begin(), faces[p].end(), [&](const Plane& plane) {
        return plane.signed_distance(point) > -0.1 * offset &&
               !covered(point + offset * plane.normal);
      });
      if (exposed) points.push_back(point);
    }
  }
  return points;
}

}  // namespace

void ConvexPartOptions::check() const {
  if (!(added_volume > 0.0 && added_volume < 1.0)) {
    throw InputError("`error` volume = " + format_significant(added_volume, 6) +
                     ": must be above 0 and below 1, such as 0.02 for 2 %");
  }
  if (max_parts < 1 || max_parts > kMostParts) {
    throw InputError("`parts` = " + std::to_string(max_parts) + ": must be from 1 to " +
                     std::to_string(kMostParts));
  }
  if (max_vertices && *max_vertices < kFewestVertices) {
    throw InputError("`part_vertices` = " + std::to_string(*max_vertices) + ": must be at least " +
                     std::to_string(kFewestVertices));
  }
}

ConvexParts split_into_convex_parts(const TriangleMesh& mesh, const ConvexPartOptions& options) {
  options.check();
  solid_mass_properties(mesh, 1.0);  // refuses open meshes
  PartDivision division(mesh,
                        options.max_vertices.value_or(std::numeric_limits<std::size_t>::max()));
  while (division.size() < options.max_parts && division.added_volume() > options.added_volume &&
         division.divide()) {
  }
  return {division.hulls(), division.added_volume()};
}

MassProperties convex_part_mass_properties(const std::vector<TriangleMesh>& parts, double density) {
  const Vec3 origin = massprops_detail::vertex_mean(parts.front());
  massprops_detail::SolidMoments sum;
  for (const TriangleMesh& part : parts) sum += massprops_detail::polyhedron_moments(part, origin);
  return massprops_detail::to_mass_properties(sum, origin, Mat3::Identity(), density);
}

ShapeErrors measure_part_errors(const ParticleBody& body, const std::vector<TriangleMesh>& parts) {
  ShapeErrors errors = compare_mass_properties(convex_part_mass_properties(parts, 1.0), body.mass);
  const double spacing = kFineSpacing * body.length;
  const BodySurface surface(body.mesh, body.radius);
  errors.surface = measure_covering_distance(
                       surface, sample_body(surface, spacing),
                       exposed_part_points(parts, spacing, kExposureOffset * body.length), spacing)
                       .value /
                   body.length;
  return errors;
}

}  // namespace clast
