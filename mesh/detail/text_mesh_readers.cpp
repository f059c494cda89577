/// OBJ, OFF and the asteroid table: formats that are plain lists of numbers.
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_scanner.hpp"
#include "mesh/detail/mesh_readers.hpp"
#include "mesh/polygon.hpp"

namespace clast::mesh_detail {

namespace {

Vec3 read_point(TextScanner& text) {
  const double x = text.next_number(), y = text.next_number();
  return {x, y, text.next_number()};
}

/// A face line; the vertices it names may come later in the file.
struct PendingFace {
  std::size_t line = 0;
  std::vector<std::int64_t> corners;
};

void append_pending(TriangleMesh& mesh, const std::vector<PendingFace>& faces) {
  for (const PendingFace& face : faces) {
    with_error_context("line " + std::to_string(face.line),
                       [&] { append_polygon(mesh, face.corners); });
  }
}

/// The next line that holds something other than a comment.
bool next_content_line(TextScanner& text) {
  while (text.next_line()) {
    const std::string_view line = text.rest_of_line();
    const std::size_t first = line.find_first_not_of(" \t\v\f");
    if (first != std::string_view::npos && line[first] != '#') return true;
  }
  return false;
}

/// `content` with lines of vertices and faces that go on below joined into one, followed by as many
/// empty lines; empty where there are none.
std::string joined_lines(std::string_view content) {
  if (content.find("\\\n") == std::string_view::npos &&
      content.find("\\\r") == std::string_view::npos) {
    return {};
  }
  std::string joined;
  TextScanner text(content);
  std::size_t open = 0;  ///< lines that were joined to the one before
  while (text.next_line()) {
    std::string_view line = text.rest_of_line();
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const bool element = open > 0 || line.substr(begin, 1) == "v" || line.substr(begin, 1) == "f";
    const bool remark = line.find('#') != std::string_view::npos;
    const bool goes_on = element && !remark && line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    joined += line;
    if (goes_on) {
      joined += ' ';
      ++open;
    } else {
      joined.append(open + 1, '\n');
      open = 0;
    }
  }
  return joined;
}

/// The rest of a line of a face, up to a remark.
/// @param vertices  read so far, from which negative numbers count back
std::vector<std::int64_t> read_corners(TextScanner& text, std::size_t vertices) {
  std::vector<std::int64_t> corners;
  for (std::string_view corner = text.next_word(); !corner.empty() && corner.front() != '#';
       corner = text.next_word()) {
    const auto number = parse_integer_token(corner.substr(0, corner.find('/')));
    if (!number || *number == 0) {
      throw InputError(text.line_prefix() + "\"" + std::string(corner.substr(0, 40)) +
                       "\" is not a vertex number (they start at 1)");
    }
    corners.push_back(*number > 0 ? *number - 1 : static_cast<std::int64_t>(vertices) + *number);
  }
  return corners;
}

}  // namespace

std::optional<TriangleMesh> read_obj_mesh(std::string_view content) {
  const std::string joined = joined_lines(content);
  TriangleMesh mesh;
  std::vector<PendingFace> faces;
  TextScanner text(joined.empty() ? content : joined);
  bool recognised = false;
  while (text.next_line()) {
    const std::string_view keyword = text.next_word();
    if (keyword == "v") {
      recognised = true;
      mesh.vertices.push_back(read_point(text));
    } else if (keyword == "f" || keyword == "fo") {  // "fo" before version 3
      recognised = true;
      faces.push_back({text.line_number(), read_corners(text, mesh.vertices.size())});
    } else if (keyword == "surf" || keyword == "curv" || keyword == "curv2" ||
               keyword == "cstype") {
      throw InputError(text.line_prefix() + "\"" + std::string(keyword) +
                       "\" begins a free-form curve or surface, which is not read; export it as "
                       "polygons");
    }
  }
  if (!recognised) throw InputError("is not an OBJ file: it has no \"v\" and no \"f\" lines");
  append_pending(mesh, faces);
  return mesh;
}

std::optional<TriangleMesh> read_off_mesh(std::string_view content) {
  TextScanner text(content);
  if (!next_content_line(text)) throw InputError("is not an OFF file");
  std::string_view keyword = text.next_word();
  if (!keyword.ends_with("OFF")) throw InputError("is not an OFF file: it starts without \"OFF\"");
  // 4OFF and nOFF have other coordinates, BINARY is not text: assimp may know them.
  keyword.remove_suffix(3);
  if (keyword.find_first_not_of("STCN") != std::string_view::npos) return std::nullopt;
  if (text.rest_of_line().find("BINARY") != std::string_view::npos) return std::nullopt;

  std::string_view first = text.next_word();
  if (first.empty() || first[0] == '#') {
    if (!next_content_line(text)) throw InputError("the file ends before the numbers of vertices");
    first = text.next_word();
  }
  const std::optional<std::int64_t> vertices = parse_integer_token(first);
  if (!vertices) throw InputError(text.line_prefix() + "the number of vertices is needed here");
  const std::int64_t faces = text.next_integer();
  // Every vertex and face takes a line of at least two bytes: a wrong count ends here.
  const auto lines = static_cast<std::int64_t>(content.size() / 2);
  if (*vertices < 0 || faces < 0 || *vertices > lines || faces > lines) {
    throw InputError(text.line_prefix() + "says " + std::to_string(*vertices) + " vertices and " +
                     std::to_string(faces) + " faces, more than the file can hold");
  }
  TriangleMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(*vertices));
  for (std::int64_t v = 0; v < *vertices; ++v) {
    if (!next_content_line(text)) {
      throw InputError("the file ends after " + std::to_string(v) + " of " +
                       std::to_string(*vertices) + " vertices; it was cut short");
    }
    mesh.vertices.push_back(read_point(text));
  }
  std::vector<PendingFace> pending;
  for (std::int64_t f = 0; f < faces; ++f) {
    if (!next_content_line(text)) {
      throw InputError("the file ends after " + std::to_string(f) + " of " + std::to_string(faces) +
                       " faces; it was cut short");
    }
    const std::int64_t count = text.next_integer();
    if (count < 0 || count > static_cast<std::int64_t>(text.rest_of_line().size())) {
      throw InputError(text.line_prefix() + "a face of " + std::to_string(count) + " corners");
    }
    if (count < 3) continue;  // points and lines of a mixed file
    pending.push_back({text.line_number(), {}});
    for (std::int64_t k = 0; k < count; ++k) pending.back().corners.push_back(text.next_integer());
  }
  append_pending(mesh, pending);
  return mesh;
}

std::optional<TriangleMesh> read_tab_mesh(std::string_view content) {
  TriangleMesh mesh;
  std::vector<PendingFace> faces;
  TextScanner text(content);
  std::int64_t smallest = 1, largest = 0;
  while (next_content_line(text)) {
    const std::string_view keyword = text.next_word();
    if (keyword == "v") {
      mesh.vertices.push_back(read_point(text));
    } else if (keyword == "f") {
      const std::int64_t i = text.next_integer(), j = text.next_integer(), k = text.next_integer();
      faces.push_back({text.line_number(), {i, j, k}});
      smallest = std::min({smallest, i, j, k});
      largest = std::max({largest, i, j, k});
    } else {
      throw InputError(text.line_prefix() + "is not a line \"v x y z\" or \"f i j k\"");
    }
  }
  // Tables count from 0 or from 1; only the latter reach the number of vertices.
  if (smallest > 0 && largest == static_cast<std::int64_t>(mesh.vertices.size())) {
    for (PendingFace& face : faces) {
      for (std::int64_t& corner : face.corners) --corner;
    }
  }
  append_pending(mesh, faces);
  return mesh;
}

}  // namespace clast::mesh_detail
