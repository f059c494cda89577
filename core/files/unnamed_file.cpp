#include "core/files/unnamed_file.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/error.hpp"

namespace clast {

UnnamedFile::UnnamedFile() {
  std::error_code code;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(code);
  std::string name = (folder / "clast-XXXXXX").string();
  descriptor_ = code ? -1 : ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    throw InputError("the folder for temporary files can't be written (" +
                     (code ? code.message() : folder.string() + ", " + std::strerror(errno)) +
                     "); set TMPDIR to one that can");
  }
  ::unlink(name.c_str());
}

UnnamedFile::~UnnamedFile() { ::close(descriptor_); }

}  // namespace clast
