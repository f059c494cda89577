#pragma once
/// Uncertainty of the size of a partly visible block.
#include "shapes/volume_bracket.hpp"

namespace clast::reconstruct_detail {

/// Computes intervals and bounds of volume and sides from the visible fraction of the surface.
///
/// Both are quantiles of the ratio of estimated to true sizes in virtual deposits
/// (docs/theory/deposits.md), interpolated between visible fractions. They include blocks whose
/// outline is partly wrong. Below half of the surface, there is no upper bound of the volume.
/// @param volume  estimated volume, m^3
/// @param sides  estimated L, I, S, m
/// @param visible_fraction  observed area over the area of the body
VolumeBracket estimate_size_uncertainty(double volume, const Vec3& sides, double visible_fraction);

}  // namespace clast::reconstruct_detail
