#include "report/blocks/mesh_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/plan_geometry.hpp"

namespace clast::report_detail {

namespace {

constexpr int kSamples = 2;        ///< a side of a pixel
constexpr double kMargin = 0.08;   ///< share of a picture that stays empty at each side
constexpr double kHidden = 0.005;  ///< share of the width by which a thing may lie behind another
constexpr double kFar = -std::numeric_limits<double>::infinity();

/// Unit; right, up and toward the eye.
Vec3 light() { return Vec3(-0.45, 0.55, 0.70).normalized(); }

std::array<float, 3> shaded(const Rgb& colour, double light) {
  std::array<float, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = static_cast<float>(std::min(255.0, colour[i] * light));
  }
  return result;
}

}  // namespace

Vec3 Camera::projected(const Vec3& point) const {
  const Vec3 offset = point - target;
  return {0.5 * width + right.dot(offset) / pixel, 0.5 * height - up.dot(offset) / pixel,
          toward.dot(offset)};
}

Camera make_camera(const Vec3& toward) {
  Camera camera;
  camera.toward = toward.normalized();
  // Straight from above or below, y is up.
  const bool upright = std::abs(camera.toward.z()) > 1.0 - 1e-9;
  const Vec3 top = upright ? Vec3::UnitY() : Vec3::UnitZ();
  camera.right = top.cross(camera.toward).normalized();
  camera.up = camera.toward.cross(camera.right);
  return camera;
}

void frame(std::span<Camera> cameras, std::span<const Vec3> points, std::uint32_t width,
           std::uint32_t height) {
  double pixel = 0.0;
  for (Camera& camera : cameras) {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    for (const Vec3& point : points) {
      const Vec3 there(camera.right.dot(point), camera.up.dot(point), camera.toward.dot(point));
      low = low.cwiseMin(there);
      high = high.cwiseMax(there);
    }
    camera.width = width;
    camera.height = height;
    if (points.empty()) continue;
    const Vec3 middle = 0.5 * (low + high), size = (high - low) / (1.0 - 2.0 * kMargin);
    camera.target = camera.right * middle.x() + camera.up * middle.y() + camera.toward * middle.z();
    pixel = std::max({pixel, size.x() / width, size.y() / height});
  }
  for (Camera& camera : cameras) camera.pixel = pixel > 0.0 ? pixel : 1.0;
}

Canvas::Canvas(const Camera& camera)
    : camera_(camera),
      columns_(std::int64_t{kSamples} * camera.width),
      rows_(std::int64_t{kSamples} * camera.height),
      samples_(static_cast<std::size_t>(columns_ * rows_), Sample{kFar, {255.f, 255.f, 255.f}}) {}

Canvas::Sample& Canvas::at(std::int64_t column, std::int64_t row) {
  return samples_[static_cast<std::size_t>(row * columns_ + column)];
}

void Canvas::draw(const TriangleMesh& mesh, const Paint& paint, double ambient) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> nearest(samples_.size(), kNone);
  std::vector<Vec3> seen;
  seen.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) {
    const Vec3 there = camera_.projected(v);
    seen.emplace_back(kSamples * there.x(), kSamples * there.y(), there.z());
  }
  const auto clamped = [](double value, std::int64_t maximum) {
    return static_cast<std::int64_t>(std::clamp(value, -1.0, static_cast<double>(maximum)));
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 &a = seen[mesh.triangles[t][0]], &b = seen[mesh.triangles[t][1]],
               &c = seen[mesh.triangles[t][2]];
    const Vec2 plane_a = a.head<2>(), plane_b = b.head<2>(), plane_c = c.head<2>();
    const double area = twice_area(plane_a, plane_b, plane_c);
    if (area == 0.0 || !std::isfinite(area)) continue;
    const std::int64_t left = std::max<std::int64_t>(
        0, clamped(std::ceil(std::min({a.x(), b.x(), c.x()}) - 0.5), columns_));
    const std::int64_t right = std::min(
        columns_ - 1, clamped(std::floor(std::max({a.x(), b.x(), c.x()}) - 0.5), columns_));
    const std::int64_t top =
        std::max<std::int64_t>(0, clamped(std::ceil(std::min({a.y(), b.y(), c.y()}) - 0.5), rows_));
    const std::int64_t bottom =
        std::min(rows_ - 1, clamped(std::floor(std::max({a.y(), b.y(), c.y()}) - 0.5), rows_));
    for (std::int64_t row = top; row <= bottom; ++row) {
      const double y = static_cast<double>(row) + 0.5;
      for (std::int64_t column = left; column <= right; ++column) {
        const double x = static_cast<double>(column) + 0.5;
        const double v = twice_area(plane_a, {x, y}, plane_c) / area;
        const double w = twice_area(plane_a, plane_b, {x, y}) / area;
        if (v < 0.0 || w < 0.0 || v + w > 1.0) continue;
        const double nearness = a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z());
        Sample& sample = at(column, row);
        if (nearness <= sample.nearness) continue;
        sample.nearness = nearness;
        nearest[static_cast<std::size_t>(row * columns_ + column)] = t;
      }
    }
  }
  const Vec3 lamp =
      camera_.right * light().x() + camera_.up * light().y() + camera_.toward * light().z();
  for (std::int64_t row = 0; row < rows_; ++row) {
    std::uint32_t asked = kNone;  // the triangle of the last answer, and its pixel
    std::int64_t asked_pixel = -1;
    Rgb base{};
    for (std::int64_t column = 0; column < columns_; ++column) {
      const std::uint32_t t = nearest[static_cast<std::size_t>(row * columns_ + column)];
      if (t == kNone) continue;
      Sample& sample = at(column, row);
      const auto& [a, b, c] = mesh.triangles[t];
      Vec3 normal = (mesh.vertices[b] - mesh.vertices[a])
                        .cross(mesh.vertices[c] - mesh.vertices[a])
                        .normalized();
      const bool behind = normal.dot(camera_.toward) < 0.0;
      if (behind) normal = -normal;
      if (t != asked || column / kSamples != asked_pixel) {
        const double x = (static_cast<double>(column) + 0.5) / kSamples - 0.5 * camera_.width;
        const double y = 0.5 * camera_.height - (static_cast<double>(row) + 0.5) / kSamples;
        base = paint(t,
                     camera_.target + camera_.right * (x * camera_.pixel) +
                         camera_.up * (y * camera_.pixel) + camera_.toward * sample.nearness,
                     behind);
        asked = t;
        asked_pixel = column / kSamples;
      }
      sample.colour = shaded(base, ambient + (1.0 - ambient) * std::max(0.0, normal.dot(lamp)));
    }
  }
}

