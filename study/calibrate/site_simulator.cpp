#include "study/calibrate/site_simulator.hpp"

#include <algorithm>
#include <utility>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "study/calibrate/observation_reading.hpp"
#include "study/campaign/named_seed.hpp"
#include "study/simulate/campaign_checks.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/ground_sets.hpp"
#include "study/simulate/realisation.hpp"
#include "study/simulate/run_plan.hpp"
#include "study/simulate/run_stiffness.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// The middle of the ranges, for what must be decided before any member.
Campaign with_middles(Campaign campaign, const std::vector<UnknownParameter>& unknowns) {
  for (const UnknownParameter& unknown : unknowns) {
    if (has_parameter(campaign, unknown.parameter)) {
      set_parameter(campaign, unknown.parameter, unknown.prior_quantile(0.5));
    }
  }
  return campaign;
}

/// True if the campaign has an unknown of this kind.
bool has_any(const Campaign& campaign, const std::vector<UnknownParameter>& unknowns,
             bool (*kind)(const std::string&)) {
  return std::any_of(unknowns.begin(), unknowns.end(), [&](const UnknownParameter& unknown) {
    return kind(unknown.parameter) && has_parameter(campaign, unknown.parameter);
  });
}

/// Sees what a run does at the moments that are observed.
class MomentObserver {
 public:
  MomentObserver(const std::vector<ObservedMoment>& moments, const RigidBody& body,
                 const MapFrame& frame, double gravity)
      : moments_(moments), body_(body), frame_(frame), gravity_(gravity), impacts_(body, 0) {
    outcomes_.resize(moments.size());
  }

  void observe_step(const MotionStep& step) {
    impacts_.observe_step(step);
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      const double time = moments_[i].value;
      if (moments_[i].kind != ObservedMoment::Kind::kTime || outcomes_[i].passed()) continue;
      if (time <= step.end_time) outcomes_[i] = at(interpolate_state(body_, step, time, gravity_));
    }
  }

  /// @param end  of the run
  std::vector<OutcomeAtMoment> outcomes(const RigidState& end) {
    impacts_.finish();
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      if (moments_[i].kind == ObservedMoment::Kind::kTime) {
        if (!outcomes_[i].passed()) outcomes_[i] = at(end);
        continue;
      }
      const auto number = static_cast<std::size_t>(moments_[i].value);
      if (number > impacts_.impacts.size()) continue;
      outcomes_[i] = at(impacts_.last_contact_states[number - 1]);
      outcomes_[i].depth = impacts_.impacts[number - 1].depth;
    }
    return outcomes_;
  }

 private:
  OutcomeAtMoment at(const RigidState& state) const {
    OutcomeAtMoment outcome;
    outcome.speed = state.velocity.norm();
    outcome.spin = state.angular_velocity.norm();
    outcome.energy = translational_energy(body_, state) + rotational_energy(body_, state);
    outcome.position = frame_.to_map(state.position).head<2>();
    return outcome;
  }

  const std::vector<ObservedMoment>& moments_;
  const RigidBody& body_;
  const MapFrame& frame_;
  double gravity_;
  ImpactObserver impacts_;
  std::vector<OutcomeAtMoment> outcomes_;
};

