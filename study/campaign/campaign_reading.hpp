#pragma once
/// Parts of a campaign file, read and checked.
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/campaign/bound_table.hpp"
#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// Far above any study, and low enough that a slip of the keyboard does not fill the memory.
inline constexpr std::uint64_t kMostPerSet = 1'000'000;
/// No rock is faster, m/s and rad/s: more is a slip of units, heights or gravity, and its time step
/// would be so short that the run never ended.
inline constexpr double kMostSpeed = 1000.0, kMostSpin = 1e4;

/// Schemes whose classes blocks are selected and drawn by.
inline const std::vector<std::string> kSelectingSchemes = {"garcia", "sneed-folk", "zingg"};

/// Runs what reads a part of a campaign, and says whether that was done.
using PartReader = std::function<bool(const std::function<void()>&)>;

/// Runs parts, and puts what they refuse into `findings`, each refusal once.
PartReader collect_findings(std::vector<std::string>& findings);

/// Reads parts so that the first refusal ends it.
inline bool read_at_once(const std::function<void()>& part) {
  part();
  return true;
}

/// A whole file. Tables that are not declared are refused through `read`.
TomlTable parse_top_level_table(const TomlNode& root, const std::filesystem::path& file,
                    const std::vector<KeyTable>& declared, const PartReader& read);

/// A campaign, read part by part through `read`; a part that needs another is left out where that
/// one was not read.
/// @param text  what the file holds or could hold; none: it is read
Campaign read_by_parts(const std::filesystem::path& file, const std::optional<std::string>& text,
                       const PartReader& read);

// Its tables, in the order of docs/formats.md.
const MemberTable<BlockSelection>& blocks_keys();
const MemberTable<SeriesRequest>& vary_keys();
const MemberTable<BlockGroup>& block_group_keys();
const MemberTable<Campaign>& terrain_keys();
const MemberTable<GroundDistributions>& ground_keys();
const MemberTable<Ensemble>& ensemble_keys();
const MemberTable<ReleaseSet>& release_keys();
const MemberTable<MultiBlockRelease>& mass_keys();
const MemberTable<Campaign>& contact_keys();
const MemberTable<GroundParameters>& between_blocks_keys();
const MemberTable<Barrier>& barrier_keys();
const MemberTable<Campaign>& run_keys();

BlockSelection read_blocks(const TomlTable& top);
/// `vary` of [blocks], without library and blocks.
SeriesRequest read_vary(const DeclaredTable& blocks);
std::map<std::string, GroundDistributions> read_ground(const TomlTable& top);
/// @param campaign  with its ground
std::vector<BlockGroup> read_block_groups(const TomlTable& top, const Campaign& campaign);
/// @param campaign  with its ground and groups
Ensemble read_ensemble(const TomlTable& top, const Campaign& campaign);
/// Can all releases have the starts that members take from a posterior?
/// @param campaign  with its ensemble, releases and what stays
void check_posterior_parameters(const TomlTable& top, const Campaign& campaign);
/// How often blocks that stay are released: of [release] or the first [[mass]].
std::uint32_t read_realisations(const DeclaredTable& table);
/// [contact.blocks].
/// @param who  needs it, for the message
GroundParameters read_between_blocks(const TomlTable& top, const std::string& who);
/// Names of the masses, seed, and that orientations are random: one to each [[mass]]; none without.
std::vector<ReleaseSet> read_mass_releases(const TomlTable& top);
/// All [[mass]]; none without.
/// @param campaign  with its blocks and groups
std::optional<PersistentBlocksPlan> read_multi_block_releases(const TomlTable& top, const Campaign& campaign);
/// Of [release], or those of [[mass]].
std::vector<ReleaseSet> read_releases(const TomlTable& top, bool y_up);
/// @param campaign  with its blocks, groups and releases
std::optional<PersistentBlocksPlan> read_persistent_blocks_plan(const TomlTable& top, const Campaign& campaign);

}  // namespace clast::study_detail
