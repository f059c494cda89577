#pragma once
/// Simple bodies that studies compare rocks with.
#include <string>
#include <vector>

#include "shapes/box_stretch.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

enum class ReferenceShape {
  kSphere,
  kBox,
  kEllipsoid,
  kSuperellipsoid,  ///< |x/a|^n + |y/b|^n + |z/c|^n = 1
  kCylinder,        ///< elliptic, its axis along the side that differs most from I
  kEota111,         ///< the cube of tests of rockfall nets: all edges cut, 24 corners
  kEota221,         ///< the plate of the same, 2 by 2 by 1
};

/// "sphere", "box", "ellipsoid", "superellipsoid", "cylinder", "eota-111", "eota-221".
const std::vector<std::string>& reference_shape_names();
std::string name_of(ReferenceShape form);
/// @throws InputError  no such form; the message lists those there are
ReferenceShape parse_reference_shape(const std::string& name);

struct ReferenceBodyOptions {
  BoxRatios ratios;           ///< of the smallest box; no matter for the sphere and EOTA bodies
  double radius_share = 0.0;  ///< Minkowski radius as a share of S; no matter for the sphere
  double exponent = 4.0;      ///< n of the superellipsoid, 1 to 20

  void check() const;  ///< throws InputError naming the field and its value
};

/// The body with L = 1 m about the origin, L along x, S along z, all edges rounded with the radius
/// inwards. Its smallest box has the ratios within 1e-4. The sphere is exact; curved surfaces of
/// the others have 162 corners, cylinders 32 around.
/// @throws InputError     as `ReferenceBodyOptions::check`
/// @throws GeometryError  a radius for which nothing is left of the core
/// @cite etag027
SpheroPolyhedron make_reference_body(ReferenceShape form, const ReferenceBodyOptions& options);

}  // namespace clast
