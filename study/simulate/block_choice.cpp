#include "study/simulate/block_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "library/block_library.hpp"
#include "library/deposit_observations.hpp"
#include "library/unscaled.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/named_seed.hpp"

namespace clast {
namespace {

bool passes(const BlockFilter& filter, const Block& block) {
  if (!filter.ids.empty()) {
    return std::find(filter.ids.begin(), filter.ids.end(), block.id) != filter.ids.end();
  }
  return filter.scheme.empty() || shape_class(filter.scheme, block.axes()) == filter.shape_class;
}

std::vector<Block> selected_from(const BlockLibrary& library, const Campaign& campaign) {
  const BlockSelection& selection = campaign.blocks;
  std::vector<Block> blocks;
  for (const std::string& id : selection.filter.ids) blocks.push_back(library.find_block(id));
  if (!selection.filter.ids.empty()) return blocks;
  for (const Block& block : library.blocks()) {
    if (passes(selection.filter, block)) blocks.push_back(block);
  }
  if (blocks.empty()) {
    throw InputError(
        campaign.file.string() + ": [blocks] selects no block of " + selection.library.string() +
        (selection.filter.scheme.empty()
             ? "; the library is empty"
             : "; none is " + selection.filter.shape_class + " by " + selection.filter.scheme));
  }
  return blocks;
}

/// The bodies that are made of the blocks, in place of them.
void vary(const Campaign& campaign, const BlockLibrary& library,
          const BlockPreparationOptions& preparation, CampaignBlocks& choice) {
  VariationSeriesRequest request = *campaign.blocks.vary;
  request.library = campaign.blocks.library;
  for (const Block& block : choice.library) request.ids.push_back(block.id);
  request.options.threads = preparation.threads;
  request.options.progress = preparation.progress;
  const auto of_campaign = [&](const std::string& message) {
    return campaign.file.string() + ": [blocks] vary: " + remove_backticks(message);
  };
  VariationSeriesResult made = with_rewritten_error(of_campaign, [&] {
    VariationSeriesResult series = make_variation_series(request, library);
    const std::vector<std::string>& failed = series.series.failures;
    if (!failed.empty()) {
      throw GeometryError(
          std::to_string(failed.size()) + " of " +
          format_count(series.requested_count, "body", "bodies") +
          " can't be made; leave out the keys that request them. First reason: " + failed.front());
    }
    return series;
  });
  BlockLibrary bodies;
  for (Block& block : made.series.blocks) bodies.add(std::move(block));
  choice.parents = std::move(request.ids);
  choice.notes = std::move(made.notes);
  choice.library = bodies.blocks();
}

// A shape without a size runs only at a size that the campaign gives it.
void check_block_sizes(const Campaign& campaign, const std::vector<Block>& blocks) {
  const BlockSelection& selection = campaign.blocks;
  const bool sized = selection.draw ? selection.draw->mass.has_value()
                                    : selection.scale.kind == BlockScaling::Kind::kMass ||
                                          selection.scale.kind == BlockScaling::Kind::kVolume;
  if (sized) return;
  for (const Block& block : blocks) {
    if (!is_unscaled(block)) continue;
    throw InputError(campaign.file.string() + ": block " + block.id + " of " +
                     selection.library.string() + " is unscaled: " + explain_unscaled_block() +
                     "; or give it a size in [blocks] with scale = { mass_kg = M } or { volume_m3 "
                     "= V }, or with mass_kg in draw; or leave it out with select");
  }
}

// The factor of lengths that brings a block to the asked size.
double scale_of(const BlockScaling& scale, const Block& block, double mean_mass) {
  switch (scale.kind) {
    case BlockScaling::Kind::kNone:
      return 1.0;
    case BlockScaling::Kind::kMass:
      return std::cbrt(scale.value / block.mass.mass);
    case BlockScaling::Kind::kVolume:
      return std::cbrt(scale.value / block.mass.volume);
    case BlockScaling::Kind::kEqualMass:
      return std::cbrt(mean_mass / block.mass.mass);
  }
  return 1.0;
}

std::vector<CampaignBlock> all_of(const std::vector<Block>& blocks, const BlockScaling& scale) {
  double sum = 0.0;
  for (const Block& block : blocks) sum += block.mass.mass;
  std::vector<CampaignBlock> chosen;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double factor = scale_of(scale, blocks[i], sum / static_cast<double>(blocks.size()));
    chosen.push_back({blocks[i].id, i, factor, 0});
  }
  return chosen;
}

/// Ids of a group that no block has are slips of the keyboard; blocks that do not run are not.
void check_named(const Campaign& campaign, const BlockGroup& group, const BlockLibrary& library,
                 const CampaignBlocks& choice) {
  for (const std::string& id : group.filter.ids) {
    const bool runs = std::any_of(choice.library.begin(), choice.library.end(),
                                  [&](const Block& block) { return block.id == id; });
    if (runs || (choice.parents.empty() && library.contains(id))) continue;
    const std::string start =
        campaign.file.string() + ": the block group \"" + group.name + "\" names " + id + ", ";
    if (choice.parents.empty()) {
      throw InputError(start + "which " + campaign.blocks.library.string() +
                       " does not have; clast show lists its blocks");
    }
    throw InputError(
        start + "which is none of the " + format_count(choice.library.size(), "body", "bodies") +
        " made by vary, such as " + choice.library.front().id + "; name bodies, or a class");
  }
}

void put_in_groups(const Campaign& campaign, CampaignBlocks& choice) {
  for (std::size_t g = 0; g < campaign.groups.size(); ++g) {
    const BlockGroup& group = campaign.groups[g];
    bool any = false;
    for (CampaignBlock& block : choice.blocks) {
      if (!passes(group.filter, choice.library[block.library])) continue;
      if (block.group != 0) {
        throw InputError(campaign.file.string() + ": block " + block.id +
                         " is in the block groups \"" + campaign.groups[block.group - 1].name +
                         "\" and \"" + group.name + "\"; a block has one ground only");
      }
      block.group = g + 1;
      any = true;
    }
    if (!any) {
      throw InputError(campaign.file.string() + ": the block group \"" + group.name +
                       "\" holds no block of the campaign; check its select");
    }
  }
}

/// Every share of a draw with the blocks that it can be drawn from; without shares all in one.
struct DrawPools {
  std::vector<std::vector<std::size_t>> pools;
  std::vector<double> shares;
  std::optional<WeightedDeposit> deposit = {};  ///< if the blocks are those of a scanned deposit

