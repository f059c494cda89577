#pragma once
/// The journal in which runs are kept until a campaign is complete: records with a checksum, one
/// after the other. An HDF5 file that is written to can be lost to a kill at the wrong moment,
/// since its parts change in place; of a journal at most the last record is.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/byte_archive.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// A run as bytes, and back: what the journal keeps and processes send each other.
std::string packed(StoredRun run);
/// @throws InputError  not the bytes of a run
StoredRun unpacked(const std::string& bytes);

/// What a campaign is recognised by, with its inputs and the program, as bytes.
std::string format_campaign_identity(const CampaignHeader& header);
/// How the campaign of stored results differs from this one: campaign file, inputs, version,
/// number of runs or physics. Empty: not at all.
std::string describe_campaign_difference(const CampaignHeader& stored, const CampaignHeader& now);
/// The same of a stored `format_campaign_identity`, which it reads.
/// @throws InputError  no such bytes
std::string describe_campaign_difference(ByteReader& stored, const CampaignHeader& now);

class ResultsJournal {
 public:
  /// Begins a journal in place of what was there. Makes missing parent folders.
  /// @throws InputError  the file can't be written
  static ResultsJournal create(const std::filesystem::path& path, const CampaignHeader& header);
  /// Opens a journal and drops a broken end.
  /// @throws InputError  missing, not a journal, or of another campaign, inputs or program
  static ResultsJournal resume(const std::filesystem::path& path, const CampaignHeader& header);

  /// Bytes that a run takes at least.
  static std::uint64_t smallest_record_size();

  const std::filesystem::path& path() const { return path_; }
  /// Physics digest of the program that began it; empty: an older one.
  const std::string& physics() const { return physics_; }
  /// Runs in the order they were added.
  const std::vector<std::uint32_t>& runs() const { return runs_; }
  /// @throws InputError  the disk is full
  void add(const StoredRun& run);
  /// @param index  into `runs()`
  StoredRun read(std::size_t index);

 private:
  ResultsJournal(std::filesystem::path path, std::fstream file)
      : path_(std::move(path)), file_(std::move(file)) {}

  std::filesystem::path path_;
  std::string physics_;
  std::fstream file_;
  std::vector<std::uint32_t> runs_;
  std::vector<std::uint64_t> begins_;  ///< of the record of each run, bytes
  std::uint64_t end_ = 0;              ///< of the last whole record
};

}  // namespace clast::study_detail
