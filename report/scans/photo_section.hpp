#pragma once
/// The part of a block's page that is about its photographs.
#include <string>

#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// Section "Photographs" of a block's page: who stood where, what was seen how often, what the
/// scale rests on, which photos were left out.
std::string format_photo_section(const PhotoScan& scan, const PhotoSummary& evidence,
                                 const TriangleMesh& surface);

}  // namespace clast
