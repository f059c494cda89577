#pragma once
/// The tables of a campaign file and the keys of each: what `read_campaign` knows, and nothing
/// else.
#include <string>
#include <vector>

namespace clast {

struct CampaignTable {
  std::string name;  ///< "blocks"; "ground" has the keys of a ground zone
  std::vector<std::string> keys;
};

/// In the order of docs/formats.md.
const std::vector<CampaignTable>& campaign_tables();

/// @throws std::out_of_range  no such table, which is our own mistake
const std::vector<std::string>& campaign_keys(const std::string& table);

}  // namespace clast
