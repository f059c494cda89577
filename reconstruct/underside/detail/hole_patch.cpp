#include "reconstruct/underside/detail/hole_patch.hpp"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/cgal_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

/// A patch with fewer new vertices than this, or than half the rim has, can't bulge smoothly.
constexpr std::size_t kMinNewVertices = 30;
constexpr int kPatchRefinements = 6;
/// Smallest weight of an edge against the largest at its vertex: long obtuse triangles have
/// negative ones, with which a membrane may leave the hull of its rim.
constexpr double kMinWeight = 1e-3;

HolePatch triangulate(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop,
                      double density) {
  mesh_detail::CgalMesh work = mesh_detail::to_cgal_mesh(mesh);
  const auto first = mesh_detail::CgalMesh::Vertex_index(loop[0]),
             second = mesh_detail::CgalMesh::Vertex_index(loop[1]);
  const mesh_detail::CgalMesh::Halfedge_index border = work.halfedge(first, second);
  if (!border.is_valid() || !work.is_border(border)) {
    throw GeometryError("no border runs from " + format_point(mesh.vertices[loop[0]]) + " to " +
                        format_point(mesh.vertices[loop[1]]));
  }
  std::vector<mesh_detail::CgalMesh::Face_index> faces;
  std::vector<mesh_detail::CgalMesh::Vertex_index> vertices;
  namespace pmp = CGAL::Polygon_mesh_processing;
  pmp::triangulate_and_refine_hole(
      work, border, std::back_inserter(faces), std::back_inserter(vertices),
      pmp::parameters::density_control_factor(density).use_2d_constrained_delaunay_triangulation(
          true));
  HolePatch patch;
  for (std::size_t v = mesh.vertices.size(); v < work.number_of_vertices(); ++v) {
    const mesh_detail::CgalPoint& p =
        work.point(mesh_detail::CgalMesh::Vertex_index(static_cast<std::uint32_t>(v)));
    patch.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  std::sort(faces.begin(), faces.end());
  for (const mesh_detail::CgalMesh::Face_index face : faces) {
    TriangleMesh::Triangle triangle{};
    std::size_t corner = 0;
    for (const mesh_detail::CgalMesh::Vertex_index v :
         work.vertices_around_face(work.halfedge(face))) {
      triangle[corner++] = v.idx();
    }
    patch.triangles.push_back(triangle);
  }
  return patch;
}

/// Moves the new vertices to the membrane and sets their bulge.
void relax(HolePatch& patch, const TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto count = static_cast<Eigen::Index>(patch.vertices.size());
  const auto position = [&](std::uint32_t v) -> const Vec3& {
    return v < first ? mesh.vertices[v] : patch.vertices[v - first];
  };
  const Vec3 origin = patch.vertices[0];  // map coordinates would cost digits
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(count, 4);  // x, y, z of the membrane; pressure
  const auto add = [&](std::uint32_t v, std::uint32_t other, double weight) {
    if (v < first) return;
    const auto row = static_cast<Eigen::Index>(v - first);
    entries.emplace_back(row, row, weight);
    if (other >= first) {
      entries.emplace_back(row, static_cast<Eigen::Index>(other - first), -weight);
    } else {
      sides.block<1, 3>(row, 0) += weight * (mesh.vertices[other] - origin).transpose();
    }
  };
  for (const TriangleMesh::Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const Vec3 u = position(a) - position(c), v = position(b) - position(c);
      const double doubled_area = u.cross(v).norm();
      const double cotangent = doubled_area > 0.0 ? u.dot(v) / doubled_area : 0.0;
      const double weight = 0.5 * std::clamp(cotangent, kMinWeight, 1.0 / kMinWeight);
      add(a, b, weight);
      add(b, a, weight);
      if (c >= first) sides(static_cast<Eigen::Index>(c - first), 3) += doubled_area / 6.0;
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixXd solution = solver.solve(sides);
  const double most = solution.col(3).maxCoeff();
  patch.deflection.resize(patch.vertices.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    patch.vertices[static_cast<std::size_t>(i)] = origin + solution.block<1, 3>(i, 0).transpose();
    patch.deflection[static_cast<std::size_t>(i)] = std::max(0.0, solution(i, 3) / most);
  }
}

/// Triangles from the middle of the rim: for rims whose corners are joined across already, where
/// no triangulation without a new vertex is manifold.
HolePatch star(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop) {
  HolePatch patch;
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t v : loop) middle += mesh.vertices[v] / static_cast<double>(loop.size());
  patch.vertices.push_back(middle);
  patch.deflection.push_back(1.0);
  const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    patch.triangles.push_back({centre, loop[i], loop[(i + 1) % loop.size()]});
  }
  return patch;
}

}  // namespace

HolePatch fill_with_membrane(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop) {
  HolePatch patch;
  double density = std::sqrt(2.0);
  for (int i = 0; i < kPatchRefinements; ++i, density *= 1.5) {
    patch = triangulate(mesh, loop, density);
    if (patch.triangles.empty()) return star(mesh, loop);
    if (patch.vertices.size() >= std::max(kMinNewVertices, loop.size() / 2)) break;
  }
  if (!patch.vertices.empty()) relax(patch, mesh);
  return patch;
}

}  // namespace clast::reconstruct_detail
