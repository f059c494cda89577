#include "shapes/detail/shp_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/files/text_scanner.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"

namespace clast::shapes_detail {

namespace {

using Index = std::uint32_t;

constexpr double kUnitSlack = 1e-3;  ///< quaternions this far from length 1 are normalised
constexpr double kMinShpPoints = 1e3, kMaxShpPoints = 1e7;  ///< Rockable keeps MCnstep between
constexpr std::string_view kKeywords =
    "name, radius, preCompDone, nv, ne, nf, volume, I/m, obb.extent, obb.center, obb.e1, obb.e2, "
    "obb.e3, position, orientation, isSurface, MCnstep, fibObbOption, OBBtreeLevel";

/// Reads one shape after the other; words may stand on any line.
class ShpReader {
 public:
  explicit ShpReader(std::string_view content) : text_(content), bytes_(content.size()) {}

  std::vector<ShpShape> shapes() {
    std::vector<ShpShape> found;
    std::set<std::string> names;
    while (!(word_ = next_word()).empty()) {
      if (word_ != "<") {
        fail("a shape starts with <, found \"" + printable(word_) +
             "\"; is this a Rockable shape file?");
      }
      found.push_back(read_shape());
      if (!names.insert(found.back().name).second) {
        fail("this file has another shape of the same name; give each shape a name of its own");
      }
      shape_.clear();
    }
    if (found.empty()) {
      throw InputError("holds no shape; a .shp file has shapes between < and >");
    }
    return found;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("line " + std::to_string(text_.line_number()) + ": " +
                     (shape_.empty() ? "" : "shape " + shape_ + ": ") + what);
  }

  static std::string printable(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 40)) text += c >= 32 && c < 127 ? c : '?';
    return text;
  }

  /// The next word that is no comment; empty at the end.
  std::string_view next_word() {
    for (;;) {
      const std::string_view word = text_.next_word();
      const bool comment = word.starts_with('#') || word.starts_with('!') || word.starts_with("//");
      if (!word.empty() && !comment) return word;
      if (!text_.next_line()) return {};
    }
  }

  std::string_view needed(const std::string& what) {
    const std::string_view word = next_word();
    if (word.empty()) fail("the file ends where " + what + " is needed; it was cut short");
    return word;
  }

  double number(const std::string& what) {
    const std::string_view word = needed(what);
    const std::optional<double> value = parse_number_token(word);
    if (!value) fail(what + " is needed, found \"" + printable(word) + "\"");
    if (!std::isfinite(*value)) {
      fail(what + " is \"" + printable(word) + "\", not a finite number; correct the file");
    }
    return *value;
  }

  Vec3 vector(const std::string& what) {
    const double x = number(what), y = number(what);
    return {x, y, number(what)};
  }

  std::int64_t integer(const std::string& what) {
    const std::string_view word = needed(what);
    const std::optional<std::int64_t> value = parse_integer_token(word);
    if (!value) fail(what + " is needed, found \"" + printable(word) + "\"");
    return *value;
  }

  /// A number of things that take `bytes` each in the file at least.
  std::size_t count(const std::string& what, std::size_t bytes) {
    const std::int64_t value = integer("the number of " + what);
    if (value < 0 || static_cast<std::uint64_t>(value) > bytes_ / bytes) {
      fail(std::to_string(value) + " " + what + " do not fit in a file of " +
           std::to_string(bytes_) + " bytes; correct the count");
    }
    return static_cast<std::size_t>(value);
  }

  Index vertex_number(const std::string& what) {
    const std::int64_t value = integer(what);
    if (value < 0 || value > 0xfffffffe) {
      fail(what + " is " + std::to_string(value) + "; vertices are counted from 0");
    }
    largest_ = std::max(largest_, static_cast<Index>(value));
    return static_cast<Index>(value);
  }

