#pragma once
/// Colours of blocks and of their distance from a scan, and small pictures of them.
#include <array>
#include <cstdint>
#include <string>

#include "core/files/png.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::report_detail {

inline constexpr Rgb kRock{214, 205, 190};

/// Direction to the eye that looks at a block from the front (-y) and above.
inline Vec3 default_view_direction() { return {0.55, -1.0, 0.55}; }

/// Blue inside, pale where it is on the scan, red outside (RdBu of ColorBrewer).
inline constexpr std::array<Rgb, 5> kDeviationColours = {
    {{33, 102, 172}, {146, 197, 222}, {247, 247, 247}, {244, 165, 130}, {178, 24, 43}}};
/// Between these colours.
/// @param share  of the largest distance, -1 to 1; cut to it
Rgb deviation_colour(double share);

/// A small picture of a surface, a PNG file.
std::string render_thumbnail_png(const TriangleMesh& mesh, std::uint32_t width, std::uint32_t height);

/// The same as an <img>.
std::string thumbnail(const TriangleMesh& mesh, const std::string& name, std::uint32_t width = 120,
                      std::uint32_t height = 96);

}  // namespace clast::report_detail
