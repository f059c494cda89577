#pragma once
/// Reference bodies of simple shapes, for shape studies.
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
  kCylinder,        ///< elliptic cylinder; its axis is along the side that differs most from I
  kEota111,         ///< test cube for rockfall nets, with chamfered edges and 24 vertices
  kEota221,         ///< test plate for rockfall nets, with side ratios 2 : 2 : 1
};

/// Returns the names of all reference shapes: "sphere", "box", "ellipsoid", "superellipsoid",
/// "cylinder", "eota-111", "eota-221".
const std::vector<std::string>& reference_shape_names();
std::string name_of(ReferenceShape form);
/// Parses the name of a reference shape.
/// @throws InputError  if the name is unknown; the message lists all names
ReferenceShape parse_reference_shape(const std::string& name);

struct ReferenceBodyOptions {
  BoxRatios ratios;              ///< ratios of the smallest box; ignored for sphere and EOTA bodies
  double radius_fraction = 0.0;  ///< Minkowski radius divided by S; ignored for the sphere
  double exponent = 4.0;         ///< n of the superellipsoid, 1 to 20

  void check() const;  ///< throws InputError naming the field and its value
};

/// Makes a reference body about the origin with L = 1 m along x and S along z. Its edges are
/// rounded without enlarging it. The box ratios are met within 1e-4. The sphere is exact. Cylinders
/// have 32 vertices around each end, other curved surfaces 162 vertices.
/// @throws InputError  as `ReferenceBodyOptions::check`
/// @throws GeometryError  if no core remains for the radius
/// @cite etag027
SpheroPolyhedron make_reference_body(ReferenceShape form, const ReferenceBodyOptions& options);

}  // namespace clast
