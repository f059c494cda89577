#pragma once
/// The rock mass between the surfaces before and after it came down.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrain/terrain.hpp"

namespace clast {

/// What of the difference counts as the mass.
struct ReleasedMassOptions {
  /// Upright, m: less counts as error of the surveys. 0: all counts.
  double min_thickness = 0.1;
  /// Polygons (GeoJSON, GeoPackage, Shapefile) outside of which nothing counts.
  std::optional<std::filesystem::path> polygon = {};
  /// Both surfaces are made into grids of such cells first, m; absent: they stay what they are.
  std::optional<double> resolution = {};
  /// "largest"; "all"; or their places in the order of volume, as "1,3": 1 is the largest.
  std::string bodies = "largest";
  /// Bodies below are left out always, m^3.
  double least_volume = 1e-3;

  void check() const;  ///< throws InputError naming the field and its value
};

/// One body of the mass.
struct MassBody {
  std::size_t rank = 0;        ///< in the order of volume, from 1
  TriangleMesh mesh;           ///< closed, outward, on the map; of those left out empty
  double volume = 0.0;         ///< m^3
  double plan_area = 0.0;      ///< m^2
  double max_thickness = 0.0;  ///< upright, m
  Vec3 centre = Vec3::Zero();  ///< of its bounds, on the map
};

/// The mass, in bodies that do not touch.
struct ReleasedMass {
  std::vector<MassBody> bodies;    ///< those chosen, the largest first
  std::vector<MassBody> excluded;  ///< the others, the largest first
  double edge_before = 0.0;        ///< median side of the triangles of either surface, m
  double edge_after = 0.0;
  std::string crs;                 ///< of the map; empty when neither surface names one
  std::vector<std::string> notes;  ///< doubts, in words

  double volume() const;           ///< of the bodies, m^3
  double excluded_volume() const;  ///< m^3
};

/// The bodies between two surfaces where `before` is more than the least thickness above `after`.
/// Their top is the one surface, their base the other, without resampling: the edges of both
/// become edges of the bodies. At the outline they have walls as high as the least thickness. The
/// volume of a body is the integral of the thickness over its plan area. Thickness is upright; what
/// overhangs cannot be distinguished by two heights over a place.
/// @param before, after  on one map; each surface is of heights, z up
/// @throws InputError     map systems that differ, no place in common, nowhere thick enough (the
///                        message says how thick at most, and when they seem swapped), a polygon
///                        file as `read_zone_polygons` has it, or bodies that are not there
/// @throws GeometryError  a surface stands upright or overhangs within a chosen body, with a place
ReleasedMass find_released_mass(const Terrain& before, const Terrain& after,
                                const ReleasedMassOptions& options = {});

}  // namespace clast
