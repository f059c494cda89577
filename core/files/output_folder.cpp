#include "core/files/output_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"

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
  if (code) {
    throw InputError(folder.string() + ": can't be read (" + code.message() +
                     "); check the permissions of what is in it, or name another folder");
  }
  return files;
}

bool is_marked(const fs::path& folder, const OutputFolderKind& kind) {
  std::error_code code;
  const fs::path file = folder / kind.marker_file_name;
  return fs::is_regular_file(file, code) &&
         read_text_file(file).find(kind.marker_text) != std::string::npos;
}

/// Why what is there is kept; empty when the folder may be written.
std::string why_folder_is_kept(const fs::path& target, const OutputFolderKind& kind, bool replace) {
  std::error_code code;
  if (!fs::exists(target, code)) return "";
  if (!fs::is_directory(target, code)) {
    return target.string() + ": is a file; name a folder for the tables and the report";
  }
  const std::vector<fs::path> files = files_in(target);
  const auto first = std::find_if(files.begin(), files.end(), kind.is_own_file);
  if (first == files.end()) return "";
  if (!is_marked(target, kind)) {
    return target.string() + ": holds " + first->string() + ", but is not a " + kind.name +
           " of clast, so it is not replaced; name another folder";
  }
  if (replace) return "";
  return target.string() + ": holds a " + kind.name +
         " already; `replace` replaces it, or name another folder";
}

/// The folder itself, by an absolute name that ends with its own.
fs::path resolved(const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code)) return fs::canonical(target);
  const fs::path named = fs::absolute(target).lexically_normal();
  return resolve_link(named.has_filename() ? named : named.parent_path());
}

[[noreturn]] void refuse_exchange(const fs::path& target, const std::error_code& code) {
  throw InputError(target.string() + ": can't be replaced (" + code.message() +
                   "), so it is unchanged; check the permissions of the folder and of its parent "
                   "folder, or name another");
}

/// Exchanges two folders: in one step where the file system can.
/// @param between  the name that one has meanwhile where it can't
void exchange_folders(const fs::path& made, const fs::path& target, const fs::path& between) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return;
  std::error_code code, back;
  fs::rename(target, between, code);
  if (code) refuse_exchange(target, code);
  fs::rename(made, target, code);
  if (code) {
    fs::rename(between, target, back);
    refuse_exchange(target, code);
  }
  fs::rename(between, made, back);
}

/// Adds files to a folder, where `replace` in place of those of the kind; the rest is not touched.
void exchange_files(const fs::path& made, const fs::path& target, const fs::path& backup_path,
                    const OutputFolderKind& kind, bool replace) {
  std::vector<std::pair<fs::path, fs::path>> moved;
  const auto move = [&](const fs::path& from, const fs::path& to) {
    std::error_code code, back;
    fs::create_directories(to.parent_path(), code);
    code = rename_without_replacing(from, to);
    if (code) {
      for (auto pair = moved.rbegin(); pair != moved.rend(); ++pair) {
        fs::rename(pair->second, pair->first, back);
      }
      refuse_exchange(target, code);
    }
    moved.emplace_back(from, to);
  };
  for (const fs::path& file : files_in(target)) {
    if (!replace || !kind.is_own_file(file)) continue;
    move(target / file, backup_path / file);
    std::error_code not_empty;
    if (file.has_parent_path()) fs::remove(target / file.parent_path(), not_empty);
  }
  for (const fs::path& file : files_in(made)) move(made / file, target / file);
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, OutputFolderKind kind, bool replace)
    : kind_(std::move(kind)), replace_(replace) {
  if (target.empty()) throw InputError("the name of the folder to write is empty; name one");
  target_ = resolved(target);
  // An exchange that was killed may have left what is to be replaced under another name.
  if (target_.has_parent_path()) remove_stale_staging(target_, StagingPath::Kind::kFolder);
  if (const std::string why = why_folder_is_kept(target_, kind_, replace_); !why.empty()) {
    throw InputError(why);
  }
  const fs::path beside = target_.parent_path();
  if (target_ == beside) {
    throw InputError(beside.string() + ": is the root of a disk; name a folder in it");
  }
  std::error_code code;
  fs::create_directories(beside, code);
  if (code) {
    throw InputError(beside.string() + ": can't make this folder (" + code.message() +
                     "); check the permissions of its parent folder, or name another place");
  }
  staging_ = std::make_unique<StagingPath>(target_, StagingPath::Kind::kFolder);
  if (fs::exists(target_, code)) {
    fs::permissions(temporary_path(), fs::status(target_, code).permissions(), code);
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove_all(temporary_path(), ignored);
}

void OutputFolder::commit() {
  const fs::path backup_path = staging_->backup_path();
  std::error_code code = rename_without_replacing(temporary_path(), target_);
  if (!code) {
    committed_ = true;
    staging_->unlock();
    return;
  }
  if (code != std::errc::file_exists) refuse_exchange(target_, code);
  const auto is_kept = [&](const fs::path& there) {
    return !why_folder_is_kept(there, kind_, replace_).empty();
  };
  if (is_kept(target_)) throw_concurrent_write(target_);
  // The folder contains foreign files, or is a working directory.
  bool shared = fs::equivalent(target_, fs::current_path(), code);
  for (const fs::path& file : files_in(target_)) {
    if (kind_.is_own_file(file)) continue;
    shared = true;
    if (!fs::exists(temporary_path() / file, code)) continue;
    throw InputError((target_ / file).string() + ": does not belong to the existing " + kind_.name +
                     ", and would be overwritten; move it elsewhere");
  }
  if (shared) {
    exchange_files(temporary_path(), target_, backup_path, kind_, replace_);
  } else {
    exchange_folders(temporary_path(), target_, backup_path);
    // Another program may have written it after the check above: that is put back.
    if (is_kept(temporary_path())) {
      exchange_folders(temporary_path(), target_, backup_path);
      throw_concurrent_write(target_);
    }
  }
  committed_ = true;
  fs::remove_all(temporary_path(), code);
  fs::remove_all(backup_path, code);
  staging_->unlock();
}

}  // namespace clast
