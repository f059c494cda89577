#include "dem/motion/box_body.hpp"

namespace clast {

RigidBody make_box_body(const Vec3& sides, double radius, double mass) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1 ? 0.5 : -0.5) * sides.x(), (i & 2 ? 0.5 : -0.5) * sides.y(),
                               (i & 4 ? 0.5 : -0.5) * sides.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const Vec3 squares = sides.cwiseProduct(sides);
  return {make_sphero_polyhedron(mesh, radius), mass,
          mass / 12.0 *
              Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()),
          sides.minCoeff() + 2.0 * radius};
}

}  // namespace clast
