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
  std::string first;
  for (const fs::path& file : files_in(target)) {
    if (kind.owns(file) && first.empty()) first = file.string();
  }
  if (first.empty()) return;
  if (!is_marked(target, kind)) {
    throw InputError(target.string() + ": holds " + first + ", but is not a " + kind.name +
                     " of clast, so it is not replaced; name another folder");
  }
  if (!replace) {
    throw InputError(target.string() + ": holds a " + kind.name +
                     " already, and replace is not set; set it to replace that one, or "
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

[[noreturn]] void refuse_exchange(const fs::path& target, const std::error_code& code) {
  throw InputError(target.string() + ": can't be replaced (" + code.message() + ")");
}

/// Replaces a folder, which may be missing, by another: in one step where the file system can
/// exchange names, and then the former folder is where the new one was.
void exchange_folders(const fs::path& made, const fs::path& target, const fs::path& former) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return;
  std::error_code code, back;
  const bool there = fs::exists(target, code);
  if (there) fs::rename(target, former, code);
  if (code) refuse_exchange(target, code);
  fs::rename(made, target, code);
  if (!code) return;
  if (there) fs::rename(former, target, back);
  refuse_exchange(target, code);
}

/// Replaces the files of a kind in a folder; the rest is not touched.
void exchange_files(const fs::path& made, const fs::path& target, const fs::path& former,
                    const FolderKind& kind) {
  std::vector<std::pair<fs::path, fs::path>> moved;
  const auto move = [&](const fs::path& from, const fs::path& to) {
    std::error_code code, back;
    fs::create_directories(to.parent_path(), code);
    fs::rename(from, to, code);
    if (code) {
      for (auto pair = moved.rbegin(); pair != moved.rend(); ++pair) {
        fs::rename(pair->second, pair->first, back);
      }
      refuse_exchange(target, code);
    }
    moved.emplace_back(from, to);
  };
  for (const fs::path& file : files_in(target)) {
    if (!kind.owns(file)) continue;
    move(target / file, former / file);
    std::error_code not_empty;
    if (file.has_parent_path()) fs::remove(target / file.parent_path(), not_empty);
  }
  for (const fs::path& file : files_in(made)) move(made / file, target / file);
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
                     target_.filename().string() + " is made before it is renamed (" +
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
  bool shared = false;  // with files of another kind, or it is a working directory
  if (fs::exists(target_, code)) {
    shared = fs::equivalent(target_, fs::current_path(), code);
    for (const fs::path& file : files_in(target_)) {
      if (kind_.owns(file)) continue;
      shared = true;
      if (!fs::exists(temporary_ / file, code)) continue;
      throw InputError((target_ / file).string() + ": does not belong to the existing " +
                       kind_.name + ", and would be overwritten; move it elsewhere");
    }
  }
  fs::path former = temporary_;
  former += ".former";
  shared ? exchange_files(temporary_, target_, former, kind_)
         : exchange_folders(temporary_, target_, former);
  committed_ = true;
  fs::remove_all(temporary_, code);
  fs::remove_all(former, code);
}

}  // namespace clast
