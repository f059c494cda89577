#include "core/output_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <numeric>
#include <string>

#include "core/error.hpp"
#include "core/file_kind.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

/// Checks that an existing file may be replaced.
void check_rules(const fs::path& target, const OutputRules& rules) {
  if (rules.kind.empty() && rules.replace) return;
  const std::string there = kind_of_file(target);
  if (there.empty()) return;
  const std::string begin = target.string() + ": already exists";
  if (!rules.kind.empty() && there != rules.kind) {
    throw InputError(begin + " and holds \"" + there + "\", not \"" + rules.kind +
                     "\", so it is not replaced; give another name, or delete it first");
  }
  if (!rules.replace) {
    throw InputError(begin +
                     ", and replace is not set; set it to replace the file, or give another "
                     "name");
  }
}

}  // namespace

fs::path linked_target(const fs::path& target) {
  constexpr int kMostLinks = 40;  // as Linux allows
  std::error_code code;
  fs::path at = target;
  for (int links = 0; fs::is_symlink(at, code); ++links) {
    const fs::path next = fs::read_symlink(at, code);
    if (links == kMostLinks) code = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (code) throw InputError(target.string() + ": " + code.message() + "; repair the link");
    at = at.parent_path() / next;
  }
  return at;
}

OutputFile::OutputFile(fs::path target, const OutputRules& rules) : target_(std::move(target)) {
  if (target_.empty()) throw InputError("the name of the file to write is empty; name one");
  std::error_code code;
  // The rename would put a file in place of a link and leave what it points to as it was.
  target_ = linked_target(target_);
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
  check_rules(target_, rules);
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

void check_output(const fs::path& target, const OutputRules& rules) {
  const OutputFile trial(target, rules);
}

void check_room(const fs::path& target, std::initializer_list<std::uint64_t> files) {
  const auto refuse = [&](std::uint64_t bytes, std::uint64_t most, const std::string& what) {
    if (bytes <= most) return;
    const auto size = [](std::uint64_t count) {
      return with_digits(static_cast<double>(count) / 1e6, 3) + " MB";
    };
    throw InputError(target.string() + ": at least " + size(bytes) + " will be written, and " +
                     what + size(most) + "; free some space or name another place");
  };
  rlimit largest{};
  if (::getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur != RLIM_INFINITY) {
    refuse(std::max(files), largest.rlim_cur, "no file here may be larger (ulimit -f) than ");
  }
  std::error_code code;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, code);
  if (code) return;
  refuse(std::accumulate(files.begin(), files.end(), std::uint64_t{0}), space.available,
         "the disk has room for ");
}

}  // namespace clast
