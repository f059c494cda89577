#include "study/detail/checkpoint_file.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/output_file.hpp"
#include "core/text_file.hpp"
#include "study/detail/results_journal.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

const std::string kMagic = "clast checkpoint 1\n";
constexpr std::size_t kDigestLength = 64;

/// Of the files of all realisations, before the number.
std::string name_begin(const fs::path& target) {
  return partial_results(target).filename().string() + ".";
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](unsigned char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

CheckpointFile::CheckpointFile(const fs::path& target, const CampaignResults& header,
                               std::uint32_t realisation)
    : path_(target.parent_path() / (name_begin(target) + std::to_string(realisation + 1))),
      identity_(campaign_identity(header)) {}

std::string CheckpointFile::read() const {
  if (!fs::exists(path_)) return {};
  std::string file = read_text_file(path_);
  const std::size_t whole = file.size() - std::min(file.size(), kDigestLength);
  const std::string digest = file.substr(whole);
  file.resize(whole);
  if (sha256(file) != digest) {
    throw InputError(path_.string() +
                     ": is damaged; delete it, and `resume` begins that realisation anew");
  }
  const std::string begin = kMagic + identity_;
  if (!file.starts_with(begin)) {
    throw InputError(path_.string() +
                     ": is of another campaign, other inputs or another clast; delete it, and "
                     "`resume` begins that realisation anew");
  }
  file.erase(0, begin.size());
  return file;
}

void CheckpointFile::write(const std::function<void(ByteWriter& to)>& save) const {
  OutputFile output(path_);
  {
    std::ofstream file(output.temporary(), std::ios::binary);
    file << kMagic << identity_;
    ByteWriter writer(file);
    save(writer);
    file.flush();
    if (file) file << sha256_of_file(output.temporary()) << std::flush;
    if (!file) {
      throw InputError(path_.string() +
                       ": writing failed; is the disk full? Free some space and go on with "
                       "`resume`");
    }
  }
  output.commit();
}

void CheckpointFile::remove() const {
  std::error_code code;  // what is left of it is harmless
  fs::remove(path_, code);
}

void CheckpointFile::remove_all(const fs::path& target) {
  const std::string begin = name_begin(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && is_number(name.substr(begin.size()))) {
      fs::remove(entry.path(), code);
    }
  }
}

}  // namespace clast::study_detail
