#include "report/blocks/block_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "report/blocks/mesh_picture.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

/// Rock in light and shade, and its edge against white, as a picture with a small palette.
std::string shaded_png(const Canvas& canvas) {
  constexpr std::uint8_t kShades = 96;
  constexpr Rgb kWhite{255, 255, 255};
  std::vector<Rgb> palette = {kWhite};
  for (int shade = 0; shade < kShades; ++shade) {
    const double red = 255.0 * shade / (kShades - 1);
    const double over = std::max(0.0, (red - kBlockColour[0]) / (255.0 - kBlockColour[0]));
    const double light = std::min(1.0, red / kBlockColour[0]);
    Rgb colour{};
    for (std::size_t k = 0; k < 3; ++k) {
      colour[k] = static_cast<std::uint8_t>(
          std::lround((1.0 - over) * light * kBlockColour[k] + over * kWhite[k]));
    }
    palette.push_back(colour);
  }
  std::vector<std::uint8_t> pixels;
  for (const Rgb& pixel : canvas.picture()) {
    const long shade = std::lround(pixel[0] / 255.0 * (kShades - 1));
    pixels.push_back(pixel == kWhite ? 0 : static_cast<std::uint8_t>(1 + shade));
  }
  return encode_palette_png(canvas.camera().width, canvas.camera().height, pixels, palette);
}

}  // namespace

Rgb deviation_colour(double share) {
  const double place = (std::clamp(share, -1.0, 1.0) + 1.0) * 0.5 * (kDeviationColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kDeviationColours.size() - 2);
  const double rest = place - static_cast<double>(below);
  Rgb colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    colour[k] = static_cast<std::uint8_t>((1.0 - rest) * kDeviationColours[below][k] +
                                          rest * kDeviationColours[below + 1][k] + 0.5);
  }
  return colour;
}

std::string render_thumbnail_png(const TriangleMesh& mesh, std::uint32_t width,
                                 std::uint32_t height) {
  std::array<Camera, 1> camera = {make_camera(default_view_direction())};
  frame(camera, mesh.vertices, width, height);
  Canvas canvas(camera[0]);
  canvas.draw(mesh, [](std::uint32_t, const Vec3&, bool) { return kBlockColour; });
  return shaded_png(canvas);
}

std::string render_thumbnail(const TriangleMesh& mesh, const std::string& name, std::uint32_t width,
                             std::uint32_t height) {
  return "<img width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) +
         "\" alt=\"" + escape_html(name) + "\" src=\"" +
         png_data_uri(render_thumbnail_png(mesh, width, height)) + "\"/>";
}

}  // namespace clast::report_detail
