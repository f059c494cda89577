#include "core/files/output_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <numeric>
#include <string>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

/// Why the rules keep the file that is there; empty when it may be replaced.
std::string why_file_is_kept(const fs::path& target, const OverwritePolicy& rules) {
  if (rules.kind.empty() && rules.replace) return "";
  const std::string there = detect_file_kind(target);
  if (there.empty()) return "";
  const std::string begin = target.string() + ": already exists";
  if (!rules.kind.empty() && there != rules.kind) {
    return begin + " and holds \"" + there + "\", not \"" + rules.kind +
           "\", so it is not replaced; give another name, or delete it first";
  }
  if (rules.replace) return "";
  return begin + "; `replace` replaces it, or give another name";
}

}  // namespace

fs::path resolve_link(const fs::path& target) {
  constexpr int kMaxLinks = 40;  // as Linux allows
  std::error_code code;
  fs::path at = target;
  for (int links = 0; fs::is_symlink(at, code); ++links) {
    const fs::path next = fs::read_symlink(at, code);
    if (links == kMaxLinks) code = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (code) throw InputError(target.string() + ": " + code.message() + "; repair the link");
    at = at.parent_path() / next;
  }
  return at;
}

OutputFile::OutputFile(fs::path target, const OverwritePolicy& rules)
    : target_(std::move(target)), rules_(rules) {
  if (target_.empty()) throw InputError("the name of the file to write is empty; name one");
  std::error_code code;
  // The rename would put a file in place of a link and leave what it points to as it was.
  target_ = resolve_link(target_);
  if (fs::is_directory(target_, code)) {
    throw InputError(target_.string() + ": is a folder; name a file to write");
  }
  // A rename would replace a device such as /dev/null for every program on the machine.
  if (fs::exists(target_, code) && !fs::is_regular_file(target_, code)) {
    throw InputError(target_.string() + ": is a device or a pipe; name a file to write");
  }
  // A rename asks for no permission of the file that it replaces.
  if (fs::exists(target_, code) && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) {
    throw InputError(target_.string() +
                     ": is write-protected; allow writing to it or name another file");
  }
  absent_ = !fs::exists(target_, code);
  if (const std::string why = why_file_is_kept(target_, rules_); !why.empty()) {
    throw InputError(why);
  }
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  fs::create_directories(folder, code);
  if (code) {
    throw InputError(folder.string() + ": can't make this folder (" + code.message() +
                     "); check the permissions of its parent folder, or name another place");
  }
  staging_ = std::make_unique<StagingPath>(target_, StagingPath::Kind::kFile);
}

OutputFile::~OutputFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(temporary_path(), ignored);
}

void OutputFile::write(std::string_view content) {
  std::ofstream stream(temporary_path(), std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) {
    throw InputError(target_.string() +
                     ": writing failed; is the disk full? Free some space or name another place");
  }
}

void OutputFile::commit() {
  std::error_code code;
  const fs::perms mode = fs::status(target_, code).permissions();
  if (!code && mode != fs::perms::unknown) fs::permissions(temporary_path(), mode, code);
  if (absent_ && !rules_.replace) {
    code = rename_without_replacing(temporary_path(), target_);
  } else if (!why_file_is_kept(target_, rules_).empty()) {
    code = std::make_error_code(std::errc::file_exists);
  } else {
    fs::rename(temporary_path(), target_, code);
  }
  if (code == std::errc::file_exists) throw_concurrent_write(target_);
  if (code) {
    throw InputError(target_.string() + ": can't be " + (absent_ ? "made" : "replaced") + " (" +
                     code.message() +
                     "); check the permissions of its folder or name another place");
  }
  committed_ = true;
  staging_->unlock();
}

void write_output(const fs::path& target, std::string_view content, const OverwritePolicy& rules) {
  OutputFile file(target, rules);
  file.write(content);
  file.commit();
}

void check_output_target(const fs::path& target, const OverwritePolicy& rules) {
  const OutputFile trial(target, rules);
}

std::error_code rename_without_replacing(const fs::path& from, const fs::path& to) {
  const auto last_error = [] { return std::error_code(errno, std::generic_category()); };
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) return last_error();
  // Network file systems don't have that, but a second name for a file; of a folder nobody has.
  std::error_code code;
  if (::link(from.c_str(), to.c_str()) == 0) {
    fs::remove(from, code);
    return {};
  }
  if (errno == EEXIST) return last_error();
  if (fs::exists(fs::symlink_status(to, code))) return std::make_error_code(std::errc::file_exists);
  fs::rename(from, to, code);
  return code;
}

void throw_concurrent_write(const fs::path& target) {
  throw InputError(
      target.string() +
      ": another program wrote it meanwhile, so it is not replaced; run again with another name");
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return fs::weakly_canonical(a, none) == fs::weakly_canonical(b, none) ||
         fs::equivalent(a, b, none);
}

void check_disk_space(const fs::path& target, std::initializer_list<std::uint64_t> files) {
  const auto refuse = [&](std::uint64_t bytes, std::uint64_t most, const std::string& what) {
    if (bytes <= most) return;
    const auto size = [](std::uint64_t count) {
      return format_significant(static_cast<double>(count) / 1e6, 3) + " MB";
    };
    throw InputError(target.string() + ": at least " + size(bytes) + " will be written, and " +
                     what + size(most) + "; free some space or name another place");
  };
  rlimit largest{};
  if (::getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur != RLIM_INFINITY) {
    refuse(std::max(files), largest.rlim_cur, "files must not be larger (ulimit -f) than ");
  }
  std::error_code code;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const fs::space_info space = fs::space(folder, code);
  if (code) return;
  refuse(std::accumulate(files.begin(), files.end(), std::uint64_t{0}), space.available,
         "the disk has room for ");
}

}  // namespace clast
