#include "mesh/labelled_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/little_endian.hpp"
#include "mesh/ply_properties.hpp"

namespace clast {

using mesh_detail::append_little_endian;

namespace {

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

}  // namespace

void write_labelled_cloud(const std::filesystem::path& path, std::span<const Vec3> points,
                          std::span<const std::uint32_t> blocks) {
  const bool single = std::all_of(points.begin(), points.end(), [](const Vec3& p) {
    return is_float(p.x()) && is_float(p.y()) && is_float(p.z());
  });
  const std::string type = single ? "float" : "double";
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment made by clast\nelement vertex " +
      std::to_string(points.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) bytes += "property " + type + " " + axis + "\n";
  bytes += blocks.empty() ? "end_header\n" : "property int block\nend_header\n";
  bytes.reserve(bytes.size() + points.size() * (single ? 16 : 28));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double coordinate : points[i]) {
      if (single) {
        append_little_endian(bytes, static_cast<float>(coordinate));
      } else {
        append_little_endian(bytes, coordinate);
      }
    }
    if (!blocks.empty()) append_little_endian(bytes, blocks[i]);
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
