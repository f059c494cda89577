#pragma once
/// Rockable's and ExaDEM's shape file (.shp): one or more sphero-polyhedra as keyword text. Not the
/// map format of the same extension.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// What a .shp file holds of one shape. With `preCompDone y` its vertices are in the principal
/// frame, origin at the centre; with `n` anywhere, and the rest is still to be computed.
struct ShpShape {
  std::string name;                      ///< no spaces
  SpheroPolyhedron body;                 ///< as read, faces may be turned either way
  double volume = 0.0;                   ///< m^3; 0 when the file doesn't say
  Vec3 inertia_per_mass = Vec3::Zero();  ///< principal, m^2; 0 when the file doesn't say
  OrientedBox box;        ///< of the rounded body, in the principal frame; 0 when not said
  Pose source_from_body;  ///< where the centre and the axes were
  /// Points that Rockable sampled volume and inertia with (`MCnstep`, its default when not said).
  double sampled_points = 10000.0;
  bool is_surface = false;         ///< a ground or a wall: its core isn't solid
  std::vector<std::string> notes;  ///< what reading left out, in words
};

/// Writes the shapes in order with `preCompDone y`, so that nothing is sampled anew on loading.
/// @throws InputError  a name with spaces, or as `OutputFile`
void write_shp(const std::filesystem::path& path, std::span<const ShpShape> shapes,
               const OverwritePolicy& rules = {});

/// The shapes in order. Edges are those of the faces, each once, whatever the file lists; where
/// there are no faces they are the file's. Vertices that nothing uses are left out with a note.
/// Faces are not turned: `clean_scan(core_mesh(body), ...)` orients, repairs and checks.
/// Comments start with #, ! or // where a keyword or a number may stand.
/// @throws InputError  missing, a map file of that extension, cut short, a word that is no keyword
///                     or no number, a count the file can't hold, a vertex that isn't there, a
///                     repeated or missing keyword, an edge beside all faces: with file and line
std::vector<ShpShape> read_shp(const std::filesystem::path& path);

/// Is it a map file (ESRI shapefile), by its first bytes? Not when it can't be read.
bool is_esri_shapefile(const std::filesystem::path& path);

}  // namespace clast
