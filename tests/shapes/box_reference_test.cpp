#include <gtest/gtest.h>

#include <sstream>

#include "core/files/text_file.hpp"
#include "mesh/mesh_io.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// Vertices of a mesh file, of the table of points of a .ply without faces, or of an .xyz.
std::vector<Vec3> points_of(const ReferenceRow& row) {
  const std::filesystem::path path = test_data("meshes/" + row.at("file"));
  if (row.at("kind") == "mesh") return read_mesh(path).vertices;
  std::string text = read_text_file(path);
  const std::size_t header = text.find("end_header");
  if (header != std::string::npos) text.erase(0, text.find('\n', header) + 1);
  std::istringstream lines(text);
  std::vector<Vec3> points;
  for (std::string line; std::getline(lines, line);) {
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream fields(line);
    Vec3 p;
    if (fields >> p[0] >> p[1] >> p[2]) points.push_back(p);
  }
  return points;
}

// The best of four programs' boxes, one of them a long random search in double precision.
TEST(BoxReference, NoFilesBoxIsAboveTheBestKnown) {
  int boxes = 0;
  for (const ReferenceRow& row : mesh_reference()) {
    if (row.at("obb_volume_best").empty()) continue;
    const OrientedBox box = smallest_box(points_of(row));
    EXPECT_LE(box.volume(), value(row, "obb_volume_best") * (1.0 + 1e-5)) << row.at("file");
    EXPECT_GE(box.volume(), value(row, "hull_volume")) << row.at("file");
    ++boxes;
  }
  EXPECT_GE(boxes, 17);
}

}  // namespace
}  // namespace clast
