#include "study/detail/results_journal.hpp"

#include <bit>
#include <cstring>
#include <optional>
#include <set>

#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "dem/physics_digest.hpp"
#include "study/detail/results_layout.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "the journal is little-endian");

constexpr std::size_t kDigestLength = 64;
const std::string kMagic = "clast results journal 5\n";

// A record to be, and the same calls that read it back.
class Packer {
 public:
  template <class T>
  void value(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void value(const std::string& text) {
    value(std::uint64_t{text.size()});
    bytes += text;
  }
  template <class T>
  void size(const std::vector<T>& list) {
    value(std::uint64_t{list.size()});
  }
  /// Written last, and missing in records of older programs.
  void last(const std::string& text) { value(text); }
  std::string bytes;
};

class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}
  template <class T>
  void value(T& value) {
    std::memcpy(&value, take(sizeof value), sizeof value);
  }
  void value(std::string& text) {
    std::uint64_t length = 0;
    value(length);
    text.assign(take(length), length);
  }
  template <class T>
  void size(std::vector<T>& list) {
    std::uint64_t count = 0;
    value(count);
    // An element takes a byte at least.
    if (count > bytes_.size()) throw InputError("a record has an impossible size");
    list.resize(count);
  }
  void last(std::string& text) {
    if (at_ < bytes_.size()) value(text);
  }

 private:
  const char* take(std::uint64_t count) {
    if (count > bytes_.size() - at_) throw InputError("a record is too short");
    at_ += count;
    return bytes_.data() + (at_ - count);
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class Archive, class Row>
void transfer_row(Archive& archive, Row& row) {
  visit_columns(kRowsOf<Row>, [&](const auto&, const auto&, const auto&, const auto& field) {
    archive.value(std::invoke(field, row));
  });
}

template <class Archive, class Row>
void transfer_rows(Archive& archive, std::vector<Row>& rows) {
  archive.size(rows);
  for (Row& row : rows) transfer_row(archive, row);
}

// Fields in one order for both ways.
template <class Archive>
void transfer(Archive& archive, StoredRun& run) {
  transfer_row(archive, run.record);
  transfer_rows(archive, run.crossings);
  transfer_rows(archive, run.impacts);
  transfer_rows(archive, run.stays);
  transfer_rows(archive, run.energies);
  archive.size(run.trajectory.time);
  for (double& time : run.trajectory.time) archive.value(time);
  transfer_rows(archive, run.trajectory.states);
}

struct Identity {
  std::string campaign, program;
  std::vector<std::string> inputs;
  std::uint32_t planned = 0;
  std::string physics;  ///< empty: of an older program
};

template <class Archive>
void transfer(Archive& archive, Identity& identity) {
  archive.value(identity.campaign);
  archive.value(identity.program);
  archive.size(identity.inputs);
  for (std::string& input : identity.inputs) archive.value(input);
  archive.value(identity.planned);
  archive.last(identity.physics);
}

Identity identity_of(const CampaignResults& header) {
  return {header.campaign_sha256, header.program_version, header.inputs, header.planned_runs,
          header.physics_digest};
}

template <class T>
std::string bytes_of(T value) {
  Packer packer;
  transfer(packer, value);
  return std::move(packer.bytes);
}

std::string record_of(const std::string& content) {
  Packer record;
  record.value(std::uint64_t{content.size()});
  return record.bytes + sha256(content) + content;
}

// The content of the record that begins at `begin`; none when it is cut short or damaged.
std::optional<std::string> read_record(std::fstream& file, std::uint64_t begin,
                                       std::uint64_t file_size) {
  std::uint64_t length = 0;
  constexpr std::uint64_t kOverhead = sizeof length + kDigestLength;
  if (begin + kOverhead > file_size) return std::nullopt;
  file.clear();
  file.seekg(static_cast<std::streamoff>(begin));
  file.read(reinterpret_cast<char*>(&length), sizeof length);
  if (!file || length > file_size - begin - kOverhead) return std::nullopt;
  std::string digest(kDigestLength, '\0'), bytes(length, '\0');
  file.read(digest.data(), kDigestLength);
  file.read(bytes.data(), static_cast<std::streamsize>(length));
  if (!file || sha256(bytes) != digest) return std::nullopt;
  return bytes;
}

std::uint64_t record_size(const std::string& content) {
  return sizeof(std::uint64_t) + kDigestLength + content.size();
}

std::multiset<std::string> digests(const std::vector<std::string>& inputs) {
  std::multiset<std::string> result;
  for (const std::string& input : inputs) result.insert(input.substr(input.rfind(' ') + 1));
  return result;
}

/// Empty: none.
std::string difference_of(const Identity& stored, const Identity& now) {
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
  } else if (!physics_difference(stored.physics, now.physics).empty()) {
    difference =
        "clast " + stored.program + " too, but " + physics_difference(stored.physics, now.physics);
  }
  return difference;
}

