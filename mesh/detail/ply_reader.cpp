#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_scanner.hpp"
#include "mesh/detail/mesh_readers.hpp"
#include "mesh/polygon.hpp"

namespace clast::mesh_detail {

namespace {

enum class Format { kAscii, kLittle, kBig };

struct Type {
  char kind = 'i';  ///< i: signed, u: unsigned, f: floating point
  std::size_t bytes = 4;
};

struct Property {
  std::string name;
  Type type;
  bool is_list = false;
  Type count_type;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  Format format = Format::kAscii;
  std::vector<Element> elements;
};

Type parse_type(const TextScanner& text, std::string_view name) {
  static const std::map<std::string_view, Type> kTypes = {
      {"char", {'i', 1}},  {"int8", {'i', 1}},    {"uchar", {'u', 1}},  {"uint8", {'u', 1}},
      {"short", {'i', 2}}, {"int16", {'i', 2}},   {"ushort", {'u', 2}}, {"uint16", {'u', 2}},
      {"int", {'i', 4}},   {"int32", {'i', 4}},   {"uint", {'u', 4}},   {"uint32", {'u', 4}},
      {"float", {'f', 4}}, {"float32", {'f', 4}}, {"double", {'f', 8}}, {"float64", {'f', 8}}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) {
    throw InputError(text.line_prefix() + "unknown type \"" + std::string(name.substr(0, 40)) +
                     "\"");
  }
  return found->second;
}

PlyHeader read_ply_header(TextScanner& text) {
  if (!text.next_line() || text.next_word() != "ply") {
    throw InputError("is not a PLY file: it does not start with \"ply\"");
  }
  PlyHeader header;
  bool has_format = false;
  while (text.next_line()) {
    const std::string_view keyword = text.next_word();
    if (keyword == "end_header") {
      if (!has_format) throw InputError("the PLY header has no \"format\" line");
      return header;
    }
    if (keyword == "format") {
      const std::string_view name = text.next_word();
      has_format = true;
      if (name == "ascii") {
        header.format = Format::kAscii;
      } else if (name == "binary_little_endian") {
        header.format = Format::kLittle;
      } else if (name == "binary_big_endian") {
        header.format = Format::kBig;
      } else {
        throw InputError(text.line_prefix() + "unknown PLY format");
      }
    } else if (keyword == "element") {
      Element element;
      element.name = text.next_word();
      element.count = text.next_integer();
      if (element.count < 0) throw InputError(text.line_prefix() + "a negative number of elements");
      header.elements.push_back(element);
    } else if (keyword == "property") {
      if (header.elements.empty())
        throw InputError(text.line_prefix() + "a property without an element");
      Property property;
      std::string_view type = text.next_word();
      if (type == "list") {
        property.is_list = true;
        property.count_type = parse_type(text, text.next_word());
        type = text.next_word();
      }
      property.type = parse_type(text, type);
      property.name = text.next_word();
      if (property.name == "X" || property.name == "Y" || property.name == "Z") {
        property.name[0] = static_cast<char>(property.name[0] - 'A' + 'a');
      }
      header.elements.back().properties.push_back(property);
    }
  }
  throw InputError("the PLY header has no end; the file was cut short");
}

/// The values after the header, one at a time.
class Body {
 public:
  /// A text with one line for each element is read line by line, so that numbers beyond those that
  /// the header declares, such as colours of faces, are passed over.
  Body(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes), format_(header.format), by_line_(has_a_line_each(bytes, header)) {}

  /// Goes on to the next element.
  void begin_element() {
    if (!by_line_) return;
    if (in_line_) bytes_.remove_prefix(std::min(line_end(bytes_), bytes_.size()));
    bytes_.remove_prefix(std::min(bytes_.find_first_not_of(kBlank), bytes_.size()));
    line_ = bytes_.substr(0, line_end(bytes_));
    in_line_ = true;
  }

  double value(const Type& type) { return format_ == Format::kAscii ? word() : binary(type); }

  std::size_t count(const Type& type) {
    const double number = value(type);
    if (!(number >= 0.0) || number > static_cast<double>(bytes_.size())) {
      throw InputError("a list has more entries than the file can contain; the file is corrupt");
    }
    return static_cast<std::size_t>(number);
  }

