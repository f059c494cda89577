#pragma once
/// Section of a block's page about its photographs.
#include <string>

#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// Formats the section on the photographs of a block: camera positions, coverage, scale and omitted
/// photos.
std::string format_photo_section(const PhotoScan& scan, const PhotoSummary& evidence,
                                 const TriangleMesh& surface);

}  // namespace clast