ReleaseOutcome make_release_outcome(const StoredRun& run, const CampaignPlan& prepared) {
  const MapFrame& frame = prepared.header.frame;
  ReleaseOutcome outcome;
  outcome.block = run.record.block;
  outcome.point = run.record.point;
  outcome.release = prepared.header.set_of_point[run.record.point];
  outcome.start = frame.to_map(run.record.start.position).head<2>();
  outcome.stop = frame.to_map(run.record.result.final_state.position).head<2>();
  outcome.barriers.resize(prepared.header.barriers.size());
  for (const Crossing& crossing : run.crossings) {
    OutcomeAtMoment& at = outcome.barriers[crossing.barrier];
    const bool counts =
        prepared.header.barriers[crossing.barrier].counted != CountedDirection::kForward ||
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

struct SiteMemberSimulator::Impl {
  explicit Impl(CampaignPlan plan) : prepared(std::move(plan)) {}

  std::string name;
  std::vector<UnknownParameter> unknowns;
  CalibrationDesign design;
  bool starts_vary = false;
  /// Blocks are drawn for each member; outcomes name those that they are drawn from.
  bool blocks_vary = false;
  CampaignPlan prepared;
  std::vector<RunRecord> planned;  ///< all runs of the campaign, at the middle of the ranges
  SiteDescription facts;
  std::vector<std::string> inputs;

  /// Chooses one planned run at random from each of `releases` equal parts.
  std::vector<RunRecord> chosen_runs(std::uint32_t member) {
    Random random(derive_seed(design.seed, name + " member " + std::to_string(member)));
    std::vector<std::uint32_t> numbers;
    const double each = static_cast<double>(planned.size()) / design.releases_per_member;
    for (std::uint32_t i = 0; i < design.releases_per_member; ++i) {
      const auto number = static_cast<std::size_t>((i + random.uniform()) * each);
      numbers.push_back(static_cast<std::uint32_t>(std::min(number, planned.size() - 1)));
    }
    if (starts_vary || blocks_vary) return plan_selected_runs(prepared, numbers);
    std::vector<RunRecord> runs;
    for (const std::uint32_t number : numbers) runs.push_back(planned[number]);
    return runs;
  }

  /// Draws other blocks for each member, so that sampling of blocks contributes to the scatter.
  void draw_blocks_of(std::uint32_t member) {
    const std::uint64_t seed = std::exchange(
        prepared.campaign.blocks.draw->seed,
        derive_seed(prepared.campaign.blocks.draw->seed, "member " + std::to_string(member)));
    resample_blocks(prepared);
    prepared.campaign.blocks.draw->seed = seed;
  }

  /// The largest blocks that members may have must not be of unusual size.
  void check_largest_blocks() {
    const Campaign middle = prepared.campaign;
    for (const UnknownParameter& unknown : unknowns) {
      if (!is_block_parameter(unknown.parameter) ||
          !class_of_fraction_parameter(unknown.parameter).empty())
        continue;
      if (has_parameter(middle, unknown.parameter)) {
        set_parameter(prepared.campaign, unknown.parameter, unknown.high);
      }
    }
    draw_blocks_of(0);
    try {
      check_block_sizes(prepared);
    } catch (const InputError& error) {
      throw InputError(
          std::string(error.what()) +
          "; the blocks are drawn with masses at the upper ends of the ranges in [[unknown]]");
    }
    prepared.campaign = middle;
  }

  void name_blocks() {
    if (blocks_vary) {
      for (const Block& block : prepared.choice.library) {
        facts.blocks.push_back(block.id);
        facts.shapes.push_back(garcia_class(block.axes()));
      }
      return;
    }
    for (const BlockSummary& block : prepared.header.blocks) {
      facts.blocks.push_back(block.id);
      facts.shapes.push_back(block.garcia);
    }
  }
};

SiteMemberSimulator::SiteMemberSimulator(const CalibrationSite& site,
                                         const std::vector<UnknownParameter>& unknowns,
                                         const CalibrationDesign& design,
                                         const std::vector<ObservedMoment>& moments)
    : impl_(std::make_unique<Impl>(prepare_campaign(with_middles(site.campaign, unknowns)))) {
  Impl& own = *impl_;
  own.name = site.name;
  own.design = design;
  own.unknowns = unknowns;
  own.starts_vary = has_any(site.campaign, unknowns, is_release_parameter);
  own.blocks_vary = has_any(site.campaign, unknowns, is_block_parameter);
  own.planned = own.prepared.runs;
  if (own.planned.size() < design.releases_per_member) {
    throw InputError(site.campaign.file.string() + ": plans " + std::to_string(own.planned.size()) +
                     " runs, fewer than the " + std::to_string(design.releases_per_member) +
                     " releases of each member; add orientations or points, or lower releases");
  }
  own.facts = read_site_path(site);
  own.facts.moments = moments;
  if (own.blocks_vary) {
    own.prepared.choice.library = read_selected_blocks(own.prepared.campaign);
    own.check_largest_blocks();
  }
  own.name_blocks();
  own.inputs = own.prepared.header.inputs;
  own.inputs.insert(own.inputs.begin(), site.campaign.file.string() + " " + site.campaign.sha256);
}

SiteMemberSimulator::~SiteMemberSimulator() = default;
SiteMemberSimulator::SiteMemberSimulator(SiteMemberSimulator&&) noexcept = default;

const SiteDescription& SiteMemberSimulator::description() const { return impl_->facts; }
const std::vector<std::string>& SiteMemberSimulator::inputs() const { return impl_->inputs; }

std::vector<ReleaseOutcome> SiteMemberSimulator::simulate(std::uint32_t member,
                                                          const std::vector<double>& values,
                                                          unsigned threads) {
  Impl& own = *impl_;
  CampaignPlan& prepared = own.prepared;
  const std::string who = "site " + own.name + ", member " + std::to_string(member + 1) + ": ";
  try {
    for (std::size_t i = 0; i < own.unknowns.size(); ++i) {
      if (has_parameter(prepared.campaign, own.unknowns[i].parameter)) {
        set_parameter(prepared.campaign, own.unknowns[i].parameter, values[i]);
      }
    }
    prepared.header.ground_sets = sample_ground_sets(prepared.campaign, prepared.header.zone_names);
    if (own.blocks_vary) own.draw_blocks_of(member);
    prepared.runs = own.chosen_runs(member);
    choose_run_stiffness(prepared);
  } catch (const Error& error) {
    throw SimulationError(who + error.what());
  }
  std::vector<ReleaseOutcome> outcomes(prepared.runs.size());
  std::vector<std::string> failures(prepared.runs.size());
  parallel_for(prepared.runs.size(), threads, [&](std::size_t i) {
    const RigidBody body = prepared.bodies[prepared.runs[i].block];
    MomentObserver moments(own.facts.moments, body, prepared.header.frame,
                           prepared.campaign.gravity);
    MotionObserver observe;
    if (!own.facts.moments.empty())
      observe = [&](const MotionStep& step) { moments.observe_step(step); };
    const StoredRun run =
        simulate_realisation(prepared, static_cast<std::uint32_t>(i), {}, 1, observe).front();
    outcomes[i] = make_release_outcome(run, prepared);
    if (own.blocks_vary) {
      outcomes[i].block =
          static_cast<std::uint32_t>(prepared.choice.blocks[outcomes[i].block].library);
    }
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
  constexpr double kMaxFailed = 0.1;
  const double failed = static_cast<double>(outcomes.size() - good.size());
  if (failed > kMaxFailed * static_cast<double>(outcomes.size())) {
    throw SimulationError(who + std::to_string(outcomes.size() - good.size()) + " of " +
                          std::to_string(outcomes.size()) + " runs failed, last error: " + failure);
  }
  return good;
}

}  // namespace clast
