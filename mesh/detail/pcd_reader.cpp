// Point Cloud Data files, versions .5 to .7.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_scanner.hpp"
#include "mesh/detail/cloud_readers.hpp"

namespace clast::mesh_detail {
namespace {

struct Field {
  std::string name;
  std::size_t size = 4;
  char type = 'F';  ///< I, U or F
  std::size_t count = 1;
};

struct PcdHeader {
  std::vector<Field> fields;
  std::size_t points = 0;
  std::string data;  ///< ascii, binary or binary_compressed

  std::size_t record() const {
    std::size_t bytes = 0;
    for (const Field& field : fields) bytes += field.size * field.count;
    return bytes;
  }
};

std::size_t whole(TextScanner& text, std::int64_t most) {
  const std::int64_t value = text.next_integer();
  if (value < 0 || value > most) {
    throw InputError(text.line_prefix() + std::to_string(value) +
                     " can't be; the header is corrupt");
  }
  return static_cast<std::size_t>(value);
}

std::string in_case(std::string_view word, int (*converted)(int)) {
  std::string result;
  for (const char c : word) {
    result += static_cast<char>(converted(static_cast<unsigned char>(c)));
  }
  return result;
}

PcdHeader read_pcd_header(TextScanner& text) {
  constexpr std::int64_t kMaxPoints = 1'000'000'000'000, kMaxCount = 100'000;
  PcdHeader header;
  std::size_t width = 0, height = 1;
  bool has_points = false;
  while (text.next_line()) {
    const std::string keyword = in_case(text.next_word(), std::toupper);
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      for (std::string_view name = text.next_word(); !name.empty(); name = text.next_word()) {
        header.fields.push_back({std::string(name)});
      }
    } else if (keyword == "SIZE") {
      for (Field& field : header.fields) field.size = whole(text, 8);
    } else if (keyword == "TYPE") {
      for (Field& field : header.fields) {
        const std::string type = in_case(text.next_word(), std::toupper);
        if (type != "I" && type != "U" && type != "F") {
          throw InputError(text.line_prefix() + "a TYPE is I, U or F");
        }
        field.type = type[0];
      }
    } else if (keyword == "COUNT") {
      for (Field& field : header.fields) field.count = whole(text, kMaxCount);
    } else if (keyword == "WIDTH") {
      width = whole(text, kMaxPoints);
    } else if (keyword == "HEIGHT") {
      height = whole(text, kMaxPoints);
    } else if (keyword == "POINTS") {
      header.points = whole(text, kMaxPoints);
      has_points = true;
    } else if (keyword == "DATA") {
      header.data = in_case(text.next_word(), std::tolower);
      if (!has_points) header.points = width * height;
      return header;
    }
  }
  throw InputError("has no DATA line; it is not a PCD file, or was cut short");
}

/// Numbers of the columns x, y and z.
std::array<std::size_t, 3> axes_of(const PcdHeader& header) {
  std::array<std::size_t, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto found =
        std::find_if(header.fields.begin(), header.fields.end(), [&](const Field& field) {
          return field.name.size() == 1 && (field.name[0] | 0x20) == "xyz"[axis];
        });
    if (found == header.fields.end() || found->count != 1) {
      throw InputError(std::string("has no field ") + "xyz"[axis] + "; a cloud needs x, y and z");
    }
    axes[axis] = static_cast<std::size_t>(found - header.fields.begin());
  }
  return axes;
}

double pcd_number_at(const char* bytes, const Field& field) {
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  };
  if (field.type == 'F' && field.size == 4) return as(float{});
  if (field.type == 'F' && field.size == 8) return as(double{});
  const bool is_signed = field.type == 'I';
  switch (field.type == 'F' ? 0 : field.size) {
    case 1:
      return is_signed ? as(std::int8_t{}) : as(std::uint8_t{});
    case 2:
      return is_signed ? as(std::int16_t{}) : as(std::uint16_t{});
    case 4:
      return is_signed ? as(std::int32_t{}) : as(std::uint32_t{});
    case 8:
      return is_signed ? as(std::int64_t{}) : as(std::uint64_t{});
    default:
      throw InputError("field " + field.name + " has type " + field.type +
                       std::to_string(field.size) + ", which is unknown");
  }
}

