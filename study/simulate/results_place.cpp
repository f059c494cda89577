#include "study/simulate/results_place.hpp"

#include "core/error.hpp"
#include "core/files/file_lock.hpp"

namespace clast {

std::filesystem::path shard_results_path(std::filesystem::path target,
                                         const std::optional<Shard>& shard) {
  if (!shard) return target;
  const std::string part = "." + std::to_string(shard->index) + "of" + std::to_string(shard->count);
  target.replace_filename(target.stem().string() + part + target.extension().string());
  return target;
}

void check_not_interrupted(const std::filesystem::path& target) {
  const std::filesystem::path part = results_journal_path(target);
  if (!std::filesystem::exists(part)) return;
  if (std::filesystem::exists(FileLock::lock_path(target))) {
    const FileLock lock(target, {.timeout = {}});  // refused while that campaign runs
  }
  throw InputError(part.string() +
                   ": holds the runs of an interrupted campaign; add `resume` to continue it, or "
                   "delete the file to start again");
}

}  // namespace clast
