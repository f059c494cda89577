#include "report/scene/vtk_animation.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <set>
#include <span>
#include <string>

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "study/compare/path_samples.hpp"

namespace clast {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

/// The core with its corners moved out by the radius along their mean normals: within the radius of
/// the rounded surface, with a tenth of the triangles that a rounded mesh needs in every frame.
TriangleMesh outline(const SpheroPolyhedron& shape) {
  if (shape.faces.empty()) return rounded_surface_mesh(shape);  // a ball or a capsule
  TriangleMesh mesh = core_mesh(shape);
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += normal;
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const double length = normals[i].norm();
    if (length > 0.0) mesh.vertices[i] += shape.radius / length * normals[i];
  }
  return mesh;
}

struct MovingBlock {
  const RunRow* row = nullptr;
  Vec3 origin = Vec3::Zero();  ///< of the local frame on the map
  TriangleMesh skin;           ///< body frame
  Trajectory trajectory;

  /// Returns the state at `time`; after its end, a run stays where it stopped.
  const RigidState& at(double time) const {
    const auto after =
        std::upper_bound(trajectory.time.begin(), trajectory.time.end(), time + 1e-9);
    const auto index = std::max<std::ptrdiff_t>(after - trajectory.time.begin() - 1, 0);
    return trajectory.states[static_cast<std::size_t>(index)];
  }
};

/// The arrays of a VTK file, one after the other as raw bytes behind its XML.
class Appended {
 public:
  /// @return the attributes that point to the array
  template <class T>
  std::string add(std::span<const T> values) {
    const std::string offset = std::to_string(bytes_.size());
    const std::uint64_t size = values.size_bytes();
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return " format=\"appended\" offset=\"" + offset + "\"/>\n";
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string vtk_frame(const std::vector<MovingBlock>& blocks, double time) {
  std::vector<double> points, speed;
  std::vector<std::int32_t> corners, ends, file, run;
  for (const MovingBlock& block : blocks) {
    const RigidState& state = block.at(time);
    const auto first = static_cast<std::int32_t>(points.size() / 3);
    for (const Vec3& vertex : block.skin.vertices) {
      const Vec3 place = block.origin + state.world_from_body() * vertex;
      points.insert(points.end(), place.begin(), place.end());
    }
    for (const auto& triangle : block.skin.triangles) {
      for (const std::uint32_t corner : triangle) {
        corners.push_back(first + static_cast<std::int32_t>(corner));
      }
      ends.push_back(static_cast<std::int32_t>(corners.size()));
      file.push_back(static_cast<std::int32_t>(block.row->file + 1));
      run.push_back(static_cast<std::int32_t>(block.row->record->run));
      speed.push_back(state.velocity.norm());
    }
  }
  Appended data;
  const auto array = [&](const char* type, const char* name, int components, const auto& values) {
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
           "\" NumberOfComponents=\"" + std::to_string(components) + "\"" +
           data.add(std::span(values.data(), values.size()));
  };
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(points.size() / 3) + "\" NumberOfPolys=\"" + std::to_string(ends.size()) +
      "\">\n<Points>\n" + array("Float64", "points", 3, points) + "</Points>\n<Polys>\n" +
      array("Int32", "connectivity", 1, corners) + array("Int32", "offsets", 1, ends) +
      "</Polys>\n<CellData>\n" + array("Int32", "file", 1, file) + array("Int32", "run", 1, run) +
      array("Float64", "speed_m_s", 1, speed) + "</CellData>\n</Piece>\n</PolyData>\n";
  return xml + "<AppendedData encoding=\"raw\">\n_" + data.bytes() +
         "\n</AppendedData>\n</VTKFile>\n";
}

std::vector<MovingBlock> moving_blocks(const Comparison& comparison, std::size_t count) {
  std::vector<std::size_t> stored;
  for_each_trajectory(comparison, [&](std::size_t row, const Trajectory&, const TerrainSurface&) {
    stored.push_back(row);
  });
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < std::min(count, stored.size()); ++i) {
    chosen.insert(stored[i * stored.size() / std::min(count, stored.size())]);
  }
  std::vector<MovingBlock> blocks;
  for_each_trajectory(
      comparison, [&](std::size_t index, const Trajectory& trajectory, const TerrainSurface&) {
        if (!chosen.contains(index)) return;
        const RunRow& row = comparison.rows[index];
        const CampaignResults& results = comparison.results[row.file];
        const SpheroPolyhedron shape = scaled(results.shapes[row.block->shape], row.block->scale);
        blocks.push_back({&row, results.frame.origin, outline(shape), trajectory});
      });
  return blocks;
}

std::string frame_number(std::size_t value) {
  char text[24];
  std::snprintf(text, sizeof text, "%04zu", value);
  return text;
}

}  // namespace

std::filesystem::path write_animation(const std::filesystem::path& folder,
                                      const Comparison& comparison, std::size_t count) {
  const std::vector<MovingBlock> blocks = moving_blocks(comparison, count);
  if (blocks.empty()) return {};
  std::set<double> times;
  for (const MovingBlock& block : blocks) {
    times.insert(block.trajectory.time.begin(), block.trajectory.time.end());
  }
  std::string list;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    TriangleMesh ground = results.terrain.surface;
    for (Vec3& vertex : ground.vertices) vertex += results.frame.origin;
    write_mesh(folder / ("terrain_" + std::to_string(file + 1) + ".vtp"), ground);
  }
  std::size_t index = 0;
  for (const double time : times) {
    const std::string name = "frame_" + frame_number(index++) + ".vtp";
    write_text_file(folder / name, vtk_frame(blocks, time));
    list += "<DataSet timestep=\"" + format_significant(time, 9) + "\" part=\"0\" file=\"" + name +
            "\"/>\n";
  }
  const std::filesystem::path target = folder / "animation.pvd";
  write_text_file(target,
                  "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                  "byte_order=\"LittleEndian\">\n<Collection>\n" +
                      list + "</Collection>\n</VTKFile>\n");
  return target;
}

}  // namespace clast
