#pragma once
/// JSON Schema (draft 7) of TOML files, for completion and checks in editors.
#include <nlohmann/json.hpp>

namespace clast {

/// Returns the JSON Schema of campaign files.
nlohmann::ordered_json campaign_schema();
nlohmann::ordered_json calibration_schema();

}  // namespace clast
