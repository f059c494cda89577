#include "study/calibration/calibrate.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/file_lock.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/version.hpp"
#include "study/calibration/site_simulator.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

/// Members are kept this often at most, s: a kill costs no more.
constexpr double kKeepAfter = 20.0;

/// All that decides what is simulated. Paths may differ from machine to machine.
std::string design_digest(const CalibrationStudy& study, const std::vector<std::string>& inputs) {
  std::string text = std::string(version()) + "\n" + std::to_string(study.design.members) + " " +
                     std::to_string(study.design.releases) + " " +
                     std::to_string(study.design.seed) + "\n";
  for (const CalibrationSite& site : study.sites) text += site.name + "\n";
  for (const Unknown& unknown : study.unknowns) {
    text += unknown.parameter + " " + with_digits(unknown.low, 17) + " " +
            with_digits(unknown.high, 17) + (unknown.logarithmic ? " log\n" : "\n");
  }
  for (const std::string& input : inputs) text += input.substr(input.rfind(' ') + 1) + "\n";
  return sha256(text);
}

/// What members are to be observed at must have been looked at when they were simulated.
void check_moments(const fs::path& from, const CalibrationSimulator& simulator,
                   const StoredCalibration& stored) {
  for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
    const std::vector<Moment>& asked = simulator.sites[site].moments;
    const std::vector<Moment>& had = stored.runs.sites[site].moments;
    const bool done = std::count(stored.done[site].begin(), stored.done[site].end(), false) == 0;
    if (asked == had || (done && std::includes(had.begin(), had.end(), asked.begin(), asked.end())))
      continue;
    throw InputError(
        from.string() + ": the members of site " + simulator.sites[site].name +
        " were simulated to be observed at other impacts or times; delete the file, or "
        "give another output");
  }
}

/// The members that are there already.
StoredCalibration begun(const CalibrationStudy& study, const CalibrationSimulator& simulator,
                        const fs::path& target, const CalibrateOptions& options) {
  StoredCalibration fresh;
  fresh.inputs = simulator.inputs;
  fresh.design_sha256 = design_digest(study, simulator.inputs);
  fresh.runs.sites = simulator.sites;
  fresh.done.assign(simulator.sites.size(), std::vector<bool>(study.design.members, false));
  fresh.runs.outcomes.assign(simulator.sites.size(),
                             std::vector<std::vector<ReleaseOutcome>>(study.design.members));
  if (!options.resume) return fresh;
  const fs::path partial = partial_calibration(target);
  const fs::path from = fs::exists(partial) ? partial : target;
  if (!fs::exists(from)) return fresh;
  StoredCalibration stored = read_calibration_runs(from);
  if (stored.design_sha256 != fresh.design_sha256) {
    throw InputError(from.string() +
                     ": was begun with other sites, unknowns, members, inputs or program; delete "
                     "it, or give another output");
  }
  stored.inputs = simulator.inputs;
  check_moments(from, simulator, stored);
  for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
    stored.runs.sites[site].releases = simulator.sites[site].releases;
  }
  return stored;
}

void check_partial(const fs::path& target, const CalibrateOptions& options) {
  const fs::path partial = partial_calibration(target);
  if (options.resume || !fs::exists(partial)) return;
  throw InputError(partial.string() +
                   ": holds the members of an interrupted calibration; `resume` goes on with it, "
                   "or delete the file to start afresh");
}

/// Before many members are simulated in vain.
void check_releases(const CalibrationStudy& study, const CalibrationSimulator& simulator,
                    std::size_t site, const std::vector<ReleaseOutcome>& outcomes) {
  for (const Observation& observation : study.observations) {
    if (observation.site != site) continue;
    check_enough(observation, seen_by(observation, simulator.sites[site], outcomes));
  }
}

/// Simulates what is missing; whatever ends it, what was simulated is kept.
void simulate_missing(const CalibrationStudy& study, const CalibrationSimulator& simulator,
                      const fs::path& target, const CalibrateOptions& options,
                      StoredCalibration& stored) {
  const std::vector<std::vector<double>> places = study.design.places(study.unknowns.size());
  ProgressStep step;
  for (const std::vector<bool>& site : stored.done) {
    step.total += site.size();
    step.before += static_cast<std::size_t>(std::count(site.begin(), site.end(), true));
  }
  step.done = step.before;
  auto kept = std::chrono::steady_clock::now();
  bool changed = false;
  const auto keep = [&] {
    if (!changed) return;
    write_posterior(partial_calibration(target), study, stored, nullptr,
                    {.kind = kPosteriorFormat});
    kept = std::chrono::steady_clock::now();
    changed = false;
  };
  try {
    for (std::uint32_t member = 0; member < study.design.members; ++member) {
      for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
        if (stored.done[site][member]) continue;
        stored.runs.outcomes[site][member] =
            simulator.simulate(site, member, study.values(places[member]));
        check_releases(study, simulator, site, stored.runs.outcomes[site][member]);
        stored.done[site][member] = true;
        changed = true;
        ++step.done;
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - kept;
        if (since.count() > kKeepAfter) keep();
        if (options.progress) options.progress(step);
      }
    }
  } catch (...) {
    keep();
    throw;
  }
  keep();
}

}  // namespace

fs::path partial_calibration(const fs::path& target) {
  fs::path partial = target;
  partial += ".part";
  return partial;
}

Calibration calibrate_with(const CalibrationSimulator& simulator, const CalibrationStudy& study,
                           const fs::path& target, const CalibrateOptions& options) {
  for (const Observation& observation : study.observations) {
    seen_by(observation, simulator.sites[observation.site], {});  // refuses blocks that it lacks
  }
  const OutputRules rules = check_output(
      target, {.kind = kPosteriorFormat, .replace = options.replace || options.resume});
  const FileLock lock(target, {.longest_wait = std::chrono::milliseconds(0)});
  check_partial(target, options);
  Calibration calibration{study, begun(study, simulator, target, options), {}, target};
  simulate_missing(study, simulator, target, options, calibration.stored);
  calibration.posterior =
      infer_posterior(study, calibration.stored.runs, thread_count(options.threads));
  write_posterior(target, study, calibration.stored, &calibration.posterior, rules);
  std::error_code ignored;
  fs::remove(partial_calibration(target), ignored);
  return calibration;
}

Calibration calibrate(const CalibrationStudy& study, const fs::path& target,
                      const CalibrateOptions& options) {
  // Before anything is loaded.
  check_output(target, {.kind = kPosteriorFormat, .replace = options.replace || options.resume});
  check_partial(target, options);
  std::vector<SiteSimulator> sites;
  CalibrationSimulator simulator;
  for (std::size_t i = 0; i < study.sites.size(); ++i) {
    sites.emplace_back(study.sites[i], study.unknowns, study.design,
                       observed_moments(study.observations, i));
    simulator.sites.push_back(sites.back().facts());
    const std::vector<std::string>& inputs = sites.back().inputs();
    simulator.inputs.insert(simulator.inputs.end(), inputs.begin(), inputs.end());
  }
  const unsigned threads = thread_count(options.threads);
  simulator.simulate = [&](std::size_t site, std::uint32_t member,
                           const std::vector<double>& values) {
    return sites[site].simulate(member, values, threads);
  };
  return calibrate_with(simulator, study, target, options);
}

}  // namespace clast
