#include "mesh/vertex_corners.hpp"

#include <numeric>

namespace clast {

VertexCorners::VertexCorners(const TriangleMesh& mesh)
    : start_(mesh.vertices.size() + 1, 0), corners_(3 * mesh.triangles.size()) {
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++start_[v + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t c = 0; c < corners_.size(); ++c) {
    corners_[next[mesh.triangles[c / 3][c % 3]]++] = c;
  }
}

}  // namespace clast
