#include "terrain/terrain_file.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/files/output_file.hpp"

namespace clast {
namespace {

constexpr int kSchema = 1;

/// The counts of a report under the names they have in the file.
constexpr std::array<std::pair<const char*, std::size_t TerrainReport::*>, 13> kCounts = {{
    {"triangles_read", &TerrainReport::triangles_read},
    {"welded_vertices", &TerrainReport::welded_vertices},
    {"dropped_degenerate", &TerrainReport::removed_degenerate},
    {"dropped_duplicates", &TerrainReport::removed_duplicates},
    {"turned_triangles", &TerrainReport::flipped_triangles},
    {"closed_cracks", &TerrainReport::closed_cracks},
    {"filled_holes", &TerrainReport::filled_holes},
    {"open_holes", &TerrainReport::open_holes},
    {"levelled_spikes", &TerrainReport::levelled_spikes},
    {"dropped_pieces", &TerrainReport::removed_components},
    {"slivers", &TerrainReport::slivers},
    {"boundary_edges", &TerrainReport::boundary_edges},
    {"components", &TerrainReport::components},
}};

template <class T>
std::vector<T> table(const Hdf5Group& group, const std::string& name, std::size_t columns,
                     const std::string& file) {
  const std::vector<std::size_t> shape = group.shape(name);
  if (shape.size() != 2 || shape[1] != columns) {
    throw InputError(file + ": dataset \"" + name + "\" must have " + std::to_string(columns) +
                     " columns; the file is damaged, make it again with clast terrain");
  }
  return group.read<T>(name);
}

void check(const Terrain& terrain, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(file + ": " + what +
                     "; the file is damaged, make it again with clast terrain");
  };
  if (terrain.surface.triangles.empty()) refuse("holds no triangles");
  for (std::size_t v = 0; v < terrain.surface.vertices.size(); ++v) {
    if (!terrain.surface.vertices[v].allFinite()) {
      refuse("vertex " + std::to_string(v) + " is not finite");
    }
  }
  for (std::size_t t = 0; t < terrain.surface.triangles.size(); ++t) {
    for (const std::uint32_t corner : terrain.surface.triangles[t]) {
      if (corner >= terrain.surface.vertices.size()) {
        refuse("triangle " + std::to_string(t) + " refers to vertex " + std::to_string(corner) +
               " of " + std::to_string(terrain.surface.vertices.size()));
      }
    }
  }
  if (terrain.zone.size() != terrain.surface.triangles.size()) {
    refuse(std::to_string(terrain.zone.size()) + " zone numbers for " +
           std::to_string(terrain.surface.triangles.size()) + " triangles");
  }
  for (const std::uint16_t zone : terrain.zone) {
    if (zone >= terrain.zone_names.size()) {
      refuse("zone number " + std::to_string(zone) + " has no name");
    }
  }
  if (!terrain.frame.origin.allFinite()) refuse("its origin is not finite");
}

}  // namespace

void write_terrain(const std::filesystem::path& path, const Terrain& terrain,
                   const OverwritePolicy& rules) {
  OutputFile output(path, rules);
  {
    Hdf5File file = Hdf5File::create(output.temporary_path(), kTerrainFormat, kSchema);
    Hdf5Group root = file.root();
    root.set_attribute("crs", terrain.frame.crs);
    const Vec3& origin = terrain.frame.origin;
    root.write<double>("origin", std::span(origin.data(), 3));
    root.set_unit("origin", "m");
    std::vector<double> coordinates;
    coordinates.reserve(3 * terrain.surface.vertices.size());
    for (const Vec3& v : terrain.surface.vertices) {
      coordinates.insert(coordinates.end(), v.data(), v.data() + 3);
    }
    root.write<double>("vertices", coordinates, {terrain.surface.vertices.size(), 3});
    root.set_unit("vertices", "m");
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * terrain.surface.triangles.size());
    for (const TriangleMesh::Triangle& t : terrain.surface.triangles) {
      corners.insert(corners.end(), t.begin(), t.end());
    }
    root.write<std::uint32_t>("triangles", corners, {terrain.surface.triangles.size(), 3});
    root.write<std::uint16_t>("zone", terrain.zone);
    root.write<std::string>("zone_names", terrain.zone_names);
    root.write<std::string>("sources", terrain.sources);
    Hdf5Group report = root.create_group("report");
    for (const auto& [name, count] : kCounts) {
      report.set_attribute(name, static_cast<std::int64_t>(terrain.report.*count));
    }
    report.write<std::string>("notes", terrain.report.notes);
    file.flush();
  }
  output.commit();
}

Terrain read_terrain_file(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, kTerrainFormat, kSchema);
  const Hdf5Group root = file.root();
  Terrain terrain;
  terrain.frame.crs = root.read_attribute<std::string>("crs");
  const std::vector<double> origin = root.read<double>("origin");
  if (origin.size() != 3) {
    throw InputError(path.string() +
                     ": \"origin\" must be three numbers; the file is damaged, make it again with "
                     "clast terrain");
  }
  terrain.frame.origin = Vec3(origin[0], origin[1], origin[2]);
  const std::vector<double> coordinates = table<double>(root, "vertices", 3, path.string());
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    terrain.surface.vertices.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  const std::vector<std::uint32_t> corners =
      table<std::uint32_t>(root, "triangles", 3, path.string());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    terrain.surface.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  terrain.zone = root.read<std::uint16_t>("zone");
  terrain.zone_names = root.read<std::string>("zone_names");
  terrain.sources = root.read<std::string>("sources");
  const Hdf5Group report = root.open_group("report");
  for (const auto& [name, count] : kCounts) {
    // Files written before a check existed do not hold its count.
    if (!report.has_attribute(name) && std::string_view(name) != "triangles_read") continue;
    terrain.report.*count = static_cast<std::size_t>(report.read_attribute<std::int64_t>(name));
  }
  terrain.report.notes = report.read<std::string>("notes");
  check(terrain, path.string());
  return terrain;
}

}  // namespace clast
