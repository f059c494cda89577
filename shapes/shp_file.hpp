#pragma once
/// Rockable's and ExaDEM's shape file (.shp): one or more sphero-polyhedra as keyword text.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapes/oriented_box.hpp"

namespace clast {

/// What a .shp file holds of one shape. Vertices are in the principal frame, origin at the centre.
struct ShpShape {
  std::string name;  ///< no spaces
  SpheroPolyhedron body;
  double volume = 0.0;                   ///< m^3
  Vec3 inertia_per_mass = Vec3::Zero();  ///< principal, m^2
  OrientedBox box;                       ///< of the rounded body, in the principal frame
  Pose source_from_body;                 ///< where the centre and the axes were
};

/// Writes the shapes in order with `preCompDone y`, so that nothing is sampled anew on loading.
/// @throws InputError  a name with spaces, or the folder can't be written to
void write_shp(const std::filesystem::path& path, std::span<const ShpShape> shapes);

}  // namespace clast
