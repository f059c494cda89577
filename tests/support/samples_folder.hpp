#pragma once
#include <filesystem>

namespace clast {

/// The folder `samples` of the project.
inline const std::filesystem::path kSamples = std::filesystem::path(CLAST_SOURCE_DIR) / "samples";

}  // namespace clast
