#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <string>

#include "core/error.hpp"
#include "core/files/text_scanner.hpp"
#include "mesh/detail/mesh_readers.hpp"

namespace clast::mesh_detail {

namespace {

constexpr std::size_t kHeader = 84;    ///< 80 bytes of anything and the count
constexpr std::size_t kTriangle = 50;  ///< normal, three corners, two bytes of attributes

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() &&
         std::equal(word.begin(), word.end(), lower.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

template <class T>
T little_endian(const char* bytes) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

TriangleMesh read_binary_stl(std::string_view content, std::size_t count) {
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const char* record = content.data() + kHeader + t * kTriangle + 12;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const char* at = record + 12 * corner;
      mesh.vertices.emplace_back(little_endian<float>(at), little_endian<float>(at + 4),
                                 little_endian<float>(at + 8));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh read_ascii_stl(std::string_view content) {
  TriangleMesh mesh;
  TextScanner text(content);
  bool in_facet = false;
  while (text.next_line()) {
    const std::string_view keyword = text.next_word();
    if (equals_ignoring_case(keyword, "facet")) {
      if (in_facet) throw InputError(text.line_prefix() + "a facet starts inside another");
      in_facet = true;
    } else if (equals_ignoring_case(keyword, "vertex")) {
      if (!in_facet) throw InputError(text.line_prefix() + "a vertex outside of any facet");
      const double x = text.next_number(), y = text.next_number();
      mesh.vertices.emplace_back(x, y, text.next_number());
    } else if (equals_ignoring_case(keyword, "endfacet")) {
      const std::size_t corners = mesh.vertices.size() - 3 * mesh.triangles.size();
      if (!in_facet || corners != 3) {
        throw InputError(text.line_prefix() + "the facet that ends here has " +
                         std::to_string(corners) + " corners instead of 3");
      }
      in_facet = false;
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size() - 3);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  if (in_facet) {
    throw InputError("the file ends inside facet " + std::to_string(mesh.triangles.size() + 1) +
                     "; it was cut short");
  }
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> read_stl_mesh(std::string_view content) {
  std::string_view text = content;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  // Some programs start binary files with "solid" too; these have zeros in the head or the count.
  const bool is_text = (equals_ignoring_case(text.substr(0, 5), "solid") ||
                        equals_ignoring_case(text.substr(0, 5), "facet")) &&
                       content.substr(0, kHeader).find('\0') == std::string_view::npos;
  if (content.size() >= kHeader) {
    const std::uint64_t count = little_endian<std::uint32_t>(content.data() + 80);
    const std::uint64_t needed = kHeader + count * kTriangle;
    if (content.size() == needed || (!is_text && content.size() > needed && count > 0)) {
      return read_binary_stl(content, count);
    }
    if (!is_text) {
      throw InputError("its header says " + std::to_string(count) + " triangles, which takes " +
                       std::to_string(needed) + " bytes, but the file has " +
                       std::to_string(content.size()) + "; it is not an STL file or was cut short");
    }
  }
  if (!is_text) {
    throw InputError("is not an STL file: neither \"solid\" text nor a binary header");
  }
  return read_ascii_stl(text);
}

}  // namespace clast::mesh_detail
