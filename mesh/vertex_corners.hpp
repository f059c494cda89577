#pragma once
/// Triangles around each vertex.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Triangle corners at each vertex of a mesh, ascending. Corner 3 t + k is vertex k of triangle t.
class VertexCorners {
 public:
  explicit VertexCorners(const TriangleMesh& mesh);

  std::span<const std::uint32_t> corners_of(std::uint32_t vertex) const {
    return {corners_.data() + start_[vertex], corners_.data() + start_[vertex + 1]};
  }

 private:
  std::vector<std::uint32_t> start_, corners_;  ///< of all vertices, concatenated
};

}  // namespace clast
