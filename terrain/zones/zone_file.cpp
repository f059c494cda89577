#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "core/printable.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/gdal/zone_polygons.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {
namespace {

/// "1=blue,2=gray" into `file.names`.
void read_names(const std::string& text, ZoneFile& file) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string entry = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = entry.find('=');
    long number = 0;
    const char* last = entry.data() + std::min(equals, entry.size());
    const auto [stop, error] = std::from_chars(entry.data(), last, number);
    if (equals == std::string::npos || error != std::errc() || stop != last ||
        equals + 1 == entry.size()) {
      throw InputError("zones: \"" + entry +
                       "\" is not CLASS=NAME; write for example zones.asc:1=blue,2=gray");
    }
    if (!file.names.emplace(number, entry.substr(equals + 1)).second) {
      throw InputError("zones: class " + std::to_string(number) + " is named twice; give one name");
    }
  }
}

}  // namespace

std::vector<std::string> ZoneFile::zone_option_values() const {
  std::string text = path.string();
  for (const auto& [number, name] : names) {
    text += (text.size() == path.string().size() ? ":" : ",") + std::to_string(number) + "=" + name;
  }
  return {text};
}

void check_zone_name(const std::string& name) {
  const bool bad = std::any_of(name.begin(), name.end(), [](char c) {
    return c == '=' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (!name.empty() && !bad) return;
  throw InputError("zone \"" + escape_nonprintable(name) +
                   "\": a zone name must be one line without \"=\" or control characters; rename "
                   "it");
}

std::optional<ZoneFile> parse_zone_file(const std::vector<std::string>& zones) {
  if (zones.empty()) return std::nullopt;
  ZoneFile file;
  const std::size_t colon = zones.front().rfind(':');
  std::string names;
  if (colon != std::string::npos && zones.front().find('=', colon) != std::string::npos) {
    file.path = zones.front().substr(0, colon);
    names = zones.front().substr(colon + 1);
    for (std::size_t i = 1; i < zones.size(); ++i) names += "," + zones[i];
  } else if (zones.size() == 1) {
    file.path = zones.front();
  }
  if (!terrain_detail::is_raster_file(file.path) && !terrain_detail::is_polygon_file(file.path)) {
    return std::nullopt;
  }
  read_names(names, file);
  if (!names.empty() && terrain_detail::is_polygon_file(file.path)) {
    throw InputError(file.path.string() +
                     ": polygons carry their names in the property \"zone\"; leave \"" + names +
                     "\" out");
  }
  return file;
}

}  // namespace clast
