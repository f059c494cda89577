#include "shapes/shp_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "shapes/detail/shp_reader.hpp"

namespace clast {

namespace {

/// Digits that bring a double back bit by bit.
constexpr int kDigits = 17;

void check_name(const std::string& name) {
  const bool usable = !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isspace(c) || c == '<' || c == '>';
  });
  if (!usable) {
    throw InputError("shape name \"" + name +
                     "\": a .shp file takes names without blanks, < and >; rename the block");
  }
}

/// " x y z"
std::string numbers(const Vec3& v) {
  std::ostringstream text;
  text << std::setprecision(kDigits) << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
  return text.str();
}

void write_shape(std::ostream& out, const ShpShape& shape) {
  const SpheroPolyhedron& body = shape.body;
  out << "<\nname " << shape.name << "\nradius " << body.radius << "\npreCompDone y\n"
      << (shape.is_surface ? "isSurface\n" : "");
  out << "nv " << body.vertices.size() << '\n';
  for (const Vec3& v : body.vertices) out << numbers(v).substr(1) << '\n';
  out << "ne " << body.edges.size() << '\n';
  for (const SpheroPolyhedron::Edge& e : body.edges) out << e[0] << ' ' << e[1] << '\n';
  out << "nf " << body.faces.size() << '\n';
  for (const SpheroPolyhedron::Face& face : body.faces) {
    out << face.size();
    for (const std::uint32_t v : face) out << ' ' << v;
    out << '\n';
  }
  const Vec3 half_sizes = 0.5 * shape.box.lengths;
  out << "obb.extent" << numbers(half_sizes) << "\nobb.e1" << numbers(shape.box.axes.col(0))
      << "\nobb.e2" << numbers(shape.box.axes.col(1)) << "\nobb.e3"
      << numbers(shape.box.axes.col(2)) << "\nobb.center" << numbers(shape.box.centre) << '\n';
  const Quat& turn = shape.source_from_body.rotation;
  out << "volume " << shape.volume << "\nI/m" << numbers(shape.inertia_per_mass) << "\nposition"
      << numbers(shape.source_from_body.translation) << "\norientation " << turn.w() << ' '
      << turn.x() << ' ' << turn.y() << ' ' << turn.z() << "\n>\n";
}

}  // namespace

void write_shp(const std::filesystem::path& path, std::span<const ShpShape> shapes,
               const OverwritePolicy& rules) {
  std::ostringstream out;
  out << std::setprecision(kDigits);
  for (const ShpShape& shape : shapes) {
    check_name(shape.name);
    write_shape(out, shape);
  }
  write_output(path, out.str(), rules);
}

std::vector<ShpShape> read_shp(const std::filesystem::path& path) {
  return with_file_context(path.string(),
                           [&] { return shapes_detail::parse_shp(read_text_file(path)); });
}

bool is_esri_shapefile(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return false;  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  std::string start(shapes_detail::kEsriShapefileMagic.size(), ' ');
  return file.read(start.data(), static_cast<std::streamsize>(start.size())) &&
         start == shapes_detail::kEsriShapefileMagic;
}

}  // namespace clast
