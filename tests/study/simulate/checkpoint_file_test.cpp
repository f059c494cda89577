// Files of realisations under way: what is kept, refused and removed.
#include "study/simulate/detail/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using study_detail::CheckpointFile;

void write(const CheckpointFile& file, const std::string& content) {
  file.write([&](ByteWriter& to) { to.archive_bytes(content.data(), content.size()); });
}

TEST(CheckpointFiles, KeepTheLastState) {
  const ScratchFolder folder;
  const CampaignResults header = hand_made_results();
  const CheckpointFile file(folder / "r.h5", header, 1);
  EXPECT_FALSE(file.read());
  write(file, "first");
  write(file, "");
  EXPECT_EQ(file.read(), "");
  write(file, std::string("a\0b", 3));
  EXPECT_EQ(file.read(), std::string("a\0b", 3));
  EXPECT_TRUE(fs::exists(folder / "r.h5.part.2"));
  file.remove();
  EXPECT_FALSE(fs::exists(folder / "r.h5.part.2"));
  file.remove();
}

TEST(CheckpointFiles, ThatAreDamagedAreRefused) {
  const ScratchFolder folder;
  const fs::path path = folder / "r.h5.part.1";
  const CampaignResults header = hand_made_results();
  const CheckpointFile file(folder / "r.h5", header, 0);
  write(file, "so far");
  const std::string whole = read_text_file(path);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    write_text_file(path, damaged);
    EXPECT_TRUE(contains(refusal([&] { file.read(); }), path.string() + ": is damaged; delete it"))
        << i;
    write_text_file(path, whole.substr(0, i));
    EXPECT_TRUE(contains(refusal([&] { file.read(); }), "is damaged")) << i;
  }
}

TEST(CheckpointFiles, OfAnotherCampaignAreRefused) {
  const ScratchFolder folder;
  const CampaignResults first = hand_made_results();
  CampaignResults header = first;
  write(CheckpointFile(folder / "r.h5", first, 0), "so far");
  // The same files in another place are the same inputs.
  for (std::string& input : header.inputs) input.insert(0, "elsewhere/");
  EXPECT_EQ(CheckpointFile(folder / "r.h5", header, 0).read(), "so far");
  header.campaign_sha256[0] = 'x';
  const CheckpointFile other(folder / "r.h5", header, 0);
  EXPECT_TRUE(contains(refusal([&] { other.read(); }),
                       "r.h5.part.1: was written with another campaign file; delete it"));
  std::string older = read_text_file(folder / "r.h5.part.1");
  older.resize(older.size() - 64);
  older.insert(older.find('\n'), "0");
  write_text_file(folder / "r.h5.part.1", older + sha256(older));
  EXPECT_TRUE(contains(refusal([&] { other.read(); }), "another version of clast"));
}

TEST(CheckpointFiles, OfAnotherRealisationAreRefused) {
  const ScratchFolder folder;
  const CampaignResults header = hand_made_results();
  write(CheckpointFile(folder / "r.h5", header, 0), "so far");
  fs::rename(folder / "r.h5.part.1", folder / "r.h5.part.3");
  const CheckpointFile third(folder / "r.h5", header, 2);
  EXPECT_TRUE(contains(refusal([&] { third.read(); }),
                       "r.h5.part.3: was written with the number of another realisation, 1"));
  fs::create_directory(folder / "r.h5.part.2");
  const CheckpointFile second(folder / "r.h5", header, 1);
  EXPECT_TRUE(contains(refusal([&] { second.read(); }), "has the name of a checkpoint"));
  write_text_file(folder / "r.h5.part.4", "what another program has written");
  const CheckpointFile fourth(folder / "r.h5", header, 3);
  EXPECT_TRUE(
      contains(refusal([&] { write(fourth, "so far"); }),
               "r.h5.part.4: has the name of a checkpoint but is not one; move it elsewhere"));
}

TEST(CheckpointFiles, ThatCannotBeWrittenAreReported) {
  const ScratchFolder folder;
  const CampaignResults header = hand_made_results();
  const CheckpointFile file(folder / "none" / "r.h5", header, 0);
  EXPECT_TRUE(contains(refusal([&] { write(file, "so far"); }),
                       "r.h5.part.1: the checkpoint can't be written"));
}

TEST(CheckpointFiles, AreRemovedAndNothingElse) {
  const ScratchFolder folder;
  const std::string checkpoint = "clast checkpoint 1\n";
  for (const char* name : {"r.h5.part.1", "r.h5.part.12", "r.h5.part.3.new", "r.h5.part",
                           "r.h5.part.old", "r.h5.part.1.old", "other.h5.part.1"}) {
    write_text_file(folder / name, checkpoint);
  }
  write_text_file(folder / "r.h5.part.02", "what another program has split");
  CheckpointFile::remove_all(folder / "r.h5");
  EXPECT_FALSE(fs::exists(folder / "r.h5.part.1"));
  EXPECT_FALSE(fs::exists(folder / "r.h5.part.12"));
  EXPECT_FALSE(fs::exists(folder / "r.h5.part.3.new"));
  for (const char* name :
       {"r.h5.part", "r.h5.part.old", "r.h5.part.1.old", "r.h5.part.02", "other.h5.part.1"}) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  CheckpointFile::remove_all(folder / "no" / "folder.h5");
}

}  // namespace
}  // namespace clast