  void read_vertices(SpheroPolyhedron& body) {
    const std::size_t vertices = count("vertices", 6);
    body.vertices.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      body.vertices.push_back(vector("a coordinate of vertex " + std::to_string(v)));
    }
  }

  void read_edges(SpheroPolyhedron& body) {
    const std::size_t edges = count("edges", 4);
    for (std::size_t e = 0; e < edges; ++e) {
      const std::string what = "a vertex of edge " + std::to_string(e);
      const Index from = vertex_number(what), to = vertex_number(what);
      body.edges.push_back(make_edge_key(from, to));
    }
  }

  void read_faces(SpheroPolyhedron& body) {
    const std::size_t faces = count("faces", 8);
    for (std::size_t f = 0; f < faces; ++f) {
      const std::string which = "face " + std::to_string(f);
      const std::size_t corners = count("corners of " + which, 2);
      if (corners < 3) fail(which + " has " + std::to_string(corners) + " corners, 3 are needed");
      body.faces.emplace_back();
      for (std::size_t k = 0; k < corners; ++k) {
        body.faces.back().push_back(vertex_number("a vertex of " + which));
      }
    }
  }

  void read_orientation(ShpShape& shape) {
    const double w = number("orientation"), x = number("orientation"), y = number("orientation");
    Quat turn(w, x, y, number("orientation"));
    if (std::abs(turn.norm() - 1.0) > kUnitSlack) {
      fail("the orientation has length " + format_significant(turn.norm(), 4) +
           "; a rotation is a quaternion w x y z of length 1");
    }
    if (std::abs(turn.norm() - 1.0) > 1e-15) turn.normalize();
    shape.source_from_body.rotation = turn;
  }

  void read_keyword(ShpShape& shape) {
    const std::string key(word_);
    if (key == "name") {
      shape.name = text_.next_word();
      if (shape.name.empty()) fail("a name is needed on this line");
      shape_ = printable(shape.name);
    } else if (key == "radius") {
      shape.body.radius = number("the radius");
      if (shape.body.radius < 0.0) {
        fail("the radius is " + format_significant(shape.body.radius, 6) +
             "; it must be 0 or more");
      }
    } else if (key == "preCompDone") {
      const std::string_view answer = needed("y or n after preCompDone");
      if (answer != "y" && answer != "n") {
        fail("preCompDone is y or n, found \"" + printable(answer) + "\"");
      }
      computed_ = answer == "y";
    } else if (key == "nv") {
      read_vertices(shape.body);
    } else if (key == "ne") {
      read_edges(shape.body);
    } else if (key == "nf") {
      read_faces(shape.body);
    } else if (key == "volume") {
      shape.volume = number("the volume");
    } else if (key == "I/m") {
      shape.inertia_per_mass = vector("I/m, three numbers,");
    } else if (key == "obb.extent") {
      half_sizes_ = vector("obb.extent, three numbers,");
    } else if (key == "obb.center") {
      shape.box.centre = vector("obb.center, three numbers,");
    } else if (key == "obb.e1" || key == "obb.e2" || key == "obb.e3") {
      shape.box.axes.col(key[5] - '1') = vector(key + ", three numbers,");
    } else if (key == "position") {
      shape.source_from_body.translation = vector("position, three numbers,");
    } else if (key == "orientation") {
      read_orientation(shape);
    } else if (key == "isSurface") {
      shape.is_surface = true;
    } else if (key == "MCnstep") {
      shape.sampled_points = std::clamp(number("MCnstep"), kMinShpPoints, kMaxShpPoints);
    } else if (key == "fibObbOption" || key == "OBBtreeLevel") {
      number(key);
    } else {
      fail("\"" + printable(key) + "\" is no keyword of a shape; known are " +
           std::string(kKeywords) + ". Correct it or delete it");
    }
  }

  ShpShape read_shape() {
    ShpShape shape;
    std::set<std::string> seen;
    largest_ = 0;
    computed_ = false;
    half_sizes_ = Vec3::Zero();
    const std::size_t start = text_.line_number();
    for (;;) {
      word_ = next_word();
      if (word_.empty() || word_ == "<") {
        fail("the shape that starts in line " + std::to_string(start) +
             " is not closed by >; the file was cut short");
      }
      if (word_ == ">") break;
      if (!seen.emplace(word_).second) {
        fail("\"" + printable(word_) + "\" occurs twice; delete one of them");
      }
      read_keyword(shape);
    }
    for (const auto& [key, what] :
         {std::pair{"name", "a name"}, {"radius", "a Minkowski radius"}, {"nv", "vertices"}}) {
      if (!seen.count(key)) {
        fail("the shape that starts in line " + std::to_string(start) + " has no " + key + " (" +
             what + "); add it");
      }
    }
    if (shape.body.vertices.empty()) fail("the shape has no vertices");
    const bool has_parts = !shape.body.edges.empty() || !shape.body.faces.empty();
    if (has_parts && largest_ >= shape.body.vertices.size()) {
      fail("an edge or a face names vertex " + std::to_string(largest_) +
           ", counted from 0, but there are " + std::to_string(shape.body.vertices.size()));
    }
    tidy(shape);
    if (computed_) {
      sort_box(shape.box);
    } else {  // what stands there is to be computed still
      shape.volume = 0.0;
      shape.inertia_per_mass.setZero();
      shape.box = {};
      shape.source_from_body = {};
    }
    return shape;
  }

  /// Edges each once; those of the faces where there are faces; unused vertices left out.
  void tidy(ShpShape& shape) const {
    SpheroPolyhedron& body = shape.body;
    std::erase_if(body.edges, [](const SpheroPolyhedron::Edge& e) { return e[0] == e[1]; });
    std::sort(body.edges.begin(), body.edges.end());
    body.edges.erase(std::unique(body.edges.begin(), body.edges.end()), body.edges.end());
    if (body.faces.empty()) return;
    check_edges_lie_on_faces(body);
    body.edges = face_edges(body.faces);
    constexpr Index kUnused = 0xffffffffu;
    std::vector<Index> number(body.vertices.size(), kUnused);
    for (const SpheroPolyhedron::Face& face : body.faces) {
      for (const Index v : face) number[v] = 0;
    }
    std::vector<Vec3> used;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == kUnused) continue;
      number[v] = static_cast<Index>(used.size());
      used.push_back(body.vertices[v]);
    }
    if (used.size() == body.vertices.size()) return;
    const std::size_t unused = body.vertices.size() - used.size();
    shape.notes.push_back(std::to_string(unused) + (unused == 1 ? " vertex" : " vertices") +
                          " of the .shp file that no face uses, left out");
    body.vertices = std::move(used);
    for (SpheroPolyhedron::Face& face : body.faces) {
      for (Index& v : face) v = number[v];
    }
    for (SpheroPolyhedron::Edge& edge : body.edges) {
      for (Index& v : edge) v = number[v];
    }
  }

  /// An edge may be a side or a diagonal of a face; else it is a rod beside the polyhedron.
  void check_edges_lie_on_faces(const SpheroPolyhedron& body) const {
    const std::vector<SpheroPolyhedron::Edge> sides = face_edges(body.faces);
    std::vector<std::vector<Index>> faces_at(body.vertices.size());
    for (Index f = 0; f < body.faces.size(); ++f) {
      for (const Index v : body.faces[f]) faces_at[v].push_back(f);
    }
    for (const SpheroPolyhedron::Edge& edge : body.edges) {
      if (std::binary_search(sides.begin(), sides.end(), edge)) continue;
      const std::vector<Index>&a = faces_at[edge[0]], &b = faces_at[edge[1]];
      const bool diagonal = std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
      if (diagonal) continue;
      fail("the edge " + std::to_string(edge[0]) + " " + std::to_string(edge[1]) +
           " lies on no face; clast takes closed polyhedra, balls and capsules, but no rods beside "
           "a polyhedron: delete the edge or the faces");
    }
  }

  /// L, I, S in order, right-handed.
  void sort_box(OrientedBox& box) const {
    const Vec3 lengths = 2.0 * half_sizes_;
    const Mat3 axes = box.axes;
    std::array<int, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return lengths[i] > lengths[j]; });
    for (int i = 0; i < 3; ++i) {
      box.lengths[i] = lengths[order[static_cast<std::size_t>(i)]];
      box.axes.col(i) = axes.col(order[static_cast<std::size_t>(i)]);
    }
    if (box.axes.determinant() < 0.0) box.axes.col(2) *= -1.0;
  }

  TextScanner text_;
  std::size_t bytes_;
  std::string_view word_;
  std::string shape_;  ///< name of the shape that is being read
  Index largest_ = 0;  ///< largest vertex number of its edges and faces
  bool computed_ = false;
  Vec3 half_sizes_ = Vec3::Zero();
};

}  // namespace

std::vector<ShpShape> parse_shp(std::string_view content) {
  if (content.starts_with(kEsriShapefileMagic)) {
    throw InputError("is a map file (ESRI shapefile), not a Rockable shape; both are called .shp");
  }
  return ShpReader(content).shapes();
}

}  // namespace clast::shapes_detail
