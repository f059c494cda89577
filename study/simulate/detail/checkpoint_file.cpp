#include "study/simulate/detail/checkpoint_file.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "study/results/results_journal.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

const std::string kFormat = "clast checkpoint ";
const std::string kCheckpointMagic = kFormat + "2\n";
constexpr std::size_t kCheckpointDigestLength = 64;
const std::string kInTheWay = "has the name of a checkpoint but is not one; move it elsewhere";

/// Common beginning of the names of all checkpoints, before the number.
std::string name_begin(const fs::path& target) {
  return results_journal_path(target).filename().string() + ".";
}

/// While it is written.
fs::path unfinished(fs::path path) { return path += ".new"; }

/// True if a file of this name may be a checkpoint.
bool is_checkpoint_name(std::string name, const std::string& begin) {
  if (!name.starts_with(begin)) return false;
  name.erase(0, begin.size());
  if (name.ends_with(".new")) name.resize(name.size() - 4);
  return !name.empty() && std::all_of(name.begin(), name.end(),
                                      [](unsigned char c) { return c >= '0' && c <= '9'; });
}

/// Files of other programs may have such names too.
bool is_checkpoint(const fs::path& path) {
  std::string first(kFormat.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(first.data(), static_cast<std::streamsize>(first.size()));
  return file && first == kFormat;
}

}  // namespace

CheckpointFile::CheckpointFile(const fs::path& target, const CampaignHeader& header,
                               std::uint32_t realisation)
    : path_(target.parent_path() / (name_begin(target) + std::to_string(realisation + 1))),
      header_(header),
      realisation_(realisation) {}

std::optional<std::string> CheckpointFile::read() const {
  if (!fs::exists(path_)) return std::nullopt;
  if (!fs::is_regular_file(path_)) {
    throw InputError(path_.string() + ": " + kInTheWay);
  }
  const std::string advice = "; delete it, then `resume` starts that realisation again";
  std::string file = read_text_file(path_);
  const std::size_t whole = file.size() - std::min(file.size(), kCheckpointDigestLength);
  const std::string digest = file.substr(whole);
  file.resize(whole);
  if (sha256(file) != digest) throw InputError(path_.string() + ": is damaged" + advice);
  std::string difference = "another version of clast";
  if (file.starts_with(kCheckpointMagic)) {
    ByteReader reader(std::string_view(file).substr(kCheckpointMagic.size()));
    difference = describe_campaign_difference(reader, header_);
    std::uint32_t of = 0;
    reader(of);
    if (difference.empty() && of != realisation_) {
      difference = "the number of another realisation, " + std::to_string(of + 1);
    }
    if (difference.empty()) {
      file.erase(0, file.size() - reader.remaining_bytes());
      return file;
    }
  }
  throw InputError(path_.string() + ": was written with " + difference + advice);
}

void CheckpointFile::write(const std::function<void(ByteWriter& to)>& save) const {
  if (fs::exists(path_) && !is_checkpoint(path_)) {
    throw InputError(path_.string() + ": " + kInTheWay);
  }
  const fs::path written = unfinished(path_);
  std::ofstream file(written, std::ios::binary);
  file << kCheckpointMagic << format_campaign_identity(header_);
  ByteWriter writer(file);
  std::uint32_t of = realisation_;
  writer(of);
  save(writer);
  file.flush();
  if (file) file << sha256_of_file(written) << std::flush;
  file.close();
  std::error_code code;
  if (file) fs::rename(written, path_, code);
  if (!file || code) {
    fs::remove(written, code);
    throw InputError(path_.string() +
                     ": the checkpoint can't be written; is the disk full, or the folder "
                     "write-protected?");
  }
}

void CheckpointFile::remove() const {
  std::error_code code;  // what is left of it is harmless
  fs::remove(path_, code);
}

void CheckpointFile::remove_all(const fs::path& target) {
  const std::string begin = name_begin(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code code;  // what is left of them is harmless
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    const fs::path& path = it->path();
    if (is_checkpoint_name(path.filename().string(), begin) && is_checkpoint(path)) {
      found.push_back(path);
    }
  }
  for (const fs::path& path : found) fs::remove(path, code);
}

}  // namespace clast::study_detail
