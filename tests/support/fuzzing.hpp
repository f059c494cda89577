#pragma once
/// A reader against mutated files: each is read or refused with a message, in bounded time.
///
/// CLAST_FUZZ_FILES in the environment is the number of files for each reader (default: what the
/// test asks for), CLAST_FUZZ_SECONDS tries so long instead, and CLAST_FUZZ_FIRST begins
/// at another number than 0. Reader and number together give the same bytes on every machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/mutated_bytes.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/setting.hpp"

namespace clast {

/// A reader, and the files it reads: by name in a folder, all sound.
struct FuzzedReader {
  std::string name;
  std::string mutated_file;
  std::map<std::string, std::string> files;
  std::function<void(const std::filesystem::path& folder)> read;
  std::string made_of_all = {};  ///< what messages name where all files together are at fault
};

/// CPU seconds that one file may take; sanitizers cost a factor of five to ten.
#ifdef __SANITIZE_ADDRESS__
inline constexpr double kMaxFuzzSeconds = 10.0;
#else
inline constexpr double kMaxFuzzSeconds = 2.0;
#endif

/// Numbers of files that once were read wrongly, by the reader's name: they are tried every time.
inline const std::map<std::string, std::vector<std::uint64_t>> kKeptSeeds = {
    {"rock.glb", {44, 136, 285}},  // slow: of no extent
    {"rock.gltf", {141}},          // ended the program
    {"ground.ply", {103138}},      // ended the program: no triangle of any area
    {"text.stl", {100060}},        // crossed itself once it stood upright
    {"cameras.sfm", {107688}},     // version that overflowed a number
    {"zones.geojson", {106597}},   // refused without the name of the file
};

/// The numbers of the files that a reader is tried with.
class FuzzNumbers {
 public:
  FuzzNumbers(const std::string& reader, std::uint64_t usual_files) {
    if (const auto kept = kKeptSeeds.find(reader); kept != kKeptSeeds.end()) kept_ = kept->second;
    const std::optional<std::uint64_t> seconds = setting("CLAST_FUZZ_SECONDS");
    if (seconds) end_ = std::chrono::steady_clock::now() + std::chrono::seconds(*seconds);
    next_ = setting("CLAST_FUZZ_FIRST").value_or(0);
    const std::uint64_t files = setting("CLAST_FUZZ_FILES").value_or(usual_files);
    last_ = seconds ? ~std::uint64_t{0} : next_ + files;
  }

  std::optional<std::uint64_t> next() {
    if (tried_kept_ < kept_.size()) return kept_[tried_kept_++];
    if (next_ == last_ || (end_ && std::chrono::steady_clock::now() > *end_)) return std::nullopt;
    return next_++;
  }

 private:
  std::vector<std::uint64_t> kept_;
  std::size_t tried_kept_ = 0;
  std::uint64_t next_ = 0, last_ = 0;
  std::optional<std::chrono::steady_clock::time_point> end_;
};

/// The file of that number.
inline std::string mutated_file(const std::string& reader, const std::string& sound,
                                std::uint64_t number) {
  std::uint64_t hash = 14695981039346656037ull;  // FNV-1a, so that readers differ
  for (const char c : reader) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  Random random(hash + number);
  return mutated(sound, random);
}

/// A folder with the files of a reader, one of which is replaced by whatever it is tried with.
class TriedReader {
 public:
  explicit TriedReader(FuzzedReader reader) : reader_(std::move(reader)) {
    for (const auto& [name, bytes] : reader_.files) {
      std::filesystem::create_directories((folder_ / name).parent_path());
      write_text_file(folder_ / name, bytes);
    }
  }

  void read_sound() const { reader_.read(folder_.path()); }
  const std::string& sound() const { return reader_.files.at(reader_.mutated_file); }

  struct Outcome {
    bool read = false;
    std::string fault = {};  ///< of the reader: what it threw is no Error, or names no file
  };
  Outcome read(const std::string& bytes) const {
    write_text_file(folder_ / reader_.mutated_file, bytes);
    try {
      reader_.read(folder_.path());
      return {true};
    } catch (const Error& error) {
      if (names_a_file(error.what())) return {};
      return {false, std::string("names no file: ") + error.what()};
    } catch (const std::exception& error) {
      return {false, std::string("no Error: ") + error.what()};
    }
  }

 private:
  /// A file of the folder, or the folder.
  bool names_a_file(const std::string& message) const {
    const auto has = [&](const std::string& text) {
      return message.find(text) != std::string::npos;
    };
    return has(folder_.path().string()) ||
           (!reader_.made_of_all.empty() && has(reader_.made_of_all)) ||
           std::any_of(reader_.files.begin(), reader_.files.end(),
                       [&](const auto& file) { return has(file.first); });
  }

  FuzzedReader reader_;
  ScratchFolder folder_;
};

/// Reads the sound files, then mutated ones.
inline void expect_read_or_refused(const FuzzedReader& reader, std::uint64_t usual_files) {
  const TriedReader tried(reader);
  ASSERT_NO_THROW(tried.read_sound()) << "the sound file";
  std::size_t read = 0, refused = 0;
  double longest = 0.0;
  FuzzNumbers numbers(reader.name, usual_files);
  while (const std::optional<std::uint64_t> number = numbers.next()) {
    SCOPED_TRACE(reader.name + " number " + std::to_string(*number));
    const std::clock_t begin = std::clock();
    const TriedReader::Outcome outcome =
        tried.read(mutated_file(reader.name, tried.sound(), *number));
    EXPECT_EQ(outcome.fault, "");
    ++(outcome.read ? read : refused);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kMaxFuzzSeconds);
    longest = std::max(longest, seconds);
  }
  std::cout << reader.name << ": " << read << " read, " << refused << " refused, longest "
            << longest << " s\n";
}

}  // namespace clast
