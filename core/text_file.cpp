#include "core/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/output_file.hpp"

namespace clast {

std::string read_text_file(const std::filesystem::path& path) {
  check_input_file(path);
  std::ifstream stream(path, std::ios::binary);
  // In pieces: files of /proc don't know their size, and one character at a time is slow for large
  // tables.
  std::string content;
  constexpr std::size_t kPiece = 1 << 20;
  while (stream.good()) {
    const std::size_t before = content.size();
    content.resize(before + kPiece);
    stream.read(content.data() + before, kPiece);
    content.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) {
    throw InputError(path.string() + ": can't be read; check its permissions");
  }
  return content;
}

void write_text_file(const std::filesystem::path& path, std::string_view content) {
  write_output(path, content, {});
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace clast
