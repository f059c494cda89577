#pragma once
/// Journal that stores runs until a campaign is complete. If the program is killed, at most the
/// last run is lost.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/byte_archive.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// Serialises a run for the journal and for messages between processes.
std::string serialize_stored_run(StoredRun run);
/// Deserialises a run.
/// @throws InputError  if the bytes are not a run
StoredRun deserialize_stored_run(const std::string& bytes);

/// Serialises the identity of a campaign: campaign text, inputs and program.
std::string format_campaign_identity(const CampaignHeader& header);
/// Describes the difference between stored results and a campaign in campaign file, inputs,
/// version, number of runs or physics. Empty if they agree.
std::string describe_campaign_difference(const CampaignHeader& stored, const CampaignHeader& now);
/// Deserialises the identity of a campaign and describes its difference from another. Empty if they
/// agree.
/// @throws InputError  if the bytes are not an identity
std::string describe_campaign_difference(ByteReader& stored, const CampaignHeader& now);

/// Journal of the runs of a campaign.
class ResultsJournal {
 public:
  /// Creates a journal and missing parent folders. Replaces an existing file.
  /// @throws InputError  if the file cannot be written
  static ResultsJournal create(const std::filesystem::path& path, const CampaignHeader& header);
  /// Opens a journal and drops an incomplete last record.
  /// @throws InputError  if the file is missing, is not a journal, or belongs to another campaign,
  ///                     other inputs or another program version
  static ResultsJournal resume(const std::filesystem::path& path, const CampaignHeader& header);

  /// Returns the minimum size of a record, bytes.
  static std::uint64_t smallest_record_size();

  const std::filesystem::path& path() const { return path_; }
  /// Returns the digest of the simulated physics of the journal; empty if unknown.
  const std::string& physics_digest() const { return physics_; }
  /// Returns the indices of the runs in the order of their records.
  const std::vector<std::uint32_t>& run_indices() const { return runs_; }
  /// Appends the record of a run.
  /// @throws InputError  if the disk is full
  void add(const StoredRun& run);
  /// Reads the record of a run.
  /// @param index  index into `runs()`
  StoredRun read(std::size_t index);

 private:
  ResultsJournal(std::filesystem::path path, std::fstream file)
      : path_(std::move(path)), file_(std::move(file)) {}

  std::filesystem::path path_;
  std::string physics_;
  std::fstream file_;
  std::vector<std::uint32_t> runs_;
  std::vector<std::uint64_t> begins_;  ///< position of each record in the file, bytes
  std::uint64_t end_ = 0;              ///< end of the last complete record, bytes
};

}  // namespace clast::study_detail
