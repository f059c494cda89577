/// Mutated files of every format but meshes: each is read or refused with a message.
#include <gtest/gtest.h>

#include "tests/app/fuzz/readers.hpp"

namespace clast {
namespace {

class MutatedInputs : public testing::TestWithParam<NamedReader> {};

TEST_P(MutatedInputs, AreReadOrRefused) { expect_read_or_refused(GetParam().make(), 20); }

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
