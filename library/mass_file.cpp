#include "library/mass_file.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/up_axis.hpp"
#include "core/in_context.hpp"
#include "core/length_unit.hpp"
#include "core/utf8.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/weld.hpp"

namespace clast {

namespace {

/// Corners nearer than this share of the diagonal are one: STL files repeat them.
constexpr double kSameCorner = 1e-9;

TriangleMesh read_mass(const MassFile& file) {
  const double unit = length_unit(file.units);
  const bool turned = up_axis(file.up, file.path) == "y";
  TriangleMesh mass = read_mesh(file.path);
  for (Vec3& vertex : mass.vertices) {
    vertex *= unit;
    if (turned) vertex = turned_z_up(vertex);
  }
  mass = welded(mass, kSameCorner * bounds(mass).diagonal());
  if (signed_volume(mass) < 0.0) {
    for (TriangleMesh::Triangle& triangle : mass.triangles) std::swap(triangle[0], triangle[1]);
  }
  return mass;
}

}  // namespace

MassBlocks blocks_of_mass_file(const MassFile& file, const MassBlockOptions& options) {
  const std::string name = file.path.string();
  const BlockSource source{as_utf8(name), sha256_of_file(file.path),
                           "units=" + file.units + " up=" + up_axis(file.up, file.path), ""};
  const TriangleMesh mass = read_mass(file);
  return in_context(name, [&] { return blocks_of_mass(mass, source, options); });
}

}  // namespace clast
