#pragma once
/// The tables of a campaign file and the keys of each: what `read_campaign` knows, and nothing
/// else.
#include "study/campaign/key_table.hpp"

namespace clast {

/// In the order of docs/formats.md. "ground" has the keys of a ground zone, "blocks.vary" those
/// of the key `vary` of [blocks], and "contact.blocks" those of `blocks` of [contact].
const std::vector<KeyTable>& campaign_tables();

/// Names of the keys.
/// @throws std::out_of_range  no such table, which is our own mistake
std::vector<std::string> campaign_keys(const std::string& table);

/// The words that a text of a campaign may be: of the law of [contact], ...
/// @throws std::out_of_range  no such key, or any text will do
const std::vector<std::string>& campaign_words(const std::string& table, const std::string& key);

}  // namespace clast
