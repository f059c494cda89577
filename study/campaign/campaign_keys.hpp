#pragma once
/// The tables of a campaign file and the keys of each: what `read_campaign` knows, and nothing
/// else.
#include "study/campaign/key_table.hpp"

namespace clast {

/// In the order of docs/formats.md. "ground" has the keys of a ground zone, "blocks.vary" those
/// of the key `vary` of [blocks], and "contact.blocks" those of `blocks` of [contact].
const std::vector<KeyTable>& campaign_key_tables();

}  // namespace clast
