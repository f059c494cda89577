#include "samples/float_ply.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/files/text_file.hpp"

namespace clast {

void append_word(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255u);
}

void write_float_ply(const std::filesystem::path& path, const TriangleMesh& mesh, double grid,
                     const std::string& comment) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + comment +
                      "\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      // Adding zero turns a negative zero into a positive one.
      const double rounded = std::round(vertex[axis] / grid) * grid + 0.0;
      append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(rounded)));
    }
  }
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : triangle) append_word(bytes, corner);
  }
  write_text_file(path, bytes);
}

}  // namespace clast
