#pragma once
/// Shape files (.shp) of Rockable and ExaDEM, which are texts with keywords for sphero-polyhedra.
/// They are unrelated to ESRI shapefiles.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// Shape of a .shp file. With `preCompDone y`, vertices are in the principal frame about the centre
/// of mass. With `preCompDone n`, they are in any frame, and mass properties must be computed.
struct ShpShape {
  std::string name;                      ///< no spaces
  SpheroPolyhedron body;                 ///< body as read; its faces may have either orientation
  double volume = 0.0;                   ///< m^3; 0 if not stated
  Vec3 inertia_per_mass = Vec3::Zero();  ///< principal moments over mass, m^2; 0 if not stated
  OrientedBox box;        ///< box of the rounded body in the principal frame; 0 if not stated
  Pose source_from_body;  ///< original position and axes
  /// Number of sample points for volume and inertia (`MCnstep`).
  double sampled_points = 10000.0;
  bool is_surface = false;         ///< true for a ground or wall without a solid core
  std::vector<std::string> notes;  ///< notes on skipped content, as sentences
};

/// Writes shapes with `preCompDone y`, so that loading them needs no sampling.
/// @throws InputError  if a name has spaces; or as `OutputFile`
void write_shp(const std::filesystem::path& path, std::span<const ShpShape> shapes,
               const OverwritePolicy& rules = {});

/// Reads the shapes in order. Edges are derived from the faces, or read if there are no faces.
/// Removes unused vertices. Faces are not reoriented; use `clean_scan(core_mesh(body), ...)`. A
/// comment starts with #, ! or // in place of a keyword or number.
/// @throws InputError  if the file is missing, truncated or an ESRI shapefile, if a word, count or
///                     index is invalid, if a keyword is repeated or missing, or if an edge belongs
///                     to no face; the message gives file and line
std::vector<ShpShape> read_shp(const std::filesystem::path& path);

/// True if the file starts like an ESRI shapefile; false if it cannot be read.
bool is_esri_shapefile(const std::filesystem::path& path);

}  // namespace clast
