#include "study/calibration/site_simulator.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "study/calibration/observation_reading.hpp"
#include "study/campaign_runner.hpp"
#include "study/detail/ground_sets.hpp"
#include "study/detail/named_seed.hpp"
#include "study/detail/realisation.hpp"
#include "study/detail/run_plan.hpp"
#include "study/detail/run_stiffness.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// The middle of the ranges, for what must be decided before any member.
Campaign with_middles(Campaign campaign, const std::vector<Unknown>& unknowns) {
  for (const Unknown& unknown : unknowns) {
    if (has_parameter(campaign, unknown.parameter)) {
      set_parameter(campaign, unknown.parameter, unknown.value(0.5));
    }
  }
  return campaign;
}

/// Sees what a run does at the moments that are observed.
class MomentObserver {
 public:
  MomentObserver(const std::vector<Moment>& moments, const RigidBody& body, const MapFrame& frame,
                 double gravity)
      : moments_(moments), body_(body), frame_(frame), gravity_(gravity), impacts_(body, 0) {
    outcomes_.resize(moments.size());
  }

  void see(const MotionStep& step) {
    impacts_.see(step);
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      const double time = moments_[i].value;
      if (moments_[i].kind != Moment::Kind::kTime || outcomes_[i].passed()) continue;
      if (time <= step.end_time) outcomes_[i] = at(state_at(body_, step, time, gravity_));
    }
  }

  /// @param end  of the run
  std::vector<OutcomeAt> outcomes(const RigidState& end) {
    impacts_.finish();
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      if (moments_[i].kind == Moment::Kind::kTime) {
        if (!outcomes_[i].passed()) outcomes_[i] = at(end);
        continue;
      }
      const auto number = static_cast<std::size_t>(moments_[i].value);
      if (number > impacts_.impacts.size()) continue;
      outcomes_[i] = at(impacts_.last_touches[number - 1]);
      outcomes_[i].depth = impacts_.impacts[number - 1].depth;
    }
    return outcomes_;
  }

 private:
  OutcomeAt at(const RigidState& state) const {
    OutcomeAt outcome;
    outcome.speed = state.velocity.norm();
    outcome.spin = state.angular_velocity.norm();
    outcome.energy = translational_energy(body_, state) + rotational_energy(body_, state);
    outcome.place = frame_.map(state.position).head<2>();
    return outcome;
  }

  const std::vector<Moment>& moments_;
  const RigidBody& body_;
  const MapFrame& frame_;
  double gravity_;
  ImpactObserver impacts_;
  std::vector<OutcomeAt> outcomes_;
};

ReleaseOutcome outcome_of(const StoredRun& run, const PreparedCampaign& prepared) {
  const MapFrame& frame = prepared.header.frame;
  ReleaseOutcome outcome;
  outcome.block = run.record.block;
  outcome.point = run.record.point;
  outcome.release = prepared.header.set_of_point[run.record.point];
  outcome.start = frame.map(run.record.start.position).head<2>();
  outcome.stop = frame.map(run.record.result.final_state.position).head<2>();
  outcome.barriers.resize(prepared.header.barriers.size());
  for (const Crossing& crossing : run.crossings) {
    OutcomeAt& at = outcome.barriers[crossing.barrier];
    const bool counts =
        prepared.header.barriers[crossing.barrier].counted != CountedCrossings::kForward ||
        crossing.forward;
    if (at.passed() || !counts) continue;
    at.speed = crossing.velocity.norm();
    at.spin = crossing.angular_velocity.norm();
    at.height = crossing.height;
    at.energy = crossing.translational_energy + crossing.rotational_energy;
  }
  return outcome;
}

}  // namespace

struct SiteSimulator::Impl {
  explicit Impl(PreparedCampaign plan) : prepared(std::move(plan)) {}

  std::string name;
  std::vector<Unknown> unknowns;
  CalibrationDesign design;
  bool starts_vary = false;
  PreparedCampaign prepared;
  std::vector<RunRecord> planned;  ///< all runs of the campaign
  SiteFacts facts;
  std::vector<std::string> inputs;

  void plan() {
    prepared.runs.clear();
    prepared.header.release_sets.clear();
    prepared.header.set_of_point.clear();
    prepared.header.release_points.clear();
    plan_runs(prepared);
    planned = prepared.runs;
  }

