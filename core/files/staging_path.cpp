#include "core/files/staging_path.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/files/output_file.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFormer = ".former";

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// The beginning and end of the names of parts, around their numbers.
struct PartNames {
  PartNames(const fs::path& target, StagingPath::Kind kind) {
    const bool file = kind == StagingPath::Kind::kFile;
    begin = "." + (file ? target.stem() : target.filename()).string() + ".part";
    if (file) end = target.extension().string();
  }
  std::string begin, end;

  /// The name of the part that a file or folder is, its lock or what it took out of the target.
  std::optional<std::string> part_of(std::string_view name) const {
    constexpr std::string_view kLock = ".lock";
    if (name.starts_with("..") && name.ends_with(kLock)) {
      name.remove_prefix(1);
      name.remove_suffix(kLock.size());
    }
    if (name.ends_with(kFormer)) name.remove_suffix(kFormer.size());
    if (!name.starts_with(begin) || !name.ends_with(end) ||
        name.size() <= begin.size() + end.size()) {
      return std::nullopt;
    }
    const std::string_view numbers =
        name.substr(begin.size(), name.size() - begin.size() - end.size());
    if (numbers.find_first_not_of("0123456789-") != numbers.npos) return std::nullopt;
    return std::string(name);
  }
};

/// True if a program has locked the file itself, as HDF5 does.
bool is_locked_itself(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(fs::symlink_status(file, code))) return false;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return false;
  const bool busy = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return busy;
}

/// Makes an empty file or folder.
/// @return  an error; `file_exists` where the name is taken
std::error_code make_empty(const fs::path& path, StagingPath::Kind kind) {
  std::error_code code;
  if (kind == StagingPath::Kind::kFolder) {
    if (!fs::create_directory(path, code) && !code) return make_error_code(std::errc::file_exists);
    return code;
  }
  int made = -1;
  do {
    made = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (made < 0 && errno == EINTR);
  if (made < 0) return std::error_code(errno, std::generic_category());
  ::close(made);
  return {};
}

/// @return  none where another program has the lock; no lock where there are none to be had
std::optional<std::unique_ptr<FileLock>> lock_on(const fs::path& part) {
  try {
    std::unique_ptr<FileLock> lock = FileLock::try_acquire(part);
    if (!lock) return std::nullopt;
    return lock;
  } catch (const InputError&) {
    return std::unique_ptr<FileLock>();
  }
}

}  // namespace

void remove_stale_staging(const fs::path& target, StagingPath::Kind kind) {
  const PartNames names(target, kind);
  const fs::path folder = folder_of(target);
  std::error_code code;
  std::vector<std::string> parts;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    if (auto part = names.part_of(at->path().filename().string())) parts.push_back(*part);
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  for (const std::string& part : parts) {
    const fs::path path = folder / part;
    const auto lock = lock_on(path);
    // Without locks, other users of the path cannot be detected.
    if (!lock || !*lock || is_locked_itself(path)) continue;
    const bool folders = kind == StagingPath::Kind::kFolder;
    const fs::file_status status = fs::symlink_status(path, code);
    if (folders ? fs::is_directory(status) : fs::is_regular_file(status))
      fs::remove_all(path, code);
    if (!folders) continue;
    const fs::path backup_path = path.string() + std::string(kFormer);
    if (fs::exists(backup_path, code) && rename_without_replacing(backup_path, target))
      fs::remove_all(backup_path, code);
  }
}

StagingPath::StagingPath(const fs::path& target, Kind kind) {
  remove_stale_staging(target, kind);
  const PartNames names(target, kind);
  const fs::path folder = folder_of(target);
  for (int number = 1;; ++number) {
    path_ = folder / (names.begin + std::to_string(::getpid()) +
                      (number > 1 ? "-" + std::to_string(number) : "") + names.end);
    auto lock = lock_on(path_);
    if (!lock) continue;
    const std::error_code code = make_empty(path_, kind);
    if (code == std::errc::file_exists) continue;
    if (code == std::errc::filename_too_long) {
      throw InputError(target.string() +
                       ": the name is too long for this disk; give a shorter one");
    }
    if (code) {
      throw InputError(folder.string() + ": can't write into this folder, where " +
                       target.filename().string() + " is made before it is renamed (" +
                       code.message() + "); check its permissions or name another one");
    }
    lock_ = std::move(*lock);
    return;
  }
}

fs::path StagingPath::backup_path() const { return path_.string() + std::string(kFormer); }

}  // namespace clast
