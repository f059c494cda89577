/// Mutated files of every format but meshes: each is read or refused with a message.
#include <gtest/gtest.h>

#include "tests/app/fuzz/readers.hpp"

namespace clast {
namespace {

std::vector<NamedReader> all_readers() {
  std::vector<NamedReader> all;
  for (const auto& some : {cloud_and_shape_readers(), table_and_campaign_readers(), hdf5_readers(),
                           terrain_readers(), photo_readers()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

class MutatedInputs : public testing::TestWithParam<NamedReader> {};

TEST_P(MutatedInputs, AreReadOrRefused) {
  expect_read_or_refused(GetParam().make(), CLAST_FUZZ_FILES);
}

INSTANTIATE_TEST_SUITE_P(Readers, MutatedInputs, testing::ValuesIn(all_readers()),
                         [](const auto& reader) {
                           std::string name;
                           for (const char c : reader.param.name) {
                             name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace clast
