#pragma once
/// Software rendering of meshes and points.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/files/png.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::report_detail {

/// Orthographic camera with square pixels.
struct Camera {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ(),
       toward = -Vec3::UnitY();  ///< unit vectors; `toward` points to the viewer
  Vec3 target = Vec3::Zero();    ///< centre of the image, m
  double pixel = 1.0;            ///< side length of a pixel, m
  std::uint32_t width = 0, height = 0;

  /// Projects a point to the image. Returns its position in pixels right of and below the top left
  /// corner, and its distance from the target towards the viewer, m.
  Vec3 projected(const Vec3& point) const;
};

/// Makes a camera that looks at its target from the direction `toward`.
Camera make_camera(const Vec3& toward);

/// Sets targets and common scale of several cameras so that all points are in their images.
void frame(std::span<Camera> cameras, std::span<const Vec3> points, std::uint32_t width,
           std::uint32_t height);

/// Image with depth buffer and white background.
class Canvas {
 public:
  explicit Canvas(const Camera& camera);

  /// Function that returns the unshaded colour of a point on a triangle. `behind` is true for back
  /// faces.
  using Paint = std::function<Rgb(std::uint32_t triangle, const Vec3& place, bool behind)>;
  /// Draws a mesh, lit from the upper left.
  /// @param ambient  fraction of ambient light, 0 to 1
  void draw(const TriangleMesh& mesh, const Paint& paint, double ambient = 0.42);
  /// Draws points as dots of two pixels. Nearer dots are darker.
  void draw(std::span<const Vec3> points, const Rgb& colour);
  /// Draws the visible parts of lines, 1.5 pixels wide.
  void draw(std::span<const std::array<Vec3, 2>> lines, const Rgb& colour);

  /// True if a point is not hidden by drawn triangles.
  bool is_visible(const Vec3& point) const;

  const Camera& camera() const { return camera_; }
  std::vector<Rgb> picture() const;  ///< colours of the pixels, row-major from the top

 private:
  struct Sample {
    double nearness;
    std::array<float, 3> colour;
  };
  void dot(const Vec3& seen, int size, double bias, const std::array<float, 3>& colour);
  Sample& at(std::int64_t column, std::int64_t row);

  Camera camera_;
  std::int64_t columns_, rows_;  ///< number of samples; there are several per pixel
  std::vector<Sample> samples_;
};

}  // namespace clast::report_detail
