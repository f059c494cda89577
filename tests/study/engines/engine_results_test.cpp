// Results of other engines, from conf files with known trajectories.
#include "study/engines/engine_results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "study/compare/comparison.hpp"
#include "study/compare/run_columns.hpp"
#include "study/engines/engine_scene.hpp"
#include "tests/study/campaign_run.hpp"
#include "tests/support/gravity.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

using Motion = std::function<RigidState(double)>;

std::string digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string words(const Vec3& v) {
  return digits(v.x()) + " " + digits(v.y()) + " " + digits(v.z()) + " ";
}

class EngineResultsOf : public CampaignRun {
 protected:
  void SetUp() override {
    fs::remove_all(scenes());
    fs::create_directories(scenes());
    fs::remove(target());
    folders_ = write_engine_scenes(plan_, {}, scenes()).folders;
  }
  static fs::path scenes() { return *folder_ / "rockable"; }
  static fs::path target() { return *folder_ / "rockable.h5"; }

  /// The conf file of a run at a time, made from the scene's input.
  std::string conf(std::size_t run, double time, const RigidState& state) const {
    std::string text = read_text_file(scenes() / folders_[run] / "input.txt");
    text = replaced_once(text, "\nt 0\n", "\nt " + digits(time) + "\n");
    const std::string name = "\n" + plan_.header.blocks[plan_.runs[run].block].id + " ";
    const std::size_t begin = text.find(name) + 1, end = text.find('\n', begin);
    const Quat& q = state.orientation;
    const std::string body = name.substr(1) + "0 0 1 " + words(state.position) +
                             words(state.velocity) + "0 0 0 " + digits(q.w()) + " " +
                             digits(q.x()) + " " + digits(q.y()) + " " + digits(q.z()) + " " +
                             words(state.angular_velocity) + "0 0 0";
    return text.replace(begin, end - begin, body) + "Interactions 0\nInterfaces 0\n";
  }
  void write_series(std::size_t run, const std::vector<double>& times, const Motion& motion) const {
    for (std::size_t i = 0; i < times.size(); ++i) {
      write_text_file(scenes() / folders_[run] / ("conf" + std::to_string(i)),
                      conf(run, times[i], motion(times[i])));
    }
  }
  /// Ballistic, turning about the block's own axis.
  Motion flight(std::size_t run) const {
    return [this, run](double t) {
      return free_flight(plan_.bodies[plan_.runs[run].block], plan_.runs[run].start, t,
                         kTestGravity);
    };
  }
  /// A flight to `landing`, then rest there.
  Motion stop_after(std::size_t run, double landing) const {
    return [flown = flight(run), landing](double t) {
      RigidState state = flown(std::min(t, landing));
      if (t > landing) state.velocity = state.angular_velocity = Vec3::Zero();
      return state;
    };
  }
  CampaignResults imported(EngineImportSummary* found = nullptr) const {
    const EngineImportSummary runs = import_engine_results({.scenes = scenes()}, target());
    if (found) *found = runs;
    return read_results(target());
  }
  std::string refused() const {
    return clast::refusal<InputError>(
        [&] { import_engine_results({.scenes = scenes()}, target()); });
  }

  const CampaignPlan plan_ = prepared(replaced_once(
      with("library = \"blocks.h5\"", "library = \"blocks.h5\"\nselect = [\"cube\"]"),
      "turns.txt\"", "turns.txt\"\nvelocity_m_s = [6, 0, 0]\nangular_velocity_rad_s = [0, 2, 0]"));
  std::vector<std::string> folders_;
};

std::vector<double> every(double interval, double end) {
  std::vector<double> times;
  for (int i = 0; i * interval <= end + 1e-9; ++i) times.push_back(i * interval);
  return times;
}

TEST_F(EngineResultsOf, AFlightHasItsEndItsPathAndItsEnergy) {
  write_series(0, every(0.3, 1.2), flight(0));
  EngineImportSummary found;
  const CampaignResults results = imported(&found);
  EXPECT_EQ(found.runs, 1u);
  EXPECT_EQ(found.planned, plan_.runs.size());
  EXPECT_EQ(found.without_output, plan_.runs.size() - 1);
  ASSERT_EQ(results.runs.size(), 1u);
  EXPECT_EQ(results.engine, "rockable");
  EXPECT_EQ(results.planned_runs, plan_.runs.size());
  const RunRecord& run = results.runs[0];
  EXPECT_EQ(run.result.duration, 1.2);
  const RigidBody body = plan_.bodies[run.block];
  const RigidState end = flight(0)(1.2);
  EXPECT_LT((run.result.final_state.position - end.position).norm(), 1e-12);
  EXPECT_NEAR(run.result.max_speed, end.velocity.norm(), 1e-12);
  EXPECT_NEAR(run.contacts.max_spin, 2.0, 1e-9);
  // Energy is kept, and path is the arc of a parabola: s = int sqrt(36 + g^2 t^2) dt.
  EXPECT_NEAR(run.result.energy.initial, run.result.energy.final, 1e-6);
  EXPECT_NEAR(run.result.energy.initial,
              0.5 * body.mass * 36.0 + rotational_energy(body, run.start) +
                  body.mass * kTestGravity * run.start.position.z(),
              1e-9 * run.result.energy.initial);
  const double v = kTestGravity * 1.2, a = 6.0;
  const double arc = 0.5 * (1.2 * std::hypot(a, v) + a * a / kTestGravity * std::asinh(v / a));
  EXPECT_NEAR(run.result.path_length, arc, 1e-3);
}

