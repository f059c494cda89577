#include "core/files/text_file.hpp"

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "core/files/input_file.hpp"
#include "core/files/output_file.hpp"
#include "core/utf8.hpp"

namespace clast {

void read_file_in_chunks(const std::filesystem::path& path,
                         const std::function<void(std::string_view)>& consume) {
  check_input_file(path);
  std::ifstream stream(path, std::ios::binary);
  constexpr std::size_t kPiece = 1 << 20;
  std::string piece(kPiece, '\0');
  while (stream.good()) {
    stream.read(piece.data(), kPiece);
    consume(std::string_view(piece).substr(0, static_cast<std::size_t>(stream.gcount())));
  }
  if (!stream.eof()) {
    throw InputError(path.string() + ": can't be read; check its permissions");
  }
}

std::string read_text_file(const std::filesystem::path& path) {
  std::string content;  // files of /proc don't know their size
  read_file_in_chunks(path, [&](std::string_view piece) { content += piece; });
  return content;
}

void write_text_file(const std::filesystem::path& path, std::string_view content) {
  write_output(path, content, {});
}

std::string lower_case_extension(const std::filesystem::path& path) {
  return lower_case_ascii(path.extension().string());
}

}  // namespace clast