  /// Throws when `element` can't fit in what is left of the file.
  void check_disk_space(const Element& element) const {
    std::size_t each = 0;
    for (const Property& p : element.properties) {
      // A word of text takes a character and a blank; the last one may end the file.
      each += format_ == Format::kAscii ? 2 : p.is_list ? p.count_type.bytes : p.type.bytes;
    }
    const double needed = static_cast<double>(each) * static_cast<double>(element.count);
    if (needed > static_cast<double>(bytes_.size()) + 1.0) {
      throw InputError("its header says " + std::to_string(element.count) + " of element \"" +
                       element.name + "\", more than the " + std::to_string(bytes_.size()) +
                       " bytes after the header can hold; it was cut short");
    }
  }

 private:
  static constexpr std::string_view kBlank = " \t\r\n\v\f";

  static std::size_t line_end(std::string_view bytes) { return bytes.find_first_of("\r\n"); }

  static bool has_a_line_each(std::string_view bytes, const PlyHeader& header) {
    if (header.format != Format::kAscii) return false;
    std::int64_t elements = 0, lines = 0;
    for (const Element& element : header.elements) {
      if (!element.properties.empty()) elements += element.count;
    }
    while (lines <= elements) {
      const std::size_t begin = bytes.find_first_not_of(kBlank);
      if (begin == std::string_view::npos) break;
      bytes.remove_prefix(begin);
      bytes.remove_prefix(std::min(line_end(bytes), bytes.size()));
      ++lines;
    }
    return lines == elements;
  }

  [[noreturn]] static void fail_short() {
    throw InputError("the file ends before all its elements; it was cut short");
  }

  double binary(const Type& type) {
    if (bytes_.size() < type.bytes) fail_short();
    std::array<char, 8> raw{};
    std::copy_n(bytes_.begin(), type.bytes, raw.begin());
    bytes_.remove_prefix(type.bytes);
    const bool file_is_little = format_ == Format::kLittle;
    if (file_is_little != (std::endian::native == std::endian::little)) {
      std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.bytes));
    }
    const auto as = [&]<class T>(T) {
      T number;
      std::memcpy(&number, raw.data(), sizeof(T));
      return static_cast<double>(number);
    };
    if (type.kind == 'f') return type.bytes == 4 ? as(float{}) : as(double{});
    switch (type.bytes) {
      case 1:
        return type.kind == 'i' ? as(std::int8_t{}) : as(std::uint8_t{});
      case 2:
        return type.kind == 'i' ? as(std::int16_t{}) : as(std::uint16_t{});
      default:
        return type.kind == 'i' ? as(std::int32_t{}) : as(std::uint32_t{});
    }
  }

  double word() {
    std::string_view& rest = by_line_ ? line_ : bytes_;
    const std::size_t begin = rest.find_first_not_of(kBlank);
    if (begin == std::string_view::npos) {
      if (by_line_ && line_end(bytes_) != std::string_view::npos) {
        throw InputError(
            "the line \"" +
            std::string(bytes_.substr(0, std::min<std::size_t>(line_end(bytes_), 40))) +
            "\" holds fewer numbers than the header says; export it again");
      }
      fail_short();
    }
    rest.remove_prefix(begin);
    const std::string_view text = rest.substr(0, rest.find_first_of(kBlank));
    rest.remove_prefix(text.size());
    if (const std::optional<double> number = parse_number_token(text)) return *number;
    throw InputError("\"" + std::string(text.substr(0, 40)) + "\" is not a number" +
                     (text.find(',') == std::string_view::npos
                          ? ""
                          : "; PLY requires decimal points, export it with decimal points"));
  }

  std::string_view bytes_;
  Format format_;
  bool by_line_;
  bool in_line_ = false;
  std::string_view line_;  ///< what is left of the line of the element
};

std::int64_t vertex_number(double value) {
  if (value != std::floor(value) || std::abs(value) > 9e15) {
    throw InputError("a face refers to vertex " + std::to_string(value) + "; it is corrupt");
  }
  return static_cast<std::int64_t>(value);
}

