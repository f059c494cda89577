#include "samples/deposit/labelled_cloud.hpp"

#include <bit>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "mesh/ply_properties.hpp"
#include "samples/float_ply.hpp"

namespace clast {

void write_cloud(const std::filesystem::path& path, std::span<const Vec3> points,
                 std::span<const std::uint32_t> blocks) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\n"
      "comment made by make_deposit of clast, CC0-1.0, lengths in metres\nelement vertex " +
      std::to_string(points.size()) + "\nproperty float x\nproperty float y\nproperty float z\n" +
      (blocks.empty() ? "" : "property int block\n") + "end_header\n";
  bytes.reserve(bytes.size() + points.size() * (blocks.empty() ? 12 : 16));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(points[i][axis])));
    }
    if (!blocks.empty()) append_word(bytes, blocks[i]);
  }
  write_text_file(path, bytes);
}

LabelledCloud read_labelled_cloud(const std::filesystem::path& path) {
  const std::vector<std::vector<double>> columns =
      read_ply_vertex_properties(path, {"x", "y", "z", "block"});
  LabelledCloud cloud;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const double block = columns[3][i];
    if (!(block >= 0.0 && block <= 1e9 && block == std::floor(block))) {
      throw InputError(path.string() + ": point " + std::to_string(i + 1) + " has the block " +
                       format_significant(block, 9) +
                       "; blocks are whole numbers, 0 where there is none");
    }
    cloud.points.emplace_back(columns[0][i], columns[1][i], columns[2][i]);
    cloud.blocks.push_back(static_cast<std::uint32_t>(block));
  }
  return cloud;
}

}  // namespace clast
