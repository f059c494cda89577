// Runs of programs that move blocks differently do not mix.
#include <gtest/gtest.h>

#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "study/results/results.hpp"
#include "tests/study/sample_results.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

TEST(Results, RunsOfOtherPhysicsAreNotResumedOrJoined) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5";
  CampaignResults header = sample_header(), other = header;
  header.physics_digest = std::string(64, 'a');
  other.physics_digest = std::string(64, 'b');
  { ResultsWriter writer = ResultsWriter::create(target, header); }
  EXPECT_EQ(refusal([&] { ResultsWriter::resume(target, other); }),
            results_journal_path(target).string() + ": was begun with clast " +
                header.program_version +
                " too, but this version of clast computes different motions (physics digest "
                "aaaaaaaaaa, here "
                "bbbbbbbbbb); delete it and start without `resume`");
  const auto finished = [&](const fs::path& file, const CampaignResults& of, std::uint32_t run) {
    ResultsWriter writer = ResultsWriter::create(file, of);
    add_run(writer, run);
    writer.finish();
    return read_results(file).physics_digest;
  };
  EXPECT_EQ(finished(target, header, 0), header.physics_digest);
  EXPECT_TRUE(has_finished_results(target, header, 1));
  EXPECT_TRUE(has_finished_results(target, sample_header(), 1));
  EXPECT_TRUE(contains(refusal([&] { has_finished_results(target, other, 1); }),
                       "this version of clast computes different motions"));
  finished(folder / "b.h5", other, 1);
  EXPECT_EQ(refusal([&] {
              merge_results({target, folder / "b.h5"}, folder / "m.h5");
            }),
            (folder / "b.h5").string() +
                ": was made by a program that computes different motions from that of " +
                target.string() +
                " (physics digest bbbbbbbbbb, there aaaaaaaaaa), though both are clast " +
                header.program_version + "; simulate all shards with one program");
}

// Their first record ends before the digest; what is not known of their runs is not said.
TEST(Results, JournalsOfOlderProgramsGoOn) {
  const ScratchFolder folder;
  const fs::path target = folder / "r.h5", part = results_journal_path(target);
  { ResultsWriter writer = ResultsWriter::create(target, sample_header()); }
  const std::string begun = read_text_file(part);
  const std::size_t line = begun.find('\n') + 1, content = line + 8 + 64;
  const std::string older = begun.substr(content, begun.size() - content - 8);
  const std::uint64_t length = older.size();
  write_text_file(part, begun.substr(0, line) +
                            std::string(reinterpret_cast<const char*>(&length), 8) + sha256(older) +
                            older);
  CampaignResults header = sample_header();
  header.physics_digest = std::string(64, 'a');
  ResultsWriter writer = ResultsWriter::resume(target, header);
  add_run(writer, 0);
  writer.finish();
  EXPECT_EQ(read_results(target).physics_digest, "");
}

}  // namespace
}  // namespace clast
