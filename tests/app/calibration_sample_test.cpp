// samples/calibration, with two boxes for the scanned blocks: the ground that the stops were made
// with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/statistics/statistics.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/posterior_draws.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

void write_boxes(const std::filesystem::path& file) {
  BlockLibrary library;
  for (const auto& [id, size] : {std::pair{"B01_compact", Vec3(0.60, 0.56, 0.50)},
                                 std::pair{"B04_elongated", Vec3(1.0, 0.52, 0.42)}}) {
    const TriangleMesh mesh = centred_box_mesh(size);
    BlockSource source;
    source.file = "box.stl";
    source.sha256 = std::string(64, '0');
    BlockOptions options;
    options.core = true;
    options.radius = 0.03;
    library.add(make_block(id, mesh, mesh, source, options));
  }
  library.write(file);
}

TEST(CalibrationSample, FindsTheGroundThatTheStopsWereMadeWith) {
  const ScratchFolder folder;
  write_boxes(folder / "blocks.h5");
  ::setenv("CLAST", CLAST_PROGRAM, 1);
  const std::string script = std::string(CLAST_SOURCE_DIR) + "/samples/calibration/calibrate.sh";
  const ProgramRun run =
      RunningProgram({"bash", script, (folder / "blocks.h5").string(), (folder / "out").string()},
                     ".")
          .wait();
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const CalibrationStudy study = read_calibration_study(folder / "out/study.toml");
  const Campaign truth = read_campaign(folder / "out/truth-p2.toml");
  const GroundDistributions& ground = truth.ground.at("blue");
  const std::vector<double> values = {ground.friction->first, ground.rolling_length->first};
  const PosteriorDraws found = read_posterior_draws(folder / "out/posterior.h5");
  ASSERT_EQ(found.parameters.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_GT(values[i], study.unknowns[i].low);
    std::vector<double> draws;
    for (const std::vector<double>& draw : found.draws) draws.push_back(draw[i]);
    std::sort(draws.begin(), draws.end());
    EXPECT_LE(quantile(draws, 0.025), values[i]) << found.parameters[i];
    EXPECT_GE(quantile(draws, 0.975), values[i]) << found.parameters[i];
    if (i == 0) {
      EXPECT_LT(quantile(draws, 0.975) - quantile(draws, 0.025),
                0.7 * (study.unknowns[0].high - study.unknowns[0].low));
    }
  }
}

}  // namespace
}  // namespace clast