TEST_F(EngineResultsOf, CrossingsHaveTimesSpeedsAndEnergiesOfTheFlight) {
  // Lifted by 30 m, so that it flies over the barrier at x = 0 after 2 s.
  const Motion high = [&](double t) {
    RigidState state = flight(1)(t);
    state.position.z() += t > 0.0 ? 30.0 : 0.0;
    return state;
  };
  write_series(1, every(0.3, 2.4), high);
  const CampaignResults results = imported();
  ASSERT_EQ(results.crossings.size(), 1u);
  const Crossing& crossing = results.crossings[0];
  const RigidBody body = plan_.bodies[plan_.runs[1].block];
  EXPECT_EQ(crossing.run, 1u);
  EXPECT_NEAR(crossing.time, 2.0, 1e-9);
  EXPECT_NEAR(crossing.position.x(), 0.0, 1e-8);
  EXPECT_LT((crossing.velocity - Vec3(6.0, 0.0, -2.0 * kTestGravity)).norm(), 1e-8);
  EXPECT_NEAR(crossing.translational_energy,
              0.5 * body.mass * (36.0 + 4.0 * kTestGravity * kTestGravity), 1e-6 * body.mass);
  EXPECT_NEAR(crossing.rotational_energy, rotational_energy(body, plan_.runs[1].start), 1e-6);
  const Trajectory trajectory = read_trajectory(target(), 1);
  EXPECT_EQ(trajectory.time, every(0.3, 2.4));
  EXPECT_EQ(trajectory.states.back().position, high(2.4).position);
}

TEST_F(EngineResultsOf, EachEndHasItsReason) {
  ASSERT_GE(plan_.runs.size(), 6u);
  for (const std::string& folder : folders_) fs::remove(scenes() / folder / "dataExtractors.txt");
  write_series(0, every(0.1, 2.0), stop_after(0, 0.8));  // at rest for longer than 0.5 s
  write_series(1, every(0.1, 6.0), [&](double t) {       // creeps until tmax
    RigidState state = stop_after(1, 0.8)(t);
    if (t > 0.8) state.velocity = Vec3(0.1, 0.0, 0.0);
    return state;
  });
  write_series(2, every(0.1, 1.0), flight(2));      // was stopped
  write_series(3, every(1.0, 8.0), [&](double t) {  // off the ground, x < -20 or y < -20
    RigidState state = flight(3)(0.0);
    state.position.y() -= 5.0 * t;
    return state;
  });
  write_series(4, every(0.1, 0.5), [&](double t) {  // flew apart
    RigidState state = flight(4)(t);
    if (t > 0.25) state.position.x() = std::nan("");
    return state;
  });
  write_series(5, every(0.1, 0.8), flight(5));  // ended by the tracker, after its last conf file
  write_text_file(scenes() / folders_[5] / "dataExtractors.txt",
                  "TrackRockfall 2 0.02 0.05 track.txt 200\n");
  const RigidState place = stop_after(5, 0.8)(0.85);
  write_text_file(scenes() / folders_[5] / "track.txt",
                  "0 1 2 3 4 5 6 1 0 0 0 0 0 0 0 0 0 0 0 0\n0.85 " + words(place.position) +
                      "0.01 0 0 1 0 0 0 0.01 0 0 0 0 0 0 0 0\n0.9 1 2\n");
  const CampaignResults results = imported();
  ASSERT_EQ(results.runs.size(), 6u);
  const auto& runs = results.runs;
  EXPECT_EQ(runs[0].result.stop_reason, StopReason::kRest);
  EXPECT_EQ(runs[1].result.stop_reason, StopReason::kMaxTime);
  EXPECT_EQ(runs[2].result.stop_reason, StopReason::kError);
  EXPECT_TRUE(contains(runs[2].result.message, "was stopped"));
  EXPECT_EQ(runs[3].result.stop_reason, StopReason::kLeftTerrain);
  EXPECT_EQ(runs[3].result.duration, 5.0);  // from y = 3 at 5 m/s past -20
  EXPECT_EQ(runs[4].result.stop_reason, StopReason::kError);
  EXPECT_TRUE(contains(runs[4].result.message, "not a number from t = 0.3"));
  EXPECT_NEAR(runs[4].result.duration, 0.2, 1e-12);
  EXPECT_EQ(runs[5].result.stop_reason, StopReason::kRest);
  EXPECT_EQ(runs[5].result.duration, 0.85);
  EXPECT_EQ(runs[5].result.final_state.position, place.position);
}

