#include "reconstruct/photos/surface_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast {

namespace {

constexpr double kGrazing = 0.174;     ///< cosine of 80 degrees
constexpr double kBehind = 0.01;       ///< of the diagonal
constexpr double kBufferSide = 512.0;  ///< px of the depths that are compared

/// Depths of the surface as a camera sees it, nearest first.
class DepthBuffer {
 public:
  DepthBuffer(const std::vector<std::optional<Vec2>>& pixels, const std::vector<Vec3>& places)
      : places_(places) {
    Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
    for (const auto& pixel : pixels) {
      if (!pixel) continue;
      low = low.cwiseMin(*pixel);
      high = high.cwiseMax(*pixel);
    }
    const double side = (high - low).maxCoeff();
    const double scale = side > 0.0 ? kBufferSide / side : 0.0;
    for (const auto& pixel : pixels) {
      pixels_.push_back(pixel ? std::optional<Vec2>(scale * (*pixel - low)) : std::nullopt);
    }
    depths_.assign(static_cast<std::size_t>(kSide) * kSide, std::numeric_limits<float>::infinity());
  }

  bool has(const TriangleMesh::Triangle& t) const {
    return pixels_[t[0]] && pixels_[t[1]] && pixels_[t[2]];
  }

  void draw(const TriangleMesh::Triangle& t) {
    const Vec2 &a = *pixels_[t[0]], &b = *pixels_[t[1]], &c = *pixels_[t[2]];
    const double area = twice_area(a, b, c);
    const auto first = [](double v) { return std::max(0, static_cast<int>(std::ceil(v - 0.5))); };
    const auto last = [](double v) {
      return std::min(kSide - 1, static_cast<int>(std::floor(v - 0.5)));
    };
    for (int y = first(std::min({a.y(), b.y(), c.y()})); y <= last(std::max({a.y(), b.y(), c.y()}));
         ++y) {
      for (int x = first(std::min({a.x(), b.x(), c.x()}));
           x <= last(std::max({a.x(), b.x(), c.x()})); ++x) {
        const Vec2 p(x + 0.5, y + 0.5);
        const double u = twice_area(p, b, c) / area, v = twice_area(a, p, c) / area;
        if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) continue;
        const double depth =
            u * places_[t[0]].z() + v * places_[t[1]].z() + (1.0 - u - v) * places_[t[2]].z();
        float& nearest = depths_[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)];
        nearest = std::min(nearest, static_cast<float>(depth));
      }
    }
  }

  /// True if nothing occludes the centre of the triangle.
  bool shows(const TriangleMesh::Triangle& t, double tolerance) const {
    const Vec2 p = (*pixels_[t[0]] + *pixels_[t[1]] + *pixels_[t[2]]) / 3.0;
    const int x = std::clamp(static_cast<int>(p.x()), 0, kSide - 1);
    const int y = std::clamp(static_cast<int>(p.y()), 0, kSide - 1);
    const double depth = (places_[t[0]].z() + places_[t[1]].z() + places_[t[2]].z()) / 3.0;
    return depth <=
           depths_[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)] + tolerance;
  }

 private:
  static constexpr int kSide = static_cast<int>(kBufferSide) + 1;
  const std::vector<Vec3>& places_;
  std::vector<std::optional<Vec2>> pixels_;
  std::vector<float> depths_;
};

/// 1 for every triangle that the photo sees.
std::vector<std::uint8_t> seen_in(const TriangleMesh& surface, const PhotoModel& model,
                                  std::size_t index, const Pose& block_from_model) {
  const Photo& photo = model.photos[index];
  const CameraIntrinsics& lens = model.lenses[photo.lens];
  const Pose camera_from_block = photo.camera_from_world * block_from_model.inverse();
  std::vector<Vec3> places;
  std::vector<std::optional<Vec2>> pixels;
  for (const Vec3& vertex : surface.vertices) {
    places.push_back(camera_from_block * vertex);
    std::optional<Vec2> pixel = project(lens, places.back());
    const bool inside = pixel && pixel->minCoeff() >= -0.5 && pixel->x() <= lens.width - 0.5 &&
                        pixel->y() <= lens.height - 0.5;
    pixels.push_back(inside ? pixel : std::nullopt);
  }
  DepthBuffer depths(pixels, places);
  for (const auto& triangle : surface.triangles) {
    if (depths.has(triangle)) depths.draw(triangle);
  }
  const double tolerance = kBehind * bounds(surface).diagonal();
  std::vector<std::uint8_t> visible(surface.triangles.size());
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const auto& t = surface.triangles[i];
    const Vec3 &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
    const Vec3 normal = (b - a).cross(c - a), middle = (a + b + c) / 3.0;
    const bool turned = -normal.dot(middle) > kGrazing * normal.norm() * middle.norm();
    visible[i] = turned && depths.has(t) && depths.shows(t, tolerance) ? 1 : 0;
  }
  return visible;
}

}  // namespace

SurfaceViews count_surface_views(const TriangleMesh& surface, const PhotoScan& scan,
                                 const Pose& block_from_model, unsigned threads) {
  const std::size_t count = scan.model.photos.size();
  std::vector<bool> compared(count);
  for (const StereoPair& pair : scan.cloud.pairs)
    compared[pair.first] = compared[pair.second] = true;
  std::vector<std::vector<std::uint8_t>> visible(count);
  parallel_for(count, threads, [&](std::size_t i) {
    if (compared[i]) visible[i] = seen_in(surface, scan.model, i, block_from_model);
  });
  SurfaceViews views;
  views.photos.assign(surface.triangles.size(), 0);
  views.pairs = views.photos;
  for (const auto& photo : visible) {
    for (std::size_t t = 0; t < photo.size(); ++t) {
      views.photos[t] = static_cast<std::uint16_t>(views.photos[t] + photo[t]);
    }
  }
  for (const StereoPair& pair : scan.cloud.pairs) {
    for (std::size_t t = 0; t < views.pairs.size(); ++t) {
      const int both = visible[pair.first][t] & visible[pair.second][t];
      views.pairs[t] = static_cast<std::uint16_t>(views.pairs[t] + both);
    }
  }
  return views;
}

double observed_fraction(const TriangleMesh& surface, const std::vector<std::uint16_t>& counts,
                         std::uint16_t min_views) {
  double all = 0.0, visible = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[i];
    const double area = (surface.vertices[b] - surface.vertices[a])
                            .cross(surface.vertices[c] - surface.vertices[a])
                            .norm();
    all += area;
    if (counts[i] >= min_views) visible += area;
  }
  return all > 0.0 ? visible / all : 0.0;
}

}  // namespace clast
