#pragma once
/// What realisations under way have come to, beside the journal of their campaign, so that an
/// interruption costs little of them.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/byte_archive.hpp"
#include "study/results.hpp"

namespace clast::study_detail {

/// The file of one realisation. It is only for the program that wrote it.
class CheckpointFile {
 public:
  /// @param target       of the results; the file is beside it, `partial_results` and the number
  /// @param realisation  from 0; in the name from 1
  CheckpointFile(const std::filesystem::path& target, const CampaignResults& header,
                 std::uint32_t realisation);

  /// What was kept last; empty: nothing.
  /// @throws InputError  damaged, or of another campaign, inputs or program
  std::string read() const;
  /// Keeps what `save` writes, in place of what was kept before; a kill leaves the one or the
  /// other.
  /// @throws InputError  the disk is full
  void write(const std::function<void(ByteWriter& to)>& save) const;
  void remove() const;

  /// Removes the files of all realisations.
  static void remove_all(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  std::string identity_;
};

}  // namespace clast::study_detail