  double weight(std::size_t block) const { return deposit ? deposit->weights[block] : 1.0; }
  std::size_t choose(std::size_t pool, Random& random) const {
    const std::vector<std::size_t>& blocks = pools[pool];
    if (!deposit) return blocks[random.uniform_index(blocks.size())];
    std::vector<double> weights;
    for (const std::size_t block : blocks) weights.push_back(weight(block));
    return blocks[choose_by_weight(weights, random)];
  }
};

std::optional<WeightedDeposit> weighed(const std::vector<Block>& blocks) {
  std::vector<const Block*> pointers;
  for (const Block& block : blocks) pointers.push_back(&block);
  return weigh_deposit(pointers);
}

DrawPools pools_of_shares(const Campaign& campaign, const std::vector<Block>& blocks) {
  const BlockSampling& draw = *campaign.blocks.draw;
  DrawPools result;
  result.deposit = weighed(blocks);
  if (draw.shares.empty()) {
    result.pools.emplace_back(blocks.size());
    std::iota(result.pools.back().begin(), result.pools.back().end(), std::size_t{0});
    result.shares.push_back(1.0);
  }
  for (const auto& [name, share] : class_fractions(draw)) {
    std::vector<std::size_t> pool;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (shape_class(draw.scheme, blocks[i].axes()) == name) pool.push_back(i);
    }
    if (pool.empty()) {
      throw InputError(campaign.file.string() + ": [blocks] draw asks for blocks of class \"" +
                       name + "\" by " + draw.scheme + ", but none is selected from " +
                       campaign.blocks.library.string() +
                       "; add such a block to the library or leave the class out");
    }
    result.pools.push_back(std::move(pool));
    result.shares.push_back(share);
  }
  return result;
}

/// Mean volume of drawn blocks, m^3.
double mean_drawn_volume(const Campaign& campaign, const std::vector<Block>& blocks) {
  const std::optional<Distribution>& drawn_mass = campaign.blocks.draw->mass;
  const double mean_mass = drawn_mass ? drawn_mass->mean() : 0.0;
  const DrawPools from = pools_of_shares(campaign, blocks);
  double volume = 0.0;
  for (std::size_t i = 0; i < from.pools.size(); ++i) {
    double sum = 0.0, weights = 0.0;
    for (const std::size_t block : from.pools[i]) {
      const MassProperties& own = blocks[block].mass;
      weights += from.weight(block);
      sum += from.weight(block) * (drawn_mass ? own.volume * mean_mass / own.mass : own.volume);
    }
    volume += from.shares[i] * sum / weights;
  }
  return volume;
}

/// Mean number of blocks with the volume that a draw requests.
std::size_t count_of_volume(const Campaign& campaign, const std::vector<Block>& blocks) {
  const double asked = *campaign.blocks.draw->volume;
  const double each = mean_drawn_volume(campaign, blocks);
  const double count = std::round(asked / each);
  if (count >= 1.0 && count <= static_cast<double>(study_detail::kMaxItemsPerSet)) {
    return static_cast<std::size_t>(count);
  }
  throw InputError(
      campaign.file.string() + ": [blocks] draw volume_m3 = " + format_significant(asked, 6) +
      " comes to " + format_significant(asked / each, 3) + " blocks of " +
      format_significant(each, 3) + " m^3 on average; the number must round to 1 to " +
      std::to_string(study_detail::kMaxItemsPerSet) + ", so give another volume_m3 or mass_kg");
}

