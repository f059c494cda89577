#include "study/engines/engine_results.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "study/engines/detail/rockable_conf.hpp"
#include "study/engines/detail/run_of_states.hpp"
#include "study/engines/detail/scene.hpp"
#include "study/engines/engine_scene.hpp"
#include "study/results/results_file.hpp"
#include "study/simulate/results_place.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

/// Starts are written with all digits.
constexpr double kMaxSameStartDistance = 1e-6;  ///< m
/// Conf files repeat parameters and tracks repeat times with six digits.
constexpr double kSixDigits = 2e-5;

/// Data on the campaign in SCENE.txt.
struct SceneCampaign {
  fs::path file;
  std::string sha256;
  std::vector<std::string> inputs;  ///< their SHA-256
};

std::string last_word(const std::string& line) { return line.substr(line.rfind(' ') + 1); }

SceneCampaign read_scene_campaign(const EngineResultsOptions& options) {
  const fs::path file = options.scenes / kSceneDescriptionFile;
  const std::string mark = std::string(kSceneDescriptionMark) + " for ";
  std::istringstream lines(read_text_file(file));
  std::string line;
  std::getline(lines, line);
  if (!line.starts_with(mark + options.engine + ",")) {
    throw InputError(file.string() + ": does not describe scenes for " + options.engine +
                     ", which clast export writes");
  }
  SceneCampaign campaign;
  const auto rest_after = [&](const std::string& key) { return line.substr(key.size()); };
  while (std::getline(lines, line) && !line.starts_with("shapes,")) {
    if (line.starts_with("campaign ")) campaign.file = rest_after("campaign ");
    if (line.starts_with("sha256 ")) campaign.sha256 = rest_after("sha256 ");
    if (line.starts_with("input ")) campaign.inputs.push_back(last_word(line));
  }
  return campaign;
}

/// The campaign of the scenes, with the inputs that it had.
CampaignPlan prepare(const EngineResultsOptions& options) {
  const SceneCampaign scene = read_scene_campaign(options);
  const fs::path kept = options.scenes / kSceneCampaignFile;
  const fs::path text_file = options.campaign.value_or(kept);
  const std::string text = read_text_file(text_file);
  if (sha256(text) != scene.sha256) {
    throw InputError(text_file.string() +
                     ": is not the campaign of the scenes, or was changed since");
  }
  const fs::path file = options.campaign.value_or(scene.file);
  if (!options.campaign && !fs::is_directory(fs::absolute(file).parent_path())) {
    throw InputError(file.string() +
                     ": the campaign of the scenes was in this folder, which does not exist; name "
                     "the file with `campaign`");
  }
  CampaignPlan prepared = prepare_campaign(parse_campaign(text, file));
  std::vector<std::string> inputs;
  for (const std::string& input : prepared.header.inputs) inputs.push_back(last_word(input));
  if (inputs != scene.inputs) {
    throw InputError(file.string() +
                     ": its library, terrain or release files are not those of the scenes; export "
                     "the scenes again, and run them");
  }
  return prepared;
}

/// Reads the runs of scenes one by one, and keeps what is to be said of them.
class RockableReader {
 public:
  RockableReader(const CampaignPlan& prepared, fs::path folder)
      : prepared_(prepared), folder_(std::move(folder)), set_(collect_scene_contents(prepared)) {
    for (const SceneZone& zone : set_.zones) driven_ += zone.surface.triangles.empty() ? 0 : 1;
  }

