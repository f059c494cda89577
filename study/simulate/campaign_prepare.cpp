#include <utility>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/version.hpp"
#include "dem/simulation/physics_digest.hpp"
#include "study/simulate/campaign_checks.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/ground_sets.hpp"
#include "study/simulate/realisation.hpp"
#include "study/simulate/run_plan.hpp"
#include "study/simulate/run_stiffness.hpp"

namespace clast {

using namespace study_detail;
namespace {

BlockSummary summary_of(const CampaignBlock& chosen, const Block& block, const RigidBody& body,
                        const std::vector<BlockGroup>& groups) {
  const double scale = chosen.scale;
  const std::optional<VariationRecord> made = parse_variation(block);
  const Axes axes{scale * block.axes().L, scale * block.axes().I, scale * block.axes().S};
  return {chosen.id,
          body.mass,
          axes,
          shape_class("garcia", axes),
          shape_class("sneed-folk", axes),
          shape_class("zingg", axes),
          block.id,
          chosen.group > 0 ? groups[chosen.group - 1].name : "",
          scale,
          scale * scale * scale * block.mass.volume,
          static_cast<std::uint32_t>(chosen.library),
          body.moments,
          made ? made->parent : "",
          made ? describe_variation(*made) : ""};
}

std::vector<BlockSummary> block_summaries(const CampaignPlan& prepared) {
  std::vector<BlockSummary> summaries;
  for (std::size_t i = 0; i < prepared.bodies.size(); ++i) {
    const CampaignBlock& chosen = prepared.choice.blocks[i];
    summaries.push_back(summary_of(chosen, prepared.choice.library[chosen.library],
                                   prepared.bodies[i], prepared.campaign.groups));
  }
  return summaries;
}

std::string with_digest(const std::filesystem::path& file) {
  return file.string() + " " + sha256_of_file(file);
}

CampaignHeader header_of(const CampaignPlan& prepared, Terrain terrain) {
  const Campaign& campaign = prepared.campaign;
  CampaignHeader header;
  header.campaign_text = campaign.text;
  header.campaign_sha256 = campaign.sha256;
  header.inputs.push_back(with_digest(campaign.blocks.library));
  if (campaign.blocks.vary && !campaign.blocks.vary->table.empty()) {
    header.inputs.push_back(with_digest(campaign.blocks.vary->table));
  }
  header.inputs.insert(header.inputs.end(), terrain.sources.begin(), terrain.sources.end());
  for (const ReleaseSet& release : campaign.releases) {
    for (const auto& file : release.files) header.inputs.push_back(with_digest(file));
  }
  if (campaign.ensemble.posterior) {
    header.inputs.push_back(with_digest(campaign.ensemble.posterior->file));
  }
  header.program_version = version();
  header.physics_digest = physics_digest();
  header.blocks = block_summaries(prepared);
  for (const Block& block : prepared.choice.library) {
    header.shapes.push_back(rigid_body(block).shape);
  }
  const Vec2 origin = terrain.frame.origin.head<2>();
  for (Barrier barrier : campaign.barriers) {
    for (Vec2& point : barrier.vertices) point -= origin;
    header.barriers.push_back(barrier);
  }
  header.zone_names = terrain.zone_names;
  header.ground_sets = sample_ground_sets(campaign, terrain.zone_names);
  header.ground = compute_median_ground(campaign, terrain.zone_names);
  header.law = campaign.stiffness.law;
  header.weighting = campaign.weighting;
  header.frame = terrain.frame;
  header.downslope = campaign.downslope;
  header.terrain = std::move(terrain);
  return header;
}

}  // namespace

void resample_blocks(CampaignPlan& prepared) {
  prepared.choice.blocks = sample_blocks(prepared.campaign, prepared.choice.library);
  prepared.bodies = BlockBodies(prepared.choice);
  prepared.header.blocks = block_summaries(prepared);
}

CampaignPlan prepare_campaign(const Campaign& campaign,
                              const BlockPreparationOptions& preparation) {
  CampaignPlan prepared;
  prepared.campaign = campaign;
  prepared.choice = choose_campaign_blocks(campaign, preparation);
  if (std::optional<BlockSampling>& draw = prepared.campaign.blocks.draw) {
    // Later redraws give the same number of blocks.
    draw->count = prepared.choice.blocks.size() /
                  (campaign.persistent_blocks ? campaign.persistent_blocks->realisations : 1);
  }
  prepared.bodies = BlockBodies(prepared.choice);
  prepared.header = header_of(prepared, read_terrain(campaign.terrain));
  CampaignHeader& header = prepared.header;
  check_block_sizes(prepared);
  prepared.surface.emplace(make_terrain_surface(header.terrain, campaign.terrain_radius));

  plan_runs(prepared);
  check_fall_speeds(prepared);
  std::vector<std::string> warnings = choose_run_stiffness(prepared);
  const std::optional<PersistentBlocksPlan>& stay = campaign.persistent_blocks;
  if (stay && !stay->masses.empty() && stay->masses.front().in_place) {
    check_multi_block_start(prepared, 0);
  }
  header.warnings = check_campaign_settings(prepared);
  header.warnings.insert(header.warnings.begin(), warnings.begin(), warnings.end());
  const std::vector<std::string>& notes = prepared.choice.notes;
  header.warnings.insert(header.warnings.end(), notes.begin(), notes.end());
  return prepared;
}

}  // namespace clast
