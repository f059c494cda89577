#include "study/simulate/run_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "study/simulate/detail/member_settings.hpp"

namespace clast::study_detail {
namespace {

/// Maximum number of blocks named in warnings; drawn blocks can be thousands.
constexpr std::size_t kMaxNamed = 20;

/// All energy of a start, and the fall to the lowest ground, in the speed.
double fastest_speed(const RunRecord& run, const BlockSummary& block, double lowest,
                     double gravity) {
  const double fall = std::max(0.0, run.start.position.z() - lowest);
  return std::sqrt(run.start.velocity.squaredNorm() +
                   block.moments.maxCoeff() / block.mass *
                       run.start.angular_velocity.squaredNorm() +
                   2.0 * gravity * fall);
}

/// The worst that the runs of a block meet.
struct Worst {
  double fastest = 0.0;
  GroundStiffnessInputs ground;

  void include(double speed, const GroundStiffnessInputs& other) {
    fastest = std::max(fastest, speed);
    ground.include(other);
  }
};

/// Blocks that may touch each other share one stiffness: that of the most demanding start, ground
/// and contact between blocks of their realisation.
std::vector<std::string> settle_together(CampaignPlan& prepared,
                                         const std::vector<BodyStiffnessInputs>& bodies,
                                         const std::vector<GroundStiffnessInputs>& grounds) {
  const Campaign& campaign = prepared.campaign;
  const std::vector<EnsembleMemberSettings> members = sample_member_settings(campaign);
  const std::size_t each = prepared.header.persistent_blocks->blocks_per_realisation;
  const GroundStiffnessInputs between = ground_stiffness_inputs(
      std::span(&campaign.persistent_blocks->between_blocks, 1), campaign.stiffness.law);
  const double lowest = prepared.surface->extent().low.z();
  std::vector<std::string> warnings;
  for (std::size_t first = 0; first < prepared.runs.size(); first += each) {
    const std::span runs(&prepared.runs[first], each);
    Worst worst;
    worst.include(0.0, between);
    std::vector<BodyStiffnessInputs> together;
    for (const RunRecord& run : runs) {
      worst.include(fastest_speed(run, prepared.header.blocks[run.block], lowest, campaign.gravity),
                    grounds[run.ground_set]);
      together.push_back(bodies[run.block]);
    }
    const std::size_t member = std::min<std::size_t>(runs.front().ground_set, members.size() - 1);
    StiffnessOptions options = members[member].stiffness;
    options.multi_block = prepared.header.persistent_blocks->at_once;
    const StiffnessChoice choice =
        choose_stiffness(together, worst.ground, worst.fastest, campaign.gravity, options);
    for (RunRecord& run : runs) {
      run.stiffness = choice.stiffness;
      run.settled_depth = choice.settled_depth;
      run.impact_depth = choice.impact_depth;
      release_settings(campaign, run).check();
    }
    if (!warnings.empty()) continue;
    for (const std::string& warning : choice.warnings) {
      warnings.push_back("realisation " + std::to_string(first / each + 1) + ": " + warning);
    }
  }
  return warnings;
}

}  // namespace

std::vector<std::string> choose_run_stiffness(CampaignPlan& prepared) {
  const std::vector<EnsembleMemberSettings> members = sample_member_settings(prepared.campaign);
  const double gravity = prepared.campaign.gravity;
  const double lowest = prepared.surface->extent().low.z();
  std::vector<GroundStiffnessInputs> grounds;
  for (const GroundParameterSet& set : prepared.header.ground_sets) {
    grounds.push_back(ground_stiffness_inputs(set.zones, prepared.campaign.stiffness.law));
  }
  std::vector<BodyStiffnessInputs> bodies;
  for (std::size_t i = 0; i < prepared.bodies.size(); ++i) {
    const std::uint32_t first = prepared.bodies.first_equal_body(i);
    bodies.push_back(first < i ? bodies[first] : body_stiffness_inputs(prepared.bodies[i]));
  }
  if (prepared.header.persistent_blocks) return settle_together(prepared, bodies, grounds);
  const auto choose = [&](std::size_t block, const GroundStiffnessInputs& ground, double fastest,
                          const StiffnessOptions& options) {
    return with_error_context("block " + prepared.header.blocks[block].id, [&] {
      return choose_stiffness(std::span(&bodies[block], 1), ground, fastest, gravity, options);
    });
  };

  std::vector<Worst> worst(bodies.size());
  for (RunRecord& run : prepared.runs) {
    const double fastest = fastest_speed(run, prepared.header.blocks[run.block], lowest, gravity);
    const std::uint32_t member = prepared.header.ground_sets[run.ground_set].member;
    const StiffnessChoice choice =
        choose(run.block, grounds[run.ground_set], fastest,
               members[std::min<std::size_t>(member, members.size() - 1)].stiffness);
    run.stiffness = choice.stiffness;
    run.settled_depth = choice.settled_depth;
    run.impact_depth = choice.impact_depth;
    release_settings(prepared.campaign, run).check();
    worst[run.block].include(fastest, grounds[run.ground_set]);
  }

  const StiffnessOptions central = central_member_settings(prepared.campaign).stiffness;
  std::vector<std::string> warnings;
  std::size_t named = 0, others = 0;
  for (std::size_t block = 0; block < bodies.size(); ++block) {
    const StiffnessChoice choice =
        choose(block, worst[block].ground, worst[block].fastest, central);
    if (choice.warnings.empty()) continue;
    if (named == kMaxNamed) {
      ++others;
      continue;
    }
    ++named;
    for (const std::string& warning : choice.warnings) {
      warnings.push_back("block " + prepared.header.blocks[block].id + ": " + warning);
    }
  }
  if (others > 0) {
    warnings.push_back("the stiffness of " + std::to_string(others) +
                       " more blocks leads to similar warnings");
  }
  return warnings;
}

}  // namespace clast::study_detail
