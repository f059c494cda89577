#include "app/companion.hpp"

#include <sys/wait.h>
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
                   "; clast reconstruct needs this program: install the package clast-reconstruct, "
                   "or move both programs together");
}

[[noreturn]] void refuse_start(const fs::path& path) {
  throw InputError(path.string() + ": can't be started (" + std::strerror(errno) +
                   "); install clast and clast-reconstruct again");
}

}  // namespace

void run_companion(char** argv) {
  const fs::path path = companion();
  ::execv(path.c_str(), argv);
  refuse_start(path);
}

std::string read_companion_output(const std::string& argument) {
  const fs::path path = companion();
  std::string program = path.string(), word = argument;
  int ends[2];
  if (::pipe(ends) != 0) refuse_start(path);
  const ::pid_t child = ::fork();
  if (child < 0) refuse_start(path);
  if (child == 0) {
    char* argv[] = {program.data(), word.data(), nullptr};
    if (::dup2(ends[1], STDOUT_FILENO) >= 0 && ::close(ends[0]) == 0) ::execv(argv[0], argv);
    ::_exit(126);
  }
  ::close(ends[1]);
  std::string output;
  char buffer[4096];
  for (::ssize_t read; (read = ::read(ends[0], buffer, sizeof buffer)) > 0;) {
    output.append(buffer, static_cast<std::size_t>(read));
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw InputError(path.string() +
                     ": does not describe its options; install clast and clast-reconstruct again");
  }
  return output;
}

}  // namespace clast
