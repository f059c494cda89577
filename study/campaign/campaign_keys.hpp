#pragma once
/// Declarations of all tables and keys of a campaign file.
#include "study/campaign/key_table.hpp"

namespace clast {

/// Returns all tables in the order of docs/formats.md. "ground" declares the keys of a ground zone,
/// "blocks.vary" those of `vary` in [blocks], and "contact.blocks" those of `blocks` in [contact].
const std::vector<KeyTable>& campaign_key_tables();

}  // namespace clast
