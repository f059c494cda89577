#pragma once
/// Varied bodies before they are scaled to their size.
#include <optional>
#include <string>

#include "library/block_variation.hpp"

namespace clast::library_detail {

struct VariedBody {
  SpheroPolyhedron body;
  std::string record;  ///< additional "key=value" pairs for `BlockSource::options`
};

VariedBody vary_body(const Block& parent, const StretchVariation& target);
VariedBody vary_body(const Block& parent, const ConvexityVariation& target);
VariedBody vary_body(const Block& parent, const RoundingVariation& target);
VariedBody vary_body(const Block& parent, const VertexCountVariation& target);
VariedBody vary_body(const Block& parent, const DetailVariation& target);
VariedBody vary_body(const Block& parent, const ReferenceVariation& target);
VariedBody vary_body(const Block& parent, const InertiaVariation& target);
VariedBody vary_body(const Block& parent, const SampledFormVariation& target);

}  // namespace clast::library_detail
