#include "library/body_record.hpp"

#include <numeric>

#include "library/detail/hdf5_records.hpp"
#include "shapes/edge_convexity.hpp"

namespace clast {

using namespace library_detail;

void write_body(Hdf5Group group, const SpheroPolyhedron& body) {
  group.set_attribute("minkowski_radius_m", body.radius);
  write_points(group, "vertices", body.vertices);
  write_indices<2>(group, "edges", body.edges);
  std::vector<std::uint32_t> sizes, corners;
  for (const SpheroPolyhedron::Face& face : body.faces) {
    sizes.push_back(static_cast<std::uint32_t>(face.size()));
    corners.insert(corners.end(), face.begin(), face.end());
  }
  group.write<std::uint32_t>("face_sizes", sizes);
  group.write<std::uint32_t>("face_vertices", corners);
  std::vector<std::uint8_t> bends;
  for (const EdgeConvexity bend : edge_convexities(body))
    bends.push_back(static_cast<std::uint8_t>(bend));
  group.write<std::uint8_t>("edge_bends", bends);
  group.set_unit("edge_bends", "1");
  group.set_unit("face_sizes", "1");
  group.set_unit("face_vertices", "1");
}

SpheroPolyhedron read_body(const Hdf5Group& group, const std::string& where) {
  SpheroPolyhedron body;
  body.radius = read_scalar(group, "minkowski_radius_m", 0.0, where);
  body.vertices = read_points(group, "vertices", where);
  check_stored_value(!body.vertices.empty(), where, "core has no vertices");
  body.edges = read_indices<2>(group, "edges", body.vertices.size(), where);
  const std::vector<std::uint32_t> sizes = group.read<std::uint32_t>("face_sizes");
  const std::vector<std::uint32_t> corners = group.read<std::uint32_t>("face_vertices");
  check_indices(corners, body.vertices.size(), "face_vertices", where);
  check_stored_value(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) == corners.size(),
                     where, "face_sizes and face_vertices do not fit each other");
  auto corner = corners.begin();
  for (const std::uint32_t size : sizes) {
    check_stored_value(size >= 3, where, "a face has fewer than three vertices");
    body.faces.emplace_back(corner, corner + size);
    corner += size;
  }
  return body;
}

}  // namespace clast