void Canvas::dot(const Vec3& seen, int size, double bias, const std::array<float, 3>& colour) {
  if (!seen.allFinite()) return;
  const double x = kSamples * seen.x() - 0.5 * size, y = kSamples * seen.y() - 0.5 * size;
  if (x < 0.0 || y < 0.0 || x + size > static_cast<double>(columns_) ||
      y + size > static_cast<double>(rows_)) {
    return;
  }
  const auto left = static_cast<std::int64_t>(x), top = static_cast<std::int64_t>(y);
  for (std::int64_t row = top; row < std::min(rows_, top + size); ++row) {
    for (std::int64_t column = left; column < std::min(columns_, left + size); ++column) {
      Sample& sample = at(column, row);
      if (seen.z() + bias < sample.nearness) continue;
      sample.nearness = std::max(sample.nearness, seen.z());
      sample.colour = colour;
    }
  }
}

void Canvas::draw(std::span<const Vec3> points, const Rgb& colour) {
  constexpr double kPale = 1.5, kDark = 0.55;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& point : points) {
    const double nearness = camera_.projected(point).z();
    low = std::min(low, nearness);
    high = std::max(high, nearness);
  }
  for (const Vec3& point : points) {
    const Vec3 seen = camera_.projected(point);
    const double share = high > low ? (seen.z() - low) / (high - low) : 1.0;
    dot(seen, 2 * kSamples, 0.0, shaded(colour, kPale + share * (kDark - kPale)));
  }
}

void Canvas::draw(std::span<const std::array<Vec3, 2>> lines, const Rgb& colour) {
  const double bias = kHidden * camera_.width * camera_.pixel;
  const double longest = 2.0 * (camera_.width + camera_.height);
  for (const auto& [from, to] : lines) {
    const Vec3 a = camera_.projected(from), b = camera_.projected(to);
    const double length = std::min((b - a).head<2>().norm(), longest);
    const int steps = 1 + static_cast<int>(length * kSamples);
    for (int i = 0; i <= steps; ++i) {
      dot(a + (b - a) * (static_cast<double>(i) / steps), 3, bias, shaded(colour, 1.0));
    }
  }
}

bool Canvas::is_visible(const Vec3& point) const {
  const Vec3 there = camera_.projected(point);
  if (!(there.x() >= 0.0 && there.x() < camera_.width && there.y() >= 0.0 &&
        there.y() < camera_.height)) {
    return false;
  }
  const auto column = static_cast<std::int64_t>(kSamples * there.x());
  const auto row = static_cast<std::int64_t>(kSamples * there.y());
  const Sample& sample = samples_[static_cast<std::size_t>(row * columns_ + column)];
  return there.z() + kHidden * camera_.width * camera_.pixel >= sample.nearness;
}

std::vector<Rgb> Canvas::picture() const {
  std::vector<Rgb> pixels;
  pixels.reserve(std::size_t{camera_.width} * camera_.height);
  for (std::int64_t row = 0; row < rows_; row += kSamples) {
    for (std::int64_t column = 0; column < columns_; column += kSamples) {
      std::array<float, 3> sum{};
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const std::int64_t place = (row + i / kSamples) * columns_ + column + i % kSamples;
        const Sample& sample = samples_[static_cast<std::size_t>(place)];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += sample.colour[k];
      }
      Rgb pixel{};
      for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>(sum[k] / (kSamples * kSamples) + 0.5f);
      }
      pixels.push_back(pixel);
    }
  }
  return pixels;
}

}  // namespace clast::report_detail
