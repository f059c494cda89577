#pragma once
/// Shape files (.shp) of Rockable and ExaDEM: sphero-polyhedra as keyword text; unrelated to ESRI
/// shapefiles.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// Shape of a .shp file. With `preCompDone y`, vertices are in the principal frame about the
/// centre; with `n` in any frame, and mass properties are still to be computed.
struct ShpShape {
  std::string name;                      ///< no spaces
  SpheroPolyhedron body;                 ///< as read; faces may have either orientation
  double volume = 0.0;                   ///< m^3; 0 if not stated
  Vec3 inertia_per_mass = Vec3::Zero();  ///< principal, m^2; 0 if not stated
  OrientedBox box;        ///< of the rounded body, in the principal frame; 0 if not stated
  Pose source_from_body;  ///< original position and axes
  /// Number of sample points for volume and inertia (`MCnstep`; default if not stated).
  double sampled_points = 10000.0;
  bool is_surface = false;         ///< ground or wall without a solid core
  std::vector<std::string> notes;  ///< skipped content, as sentences
};

/// Writes shapes with `preCompDone y`, so that nothing is sampled again on loading.
/// @throws InputError  if a name has spaces, or as `OutputFile`
void write_shp(const std::filesystem::path& path, std::span<const ShpShape> shapes,
               const OverwritePolicy& rules = {});

/// Reads the shapes in order. Edges are derived from the faces, or read if there are no faces.
/// Unused vertices are dropped with a note. Faces are not reoriented: see
/// `clean_scan(core_mesh(body), ...)`. Comments start with #, ! or // in place of a keyword or
/// number.
/// @throws InputError  if the file is missing, an ESRI shapefile or truncated; a word is not a
///                     keyword or number; a count or index is invalid; a keyword is repeated or
///                     missing; or an edge belongs to no face: with file and line
std::vector<ShpShape> read_shp(const std::filesystem::path& path);

/// True if the file is an ESRI shapefile, by its first bytes; false if it cannot be read.
bool is_esri_shapefile(const std::filesystem::path& path);

}  // namespace clast
