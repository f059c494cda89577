#include "study/simulate/detail/block_distribution.hpp"

#include <cmath>
#include <numeric>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast::study_detail {
namespace {

/// Tolerance of the sum of fractions, which may be written with few digits.
constexpr double kMemberShareSlack = 1e-6;

/// The mass in place that a block belongs to.
/// @param centre  of the block, on the map
std::size_t mass_around(const Campaign& campaign, const std::string& block, const Vec3& centre) {
  const std::vector<MultiBlockRelease>& masses = campaign.persistent_blocks->masses;
  if (masses.size() == 1) return 0;
  std::optional<std::size_t> found;
  const std::string where = campaign.file.string() + ": block " + block + " in place at x " +
                            format_decimals(centre.x(), 3) + ", y " +
                            format_decimals(centre.y(), 3) + " lies in the polygon of ";
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (!is_inside(masses[i].polygon, centre.head<2>())) continue;
    if (found) {
      throw InputError(where + multi_block_release_name(campaign, *found) + " and of " +
                       multi_block_release_name(campaign, i) + "; they must not overlap");
    }
    found = i;
  }
  if (found) return *found;
  throw InputError(where + "no [mass]; widen a polygon, or leave the block out by [blocks] select");
}

}  // namespace

std::string multi_block_release_name(const Campaign& campaign, std::size_t mass) {
  const std::string& name = campaign.releases[mass].name;
  return name.empty() ? "[mass]" : "[mass] " + name;
}

std::vector<std::size_t> blocks_per_release(const Campaign& campaign, std::size_t blocks) {
  const std::vector<MultiBlockRelease>& masses = campaign.persistent_blocks->masses;
  const auto all = static_cast<double>(blocks);
  double area = 0.0, counted_blocks = 0.0, shared = 0.0;
  std::string by_area;  // a mass with neither count nor share
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (masses[i].count) {
      counted_blocks += *masses[i].count;
    } else if (masses[i].share) {
      shared += *masses[i].share * all;
    } else {
      area += std::abs(signed_area(masses[i].polygon));
      by_area = multi_block_release_name(campaign, i);
    }
  }
  const double rest = all - counted_blocks - shared;
  if (by_area.empty() ? std::abs(rest) > kMemberShareSlack * all : !(rest > 0.0)) {
    throw InputError(campaign.file.string() + ": count and share of [mass] make " +
                     format_significant(counted_blocks + shared, 6) + " of " +
                     format_count(blocks, "block") +
                     (by_area.empty() ? " of a realisation; change them to add up to this number, "
                                        "or leave count and share out of one mass"
                                      : " of a realisation and leave none for " + by_area +
                                            "; give smaller values, or draw more blocks"));
  }
  std::vector<double> shares;
  for (const MultiBlockRelease& mass : masses) {
    const double wanted = mass.count   ? 0.0
                          : mass.share ? *mass.share * all
                                       : rest * std::abs(signed_area(mass.polygon)) / area;
    shares.push_back(wanted);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<std::size_t> counts(masses.size(), 0);
  if (sum > 0.0) {
    for (double& share : shares) share /= sum;
    counts = allocate_quotas(shares, blocks - static_cast<std::size_t>(counted_blocks));
  }
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (masses[i].count) counts[i] = *masses[i].count;
    if (counts[i] > 0) continue;
    throw InputError(campaign.file.string() + ": " + multi_block_release_name(campaign, i) +
                     " gets none of the " + format_count(blocks, "block") +
                     " of a realisation; give it a count or a larger share, or draw more");
  }
  return counts;
}

std::vector<std::vector<std::uint32_t>> distribute_blocks(const CampaignPlan& prepared,
                                                          std::span<const std::uint32_t> order) {
  const Campaign& campaign = prepared.campaign;
  std::vector<std::vector<std::uint32_t>> blocks(campaign.persistent_blocks->masses.size());
  if (!campaign.persistent_blocks->masses.front().in_place) {
    const std::vector<std::size_t> counts = blocks_per_release(campaign, order.size());
    auto next = order.begin();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto end = next + static_cast<std::ptrdiff_t>(counts[i]);
      blocks[i].assign(next, end);
      next = end;
    }
    return blocks;
  }
  for (const std::uint32_t block : order) {
    const CampaignBlock& chosen = prepared.choice.blocks[block];
    const Vec3 centre = prepared.choice.library[chosen.library].source_from_body().translation;
    blocks[mass_around(campaign, chosen.id, centre)].push_back(block);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!blocks[i].empty()) continue;
    throw InputError(campaign.file.string() + ": " + multi_block_release_name(campaign, i) +
                     ": no block in place has its centre in its polygon; check its corners and "
                     "the map frame");
  }
  return blocks;
}

}  // namespace clast::study_detail
