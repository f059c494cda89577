#include "terrain/gdal/detail/esri_grid.hpp"

#include <cpl_vsi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstring>
#include <string_view>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"

namespace clast::terrain_detail {
namespace {

constexpr std::array<std::string_view, 11> kHeaderWords = {
    "ncols",    "nrows", "xllcorner", "yllcorner",    "xllcenter", "yllcenter",
    "cellsize", "dx",    "dy",        "nodata_value", "byteorder"};
constexpr std::string_view kGridBlank = " \t\r\n\v\f";

std::string lower_word(std::string_view text, std::size_t at) {
  return lower_case_ascii(text.substr(at, text.find_first_of(kGridBlank, at) - at));
}

/// Position of the heights, after the header lines. @return npos if it is not an Esri grid
std::size_t find_heights(std::string_view text) {
  std::size_t at = text.find_first_not_of(kGridBlank);
  for (std::size_t lines = 0; at != std::string_view::npos; ++lines) {
    const std::string word = lower_word(text, at);
    if (std::find(kHeaderWords.begin(), kHeaderWords.end(), word) == kHeaderWords.end()) {
      return lines > 3 ? at : std::string_view::npos;
    }
    at = text.find_first_not_of(kGridBlank, text.find_first_of("\r\n", at));
  }
  return at;
}

bool is_not_finite(const std::string& word) {
  const std::size_t sign = word.find_first_not_of("+-");
  const std::string_view bare = std::string_view(word).substr(std::min(sign, word.size()));
  return bare.starts_with("nan") || bare == "inf" || bare == "infinity";
}

/// @throws InputError  a word that is no number; no file name
void check_words(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const char first = text[at];
    const char second = at + 1 < text.size() ? text[at + 1] : ' ';
    const auto begins_number = [](char c) {
      return (c >= '0' && c <= '9') || c == '.' || c == ',';
    };
    const bool number =
        begins_number(first) || ((first == '-' || first == '+') && begins_number(second));
    if (!number && !is_not_finite(lower_word(text, at))) {
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      throw InputError(
          "line " + std::to_string(line) + ": \"" +
          escape_nonprintable(
              text.substr(at, std::min<std::size_t>(text.find_first_of(kGridBlank, at) - at, 40))) +
          "\" is not a height; write the NODATA_value for cells without a height");
    }
    at = text.find_first_not_of(kGridBlank, text.find_first_of(kGridBlank, at));
  }
}

std::string in_memory(const std::string& name, const std::string& content) {
  auto* const bytes = static_cast<GByte*>(VSIMalloc(content.size() + 1));
  if (!bytes) throw InputError("there is too little memory for a copy of it");
  std::memcpy(bytes, content.data(), content.size());
  VSILFILE* const file = VSIFileFromMemBuffer(name.c_str(), bytes, content.size(), TRUE);
  if (file) VSIFCloseL(file);
  return name;
}

}  // namespace

EsriGrid::EsriGrid(const std::filesystem::path& path) : path_(path.string()) {
  if (lower_case_extension(path) != ".asc") return;
  std::string text = read_text_file(path);
  const std::size_t heights = find_heights(text);
  if (heights == std::string::npos) return;
  with_error_context(path.string(), [&] { check_words(text, heights); });
  if (std::isalpha(static_cast<unsigned char>(text[heights])) == 0) return;
  text.insert(heights, " ");
  static std::atomic<unsigned> number{0};
  const std::string folder = "/vsimem/clast-" + std::to_string(number++) + "/";
  path_ = folder + path.filename().string();
  copies_.push_back(in_memory(path_, text));
  for (const char* extension : {".prj", ".PRJ", ".asc.aux.xml"}) {
    std::filesystem::path beside = path;
    beside.replace_extension(extension);
    std::error_code code;
    if (!std::filesystem::is_regular_file(beside, code)) continue;
    copies_.push_back(in_memory(folder + beside.filename().string(), read_text_file(beside)));
  }
}

EsriGrid::~EsriGrid() {
  for (const std::string& copy : copies_) VSIUnlink(copy.c_str());
}

}  // namespace clast::terrain_detail
