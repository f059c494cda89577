#pragma once
/// Shaded relief of a terrain seen from above.
#include <string>
#include <vector>

#include "core/files/png.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// Plan rectangle, m.
struct PlanWindow {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  Vec2 size() const { return high - low; }
};

/// Heights and zones in square cells, row-major from the top (largest y).
struct Relief {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  double cell = 0.0;           ///< m
  std::vector<double> height;  ///< local z of the highest triangle, m; NaN without ground
  std::vector<std::uint16_t> zone;
};

/// Samples height and zone of a terrain at the centres of square cells in `window` (local frame).
/// @param columns  number of cells along x
Relief sample_relief(const Terrain& terrain, const PlanWindow& window, std::uint32_t columns);

inline constexpr Rgb kContourColour = {122, 98, 69};

/// Returns the colour after which a zone is named ("red"), otherwise the n-th of a pale palette.
Rgb zone_colour(const std::string& name, std::size_t n);

/// Renders the relief as a PNG file with zone colours and contour lines. Light comes from the
/// north-west at 45 degrees; slopes by Horn's method. Empty cells are transparent.
/// @param first_height  map z of local z = 0, m; contours are at round map heights
/// @param contour_interval  m
/// @cite horn1981
std::string render_relief_png(const Relief& relief, const std::vector<std::string>& zone_names,
                              double first_height, double contour_interval);

}  // namespace clast