/// Reads the vertices and calls `consume` with the values of the named properties of each.
void read_vertices(Body& body, const Element& element, const std::vector<std::string>& names,
                   const std::function<void(const std::vector<double>&)>& consume) {
  constexpr std::size_t kUnnamed = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> places(element.properties.size(), kUnnamed);
  for (std::size_t n = 0; n < names.size(); ++n) {
    bool has = false;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Property& property = element.properties[p];
      if (property.name != names[n] || property.is_list) continue;
      places[p] = n;
      has = true;
    }
    if (!has) throw InputError("its vertices have no property \"" + names[n] + "\"");
  }
  std::vector<double> values(names.size(), 0.0);
  for (std::int64_t i = 0; i < element.count; ++i) {
    body.begin_element();
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Property& property = element.properties[p];
      for (std::size_t left = property.is_list ? body.count(property.count_type) : 1; left > 0;
           --left) {
        const double value = body.value(property.type);
        if (places[p] != kUnnamed) values[places[p]] = value;
      }
    }
    consume(values);
  }
}

bool is_corner_list(const Property& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Lists of corners of the faces; those of other elements are passed over.
void read_lists(Body& body, const Element& element, std::vector<std::vector<std::int64_t>>* faces) {
  if (element.properties.empty()) return;
  for (std::int64_t i = 0; i < element.count; ++i) {
    body.begin_element();
    for (const Property& property : element.properties) {
      const std::size_t count = property.is_list ? body.count(property.count_type) : 1;
      const bool corners = faces && is_corner_list(property);
      if (corners) faces->emplace_back();
      for (std::size_t k = 0; k < count; ++k) {
        const double value = body.value(property.type);
        if (corners) faces->back().push_back(vertex_number(value));
      }
    }
  }
}

/// Replaces the strips from `first` on by triangles; -1 ends a strip, every second one is flipped.
void split_strips(std::vector<std::vector<std::int64_t>>& faces, std::size_t first) {
  std::vector<std::vector<std::int64_t>> triangles;
  for (std::size_t s = first; s < faces.size(); ++s) {
    const std::vector<std::int64_t>& strip = faces[s];
    std::size_t begin = 0;
    for (std::size_t k = 0; k < strip.size(); ++k) {
      if (strip[k] == -1) begin = k + 1;
      if (k < begin + 2) continue;
      const bool turned = (k - begin) % 2 == 1;
      triangles.push_back({strip[k - (turned ? 1 : 2)], strip[k - (turned ? 2 : 1)], strip[k]});
    }
  }
  faces.resize(first);
  faces.insert(faces.end(), triangles.begin(), triangles.end());
}

}  // namespace

std::optional<TriangleMesh> read_ply_mesh(std::string_view content) {
  TextScanner text(content);
  const PlyHeader header = read_ply_header(text);
  Body body(text.remaining_text(), header);
  TriangleMesh mesh;
  std::vector<std::vector<std::int64_t>> faces;
  for (const Element& element : header.elements) {
    body.check_disk_space(element);
    if (element.name == "vertex") {
      mesh.vertices.reserve(static_cast<std::size_t>(element.count));
      read_vertices(body, element, {"x", "y", "z"}, [&](const std::vector<double>& values) {
        mesh.vertices.emplace_back(values[0], values[1], values[2]);
      });
    } else {
      const bool surface = element.name == "face" || element.name == "tristrips";
      const std::size_t before = faces.size();
      read_lists(body, element, surface ? &faces : nullptr);
      if (element.name == "tristrips") split_strips(faces, before);
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    with_error_context("face " + std::to_string(f + 1), [&] { append_polygon(mesh, faces[f]); });
  }
  return mesh;
}

std::vector<std::vector<double>> read_ply_vertex_values(std::string_view content,
                                                        const std::vector<std::string>& names) {
  TextScanner text(content);
  const PlyHeader header = read_ply_header(text);
  Body body(text.remaining_text(), header);
  std::vector<std::vector<double>> columns(names.size());
  for (const Element& element : header.elements) {
    body.check_disk_space(element);
    if (element.name != "vertex") {
      read_lists(body, element, nullptr);
      continue;
    }
    read_vertices(body, element, names, [&](const std::vector<double>& values) {
      for (std::size_t n = 0; n < names.size(); ++n) columns[n].push_back(values[n]);
    });
    return columns;
  }
  throw InputError("it has no vertices");
}

}  // namespace clast::mesh_detail
