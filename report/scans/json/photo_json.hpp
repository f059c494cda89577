#pragma once
/// Summary of a photo scan as JSON (docs/formats.md).
#include <nlohmann/json.hpp>

#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

nlohmann::ordered_json photo_json(const PhotoScan& scan, const PhotoSummary& evidence);

}  // namespace clast
