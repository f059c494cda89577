#include "library/block_library.hpp"
#include "study/results/results.hpp"
#include "terrain/terrain_file.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/library/core_library.hpp"
#include "tests/study/sample_results.hpp"

namespace clast {

namespace {

std::string library() {
  const ScratchFolder folder;
  write_core_library(folder / "b.h5", {{"B1", cuboid(1.0, 0.8, 0.5)}, {"B2", cuboid(2, 1, 1)}});
  return read_text_file(folder / "b.h5");
}

std::string results() {
  const ScratchFolder folder;
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", sample_header());
  for (std::uint32_t run = 0; run < 8; ++run) add_run(writer, run);
  writer.finish();
  return read_text_file(folder / "r.h5");
}

std::string journal() {
  const ScratchFolder folder;
  ResultsWriter writer = ResultsWriter::create(folder / "r.h5", sample_header());
  for (std::uint32_t run = 0; run < 4; ++run) add_run(writer, run);
  return read_text_file(results_journal_path(folder / "r.h5"));
}

std::string terrain() {
  const ScratchFolder folder;
  write_terrain(folder / "t.h5", sample_header().terrain);
  return read_text_file(folder / "t.h5");
}

void read_library(const std::filesystem::path& path) {
  const BlockLibrary library = BlockLibrary::read(path);
  for (const Block& block : library.blocks()) {
    ASSERT_TRUE(block.mass.mass > 0.0 && block.principal.moments.minCoeff() > 0.0);
  }
}

}  // namespace

std::vector<NamedReader> hdf5_readers() {
  return {
      reader_of("blocks.h5", library, read_library),
      reader_of("results.h5", results,
                [](const auto& path) {
                  const CampaignResults read = read_results(path);
                  for (const RunRecord& run : read.runs) read_trajectory(path, run.run);
                }),
      reader_of("results.h5.part", journal,
                [](const auto& path) {
                  ResultsWriter::resume(path.parent_path() / "results.h5", sample_header());
                }),
      reader_of("terrain.h5", terrain, [](const auto& path) { read_terrain_file(path); }),
  };
}

}  // namespace clast
