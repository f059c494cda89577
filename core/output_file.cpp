#include "core/output_file.hpp"

#include <unistd.h>

#include <fstream>
#include <string>

#include "core/error.hpp"

namespace clast {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path target) : target_(std::move(target)) {
  std::error_code code;
  if (fs::is_directory(target_, code)) {
    throw InputError(target_.string() + ": is a folder; name a file to write");
  }
  // The rename would take the place of a device such as /dev/null, for every program on the
  // machine.
  if (fs::exists(target_, code) && !fs::is_regular_file(target_, code)) {
    throw InputError(target_.string() + ": is a device or a pipe; name a file to write");
  }
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  fs::create_directories(folder, code);
  if (code) throw InputError(folder.string() + ": can't make this folder (" + code.message() + ")");
  temporary_ = folder / ("." + target_.stem().string() + ".part" + std::to_string(::getpid()) +
                         target_.extension().string());
  if (!std::ofstream(temporary_, std::ios::binary)) {
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
  fs::rename(temporary_, target_, code);
  if (code) throw InputError(target_.string() + ": can't be replaced (" + code.message() + ")");
  committed_ = true;
}

}  // namespace clast