  /// So many of the planned runs, one by chance out of each equal part of them.
  std::vector<RunRecord> chosen_runs(std::uint32_t member) const {
    Random random(named_seed(design.seed, name + " member " + std::to_string(member)));
    std::vector<RunRecord> runs;
    const double each = static_cast<double>(planned.size()) / design.releases;
    for (std::uint32_t i = 0; i < design.releases; ++i) {
      const auto number = static_cast<std::size_t>((i + random.uniform()) * each);
      runs.push_back(planned[std::min(number, planned.size() - 1)]);
    }
    return runs;
  }
};

SiteSimulator::SiteSimulator(const CalibrationSite& site, const std::vector<Unknown>& unknowns,
                             const CalibrationDesign& design, const std::vector<Moment>& moments)
    : impl_(std::make_unique<Impl>(prepare_campaign(with_middles(site.campaign, unknowns)))) {
  Impl& own = *impl_;
  own.name = site.name;
  own.design = design;
  for (const Unknown& unknown : unknowns) {
    own.starts_vary = own.starts_vary || is_of_release(unknown.parameter);
  }
  own.unknowns = unknowns;
  own.planned = own.prepared.runs;
  if (own.planned.size() < design.releases) {
    throw InputError(site.campaign.file.string() + ": plans " + std::to_string(own.planned.size()) +
                     " runs, fewer than the " + std::to_string(design.releases) +
                     " releases of each member; add orientations or points, or lower releases");
  }
  own.facts = path_of(site);
  own.facts.moments = moments;
  for (const BlockSummary& block : own.prepared.header.blocks) {
    own.facts.blocks.push_back(block.id);
    own.facts.shapes.push_back(block.garcia);
  }
  own.inputs = own.prepared.header.inputs;
  own.inputs.insert(own.inputs.begin(), site.campaign.file.string() + " " + site.campaign.sha256);
}

SiteSimulator::~SiteSimulator() = default;
SiteSimulator::SiteSimulator(SiteSimulator&&) noexcept = default;

const SiteFacts& SiteSimulator::facts() const { return impl_->facts; }
const std::vector<std::string>& SiteSimulator::inputs() const { return impl_->inputs; }

std::vector<ReleaseOutcome> SiteSimulator::simulate(std::uint32_t member,
                                                    const std::vector<double>& values,
                                                    unsigned threads) {
  Impl& own = *impl_;
  PreparedCampaign& prepared = own.prepared;
  const std::string who = "site " + own.name + ", member " + std::to_string(member + 1) + ": ";
  try {
    for (std::size_t i = 0; i < own.unknowns.size(); ++i) {
      if (has_parameter(prepared.campaign, own.unknowns[i].parameter)) {
        set_parameter(prepared.campaign, own.unknowns[i].parameter, values[i]);
      }
    }
    prepared.header.ground_sets = ground_sets(prepared.campaign, prepared.header.zone_names);
    if (own.starts_vary) own.plan();
    prepared.runs = own.chosen_runs(member);
    settle_stiffness(prepared);
  } catch (const Error& error) {
    throw SimulationError(who + error.what());
  }
  std::vector<ReleaseOutcome> outcomes(prepared.runs.size());
  std::vector<std::string> failures(prepared.runs.size());
  parallel_for(prepared.runs.size(), threads, [&](std::size_t i) {
    MomentObserver moments(own.facts.moments, prepared.bodies[prepared.runs[i].block],
                           prepared.header.frame, prepared.campaign.gravity);
    MotionObserver observe;
    if (!own.facts.moments.empty()) observe = [&](const MotionStep& step) { moments.see(step); };
    const StoredRun run =
        runs_from(prepared, static_cast<std::uint32_t>(i), {}, 1, observe).front();
    outcomes[i] = outcome_of(run, prepared);
    outcomes[i].moments = moments.outcomes(run.record.result.final_state);
    if (run.record.result.stop_reason == StopReason::kError) {
      failures[i] = run.record.result.message;
    }
  });
  std::vector<ReleaseOutcome> good;
  std::string failure;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    failures[i].empty() ? good.push_back(outcomes[i]) : void(failure = failures[i]);
  }
  // One run that fails costs no member; many are a fault of it.
  constexpr double kMostFailed = 0.1;
  const double failed = static_cast<double>(outcomes.size() - good.size());
  if (failed > kMostFailed * static_cast<double>(outcomes.size())) {
    throw SimulationError(who + std::to_string(outcomes.size() - good.size()) + " of " +
                          std::to_string(outcomes.size()) + " runs failed, the last: " + failure);
  }
  return good;
}

}  // namespace clast
