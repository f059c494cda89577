#include "core/files/input_file.hpp"

#include "core/error.hpp"

namespace clast {

namespace fs = std::filesystem;

void check_input_file(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(path.string() + ": no such file; check the path");
  }
  if (status.type() == fs::file_type::none) {
    throw InputError(path.string() + ": can't be read (" + code.message() + "); check the path");
  }
  if (fs::is_directory(status)) {
    throw InputError(path.string() + ": is a folder; name a file");
  }
  if (!fs::is_regular_file(status)) {
    throw InputError(path.string() +
                     ": is a pipe or a device, which can't be read twice; write its content to a "
                     "file and name that");
  }
}

}  // namespace clast
