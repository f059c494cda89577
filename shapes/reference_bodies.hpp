#pragma once
/// Reference bodies for shape studies.
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
  kCylinder,        ///< elliptic, axis along the side that differs most from I
  kEota111,         ///< test cube of rockfall nets: all edges chamfered, 24 vertices
  kEota221,         ///< test plate of the same, 2 by 2 by 1
};

/// Returns all names: "sphere", "box", "ellipsoid", "superellipsoid", "cylinder", "eota-111",
/// "eota-221".
const std::vector<std::string>& reference_shape_names();
std::string name_of(ReferenceShape form);
/// Parses the name of a reference shape.
/// @throws InputError  if it is unknown; the message lists all names
ReferenceShape parse_reference_shape(const std::string& name);

struct ReferenceBodyOptions {
  BoxRatios ratios;           ///< of the smallest box; ignored for sphere and EOTA bodies
  double radius_share = 0.0;  ///< Minkowski radius over S; ignored for the sphere
  double exponent = 4.0;      ///< n of the superellipsoid, 1 to 20

  void check() const;  ///< throws InputError naming the field and its value
};

/// Makes the body with L = 1 m about the origin, L along x and S along z, with edges rounded
/// inwards by the radius. The box ratios are met within 1e-4. The sphere is exact; other curved
/// surfaces have 162 vertices, cylinders 32 around.
/// @throws InputError  as `ReferenceBodyOptions::check`
/// @throws GeometryError  if the radius leaves no core
/// @cite etag027
SpheroPolyhedron make_reference_body(ReferenceShape form, const ReferenceBodyOptions& options);

}  // namespace clast
