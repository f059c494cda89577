#include "study/calibrate/member_runs.hpp"

#include <chrono>
#include <cstring>
#include <mutex>

#include "core/error.hpp"
#include "study/simulate/team_work.hpp"

namespace clast::study_detail {
namespace {

/// Members are kept this often at most, s: a kill costs no more.
constexpr double kKeepAfter = 20.0;

// Processes hand in members whose runs failed too: then the message follows.
constexpr char kSimulated = 's', kFailed = 'f';

/// A member at a site, numbered for processes.
std::uint32_t item_of(const CalibrationBackend& simulator, std::uint32_t member, std::size_t site) {
  return member * static_cast<std::uint32_t>(simulator.sites.size()) +
         static_cast<std::uint32_t>(site);
}

/// Before many members are simulated in vain.
void check_releases(const CalibrationStudy& study, const CalibrationBackend& simulator,
                    std::size_t site, const std::vector<ReleaseOutcome>& outcomes) {
  for (const Observation& observation : study.observations) {
    if (observation.site != site) continue;
    check_outcome_count(observation, select_outcomes(observation, simulator.sites[site], outcomes));
  }
}

/// Simulates members.
class Simulation {
 public:
  Simulation(const CalibrationStudy& study, const CalibrationBackend& simulator)
      : study_(study),
        simulator_(simulator),
        places_(study.design.sobol_points(study.unknowns.size())) {}

  std::vector<ReleaseOutcome> of(std::uint32_t item) const {
    const std::size_t sites = simulator_.sites.size();
    const auto member = static_cast<std::uint32_t>(item / sites);
    const std::size_t site = item % sites;
    std::vector<ReleaseOutcome> outcomes =
        simulator_.simulate(site, member, study_.values(places_[member]));
    check_releases(study_, simulator_, site, outcomes);
    return outcomes;
  }

 private:
  const CalibrationStudy& study_;
  const CalibrationBackend& simulator_;
  std::vector<std::vector<double>> places_;
};

/// Keeps members, one at a time, and reports progress.
class Keeper {
 public:
  Keeper(const CalibrationStudy& study, const std::filesystem::path& target,
         const CalibrationOptions& options, ProgressUpdate step, StoredCalibration& stored)
      : study_(study), target_(target), options_(options), step_(step), stored_(stored) {}

  void add(std::uint32_t item, std::vector<ReleaseOutcome> outcomes) {
    const std::lock_guard lock(one_at_a_time_);
    const std::size_t sites = stored_.done.size();
    stored_.runs.outcomes[item % sites][item / sites] = std::move(outcomes);
    stored_.done[item % sites][item / sites] = true;
    changed_ = true;
    ++step_.done;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - kept_;
    if (since.count() > kKeepAfter) keep();
    if (options_.progress) options_.progress(step_);
  }

  void keep() {
    if (!changed_) return;
    write_posterior(calibration_journal_path(target_), study_, stored_, nullptr,
                    {.kind = kPosteriorFormat});
    kept_ = std::chrono::steady_clock::now();
    changed_ = false;
  }

 private:
  const CalibrationStudy& study_;
  const std::filesystem::path& target_;
  const CalibrationOptions& options_;
  ProgressUpdate step_;
  StoredCalibration& stored_;
  std::mutex one_at_a_time_;
  std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
  bool changed_ = false;
};

/// @throws SimulationError  what another process threw
std::pair<std::uint32_t, std::vector<ReleaseOutcome>> handed_in(const std::string& done) {
  std::uint32_t item = 0;
  std::memcpy(&item, done.data() + 1, sizeof item);
  const std::string rest = done.substr(1 + sizeof item);
  if (done.front() == kFailed) throw SimulationError(rest);
  return {item, deserialize_outcomes(rest)};
}

}  // namespace

void simulate_missing_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                              const std::filesystem::path& target,
                              const CalibrationOptions& options, StoredCalibration& stored) {
  const Simulation simulation(study, simulator);
  std::vector<std::uint32_t> missing;
  ProgressUpdate step;
  for (std::uint32_t member = 0; member < study.design.member_count; ++member) {
    if (!options.shard.contains(member)) continue;
    for (std::size_t site = 0; site < simulator.sites.size(); ++site) {
      ++step.total;
      if (stored.done[site][member]) {
        ++step.done_before;
      } else {
        missing.push_back(item_of(simulator, member, site));
      }
    }
  }
  step.done = step.done_before;
  Keeper keeper(study, target, options, step, stored);
  const auto here = [&](std::uint32_t item) { keeper.add(item, simulation.of(item)); };
  try {
    if (options.team && options.team->size() > 1) {
      distribute_work(*options.team, missing, 1, here, [&](const std::string& done) {
        auto [item, outcomes] = handed_in(done);
        keeper.add(item, std::move(outcomes));
      });
    } else {
      for (const std::uint32_t item : missing) here(item);
    }
  } catch (...) {
    keeper.keep();
    throw;
  }
  keeper.keep();
}

void simulate_received_members(const CalibrationStudy& study, const CalibrationBackend& simulator,
                               ProcessTeam& team) {
  const Simulation simulation(study, simulator);
  process_received_work(team, 1, [&](std::uint32_t item) {
    std::string done(1 + sizeof item, kSimulated);
    std::memcpy(done.data() + 1, &item, sizeof item);
    try {
      done += serialize_outcomes(simulation.of(item));
    } catch (const Error& error) {
      done.front() = kFailed;
      done += error.what();
    }
    return done;
  });
}

std::string serialize_outcomes(const std::vector<ReleaseOutcome>& outcomes) {
  std::vector<double> numbers;
  const auto put_all = [&](const std::vector<OutcomeAtMoment>& all) {
    numbers.push_back(static_cast<double>(all.size()));
    for (const OutcomeAtMoment& at : all) {
      numbers.insert(numbers.end(), {at.speed, at.spin, at.height, at.energy, at.depth,
                                     at.position.x(), at.position.y()});
    }
  };
  for (const ReleaseOutcome& outcome : outcomes) {
    numbers.insert(numbers.end(),
                   {static_cast<double>(outcome.block), static_cast<double>(outcome.point),
                    static_cast<double>(outcome.release), outcome.start.x(), outcome.start.y(),
                    outcome.stop.x(), outcome.stop.y()});
    put_all(outcome.barriers);
    put_all(outcome.moments);
  }
  const auto* bytes = reinterpret_cast<const char*>(numbers.data());
  return {bytes, bytes + numbers.size() * sizeof(double)};
}

std::vector<ReleaseOutcome> deserialize_outcomes(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  std::size_t next = 0;
  const auto take = [&] { return numbers[next++]; };
  const auto take_count = [&] { return static_cast<std::uint32_t>(take()); };
  const auto take_place = [&] {
    const double x = take();
    return Vec2(x, take());
  };
  const auto take_all = [&] {
    std::vector<OutcomeAtMoment> all(take_count());
    for (OutcomeAtMoment& at : all) {
      for (double* value : {&at.speed, &at.spin, &at.height, &at.energy, &at.depth}) {
        *value = take();
      }
      at.position = take_place();
    }
    return all;
  };
  std::vector<ReleaseOutcome> outcomes;
  while (next < numbers.size()) {
    ReleaseOutcome outcome;
    outcome.block = take_count();
    outcome.point = take_count();
    outcome.release = take_count();
    outcome.start = take_place();
    outcome.stop = take_place();
    outcome.barriers = take_all();
    outcome.moments = take_all();
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace clast::study_detail
