#include "core/files/digest.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <fstream>

#include "core/error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

// Examples of FIPS 180-4.
TEST(Digest, MatchesThePublishedExamples) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, PiecesGiveTheDigestOfTheWhole) {
  Sha256 digest;
  for (int i = 0; i < 1000; ++i) digest.add(std::string(1000, 'a'));
  EXPECT_EQ(digest.finish(), sha256(std::string(1000000, 'a')));
}

// Clouds of gigabytes are streamed, and so are their digests.
TEST(Digest, AFileNeedNotFitIntoMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer reserves more memory than the limit";
#endif
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "large.xyz";
  std::ofstream(path).put('a');
  std::filesystem::resize_file(path, std::uintmax_t{200} << 20);
  const auto with_little_memory = [&] {
    const rlimit limit{rlim_t{160} << 20, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &limit);
    std::exit(sha256_of_file(path).size() == 64 ? 0 : 1);
  };
  EXPECT_EXIT(with_little_memory(), testing::ExitedWithCode(0), "");
}

TEST(Digest, MissingFileIsNamed) {
  try {
    sha256_of_file("no/such/file.stl");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/file.stl"), std::string::npos);
  }
}

}  // namespace
}  // namespace clast
