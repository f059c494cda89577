// Projection records of LAS (ASPRS LAS Specification 1.4 R15, 2.5 and 3).
#include "mesh/detail/las_system.hpp"

#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "mesh/geotiff_keys.hpp"

namespace clast::mesh_detail {
namespace {

constexpr std::size_t kRecordHead = 54, kExtendedHead = 60;  ///< bytes before the content
/// Keys and WKT take kilobytes.
constexpr std::uint64_t kMaxContentLength = 1 << 24;
template <class T>
T field_at(std::string_view bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof(T) <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

std::string bytes_from(std::istream& stream, std::uint64_t at, std::uint64_t count) {
  std::string bytes(count, '\0');
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(at));
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

struct ProjectionRecords {
  GeoTiffKeys keys;
  std::string wkt;

  void take(std::string_view head, std::string content) {
    const std::string_view user = head.substr(2, 16);
    const auto id = field_at<std::uint16_t>(head, 18);
    const bool projection = user.starts_with("LASF_Projection");
    if ((projection || user.starts_with("liblas")) && id == 2112) {
      wkt = content.substr(0, content.find('\0'));
    }
    if (!projection) return;
    if (id == 34735) keys.directory = std::move(content);
    if (id == 34736) keys.doubles = std::move(content);
    if (id == 34737) keys.texts = std::move(content);
  }
};

ProjectionRecords projection_records(std::istream& stream, const LasRecordLayout& records) {
  ProjectionRecords found;
  std::uint64_t at = records.begin;
  for (std::uint32_t i = 0; i < records.count && at + kRecordHead <= records.end; ++i) {
    const std::string head = bytes_from(stream, at, kRecordHead);
    if (head.size() < kRecordHead) break;
    const std::uint64_t size = field_at<std::uint16_t>(head, 20);
    found.take(head, bytes_from(stream, at + kRecordHead, size));
    at += kRecordHead + size;
  }
  at = records.extended_begin;
  for (std::uint32_t i = 0; at > 0 && i < records.extended_count; ++i) {
    const std::string head = bytes_from(stream, at, kExtendedHead);
    if (head.size() < kExtendedHead) break;
    const auto size = field_at<std::uint64_t>(head, 20);
    if (size <= kMaxContentLength) found.take(head, bytes_from(stream, at + kExtendedHead, size));
    if (size > UINT64_MAX / 4) break;  // corrupt
    at += kExtendedHead + size;
  }
  return found;
}

}  // namespace

void read_las_crs(std::istream& stream, const LasRecordLayout& records, CloudSummary& summary) {
  const ProjectionRecords found = projection_records(stream, records);
  GeoTiffReferenceSystem keyed = parse_geotiff_keys(found.keys);
  summary.crs = std::move(keyed.crs);
  summary.unit_declarations = std::move(keyed.unit_declarations);
  if (found.wkt.find_first_not_of(" \t\r\n") == std::string::npos) return;
  LengthUnitDeclaration declared = determine_crs_units(found.wkt, "WKT");
  const bool known = declared.kind != ReferenceSystemKind::kUnknown;
  summary.unit_declarations.push_back(std::move(declared));
  if (summary.crs.empty() || (records.uses_wkt && known)) summary.crs = found.wkt;
}

}  // namespace clast::mesh_detail
