#pragma once
/// Checkpoints of unfinished realisations. They are stored beside the journal of the campaign.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/byte_archive.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// Checkpoint of one unfinished realisation. Only the program version that wrote it can read it.
class CheckpointFile {
 public:
  /// Sets the path of the checkpoint; no file is accessed.
  /// @param target  results file, beside which the checkpoint is stored
  /// @param header  must outlive this object
  /// @param realisation  index of the realisation, from 0
  CheckpointFile(const std::filesystem::path& target, const CampaignHeader& header,
                 std::uint32_t realisation);

  const std::filesystem::path& path() const { return path_; }
  /// Reads the stored state of the realisation; empty if there is no file.
  /// @throws InputError  if the file is damaged, is not a checkpoint, or belongs to another
  ///                     campaign, realisation, inputs or program version
  std::optional<std::string> read() const;
  /// Writes the state of the realisation, in place of the previous one.
  /// @param save  function that writes the bytes of the state
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