void check_same_campaign(const fs::path& path, const Identity& stored, const Identity& now) {
  const std::string difference = difference_of(stored, now);
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

std::string packed(const StoredRun& run) { return bytes_of(run); }

std::string campaign_difference(const CampaignResults& stored, const CampaignResults& now) {
  return difference_of(identity_of(stored), identity_of(now));
}

StoredRun unpacked(const std::string& bytes) {
  StoredRun run;
  Unpacker unpacker(bytes);
  transfer(unpacker, run);
  return run;
}

ResultsJournal ResultsJournal::create(const fs::path& path, const CampaignResults& header) {
  const std::string begin = kMagic + record_of(bytes_of(identity_of(header)));
  write_text_file(path, begin);
  ResultsJournal journal(path, opened(path));
  journal.physics_ = header.physics_digest;
  journal.end_ = begin.size();
  return journal;
}

ResultsJournal ResultsJournal::resume(const fs::path& path, const CampaignResults& header) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    throw InputError(path.string() +
                     ": no such file; there is no interrupted campaign to go on "
                     "with");
  }
  ResultsJournal journal(path, opened(path));
  const std::uint64_t size = fs::file_size(path);
  std::string magic(kMagic.size(), '\0');
  journal.file_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  std::optional<std::string> content = read_record(journal.file_, kMagic.size(), size);
  if (magic != kMagic || !content) {
    throw InputError(path.string() +
                     ": is not the journal of an interrupted campaign; delete it and start "
                     "without `resume`");
  }
  Identity stored;
  Unpacker unpacker(*content);
  transfer(unpacker, stored);
  check_same_campaign(path, stored, identity_of(header));
  journal.physics_ = stored.physics;
  journal.end_ = kMagic.size() + record_size(*content);
  while ((content = read_record(journal.file_, journal.end_, size))) {
    journal.runs_.push_back(unpacked(*content).record.run);
    journal.begins_.push_back(journal.end_);
    journal.end_ += record_size(*content);
  }
  fs::resize_file(path, journal.end_);
  return journal;
}

std::uint64_t ResultsJournal::smallest_record() { return record_size(packed(StoredRun{})); }

void ResultsJournal::add(const StoredRun& run) {
  const std::string record = record_of(packed(run));
  file_.clear();
  file_.seekp(static_cast<std::streamoff>(end_));
  file_.write(record.data(), static_cast<std::streamsize>(record.size()));
  file_.flush();
  if (!file_) {
    throw InputError(path_.string() +
                     ": writing failed; is the disk full? Free some space and go on with `resume`");
  }
  runs_.push_back(run.record.run);
  begins_.push_back(end_);
  end_ += record.size();
}

StoredRun ResultsJournal::read(std::size_t index) {
  const std::optional<std::string> content = read_record(file_, begins_[index], end_);
  if (!content) {
    throw InputError(path_.string() +
                     ": was changed by another program; go on with `resume`, which repeats the "
                     "runs that were lost");
  }
  return unpacked(*content);
}

}  // namespace clast::study_detail
