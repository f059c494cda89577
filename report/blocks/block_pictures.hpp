#pragma once
/// Colours and thumbnails of blocks.
#include <array>
#include <cstdint>
#include <string>

#include "core/files/png.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::report_detail {

/// Default colour of blocks in images.
inline constexpr Rgb kBlockColour{214, 205, 190};

/// Colour of surface that no scan observed.
inline constexpr Rgb kUnobservedColour{232, 142, 40};

/// Returns the direction from a block towards the viewer, who is in front of it (-y) and above.
inline Vec3 default_view_direction() { return {0.55, -1.0, 0.55}; }

/// Colours of deviations of a block from its scan, from blue (inside) to red (ColorBrewer RdBu).
inline constexpr std::array<Rgb, 5> kDeviationColours = {
    {{33, 102, 172}, {146, 197, 222}, {247, 247, 247}, {244, 165, 130}, {178, 24, 43}}};
/// Returns the colour of a deviation, interpolated between `kDeviationColours`.
/// @param share  deviation divided by the largest deviation, clamped to [-1, 1]
Rgb deviation_colour(double share);

/// Renders a thumbnail of a surface as a PNG file.
std::string render_thumbnail_png(const TriangleMesh& mesh, std::uint32_t width,
                                 std::uint32_t height);

/// Renders a thumbnail of a surface as an HTML <img> element.
std::string render_thumbnail(const TriangleMesh& mesh, const std::string& name,
                             std::uint32_t width = 120, std::uint32_t height = 96);

}  // namespace clast::report_detail
