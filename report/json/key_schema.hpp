#pragma once
/// JSON Schema (draft 7) of TOML files, for completion and checks in editors.
#include <nlohmann/json.hpp>

namespace clast {

/// Returns the schema of campaign files. Its keys have `description` and `unit`.
nlohmann::ordered_json campaign_schema();
nlohmann::ordered_json calibration_schema();

}  // namespace clast
