#include "study/results/results_journal.hpp"

#include <bit>
#include <optional>
#include <set>
#include <sstream>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "dem/simulation/physics_digest.hpp"
#include "study/results/detail/results_layout.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "the journal is little-endian");

constexpr std::size_t kJournalDigestLength = 64;
const std::string kJournalMagic = "clast results journal 5\n";

template <class Bytes, class Row>
void serialize_row(Bytes& bytes, Row& row) {
  visit_columns(kRowType<Row>, [&](const auto&, const auto&, const auto&, const auto& field) {
    bytes(std::invoke(field, row));
  });
}

template <class Bytes, class Row>
void serialize_rows(Bytes& bytes, std::vector<Row>& rows) {
  rows.resize(bytes.archive_size(rows.size()));
  for (Row& row : rows) serialize_row(bytes, row);
}

template <class Bytes>
void serialize_run(Bytes& bytes, StoredRun& run) {
  serialize_row(bytes, run.record);
  serialize_rows(bytes, run.crossings);
  serialize_rows(bytes, run.impacts);
  serialize_rows(bytes, run.persistent_block_records);
  serialize_rows(bytes, run.energies);
  bytes(run.trajectory.time);
  serialize_rows(bytes, run.trajectory.states);
}

struct Identity {
  std::string campaign, program;
  std::vector<std::string> inputs;
  std::uint32_t planned = 0;
  std::string physics;  ///< empty: of an older program

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(campaign, program, inputs, planned);
    if constexpr (Bytes::kReads) {
      if (bytes.at_end()) return;
    }
    bytes(physics);
  }
};

Identity identity_of(const CampaignHeader& header) {
  return {header.campaign_sha256, header.program_version, header.inputs, header.planned_runs,
          header.physics_digest};
}

std::string record_of(const std::string& content) {
  std::uint64_t length = content.size();
  return serialized_bytes(length) + sha256(content) + content;
}

// The content of the record that begins at `begin`; none when it is cut short or damaged.
std::optional<std::string> read_record(std::fstream& file, std::uint64_t begin,
                                       std::uint64_t file_size) {
  std::uint64_t length = 0;
  constexpr std::uint64_t kOverhead = sizeof length + kJournalDigestLength;
  if (begin + kOverhead > file_size) return std::nullopt;
  file.clear();
  file.seekg(static_cast<std::streamoff>(begin));
  file.read(reinterpret_cast<char*>(&length), sizeof length);
  if (!file || length > file_size - begin - kOverhead) return std::nullopt;
  std::string digest(kJournalDigestLength, '\0'), bytes(length, '\0');
  file.read(digest.data(), kJournalDigestLength);
  file.read(bytes.data(), static_cast<std::streamsize>(length));
  if (!file || sha256(bytes) != digest) return std::nullopt;
  return bytes;
}

std::uint64_t record_size(const std::string& content) {
  return sizeof(std::uint64_t) + kJournalDigestLength + content.size();
}

std::multiset<std::string> digests(const std::vector<std::string>& inputs) {
  std::multiset<std::string> result;
  for (const std::string& input : inputs) result.insert(input.substr(input.rfind(' ') + 1));
  return result;
}

/// Empty: none.
std::string identity_difference(const Identity& stored, const Identity& now) {
  std::string difference;
  if (stored.campaign != now.campaign) {
    difference = "another campaign file";
  } else if (digests(stored.inputs) != digests(now.inputs)) {
    difference = "other input files";
    for (const std::string& input : now.inputs) {
      if (digests(stored.inputs).count(input.substr(input.rfind(' ') + 1)) == 0) {
        difference += " (" + input.substr(0, input.rfind(' ')) + " has changed)";
        break;
      }
    }
  } else if (stored.program != now.program) {
    difference = "clast " + stored.program + ", this is clast " + now.program;
  } else if (stored.planned != now.planned) {
    difference = std::to_string(stored.planned) + " planned runs, now there are " +
                 std::to_string(now.planned);
  } else if (!describe_physics_difference(stored.physics, now.physics).empty()) {
    difference = "clast " + stored.program + " too, but " +
                 describe_physics_difference(stored.physics, now.physics);
  }
  return difference;
}

