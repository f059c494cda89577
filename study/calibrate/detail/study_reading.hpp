#pragma once
/// Values of a study file, as `calibration_tables` declares them.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/key_table.hpp"

namespace clast::study_detail {

/// One table of a study, whose values are read by its declaration.
class StudyTable : public TomlTable {
 public:
  StudyTable(const TomlNode& node, const std::string& file, const std::string& name);

  std::optional<std::uint64_t> count_of(const std::string& key) const;
  /// One of the key's words.
  std::optional<std::string> choice_of(const std::string& key) const;
  /// The numbers of a list, which is there.
  std::vector<double> numbers_of(const std::string& key, const std::string& expected) const;

  /// Which of the keys that exclude each other is there.
  /// @param missing  what the refusal says where none is
  /// @throws InputError  none or several of them are, or a key that has no meaning beside it
  std::string source(const std::string& missing) const;

 private:
  const KeyTable* declared_;
};

/// A study, read part by part through `read`; a part that needs another is left out where that one
/// was not read.
CalibrationStudy read_study_by_parts(const std::filesystem::path& file, const PartReader& read);

}  // namespace clast::study_detail
