#include "core/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "core/output_file.hpp"

namespace clast {

std::string read_text_file(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::exists(path, code)) {
    throw InputError(path.string() + ": no such file; check the path");
  }
  if (std::filesystem::is_directory(path, code)) {
    throw InputError(path.string() + ": is a folder, a file is needed");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.good() && !stream.eof()) {
    throw InputError(path.string() + ": can't be read; check its permissions");
  }
  return content;
}

void write_text_file(const std::filesystem::path& path, std::string_view content) {
  OutputFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throw InputError(path.string() + ": writing failed; is the disk full?");
  file.commit();
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace clast
