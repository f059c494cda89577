#pragma once
/// Checkpoints of unfinished realisations, beside the journal of their campaign.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/byte_archive.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// The file of one realisation, readable only by the program that wrote it. Whoever writes it holds
/// the lock on the target.
class CheckpointFile {
 public:
  /// @param target       of the results; the file is beside it, `journal_path` and the number
  /// @param header       must outlive it
  /// @param realisation  from 0; in the name from 1
  CheckpointFile(const std::filesystem::path& target, const CampaignHeader& header,
                 std::uint32_t realisation);

  const std::filesystem::path& path() const { return path_; }
  /// The last state written; none: there is no file.
  /// @throws InputError  damaged, no checkpoint, or of another campaign, realisation, inputs or
  /// program
  std::optional<std::string> read() const;
  /// Writes what `save` gives, in place of the state before; a kill leaves one or the other.
  /// @throws InputError  the file can't be written
  void write(const std::function<void(ByteWriter& to)>& save) const;
  void remove() const;

  /// Removes the checkpoints of all realisations.
  static void remove_all(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  const CampaignHeader& header_;
  std::uint32_t realisation_;
};

}  // namespace clast::study_detail