  /// Reads the scene that begins with this run; empty if it was not run.
  std::vector<StoredRun> read(std::uint32_t first) {
    const Scene scene = build_scene(prepared_, set_, first);
    const std::vector<fs::path> files = list_rockable_states(folder_ / scene.name);
    if (files.empty()) return {};
    std::vector<RockableConf> confs;
    try {
      for (const fs::path& file : files) confs.push_back(read_rockable_conf(file));
    } catch (const InputError& error) {  // one bad run never costs the others
      return failed(first, scene.bodies.size(), error.what());
    }
    check_scene(scene, confs.front(), files.front());
    check_times(confs, files);
    note_parameters(scene, confs.front());
    const std::optional<TrackedState> end = tracked_end(scene, confs.back(), files.back());
    std::vector<StoredRun> runs;
    for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
      runs.push_back(run_of(first + i, i, scene, confs, end));
    }
    return runs;
  }

  std::string changed;  ///< a parameter that is not the campaign's any more; empty: none

 private:
  std::vector<StoredRun> failed(std::uint32_t first, std::size_t count, const std::string& why) {
    std::vector<StoredRun> runs;
    for (std::uint32_t run = first; run < first + count; ++run) {
      const RunRecord& planned = prepared_.runs[run];
      runs.push_back(make_run_from_states(prepared_, planned, {{0.0}, {planned.start}},
                                          {StopReason::kError, why}));
      add_stay(runs.back());
    }
    return runs;
  }

  void check_scene(const Scene& scene, const RockableConf& conf, const fs::path& file) const {
    const auto refuse = [&](const std::string& what) {
      throw InputError(file.string() + ": " + what +
                       "; it belongs to another scene than clast export wrote for the campaign");
    };
    if (conf.fixed_body_count != driven_ || conf.bodies.size() != driven_ + scene.bodies.size()) {
      refuse(
          "has " + std::to_string(conf.fixed_body_count) + " grounds and " +
          std::to_string(conf.bodies.size() - std::min(conf.fixed_body_count, conf.bodies.size())) +
          " blocks, not " + std::to_string(driven_) + " and " +
          std::to_string(scene.bodies.size()));
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const RockableBody& body = conf.bodies[driven_ + i];
      const SceneBody& planned = scene.bodies[i];
      const std::string& name = set_.shapes[planned.shape].shape.name;
      if (body.shape != name || !(std::abs(body.scale / planned.scale - 1.0) < kSixDigits)) {
        refuse("has a block " + body.shape + " of scale " + format_significant(body.scale, 6) +
               ", not " + name + " of " + format_significant(planned.scale, 6));
      }
      const double away = (body.state.position - planned.start.position).norm();
      if (conf.time == 0.0 && !(away < kMaxSameStartDistance)) {
        refuse("block " + name + " starts " + format_significant(away, 4) +
               " m from its planned position");
      }
    }
  }

  static void check_times(const std::vector<RockableConf>& confs,
                          const std::vector<fs::path>& files) {
    for (std::size_t i = 1; i < confs.size(); ++i) {
      if (confs[i].time > confs[i - 1].time) continue;
      throw InputError(files[i].string() + ": is at t = " + format_significant(confs[i].time, 6) +
                       " s, but the file before it is at " +
                       format_significant(confs[i - 1].time, 6) +
                       " s; the folder has files of two runs, so delete those of the older");
    }
  }

  void note_parameters(const Scene& scene, const RockableConf& conf) {
    for (const SceneContact& contact : scene.contacts) {
      const std::string pair =
          " " + std::to_string(contact.first) + " " + std::to_string(contact.second);
      const std::pair<const char*, double> values[] = {
          {"knContact", contact.normal},
          {"ktContact", contact.tangential},
          {"krContact", contact.rolling},
          {"en2Contact", contact.parameters.energy_restitution},
          {"muContact", contact.parameters.friction},
          {"murContact", contact.parameters.rolling_friction}};
      for (const auto& [name, planned] : values) {
        const auto found = conf.pair.find(name + pair);
        if (!changed.empty() || found == conf.pair.end() ||
            std::abs(found->second - planned) <= kSixDigits * std::abs(planned)) {
          continue;
        }
        changed = scene.name + " was run with " + name + pair + " = " +
                  format_significant(found->second, 6) + ", but the campaign has " +
                  format_significant(planned, 6);
      }
    }
  }

  /// The state in which a tracker ended the run, after the last conf file.
  std::optional<TrackedState> tracked_end(const Scene& scene, const RockableConf& last,
                                          const fs::path& file) {
    tracker_ = read_rockfall_tracker(folder_ / scene.name);
    if (!tracker_ || scene.bodies.size() != 1 || tracker_->body != driven_) {
      tracker_.reset();
      return std::nullopt;
    }
    const fs::path track = folder_ / scene.name / tracker_->file;
    const std::optional<TrackedState> end = read_last_tracked_state(track);
    const double interval = last.time_step * kStepsPerTrackLine;
    if (end && end->time + interval < (1.0 - kSixDigits) * last.time) {
      throw InputError(file.string() + ": is at t = " + format_significant(last.time, 6) +
                       " s, and " + track.string() + " ends at " +
                       format_significant(end->time, 6) +
                       " s; the folder has files of two runs, so delete those of the older");
    }
    return end;
  }

  StoredRun run_of(std::uint32_t number, std::size_t body, const Scene& scene,
                   const std::vector<RockableConf>& confs, const std::optional<TrackedState>& end) {
    RunRecord planned = prepared_.runs[number];
    planned.stiffness.time_step = confs.front().time_step;
    StateSeries series{{0.0}, {scene.bodies[body].start}};
    std::optional<double> lost;  // when its state was no number any more
    const auto add = [&](double time, const RigidState& state) {
      if (lost || time <= series.time.back()) return;
      if (!state.position.allFinite() || !state.velocity.allFinite() ||
          !state.angular_velocity.allFinite() || !state.orientation.coeffs().allFinite()) {
        lost = time;
        return;
      }
      series.time.push_back(time);
      series.states.push_back(state);
    };
    for (const RockableConf& conf : confs) add(conf.time, conf.bodies[driven_ + body].state);
    if (end) add(end->time, end->state);
    const RunEnding how = end_of(planned, confs, series, lost);
    StoredRun run = make_run_from_states(prepared_, planned, series, how);
    add_stay(run);
    return run;
  }

  /// Returns the end of the series; cuts off states beyond the terrain.
  RunEnding end_of(const RunRecord& planned, const std::vector<RockableConf>& confs,
                   StateSeries& series, const std::optional<double>& lost) const {
    const std::size_t off = find_first_state_off_terrain(prepared_, series);
    if (off < series.states.size()) {
      series.time.resize(off + 1);
      series.states.resize(off + 1);
      return {StopReason::kLeftTerrain};
    }
    if (lost) {
      return {StopReason::kError, "the state of the block is not a number from t = " +
                                      format_significant(*lost, 6) + " s on"};
    }
    const RigidState& last = series.states.back();
    const bool tracked_rest = tracker_ && series.states.size() > 1 &&
                              last.velocity.norm() < tracker_->rest_speed &&
                              last.angular_velocity.norm() < tracker_->rest_spin;
    if (tracked_rest || is_at_rest_at_end(prepared_, planned, series)) return {StopReason::kRest};
    const RockableConf& conf = confs.back();
    const double interval =
        confs.size() > 1 ? conf.time - confs[confs.size() - 2].time : conf.max_time;
    if (series.time.back() + 1.5 * interval > conf.max_time) return {StopReason::kMaxTime};
    return {StopReason::kError,
            "the files end at t = " + format_significant(series.time.back(), 6) +
                " s, when the block moves at " + format_significant(last.velocity.norm(), 3) +
                " m/s, before tmax = " + format_significant(conf.max_time, 6) +
                " s; Rockable was stopped, or files are missing"};
  }

  void add_stay(StoredRun& run) const {
    if (!prepared_.header.persistent_blocks) return;
    PersistentBlockRecord stay;
    stay.run = run.record.run;
    run.persistent_block_records = {stay};
  }

  const CampaignPlan& prepared_;
  fs::path folder_;
  SceneContents set_;
  std::size_t driven_ = 0;  ///< zones that have ground
  std::optional<RockfallTracker> tracker_;
};

