// samples/prediction at a small size: a quarter of the field's blocks, 8 members, both ways.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include "core/files/text_file.hpp"
#include "library/block_library.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

constexpr std::size_t kEvery = 4;

/// A surveyed block, as the field's file has it.
struct Surveyed {
  double x = 0.0, y = 0.0, z = 0.0, mass = 0.0, l = 0.0, i = 0.0, s = 0.0;
};

std::vector<Surveyed> surveyed(const std::string& profile) {
  std::istringstream lines(
      read_text_file(test_data("authume/field/Endpoints_P" + profile + ".txt")));
  std::vector<Surveyed> blocks;
  Surveyed one;
  while (lines >> one.x >> one.y >> one.z >> one.mass >> one.l >> one.i >> one.s) {
    blocks.push_back(one);
  }
  return blocks;
}

class Prediction : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const auto data = std::filesystem::absolute(test_data("authume")).parent_path();
    ::setenv("CLAST", CLAST_PROGRAM, 1);
    ::setenv("MEMBERS", "8", 1);
    ::setenv("RELEASES", "24", 1);
    ::setenv("PREDICTED", "2", 1);
    ::setenv("EVERY", std::to_string(kEvery).c_str(), 1);
    const std::string script = std::string(CLAST_SOURCE_DIR) + "/samples/prediction/predict.sh";
    made_ = RunningProgram({"bash", script, data.string(), path("out")}, ".").wait();
    ASSERT_EQ(made_.exit_code, 0) << made_.err;
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return *folder_ / name; }

  static ScratchFolder* folder_;
  static ProgramRun made_;
};

ScratchFolder* Prediction::folder_ = nullptr;
ProgramRun Prediction::made_;

TEST_F(Prediction, BlocksHaveMassFormAndClassOfThoseSurveyed) {
  for (const std::string profile : {"1", "2"}) {
    const BlockLibrary library = BlockLibrary::read(path("out/blocks-p" + profile + ".h5"));
    const std::vector<Surveyed> field = surveyed(profile);
    ASSERT_EQ(library.blocks().size(), field.size() / kEvery);
    for (std::size_t k = 0; k < library.blocks().size(); ++k) {
      const Block& block = library.blocks()[k];
      const Surveyed& taped = field[kEvery * (k + 1) - 1];
      EXPECT_NEAR(block.mass.mass, taped.mass, 1e-3 * taped.mass) << block.id;
      EXPECT_NEAR(block.density, 2500.0, 25.0) << block.id;
      EXPECT_NEAR(block.axes().I / block.axes().L, taped.i / taped.l, 0.01) << block.id;
      EXPECT_NEAR(block.axes().S / block.axes().L, taped.s / taped.l, 0.01) << block.id;
    }
  }
}

// One set of simulations, of which either profile is fitted and the other kept.
TEST_F(Prediction, BothDirectionsHaveTheSameSimulations) {
  const StoredCalibration p2 = read_calibration_runs(path("out/fit-p2.h5"));
  const StoredCalibration p1 = read_calibration_runs(path("out/fit-p1.h5"));
  EXPECT_EQ(p1.design_sha256, p2.design_sha256);
  const auto stops = [](const StoredCalibration& stored) {
    std::vector<double> x;
    for (const auto& site : stored.runs.outcomes) {
      for (const auto& member : site) {
        for (const ReleaseOutcome& outcome : member) x.push_back(outcome.stop.x());
      }
    }
    return x;
  };
  EXPECT_EQ(stops(p1).size(), 2u * 8u * 24u);
  EXPECT_EQ(stops(p1), stops(p2));
  const auto fitted_sites = [](const std::string& name) {
    const CalibrationStudy study = read_calibration_study(path("out/" + name));
    std::set<std::string> sites;
    for (const Observation& observation : study.observations) {
      if (observation.fitted) sites.insert(study.sites[observation.site].name);
    }
    return sites;
  };
  ::setenv("CLAST_DATA", std::filesystem::absolute(test_data("authume")).parent_path().c_str(), 1);
  EXPECT_EQ(fitted_sites("fit-p2.toml"), std::set<std::string>{"P2"});
  EXPECT_EQ(fitted_sites("fit-p1.toml"), std::set<std::string>{"P1"});
}

TEST_F(Prediction, StopsOfTheOtherProfileAreHeldAgainstTheFields) {
  for (const std::string profile : {"1", "2"}) {
    const CsvTable measured =
        read_csv(read_text_file(path("out/predict-p" + profile + "/measured.csv")));
    std::size_t stops = 0;
    for (const std::string shape : {"compact", "elongated"}) {
      const std::size_t row = measured.find("group", "class " + shape);
      stops += static_cast<std::size_t>(measured.number(row, "measured"));
      EXPECT_GT(measured.number(row, "simulated"), 0.0);
    }
    EXPECT_EQ(stops, surveyed(profile).size());
  }
}

}  // namespace
}  // namespace clast
