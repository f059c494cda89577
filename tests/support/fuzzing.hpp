#pragma once
/// A reader against mutated files: each is read or refused with a message, in bounded time.
///
/// CLAST_FUZZ_FILES in the environment is the number of files for each reader (default: what the
/// test was compiled with), CLAST_FUZZ_SECONDS tries so long instead, and CLAST_FUZZ_FIRST begins
/// at another number than 0. Reader and number together give the same bytes on every machine.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "tests/support/mutated_bytes.hpp"
#include "tests/support/scratch_folder.hpp"

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
inline constexpr double kMostFuzzSeconds = 10.0;
#else
inline constexpr double kMostFuzzSeconds = 2.0;
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
  static std::optional<std::uint64_t> setting(const char* name) {
    const char* text = std::getenv(name);
    return text ? std::optional<std::uint64_t>(std::stoull(text)) : std::nullopt;
  }

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

/// Reads the sound files, then mutated ones. What is thrown must be an Error that names a file of
/// the folder, or the folder.
inline void expect_read_or_refused(const FuzzedReader& reader, std::uint64_t usual_files) {
  const ScratchFolder folder;
  for (const auto& [name, bytes] : reader.files) {
    std::filesystem::create_directories((folder / name).parent_path());
    write_text_file(folder / name, bytes);
  }
  ASSERT_NO_THROW(reader.read(folder.path())) << "the sound file";
  const auto names_a_file = [&](const std::string& message) {
    bool named =
        message.find(folder.path().string()) != std::string::npos ||
        (!reader.made_of_all.empty() && message.find(reader.made_of_all) != std::string::npos);
    for (const auto& [name, bytes] : reader.files) named |= message.find(name) != std::string::npos;
    return named;
  };
  std::size_t read = 0, refused = 0;
  double longest = 0.0;
  FuzzNumbers numbers(reader.name, usual_files);
  while (const std::optional<std::uint64_t> number = numbers.next()) {
    SCOPED_TRACE(reader.name + " number " + std::to_string(*number));
    write_text_file(folder / reader.mutated_file,
                    mutated_file(reader.name, reader.files.at(reader.mutated_file), *number));
    const std::clock_t begin = std::clock();
    try {
      reader.read(folder.path());
      ++read;
    } catch (const Error& error) {
      EXPECT_TRUE(names_a_file(error.what())) << error.what();
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "no Error: " << error.what();
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kMostFuzzSeconds);
    longest = std::max(longest, seconds);
  }
  std::cout << reader.name << ": " << read << " read, " << refused << " refused, longest "
            << longest << " s\n";
}

}  // namespace clast
