// LAS 1.0 to 1.4 (ASPRS LAS Specification 1.4 R15); all numbers in it are little-endian.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/cloud_readers.hpp"
#include "mesh/detail/las_system.hpp"
#include "mesh/detail/laz_unpacker.hpp"

namespace clast::mesh_detail {
namespace {

static_assert(std::endian::native == std::endian::little, "LAS is read as it lies in the file");

constexpr std::size_t kMinHeader = 227, kHeader14 = 375;
constexpr std::uint8_t kNoise = 7, kHighNoise = 18;
/// Smallest record of each point format 0 to 10.
constexpr std::array<std::size_t, 11> kRecordSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::size_t kRecordsPerRead = 16384;

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

std::string read_bytes(std::istream& stream, std::size_t count) {
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

struct LasHeader {
  bool compressed = false;
  std::uint64_t count = 0;
  std::uint64_t data_offset = 0;
  std::uint16_t header_size = 0;
  LasRecordLayout records;
  std::size_t format = 0;
  std::size_t record_size = 0;
  Vec3 scale = Vec3::Ones();
  Vec3 offset = Vec3::Zero();
};

/// @throws InputError  points that can't be read, or can't be where the header says
void check_points(const LasHeader& header, std::uint64_t file_size) {
  if (header.format >= kRecordSizes.size()) {
    throw InputError("has LAS point format " + std::to_string(header.format) +
                     "; 0 to 10 can be read, export it as one of these");
  }
  if (header.record_size < kRecordSizes[header.format]) {
    throw InputError("has point records of " + std::to_string(header.record_size) +
                     " bytes, less than format " + std::to_string(header.format) +
                     " needs; it is damaged, export it again");
  }
  if (!header.scale.allFinite() || !header.offset.allFinite() ||
      header.scale.cwiseAbs().minCoeff() == 0.0) {
    throw InputError("its scale or offset of coordinates is zero or not finite; it is corrupt");
  }
  if (header.data_offset < kMinHeader || header.data_offset > file_size) {
    throw InputError("its header says that the points start at byte " +
                     std::to_string(header.data_offset) + ", outside the file; it is corrupt");
  }
  if (header.compressed) return;
  const std::uint64_t room = (file_size - header.data_offset) / header.record_size;
  if (header.count > room) {
    throw InputError("its header says " + std::to_string(header.count) + " points, the file has " +
                     std::to_string(room) + "; it was cut short");
  }
}

/// Bytes of the header, which need not be followed by others; 227 to 375 unless they are missing.
std::string read_header_bytes(std::istream& stream) {
  std::string bytes = read_bytes(stream, kMinHeader);
  if (bytes.size() < kMinHeader) return bytes;
  const std::size_t end = std::min<std::size_t>(number_at<std::uint32_t>(bytes, 96), kHeader14);
  if (end > kMinHeader) bytes += read_bytes(stream, end - kMinHeader);
  return bytes;
}

LasHeader parse_las_header(const std::string& bytes, std::uint64_t file_size) {
  if (!bytes.starts_with("LASF")) {
    throw InputError("is not a LAS file: it does not start with LASF; export it as LAS or as text");
  }
  if (bytes.size() < kMinHeader) {
    throw InputError("ends within the LAS header; copy or export it again");
  }
  LasHeader header;
  const int minor = number_at<std::uint8_t>(bytes, 25);
  header.header_size = number_at<std::uint16_t>(bytes, 94);
  header.data_offset = number_at<std::uint32_t>(bytes, 96);
  header.records = {.begin = header.header_size,
                    .end = header.data_offset,
                    .count = number_at<std::uint32_t>(bytes, 100),
                    .uses_wkt = (number_at<std::uint16_t>(bytes, 6) & 16) != 0};
  const auto format = number_at<std::uint8_t>(bytes, 104);
  header.record_size = number_at<std::uint16_t>(bytes, 105);
  header.count = number_at<std::uint32_t>(bytes, 107);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    header.scale[k] = number_at<double>(bytes, 131 + 8 * axis);
    header.offset[k] = number_at<double>(bytes, 155 + 8 * axis);
  }
  if (minor >= 4 && bytes.size() >= kHeader14 && header.header_size >= kHeader14) {
    header.count = number_at<std::uint64_t>(bytes, 247);
    header.records.extended_begin = number_at<std::uint64_t>(bytes, 235);
    header.records.extended_count = number_at<std::uint32_t>(bytes, 243);
  }
  header.compressed = (format & 0xC0) != 0;
  header.format = format & 0x3F;
  check_points(header, file_size);
  return header;
}

struct Flags {
  std::uint8_t asprs_class;
  bool withheld;
};

Flags flags_of(std::string_view record, std::size_t format) {
  const auto byte = number_at<std::uint8_t>(record, 15);
  if (format < 6) return {static_cast<std::uint8_t>(byte & 0x1F), (byte & 0x80) != 0};
  return {number_at<std::uint8_t>(record, 16), (byte & 0x04) != 0};
}

PointRecording recording_of(std::string_view record, std::size_t format) {
  if (format >= 6) return {number_at<std::uint16_t>(record, 20), number_at<double>(record, 22)};
  const bool has_time = format == 1 || format >= 3;
  return {number_at<std::uint16_t>(record, 18), has_time ? number_at<double>(record, 20) : 0.0};
}

/// Reads the points, at which the stream is.
/// @return  number of points that the stream holds, at most that of the header
std::uint64_t read_points(std::istream& stream, const LasHeader& header, PointBatcher& sink,
                          CloudSummary& summary) {
  std::uint64_t done = 0;
  while (done < header.count) {
    const std::size_t wanted = std::min<std::uint64_t>(kRecordsPerRead, header.count - done);
    const std::string bytes = read_bytes(stream, wanted * header.record_size);
    const std::size_t got = bytes.size() / header.record_size;
    for (std::size_t i = 0; i < got; ++i) {
      const std::string_view record =
          std::string_view(bytes).substr(i * header.record_size, header.record_size);
      const Flags flags = flags_of(record, header.format);
      if (flags.withheld || flags.asprs_class == kNoise || flags.asprs_class == kHighNoise) {
        ++summary.withheld_points;
        continue;
      }
      const Vec3 steps(number_at<std::int32_t>(record, 0), number_at<std::int32_t>(record, 4),
                       number_at<std::int32_t>(record, 8));
      sink.add_point(steps.cwiseProduct(header.scale) + header.offset, flags.asprs_class,
                     recording_of(record, header.format));
    }
    done += got;
    if (got < wanted) break;
  }
  return done;
}

/// Reads an unpacked LAS file up to its points.
/// @param packed  header of the LAZ file
/// @throws InputError  if its points are not those of the LAZ file
LasHeader read_unpacked_header(std::istream& stream, const LasHeader& packed) {
  const std::string bytes = read_header_bytes(stream);
  const LasHeader header = parse_las_header(bytes, std::numeric_limits<std::uint64_t>::max());
  if (header.compressed) throw InputError("its points are compressed");
  if (header.count != packed.count) {
    throw InputError("its header says " + std::to_string(header.count) + " points instead of " +
                     std::to_string(packed.count));
  }
  if (header.scale != packed.scale || header.offset != packed.offset) {
    throw InputError("its coordinates have another scale or offset");
  }
  stream.ignore(static_cast<std::streamsize>(header.data_offset - bytes.size()));
  return header;
}

void read_packed_points(const LasHeader& packed, const std::filesystem::path& path, LasCopy* copy,
                        PointBatcher& sink, CloudSummary& summary) {
  if (copy && copy->complete) {
    read_las_copy(*copy, [&](std::istream& stream) {
      read_points(stream, read_unpacked_header(stream, packed), sink, summary);
    });
    return;
  }
  LasHeader header;
  LazUnpacker unpacker(
      path, [&](std::istream& stream) { header = read_unpacked_header(stream, packed); }, copy);
  const std::uint64_t count = read_points(unpacker.stream(), header, sink, summary);
  if (count < packed.count) {
    throw InputError("its header says " + std::to_string(packed.count) + " points, and " +
                     std::to_string(count) +
                     " could be unpacked; it was cut short or is damaged (" +
                     unpacker.describe_end() + ")");
  }
  unpacker.finish();
}

}  // namespace

CloudSummary read_las_cloud(std::istream& stream, const std::filesystem::path& path,
                            PointBatcher& sink, LasCopy* copy) {
  stream.seekg(0, std::ios::end);
  const auto file_size = static_cast<std::uint64_t>(stream.tellg());
  stream.seekg(0);
  const LasHeader header = parse_las_header(read_header_bytes(stream), file_size);
  CloudSummary summary;
  read_las_crs(stream, header.records, summary);
  if (header.compressed) {
    read_packed_points(header, path, copy, sink, summary);
  } else {
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(header.data_offset));
    if (read_points(stream, header, sink, summary) < header.count)
      throw InputError("can't be read completely");
  }
  return sink.finish(summary);
}

}  // namespace clast::mesh_detail
