#include "core/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>

#include "core/error.hpp"

namespace clast {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  if (target_.empty()) throw InputError("the name of the file to write is empty; name one");
  std::error_code code;
  // The rename would put a file in place of a link and leave what it points to as it was.
  if (fs::is_symlink(target_, code)) {
    const fs::path linked = fs::weakly_canonical(target_, code);
    if (code) throw InputError(target_.string() + ": " + code.message() + "; mend the link");
    target_ = linked;
  }
  if (fs::is_directory(target_, code)) {
    throw InputError(target_.string() + ": is a folder; name a file to write");
  }
  // The rename would take the place of a device such as /dev/null, for every program on the
  // machine.
  if (fs::exists(target_, code) && !fs::is_regular_file(target_, code)) {
    throw InputError(target_.string() + ": is a device or a pipe; name a file to write");
  }
  // A rename asks for no permission of the file that it replaces.
  if (fs::exists(target_, code) && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) {
    throw InputError(target_.string() +
                     ": is write-protected; allow writing to it or name another file");
  }
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  fs::create_directories(folder, code);
  if (code) throw InputError(folder.string() + ": can't make this folder (" + code.message() + ")");
  temporary_ = folder / ("." + target_.stem().string() + ".part" + std::to_string(::getpid()) +
                         target_.extension().string());
  if (!std::ofstream(temporary_, std::ios::binary)) {
    if (errno == ENAMETOOLONG) {
      throw InputError(target_.string() +
                       ": the name is too long for this disk; give a shorter one");
    }
    throw InputError(folder.string() + ": can't write into this folder; check its permissions");
  }
}

OutputFile::~OutputFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  std::error_code code;
  const fs::perms mode = fs::status(target_, code).permissions();
  if (!code && mode != fs::perms::unknown) fs::permissions(temporary_, mode, code);
  fs::rename(temporary_, target_, code);
  if (code) throw InputError(target_.string() + ": can't be replaced (" + code.message() + ")");
  committed_ = true;
}

}  // namespace clast