void check_journal_campaign(const fs::path& path, const Identity& stored, const Identity& now) {
  const std::string difference = identity_difference(stored, now);
  if (difference.empty()) return;
  throw InputError(path.string() + ": was begun with " + difference +
                   "; delete it and start without `resume`");
}

std::fstream opened(const fs::path& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  if (!file) throw InputError(path.string() + ": can't be opened; check its permissions");
  return file;
}

}  // namespace

std::string serialize_stored_run(StoredRun run) {
  std::ostringstream text;
  ByteWriter writer(text);
  serialize_run(writer, run);
  return std::move(text).str();
}

std::string format_campaign_identity(const CampaignHeader& header) {
  Identity identity = identity_of(header);
  return serialized_bytes(identity);
}

std::string describe_campaign_difference(const CampaignHeader& stored, const CampaignHeader& now) {
  return identity_difference(identity_of(stored), identity_of(now));
}

std::string describe_campaign_difference(ByteReader& stored, const CampaignHeader& now) {
  Identity identity;
  stored(identity);
  return identity_difference(identity, identity_of(now));
}

StoredRun deserialize_stored_run(const std::string& bytes) {
  StoredRun run;
  ByteReader reader(bytes);
  serialize_run(reader, run);
  return run;
}

ResultsJournal ResultsJournal::create(const fs::path& path, const CampaignHeader& header) {
  const std::string begin = kJournalMagic + record_of(format_campaign_identity(header));
  write_text_file(path, begin);
  ResultsJournal journal(path, opened(path));
  journal.physics_ = header.physics_digest;
  journal.end_ = begin.size();
  return journal;
}

ResultsJournal ResultsJournal::resume(const fs::path& path, const CampaignHeader& header) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    throw InputError(path.string() +
                     ": no such file; there is no interrupted campaign to continue");
  }
  ResultsJournal journal(path, opened(path));
  const std::uint64_t size = fs::file_size(path);
  std::string magic(kJournalMagic.size(), '\0');
  journal.file_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  std::optional<std::string> content = read_record(journal.file_, kJournalMagic.size(), size);
  if (magic != kJournalMagic || !content) {
    throw InputError(path.string() +
                     ": is not the journal of an interrupted campaign; delete it and start "
                     "without `resume`");
  }
  Identity stored;
  ByteReader reader(*content);
  reader(stored);
  check_journal_campaign(path, stored, identity_of(header));
  journal.physics_ = stored.physics;
  journal.end_ = kJournalMagic.size() + record_size(*content);
  while ((content = read_record(journal.file_, journal.end_, size))) {
    journal.runs_.push_back(deserialize_stored_run(*content).record.run);
    journal.begins_.push_back(journal.end_);
    journal.end_ += record_size(*content);
  }
  fs::resize_file(path, journal.end_);
  return journal;
}

std::uint64_t ResultsJournal::smallest_record_size() {
  return record_size(serialize_stored_run(StoredRun{}));
}

void ResultsJournal::add(const StoredRun& run) {
  const std::string record = record_of(serialize_stored_run(run));
  file_.clear();
  file_.seekp(static_cast<std::streamoff>(end_));
  file_.write(record.data(), static_cast<std::streamsize>(record.size()));
  file_.flush();
  if (!file_) {
    throw InputError(
        path_.string() +
        ": writing failed; is the disk full? Free some space and continue with `resume`");
  }
  runs_.push_back(run.record.run);
  begins_.push_back(end_);
  end_ += record.size();
}

StoredRun ResultsJournal::read(std::size_t index) {
  const std::optional<std::string> content = read_record(file_, begins_[index], end_);
  if (!content) {
    throw InputError(
        path_.string() +
        ": was changed by another program; continue with `resume`, which repeats the lost runs");
  }
  return deserialize_stored_run(*content);
}

}  // namespace clast::study_detail
