#include "app/companion.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"

namespace clast {

namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "clast-reconstruct";

/// Beside the program in a build folder, and where it is installed to.
fs::path companion() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path beside = program.parent_path() / kName;
  const fs::path installed = program.parent_path() / CLAST_COMPANION_FOLDER / kName;
  for (const fs::path& path : {beside, installed}) {
    if (fs::is_regular_file(path)) return path;
  }
  throw InputError(beside.string() + ": is missing, also in " + installed.parent_path().string() +
                   "; it does the work of clast reconstruct: install clast again, or move both "
                   "together");
}

}  // namespace

void run_companion(char** argv) {
  const fs::path path = companion();
  ::execv(path.c_str(), argv);
  throw InputError(path.string() + ": can't be started (" + std::strerror(errno) +
                   "); install clast again");
}

}  // namespace clast
