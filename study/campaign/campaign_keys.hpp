#pragma once
/// Declarations of all tables and keys of a campaign file.
#include "study/campaign/key_table.hpp"

namespace clast {

/// Returns the declarations of all tables and keys of a campaign file, in the order of
/// docs/formats.md.
const std::vector<KeyTable>& campaign_key_tables();

}  // namespace clast
