#pragma once
/// JSON Schema (draft 7) of files that are written in TOML, for editors that complete keys, explain
/// them and mark what would be refused.
#include <nlohmann/json.hpp>

namespace clast {

/// Of campaign files. Each key has `description` and, where it has one, `unit`.
nlohmann::ordered_json campaign_schema();
/// Of study files.
nlohmann::ordered_json calibration_schema();

}  // namespace clast
