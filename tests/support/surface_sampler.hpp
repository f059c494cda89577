#pragma once
/// Points drawn at random from a surface, every part of it as likely.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

class SurfaceSampler {
 public:
  struct Drawn {
    TriangleMesh::Triangle triangle;
    Vec3 point;
  };

  /// @param mesh  must outlive this
  explicit SurfaceSampler(const TriangleMesh& mesh) : mesh_(mesh) {
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      areas_.push_back((areas_.empty() ? 0.0 : areas_.back()) +
                       doubled_area_vector(mesh, t).norm());
    }
  }

  Drawn draw(Random& random) const {
    const auto place =
        std::lower_bound(areas_.begin(), areas_.end(), random.uniform(0.0, areas_.back()));
    const auto number = static_cast<std::size_t>(place - areas_.begin());
    const TriangleMesh::Triangle t = mesh_.triangles[std::min(number, areas_.size() - 1)];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Vec3& corner = mesh_.vertices[t[0]];
    return {t, corner + u * (mesh_.vertices[t[1]] - corner) + v * (mesh_.vertices[t[2]] - corner)};
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<double> areas_;  ///< running, twice
};

}  // namespace clast
