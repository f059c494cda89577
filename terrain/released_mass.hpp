#pragma once
/// Released rock mass: difference of terrain surfaces before and after a rockfall.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

struct ReleasedMassOptions {
  /// Minimum vertical thickness, m. Smaller differences are survey errors; if 0, all count.
  double min_thickness = 0.1;
  /// Polygons (GeoJSON, GeoPackage, Shapefile) that limit the area.
  std::optional<std::filesystem::path> polygon = {};
  /// Cell size to which both surfaces are resampled first, m. If empty, they are not resampled.
  std::optional<double> resolution = {};
  /// Selected bodies: "largest", "all", or ranks by volume such as "1,3" (1 is the largest).
  std::string bodies = "largest";
  /// Minimum volume of bodies, m^3.
  double min_volume = 1e-3;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Closed body of rock that was released between two surveys.
struct ReleasedBody {
  std::size_t rank = 0;        ///< rank by volume, from 1
  TriangleMesh mesh;           ///< closed, outward, map coordinates; empty for excluded bodies
  double volume = 0.0;         ///< m^3
  double plan_area = 0.0;      ///< m^2
  double max_thickness = 0.0;  ///< largest vertical thickness, m
  Vec3 centre = Vec3::Zero();  ///< centre of its bounding box, map coordinates
};

struct ReleasedMass {
  std::vector<ReleasedBody> bodies;    ///< selected bodies, the largest first
  std::vector<ReleasedBody> excluded;  ///< bodies that are not selected, the largest first
  double median_edge_before = 0.0;     ///< median edge lengths of both surfaces, m
  double median_edge_after = 0.0;
  std::string crs;                 ///< empty if neither surface has one
  std::vector<std::string> notes;  ///< warnings, as sentences

  double volume() const;           ///< total volume of `bodies`, m^3
  double excluded_volume() const;  ///< m^3
};

/// Finds the released bodies, where `before` is above `after` by more than the minimum thickness.
/// The edges of both surfaces become edges of the bodies. Vertical walls of that thickness close
/// them along their outline. Their volume is the vertical thickness, integrated over the plan.
/// Overhangs cannot be represented.
/// @param before, after  surfaces in one coordinate system, with one height per plan point, z up
/// @throws InputError  if map systems differ, if the surfaces do not overlap, if no difference is
///                     thick enough, if the polygon file is invalid (`read_outline_polygons`), or
///                     if selected bodies do not exist
/// @throws GeometryError  if a surface is vertical or overhangs within a selected body; the message
///                        gives a position
ReleasedMass find_released_mass(const Terrain& before, const Terrain& after,
                                const ReleasedMassOptions& options = {});

}  // namespace clast
