#pragma once
/// What the photos of a block showed, as JSON (docs/formats.md).
#include <nlohmann/json.hpp>

#include "reconstruct/photos/photo_evidence.hpp"

namespace clast {

nlohmann::ordered_json photo_json(const PhotoScan& scan, const PhotoEvidence& evidence);

}  // namespace clast