// Draws need not touch every block of the library.
void drop_unused(CampaignBlocks& choice) {
  std::vector<std::size_t> place(choice.library.size(), choice.library.size());
  std::vector<Block> used;
  for (CampaignBlock& block : choice.blocks) {
    std::size_t& at = place[block.library];
    if (at == choice.library.size()) {
      at = used.size();
      used.push_back(std::move(choice.library[block.library]));
    }
    block.library = at;
  }
  choice.library = std::move(used);
}

}  // namespace

CampaignBlocks choose_campaign_blocks(const Campaign& campaign,
                                      const BlockPreparationOptions& preparation) {
  CampaignBlocks choice;
  const BlockLibrary library = BlockLibrary::read(campaign.blocks.library);
  choice.library = selected_from(library, campaign);
  if (campaign.blocks.vary) vary(campaign, library, preparation, choice);
  for (const BlockGroup& group : campaign.groups) check_named(campaign, group, library, choice);
  check_block_sizes(campaign, choice.library);
  choice.blocks = campaign.blocks.draw ? sample_blocks(campaign, choice.library)
                                       : all_of(choice.library, campaign.blocks.scale);
  put_in_groups(campaign, choice);
  drop_unused(choice);
  return choice;
}

std::vector<Block> read_selected_blocks(const Campaign& campaign) {
  return selected_from(BlockLibrary::read(campaign.blocks.library), campaign);
}

std::vector<CampaignBlock> sample_blocks(const Campaign& campaign,
                                         const std::vector<Block>& blocks) {
  const BlockSampling& draw = *campaign.blocks.draw;
  const DrawPools from = pools_of_shares(campaign, blocks);
  std::vector<CampaignBlock> drawn;
  const std::vector<std::size_t> counts =
      allocate_quotas(from.shares, draw.count > 0 ? draw.count : count_of_volume(campaign, blocks));
  const std::uint32_t draws =
      campaign.persistent_blocks ? campaign.persistent_blocks->realisations : 1;
  for (std::uint32_t k = 0; k < draws; ++k) {
    Random random(k == 0
                      ? draw.seed
                      : study_detail::derive_seed(draw.seed, "realisation " + std::to_string(k)));
    for (std::size_t pool = 0; pool < from.pools.size(); ++pool) {
      for (std::size_t i = 0; i < counts[pool]; ++i) {
        const std::size_t block = from.choose(pool, random);
        const double mass = blocks[block].mass.mass;
        double scale = 1.0;
        if (draw.mass) {
          scale = std::cbrt(draw.mass->draw(random) / mass);
        } else if (from.deposit) {
          const MeasuredBlock& seen = from.deposit->blocks[block];
          scale = draw_block_sizes(seen, random).axes.I / seen.axes.I;
        }
        drawn.push_back(
            {blocks[block].id + "#" + std::to_string(drawn.size() + 1), block, scale, 0});
      }
    }
  }
  return drawn;
}

std::vector<std::pair<std::string, double>> class_fractions(const BlockSampling& draw) {
  if (draw.set_shares.empty()) return draw.shares;
  double set = 0.0, others = 0.0;
  for (const auto& [name, share] : draw.shares) {
    const auto found = draw.set_shares.find(name);
    (found != draw.set_shares.end() ? set : others) +=
        found != draw.set_shares.end() ? found->second : share;
  }
  if (set > 1.0 || (others <= 0.0 && set != 1.0)) {
    throw InputError("the fractions of the classes that are set add up to " +
                     format_significant(set, 6) +
                     (set > 1.0 ? ", more than 1" : ", and no other class makes up the rest"));
  }
  std::vector<std::pair<std::string, double>> shares = draw.shares;
  for (auto& [name, share] : shares) {
    const auto found = draw.set_shares.find(name);
    share = found != draw.set_shares.end() ? found->second : share * (1.0 - set) / others;
  }
  return shares;
}

std::vector<std::size_t> allocate_quotas(const std::vector<double>& shares, std::size_t count) {
  std::vector<std::size_t> whole;
  std::vector<double> rest;
  std::size_t given = 0;
  for (const double share : shares) {
    const double exact = share * static_cast<double>(count);
    whole.push_back(static_cast<std::size_t>(exact));
    rest.push_back(exact - static_cast<double>(whole.back()));
    given += whole.back();
  }
  for (; given < count; ++given) {
    const std::size_t next =
        static_cast<std::size_t>(std::max_element(rest.begin(), rest.end()) - rest.begin());
    ++whole[next];
    rest[next] = -1.0;
  }
  return whole;
}

RigidBody scaled(RigidBody body, double factor) {
  const double cube = factor * factor * factor;
  body.shape = scaled(std::move(body.shape), factor);
  body.mass *= cube;
  body.moments *= cube * factor * factor;
  body.smallest_side *= factor;
  return body;
}

}  // namespace clast
