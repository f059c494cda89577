#include "study/calibrate/calibrate.hpp"

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/file_lock.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/version.hpp"
#include "dem/simulation/physics_digest.hpp"
#include "study/calibrate/member_runs.hpp"
#include "study/calibrate/site_simulator.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

/// All that decides what is simulated. Paths may differ from machine to machine.
std::string design_digest(const CalibrationStudy& study, const std::vector<std::string>& inputs) {
  std::string text = std::string(version()) + "\n" + std::to_string(study.design.member_count) +
                     " " + std::to_string(study.design.releases_per_member) + " " +
                     std::to_string(study.design.seed) + "\n";
  for (const CalibrationSite& site : study.sites) text += site.name + "\n";
  for (const UnknownParameter& unknown : study.unknowns) {
    text += unknown.parameter + " " + format_significant(unknown.low, 17) + " " +
            format_significant(unknown.high, 17) + (unknown.logarithmic ? " log\n" : "\n");
  }
  for (const std::string& input : inputs) text += input.substr(input.rfind(' ') + 1) + "\n";
  return sha256(text);
}

/// Checks that all moments of observations were recorded when members were simulated.
void check_moments(const fs::path& from, const CalibrationBackend& simulator,
                   const StoredCalibration& stored) {
  for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
    const std::vector<ObservedMoment>& asked = simulator.sites[site].moments;
    const std::vector<ObservedMoment>& had = stored.runs.sites[site].moments;
    const bool done = std::count(stored.done[site].begin(), stored.done[site].end(), false) == 0;
    if (asked == had || (done && std::includes(had.begin(), had.end(), asked.begin(), asked.end())))
      continue;
    throw InputError(from.string() + ": the members of site " + simulator.sites[site].name +
                     " were simulated for observations at other impacts or times; delete the file, "
                     "or give another output");
  }
}

/// @param next  what to do about it
void check_design(const fs::path& from, const StoredCalibration& stored,
                  const StoredCalibration& asked, const std::string& next) {
  if (stored.design_sha256 != asked.design_sha256) {
    throw InputError(from.string() +
                     ": was started with different sites, unknowns, members, inputs or program; " +
                     next);
  }
  const std::string physics =
      describe_physics_difference(stored.physics_digest, asked.physics_digest);
  if (physics.empty()) return;
  throw InputError(from.string() + ": " + physics +
                   " than in the one that simulated its members, " +
                   "which has the same version number; " + next);
}

/// Takes over the members of the parts, which are of the same design and have all together.
StoredCalibration joined(const CalibrationStudy& study, const CalibrationBackend& simulator,
                         const CalibrationOptions& options, StoredCalibration all) {
  bool known = true;
  for (const fs::path& part : options.parts) {
    StoredCalibration stored = read_calibration_runs(part);
    check_design(part, stored, all, "simulate that shard of this study");
    check_moments(part, simulator, stored);
    known = known && !stored.physics_digest.empty();
    for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
      for (std::uint32_t member = 0; member < study.design.member_count; ++member) {
        if (!stored.done[site][member]) continue;
        all.done[site][member] = true;
        all.runs.outcomes[site][member] = std::move(stored.runs.outcomes[site][member]);
      }
    }
  }
  if (!known) all.physics_digest.clear();
  for (const std::vector<bool>& site : all.done) {
    const auto missing = std::find(site.begin(), site.end(), false);
    if (missing == site.end()) continue;
    throw InputError("member " + std::to_string(missing - site.begin() + 1) + " of " +
                     std::to_string(study.design.member_count) +
                     " is in none of the parts; give the finished files of all shards");
  }
  return all;
}

StoredCalibration without_members(const CalibrationStudy& study,
                                  const CalibrationBackend& simulator) {
  StoredCalibration fresh;
  fresh.inputs = simulator.inputs;
  fresh.design_sha256 = design_digest(study, simulator.inputs);
  fresh.physics_digest = simulator.physics_digest;
  fresh.runs.sites = simulator.sites;
  fresh.done.assign(simulator.sites.size(), std::vector<bool>(study.design.member_count, false));
  fresh.runs.outcomes.assign(simulator.sites.size(),
                             std::vector<std::vector<ReleaseOutcome>>(study.design.member_count));
  return fresh;
}

