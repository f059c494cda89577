#include "library/rock_mass_file.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/digest.hpp"
#include "core/files/up_axis.hpp"
#include "core/length_unit.hpp"
#include "core/utf8.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/weld.hpp"

namespace clast {

namespace {

/// Corners nearer than this share of the diagonal are one: STL files repeat them.
constexpr double kSameCorner = 1e-9;

TriangleMesh read_mass(const RockMassFile& file) {
  const double unit = parse_length_unit(file.units);
  const bool turned = resolve_up_axis(file.up, file.path) == "y";
  TriangleMesh mass = read_mesh(file.path);
  for (Vec3& vertex : mass.vertices) {
    vertex *= unit;
    if (turned) vertex = y_up_to_z_up(vertex);
  }
  mass = weld_vertices(mass, kSameCorner * bounds(mass).diagonal());
  if (signed_volume(mass) < 0.0) {
    for (TriangleMesh::Triangle& triangle : mass.triangles) std::swap(triangle[0], triangle[1]);
  }
  return mass;
}

}  // namespace

RockMassBlocks cut_rock_mass_file(const RockMassFile& file, const RockMassOptions& options) {
  const std::string name = file.path.string();
  const BlockSource source{to_utf8(name), sha256_of_file(file.path),
                           "units=" + file.units + " up=" + resolve_up_axis(file.up, file.path),
                           ""};
  const TriangleMesh mass = read_mass(file);
  return with_error_context(name, [&] { return cut_rock_mass(mass, source, options); });
}

}  // namespace clast
