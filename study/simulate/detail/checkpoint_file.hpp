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

/// Checkpoint of one realisation, readable only by the program version that wrote it. The writer
/// holds the lock on the results target.
class CheckpointFile {
 public:
  /// Names the checkpoint of a realisation.
  /// @param target  results file; the checkpoint is `journal_path` with the realisation number
  /// @param header  must outlive this object
  /// @param realisation  from 0; in the file name from 1
  CheckpointFile(const std::filesystem::path& target, const CampaignHeader& header,
                 std::uint32_t realisation);

  const std::filesystem::path& path() const { return path_; }
  /// Reads the stored state; empty if there is no file.
  /// @throws InputError  if the file is damaged, not a checkpoint, or of another campaign,
  ///                     realisation, inputs or program
  std::optional<std::string> read() const;
  /// Writes the bytes of `save`, replacing the previous state atomically.
  /// @throws InputError  if the file cannot be written
  void write(const std::function<void(ByteWriter& to)>& save) const;
  void remove() const;

  static void remove_all(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  const CampaignHeader& header_;
  std::uint32_t realisation_;
};

}  // namespace clast::study_detail