/// The members that are there already.
StoredCalibration begun(const CalibrationStudy& study, const CalibrationBackend& simulator,
                        const fs::path& target, const CalibrationOptions& options) {
  StoredCalibration fresh = without_members(study, simulator);
  if (!options.parts.empty()) return joined(study, simulator, options, std::move(fresh));
  if (!options.resume) return fresh;
  const fs::path partial = calibration_journal_path(target);
  const fs::path from = fs::exists(partial) ? partial : target;
  if (!fs::exists(from)) return fresh;
  StoredCalibration stored = read_calibration_runs(from);
  check_design(from, stored, fresh, "delete it, or give another output");
  stored.inputs = simulator.inputs;
  check_moments(from, simulator, stored);
  for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
    stored.runs.sites[site].releases = simulator.sites[site].releases;
  }
  return stored;
}

void check_partial(const fs::path& target, const CalibrationOptions& options) {
  const fs::path partial = calibration_journal_path(target);
  if (options.resume || !fs::exists(partial)) return;
  throw InputError(partial.string() +
                   ": holds the members of an interrupted calibration; `resume` continues it, or "
                   "delete the file to start again");
}

OverwritePolicy rules_of(const CalibrationOptions& options) {
  return {.kind = kPosteriorFormat, .replace = options.replace || options.resume};
}

void check_target(const fs::path& target, const CalibrationOptions& options) {
  check_output_target(target, rules_of(options));
  check_partial(target, options);
}

}  // namespace

fs::path calibration_journal_path(const fs::path& target) {
  fs::path partial = target;
  partial += ".part";
  return partial;
}

Calibration run_calibration_with(const CalibrationBackend& simulator, const CalibrationStudy& study,
                                 const fs::path& target, const CalibrationOptions& options) {
  std::optional<FileLock> lock;
  Calibration calibration{study, {}, {}, target};
  const auto begin = [&] {
    for (const Observation& observation : study.observations) {
      select_outcomes(observation, simulator.sites[observation.site],
                      {});  // refuses blocks that it lacks
    }
    check_target(target, options);
    lock.emplace(target, FileLockOptions{.timeout = std::chrono::milliseconds(0)});
    check_partial(target, options);
    calibration.stored = begun(study, simulator, target, options);
    return std::string();
  };
  options.team ? options.team->check_agreement(begin) : void(begin());
  simulate_missing_members(study, simulator, target, options, calibration.stored);
  const bool whole = options.shard.count == 1;
  if (whole) {
    calibration.posterior =
        infer_posterior(study, calibration.stored.runs, resolve_thread_count(options.threads));
  }
  write_posterior(target, study, calibration.stored, whole ? &calibration.posterior : nullptr,
                  rules_of(options));
  std::error_code ignored;
  fs::remove(calibration_journal_path(target), ignored);
  return calibration;
}

namespace {

/// The sites of a study, ready to simulate.
struct PreparedSites {
  std::vector<SiteMemberSimulator> sites;
  CalibrationBackend simulator;

  PreparedSites(const CalibrationStudy& study, const CalibrationOptions& options) {
    for (std::size_t i = 0; i < study.sites.size(); ++i) {
      sites.emplace_back(study.sites[i], study.unknowns, study.design,
                         observed_moments(study.observations, i));
      simulator.sites.push_back(sites.back().description());
      const std::vector<std::string>& inputs = sites.back().inputs();
      simulator.inputs.insert(simulator.inputs.end(), inputs.begin(), inputs.end());
    }
    // Processes are started one by one, so each uses one core unless another number is given.
    const bool alone = !options.team || options.team->size() == 1;
    const unsigned threads =
        options.threads == 0 && !alone ? 1 : resolve_thread_count(options.threads);
    simulator.physics_digest = physics_digest();
    simulator.simulate = [this, threads](std::size_t site, std::uint32_t member,
                                         const std::vector<double>& values) {
      return sites[site].simulate(member, values, threads);
    };
  }
  PreparedSites(const PreparedSites&) = delete;
  PreparedSites& operator=(const PreparedSites&) = delete;
};

}  // namespace

Calibration run_calibration(const CalibrationStudy& study, const fs::path& target,
                            const CalibrationOptions& options) {
  options.shard.check();
  std::optional<PreparedSites> prepared;
  const auto prepare = [&] {
    check_target(target, options);  // before anything is loaded
    prepared.emplace(study, options);
    return design_digest(study, prepared->simulator.inputs) + physics_digest();
  };
  options.team ? options.team->check_agreement(prepare) : void(prepare());
  return run_calibration_with(prepared->simulator, study, target, options);
}

void simulate_members_for_leader(const CalibrationStudy& study, const CalibrationOptions& options) {
  std::optional<PreparedSites> prepared;
  options.team->check_agreement([&] {
    prepared.emplace(study, options);
    return design_digest(study, prepared->simulator.inputs) + physics_digest();
  });
  options.team->check_agreement([] { return std::string(); });
  simulate_received_members(study, prepared->simulator, *options.team);
}

}  // namespace clast
