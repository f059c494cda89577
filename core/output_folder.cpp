#include "core/output_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/text_file.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

/// Files of a folder and of those in it, relative to it.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end;
       at.increment(code)) {
    std::error_code unseen;
    if (!at->is_directory(unseen) || at->is_symlink(unseen)) {
      files.push_back(at->path().lexically_relative(folder));
    }
  }
  if (code) throw InputError(folder.string() + ": can't be read (" + code.message() + ")");
  return files;
}

bool is_marked(const fs::path& folder, const FolderKind& kind) {
  std::error_code code;
  const fs::path file = folder / kind.mark_file;
  return fs::is_regular_file(file, code) &&
         read_text_file(file).find(kind.mark) != std::string::npos;
}

void check_place(const fs::path& target, const FolderKind& kind, bool replace) {
  std::error_code code;
  if (!fs::exists(target, code)) return;
  if (!fs::is_directory(target, code)) {
    throw InputError(target.string() + ": is a file; name a folder for the tables and the report");
  }
  // Who is in a folder that another takes the place of is in none any more, and so is the shell.
  if (fs::equivalent(target, fs::current_path(), code)) {
    throw InputError(target.string() +
                     ": is the folder that this program runs in, so nothing can take its place; "
                     "name another, or run it from elsewhere");
  }
  std::string first;
  for (const fs::path& file : files_in(target)) {
    if (kind.owns(file) && first.empty()) first = file.string();
  }
  if (first.empty()) return;
  if (!is_marked(target, kind)) {
    throw InputError(target.string() + ": holds " + first + ", but not by a " + kind.name +
                     " of clast, so it is not replaced; name another folder");
  }
  if (!replace) {
    throw InputError(target.string() + ": holds a " + kind.name +
                     " already, and replace is not set; set it to put a new one in its place, or "
                     "name another folder");
  }
}

/// The folder itself, by an absolute name that ends with its own.
fs::path resolved(const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code)) return fs::canonical(target);
  const fs::path named = fs::absolute(target).lexically_normal();
  return linked_target(named.has_filename() ? named : named.parent_path());
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, FolderKind kind, bool replace)
    : kind_(std::move(kind)) {
  if (target.empty()) throw InputError("the name of the folder to write is empty; name one");
  target_ = resolved(target);
  check_place(target_, kind_, replace);
  const fs::path beside = target_.parent_path();
  std::error_code code;
  fs::create_directories(beside, code);
  temporary_ = beside / ("." + target_.filename().string() + ".part" + std::to_string(::getpid()));
  if (!code) {
    fs::remove_all(temporary_, code);
    fs::create_directory(temporary_, code);
  }
  if (code || target_ == beside) {
    throw InputError(beside.string() + ": can't write into this folder, where " +
                     target_.filename().string() + " is made before it takes its place (" +
                     code.message() + "); check its permissions or name another folder");
  }
  if (fs::exists(target_, code)) {
    fs::permissions(temporary_, fs::status(target_, code).permissions(), code);
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void OutputFolder::commit() {
  std::error_code code;
  const auto check = [&] {
    if (code) throw InputError(target_.string() + ": can't be replaced (" + code.message() + ")");
  };
  if (!fs::exists(target_, code)) {
    fs::rename(temporary_, target_, code);
    check();
    committed_ = true;
    return;
  }
  for (const fs::path& file : files_in(target_)) {
    if (kind_.owns(file) || !fs::exists(temporary_ / file, code)) continue;
    throw InputError((target_ / file).string() + ": is no file of the " + kind_.name +
                     " that is there, and would be written over; move it away");
  }
  // Both change places at once where the file system can do that.
  fs::path former = temporary_;
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) != 0) {
    former += ".former";
    fs::rename(target_, former, code);
    check();
    fs::rename(temporary_, target_, code);
    if (code) {
      std::error_code back;
      fs::rename(former, target_, back);
      check();
    }
  }
  committed_ = true;
  for (const fs::path& file : files_in(former)) {
    if (kind_.owns(file)) continue;
    fs::create_directories((target_ / file).parent_path(), code);
    fs::rename(former / file, target_ / file, code);
    if (code) {
      throw InputError((former / file).string() + ": can't be put back into " + target_.string() +
                       " (" + code.message() + "); it is kept where it is");
    }
  }
  fs::remove_all(former, code);
}

}  // namespace clast