std::vector<std::string> notes_of(const RockableReader& reader, std::size_t without_output) {
  std::vector<std::string> notes = {
      "The runs were computed by Rockable. Its conf files hold states but no contacts: "
      "penetration, impacts, contact points and the kinds of dissipation are unknown.",
      "Largest speeds, spins and energies are those of the stored states, and passages between two "
      "states are interpolated unless the block flew from one to the other."};
  if (!reader.changed.empty())
    notes.push_back(reader.changed + "; the runs are those of the scene");
  if (without_output > 0) {
    notes.push_back(format_count(without_output, "scene") +
                    (without_output == 1 ? " has" : " have") +
                    " no conf files, so its runs are not in the results");
  }
  return notes;
}

}  // namespace

const std::vector<std::string>& importable_engines() {
  static const std::vector<std::string> kEngines = {"rockable"};
  return kEngines;
}

void EngineResultsOptions::check() const {
  const std::vector<std::string>& known = importable_engines();
  if (std::find(known.begin(), known.end(), engine) == known.end()) {
    throw InputError("engine \"" + engine + "\" is unknown; results can be read from " +
                     known.front());
  }
}

EngineImportSummary import_engine_results(const EngineResultsOptions& options,
                                          const fs::path& target) {
  options.check();
  check_results_target(target, options.replace);
  check_not_interrupted(target);
  CampaignPlan prepared = prepare(options);
  RockableReader reader(prepared, options.scenes);
  const std::uint32_t together = prepared.header.runs_per_realisation();
  std::vector<StoredRun> runs;
  EngineImportSummary found;
  found.planned = prepared.runs.size();
  for (std::uint32_t first = 0; first < prepared.runs.size(); first += together) {
    const std::vector<StoredRun> some = reader.read(first);
    const std::string name = scene_name(prepared, first);
    if (some.empty() && fs::is_directory(options.scenes / name)) ++found.without_output;
    runs.insert(runs.end(), some.begin(), some.end());
    if (options.progress) options.progress({.done = first + together, .total = found.planned});
  }
  if (runs.empty()) {
    throw InputError(options.scenes.string() +
                     ": no scene has conf files; run Rockable in its folders first, as in "
                     "run00000: rockable input.txt");
  }
  found.runs = runs.size();
  found.notes = notes_of(reader, found.without_output);
  CampaignHeader header = std::move(prepared.header);
  header.engine = options.engine;
  header.physics_digest.clear();
  header.warnings.insert(header.warnings.end(), found.notes.begin(), found.notes.end());
  write_results_file(target, header, runs.size(), [&](std::size_t i) { return runs[i]; });
  return found;
}

}  // namespace clast