TEST_F(EngineResultsOf, WhatTakesContactsIsEmptyAndNotZero) {
  for (std::size_t run = 0; run < 3; ++run) {
    write_series(run, every(0.1, 2.0), stop_after(run, 0.8));
  }
  std::vector<CampaignResults> both;
  both.push_back(imported());
  run_campaign(plan_, *folder_ / "own.h5", {.threads = 1, .replace = true});
  both.push_back(read_results(*folder_ / "own.h5"));
  const Comparison comparison =
      compare(std::move(both), {.by = {"engine"}, .measured = {}, .margin = {}});
  std::size_t empty = 0, filled = 0;
  for (const TableColumn<ComparisonRow<RunRow>>& column : run_columns()) {
    for (const char* name : {"max_penetration_m", "impacts", "contact_steps", "energy_normal_j",
                             "energy_friction_j", "energy_error", "most_contact_points"}) {
      if (column.name != name) continue;
      for (const RunRow& row : comparison.rows) {
        const TableCell cell = column.value({comparison, row});
        const double* number = std::get_if<double>(&cell);
        const bool is_empty = number && std::isnan(*number);
        EXPECT_EQ(is_empty, row.file == 0) << name;
        ++(is_empty ? empty : filled);
      }
    }
  }
  EXPECT_EQ(empty, 3u * 7u);
  EXPECT_EQ(filled, plan_.runs.size() * 7u);
  std::size_t of_engines = 0;
  for (const RunGroup& group : comparison.groups) {
    if (group.column == "engine") of_engines += group.rows.size();
  }
  EXPECT_EQ(of_engines, comparison.rows.size());
  std::size_t warned = 0;
  for (const std::string& warning : comparison.warnings) {
    EXPECT_FALSE(contains(warning, "an error of more than 1 %")) << warning;
    warned += contains(warning, "computed by Rockable");
  }
  EXPECT_EQ(warned, 1u);
  std::vector<CampaignResults> alone;
  alone.push_back(read_results(target()));
  EXPECT_TRUE(contains(clast::refusal<InputError>([&] {
                         compare(std::move(alone),
                                 {.by = {"impacts"}, .measured = {}, .margin = {}});
                       }),
                       "do not report their impacts"));
}

TEST_F(EngineResultsOf, OtherScenesAreRefused) {
  EXPECT_TRUE(contains(refused(), "no scene has conf files"));
  write_series(0, every(0.1, 2.0), stop_after(0, 0.8));
  const fs::path first = scenes() / folders_[0] / "conf0";
  const std::string good = read_text_file(first);
  write_text_file(first, replaced_once(good, "\ncube ", "\nslab "));
  EXPECT_TRUE(contains(refused(), "conf0: has a block slab"));
  RigidState moved = plan_.runs[0].start;
  moved.position.x() += 0.25;
  write_text_file(first, conf(0, 0.0, moved));
  EXPECT_TRUE(contains(refused(), "starts 0.25 m from its planned position"));
  write_text_file(first, good);
  write_text_file(scenes() / folders_[0] / "conf30", conf(0, 1.0, moved));
  EXPECT_TRUE(contains(refused(), "conf30: is at t = 1 s"));
  fs::remove(scenes() / folders_[0] / "conf30");
  imported();
  EXPECT_TRUE(contains(refused(), "rockable.h5"));
  fs::remove(target());
  write_text_file(scenes() / "campaign.toml", campaign_text());
  EXPECT_TRUE(contains(refused(), "is not the campaign of the scenes"));
  EXPECT_TRUE(contains(clast::refusal<InputError>([&] {
                         import_engine_results({.engine = "exadem", .scenes = scenes()}, target());
                       }),
                       "exadem"));
}

TEST_F(EngineResultsOf, ADamagedRunCostsNoOther) {
  write_series(0, every(0.1, 2.0), stop_after(0, 0.8));
  write_series(1, every(0.1, 2.0), stop_after(1, 0.8));
  const fs::path file = scenes() / folders_[1] / "conf7";
  const std::string whole = read_text_file(file);
  write_text_file(file, whole.substr(0, whole.find("\ncube ") + 30));
  const std::string changed = read_text_file(scenes() / folders_[0] / "conf0");
  write_text_file(scenes() / folders_[0] / "conf0",
                  replaced_once(changed, "muContact 1 0 0.4", "muContact 1 0 0.5"));
  EngineImportSummary found;
  const CampaignResults results = imported(&found);
  ASSERT_EQ(results.runs.size(), 2u);
  EXPECT_EQ(results.runs[0].result.stop_reason, StopReason::kRest);
  EXPECT_EQ(results.runs[1].result.stop_reason, StopReason::kError);
  EXPECT_TRUE(contains(results.runs[1].result.message, "conf7:"));
  ASSERT_EQ(found.notes.size(), 4u);
  EXPECT_TRUE(contains(found.notes[2], "muContact 1 0 = 0.5, but the campaign has 0.4"));
}

}  // namespace
}  // namespace clast
