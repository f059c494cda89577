#pragma once
/// A picture of the ground from above, to see at a glance whether all lies where it should.
#include <filesystem>
#include <vector>

#include "core/files/output_file.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// What is drawn over the ground; places on the map, m.
struct MapMarks {
  std::vector<Vec2> releases;               ///< black crosses
  std::vector<std::vector<Vec2>> barriers;  ///< black lines from corner to corner
};

/// Writes a PNG: relief lit from the north-west with contour lines, zones tinted (`zone_tint`),
/// north up, the longer side `pixels` long, with all marks inside the picture, a scale bar, an
/// arrow to the north and a legend.
/// @throws InputError  a mark farther off the ground than the ground is large, or as `OutputFile`
void write_hillshade(const std::filesystem::path& path, const Terrain& terrain,
                     const MapMarks& marks, const OutputRules& rules = {},
                     std::uint32_t pixels = 1600);

/// Lines of a GeoJSON, GeoPackage or Shapefile in the terrain's map system, as for `MapMarks`.
/// @throws InputError  as zone polygons
std::vector<std::vector<Vec2>> read_barrier_lines(const std::filesystem::path& path,
                                                  const Terrain& terrain);

}  // namespace clast
