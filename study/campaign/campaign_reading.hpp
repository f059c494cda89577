#pragma once
/// Readers of the parts of a campaign file.
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/campaign/campaign.hpp"
#include "study/campaign/member_table.hpp"

namespace clast::study_detail {

/// Upper limit of the numbers of points, orientations or blocks in a campaign. It prevents a typing
/// error from exhausting the memory.
inline constexpr std::uint64_t kMaxItemsPerSet = 1'000'000;
/// Upper limits of initial speed, m/s, and initial angular speed, rad/s. Larger values are errors
/// of unit, height or gravity.
inline constexpr double kMaxInitialSpeed = 1000.0, kMaxInitialSpin = 1e4;

/// Classification schemes by which blocks can be selected and sampled.
inline const std::vector<std::string> kSelectingSchemes = {"garcia", "sneed-folk", "zingg"};

/// Function that runs a reader of one part of a campaign. Returns false if reading failed.
using PartReader = std::function<bool(const std::function<void()>&)>;

/// Makes a part reader that catches errors and appends each message to `findings` once.
PartReader collect_findings(std::vector<std::string>& findings);

/// Runs the reader of a part without catching errors (a `PartReader`).
inline bool read_without_catching(const std::function<void()>& part) {
  part();
  return true;
}

/// Makes the top-level table of a TOML file. Undeclared tables are reported as errors through
/// `read`.
TomlTable parse_top_level_table(const TomlNode& root, const std::filesystem::path& file,
                                const std::vector<KeyTable>& declared, const PartReader& read);

/// Reads a campaign by parts. `read` runs the reader of each part; if it fails, dependent parts are
/// skipped.
/// @param text  text of the campaign; if empty, the contents of the file
Campaign read_campaign_by_parts(const std::filesystem::path& file,
                                const std::optional<std::string>& text, const PartReader& read);

// Its tables, in the order of docs/formats.md.
const MemberTable<BlockSelection>& blocks_keys();
const MemberTable<VariationSeriesRequest>& vary_keys();
const MemberTable<BlockGroup>& block_group_keys();
const MemberTable<Campaign>& terrain_keys();
const MemberTable<GroundDistributions>& ground_keys();
const MemberTable<Ensemble>& ensemble_keys();
const MemberTable<ReleaseSet>& release_keys();
const MemberTable<MultiBlockRelease>& multi_block_release_keys();
const MemberTable<Campaign>& contact_keys();
const MemberTable<GroundParameters>& between_blocks_keys();
const MemberTable<Barrier>& barrier_keys();
const MemberTable<Campaign>& run_keys();

BlockSelection read_block_selection(const TomlTable& top);
/// Reads the request for varied bodies: the table `vary` of [blocks].
VariationSeriesRequest read_variation_request(const DeclaredTable& blocks);
std::map<std::string, GroundDistributions> read_ground_distributions(const TomlTable& top);
/// Reads the groups of blocks: the tables [[block_group]].
/// @param campaign  campaign with its ground parameters
std::vector<BlockGroup> read_block_groups(const TomlTable& top, const Campaign& campaign);
/// Reads the ensemble: the table [ensemble].
/// @param campaign  campaign with its ground parameters and block groups
Ensemble read_ensemble(const TomlTable& top, const Campaign& campaign);
/// Checks that all release sets have the parameters that the posterior draws of the ensemble set.
/// @param campaign  campaign with its ensemble, releases and persistent blocks
void check_posterior_parameters(const TomlTable& top, const Campaign& campaign);
/// Reads the number of realisations from [release] or the first [[mass]].
std::uint32_t read_realisations(const DeclaredTable& table);
/// Reads the contact parameters between blocks: the table [contact.blocks].
/// @param who  name of the setting that requires the table, for the message
GroundParameters read_between_blocks(const TomlTable& top, const std::string& who);
/// Reads the release sets of simultaneous releases, one per table [[mass]]. Empty if there is none.
std::vector<ReleaseSet> read_mass_releases(const TomlTable& top);
/// Reads all simultaneous releases: the tables [[mass]]. Empty if there is none.
/// @param campaign  campaign with its blocks and groups
std::optional<PersistentBlocksPlan> read_multi_block_releases(const TomlTable& top,
                                                              const Campaign& campaign);
std::vector<ReleaseSet> read_releases(const TomlTable& top, bool y_up);
/// Reads the settings of persistent blocks.
/// @param campaign  campaign with its blocks, groups and releases
std::optional<PersistentBlocksPlan> read_persistent_blocks_plan(const TomlTable& top,
                                                                const Campaign& campaign);

}  // namespace clast::study_detail
