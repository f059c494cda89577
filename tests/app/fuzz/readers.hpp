#pragma once
/// Every reader with a sound file of each format that it takes (of meshes see
/// tests/reconstruct/fuzz_test.cpp).
#include <functional>
#include <string>
#include <vector>

#include "tests/support/fuzzing.hpp"

namespace clast {

/// A reader by name, made when it is tried.
struct NamedReader {
  std::string name;
  std::function<FuzzedReader()> make;
};
inline void PrintTo(const NamedReader& reader, std::ostream* out) { *out << reader.name; }

std::vector<NamedReader> cloud_and_shape_readers();
std::vector<NamedReader> table_and_campaign_readers();
std::vector<NamedReader> hdf5_readers();
std::vector<NamedReader> terrain_readers();
std::vector<NamedReader> photo_readers();
inline std::vector<NamedReader> all_readers() {
  std::vector<NamedReader> all;
  for (const auto& some : {cloud_and_shape_readers(), table_and_campaign_readers(), hdf5_readers(),
                           terrain_readers(), photo_readers()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// A reader of one file.
inline NamedReader reader_of(const std::string& file, const std::function<std::string()>& bytes,
                             const std::function<void(const std::filesystem::path&)>& read,
                             const std::string& made_of_all = {}) {
  return {file, [=]() -> FuzzedReader {
            return {file,
                    file,
                    {{file, bytes()}},
                    [=](const auto& folder) { read(folder / file); },
                    made_of_all};
          }};
}

}  // namespace clast
