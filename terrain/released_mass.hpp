#pragma once
/// Released rock mass: difference of terrain surfaces before and after a rockfall.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

struct ReleasedMassOptions {
  /// Minimum vertical thickness, m; smaller differences count as survey errors. 0: all count.
  double min_thickness = 0.1;
  /// Polygons (GeoJSON, GeoPackage, Shapefile) that limit the area.
  std::optional<std::filesystem::path> polygon = {};
  /// Cell size to which both surfaces are resampled first, m; empty: no resampling.
  std::optional<double> resolution = {};
  /// Selected bodies: "largest", "all", or ranks by volume such as "1,3" (1 is the largest).
  std::string bodies = "largest";  ///< selected, the largest first
  /// Minimum volume of bodies, m^3.
  double least_volume = 1e-3;

  void check() const;  ///< throws InputError naming the field and its value
};

struct MassBody {
  std::size_t rank = 0;        ///< rank by volume, from 1
  TriangleMesh mesh;           ///< closed, outward, map coordinates; empty for excluded bodies
  double volume = 0.0;         ///< of the selected bodies, m^3
  double plan_area = 0.0;      ///< m^2
  double max_thickness = 0.0;  ///< vertical, m
  Vec3 centre = Vec3::Zero();  ///< of its bounds, map coordinates
};

struct ReleasedMass {
  std::vector<MassBody> bodies;    ///< those chosen, the largest first
  std::vector<MassBody> excluded;  ///< excluded, the largest first
  double edge_before = 0.0;        ///< median edge lengths of both surfaces, m
  double edge_after = 0.0;
  std::string crs;                 ///< empty if neither surface has one
  std::vector<std::string> notes;  ///< warnings, as sentences

  double volume() const;           ///< of the bodies, m^3
  double excluded_volume() const;  ///< m^3
};

/// Finds the bodies where `before` is more than the minimum thickness above `after`, without
/// resampling: the edges of both surfaces become edges of the bodies. At their outline they have
/// walls as high as the minimum thickness. The volume is the integral of the vertical thickness
/// over the plan; overhangs cannot be represented.
/// @param before, after  on one map, single-valued heights, z up
/// @throws InputError  if map systems differ, the surfaces do not overlap, nothing is thick enough
///                     (states the maximum, and whether they seem swapped), the polygon file is
///                     invalid (`read_zone_polygons`), or selected bodies do not exist
/// @throws GeometryError  if a surface is vertical or overhangs within a selected body, with a
///                        position
ReleasedMass find_released_mass(const Terrain& before, const Terrain& after,
                                const ReleasedMassOptions& options = {});

}  // namespace clast