/// LZF: literal runs and copies of what went before.
std::string unpacked(std::string_view packed, std::size_t size) {
  const auto corrupt = [] { return InputError("its compressed points are corrupt"); };
  std::string out;
  out.reserve(std::min<std::size_t>(size, 1 << 26));
  std::size_t at = 0;
  const auto byte = [&] {
    if (at >= packed.size()) throw corrupt();
    return static_cast<std::size_t>(static_cast<unsigned char>(packed[at++]));
  };
  while (at < packed.size()) {
    const std::size_t control = byte();
    if (control < 32) {
      const std::size_t run = control + 1;
      if (packed.size() - at < run || out.size() + run > size) throw corrupt();
      out.append(packed.substr(at, run));
      at += run;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) length += byte();
    length += 2;
    const std::size_t back = ((control & 0x1F) << 8) + byte() + 1;
    if (back > out.size() || out.size() + length > size) throw corrupt();
    for (std::size_t k = 0; k < length; ++k) out += out[out.size() - back];
  }
  if (out.size() != size) throw corrupt();
  return out;
}

void read_pcd_ascii(TextScanner& text, const PcdHeader& header, PointBatcher& sink) {
  const std::array<std::size_t, 3> axes = axes_of(header);
  std::size_t left = header.points;
  while (left > 0 && text.next_line()) {
    std::string_view word = text.next_word();
    if (word.empty()) continue;
    Vec3 point = Vec3::Zero();
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      for (std::size_t k = 0; k < header.fields[f].count; ++k) {
        const auto axis = std::find(axes.begin(), axes.end(), f);
        if (axis != axes.end()) {
          const std::optional<double> value = parse_number_token(word);
          if (!value)
            throw InputError(text.line_prefix() + "a number is needed for " +
                             header.fields[f].name);
          point[axis - axes.begin()] = *value;
        } else if (word.empty()) {
          throw InputError(text.line_prefix() + "it has fewer values than FIELDS says");
        }
        word = text.next_word();
      }
    }
    sink.add_point(point);
    --left;
  }
  if (left > 0) {
    throw InputError("its header says " + std::to_string(header.points) + " points, " +
                     std::to_string(left) + " are missing; it was cut short");
  }
}

/// @param by_field  all values of a field lie together (compressed files), else those of a point
void read_pcd_binary(std::string_view bytes, const PcdHeader& header, bool by_field,
                     PointBatcher& sink) {
  const std::size_t record = header.record();
  if (record == 0 || bytes.size() / record < header.points) {
    throw InputError("its header says " + std::to_string(header.points) + " points, the file has " +
                     std::to_string(record > 0 ? bytes.size() / record : 0) + "; it was cut short");
  }
  const std::array<std::size_t, 3> axes = axes_of(header);
  std::array<std::size_t, 3> start{}, stride{};
  std::size_t offset = 0;
  for (std::size_t f = 0; f < header.fields.size(); ++f) {
    const std::size_t size = header.fields[f].size * header.fields[f].count;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axes[axis] != f) continue;
      start[axis] = by_field ? offset * header.points : offset;
      stride[axis] = by_field ? size : record;
    }
    offset += size;
  }
  for (std::size_t i = 0; i < header.points; ++i) {
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[static_cast<Eigen::Index>(axis)] =
          pcd_number_at(bytes.data() + start[axis] + i * stride[axis], header.fields[axes[axis]]);
    }
    sink.add_point(point);
  }
}

}  // namespace

CloudSummary read_pcd_cloud(std::string_view content, PointBatcher& sink) {
  TextScanner text(content);
  const PcdHeader header = read_pcd_header(text);
  if (header.data == "ascii") {
    read_pcd_ascii(text, header, sink);
  } else if (header.data == "binary") {
    read_pcd_binary(text.remaining_text(), header, false, sink);
  } else if (header.data == "binary_compressed") {
    const std::string_view rest = text.remaining_text();
    std::array<std::uint32_t, 2> sizes{};
    if (rest.size() < sizeof sizes) throw InputError("ends before its points; it was cut short");
    std::memcpy(sizes.data(), rest.data(), sizeof sizes);
    const std::string_view packed = rest.substr(sizeof sizes);
    if (packed.size() < sizes[0]) throw InputError("ends before its points; it was cut short");
    read_pcd_binary(unpacked(packed.substr(0, sizes[0]), sizes[1]), header, true, sink);
  } else {
    throw InputError("has DATA \"" + header.data.substr(0, 40) +
                     "\"; ascii, binary and binary_compressed can be read");
  }
  return sink.finish({});
}

}  // namespace clast::mesh_detail
