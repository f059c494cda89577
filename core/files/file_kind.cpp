#include "core/files/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <utility>

#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBeginning = 65536;  ///< bytes that are looked at

using namespace std::string_literals;

/// Files that begin with these bytes.
const std::array<std::pair<std::string, const char*>, 8> kSignatures = {{
    {"\x89HDF\r\n\x1a\n", "HDF5"},
    {"\x89PNG\r\n\x1a\n", "PNG"},
    {"II*\0"s, "TIFF"},
    {"MM\0*"s, "TIFF"},
    {"SQLite format 3\0"s, "SQLite"},
    {"glTF", "glTF"},
    {"ply\n", "PLY"},
    {"ply\r", "PLY"},
}};

/// A binary STL has a header of 80 bytes, the number of its triangles, and 50 bytes for each.
bool is_binary_stl(const std::string& beginning, std::uintmax_t size) {
  if (beginning.size() < 84) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, beginning.data() + 80, sizeof triangles);
  return size == 84 + std::uintmax_t{50} * triangles;
}

/// True if a line is the head of this TOML table, or sets one of its keys.
bool has_table(const std::string& text, const std::string& name) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    line.erase(std::remove_if(line.begin(), line.end(),
                              [](char c) { return c == ' ' || c == '\t' || c == '"'; }),
               line.end());
    if (line.starts_with("[" + name + "]") || line.starts_with(name + ".") ||
        line.starts_with(name + "={")) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

std::string kind_of_text(const std::string& beginning) {
  const auto holds = [&](const char* word) { return beginning.find(word) != std::string::npos; };
  if (beginning.starts_with("<!doctype html") || beginning.starts_with("<!DOCTYPE html")) {
    return holds("<meta name=\"generator\" content=\"clast\">") ? kPageKind : "HTML";
  }
  if (holds("<svg")) return "SVG";
  if (holds("<VTKFile")) return "VTK";
  if (beginning.starts_with("solid") && holds("facet")) return "STL";
  if (holds("coordinates here") && holds("\norigin ")) return "origin of coordinates";
  if (has_table(beginning, "blocks") && has_table(beginning, "terrain")) return kCampaignKind;
  return "text";
}

}  // namespace

std::string detect_file_kind(const fs::path& path) {
  std::error_code code;
  const std::uintmax_t size = fs::is_regular_file(path, code) ? fs::file_size(path, code) : 0;
  if (size == 0 || code) return "";
  std::ifstream file(path, std::ios::binary);
  std::string beginning(std::min<std::uintmax_t>(size, kBeginning), '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  if (!file) return "binary";  // not permitted: nothing is known of it
  for (const auto& [signature, kind] : kSignatures) {
    if (!beginning.starts_with(signature)) continue;
    const std::string format = kind == "HDF5"s ? Hdf5File::read_format(path) : "";
    return format.empty() ? kind : format;
  }
  if (is_binary_stl(beginning, size)) return "STL";
  // The file of a VTK surface has its numbers after the text.
  const bool text = beginning.find('\0') == std::string::npos || beginning.starts_with("<?xml");
  return text ? kind_of_text(beginning) : "binary";
}

std::string file_kind_by_extension(const fs::path& path) {
  static const std::map<std::string, std::string> kKinds = {
      {".png", "PNG"},   {".svg", "SVG"},     {".html", kPageKind}, {".tif", "TIFF"},
      {".tiff", "TIFF"}, {".gpkg", "SQLite"}, {".glb", "glTF"},     {".ply", "PLY"},
      {".stl", "STL"},   {".vtp", "VTK"},     {".pvd", "VTK"}};
  const auto kind = kKinds.find(lower_case_extension(path));
  return kind == kKinds.end() ? "text" : kind->second;
}

}  // namespace clast
