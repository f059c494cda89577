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
  double pixel = 1.0;            ///< side length, m
  std::uint32_t width = 0, height = 0;

  /// Projects a point: pixels to the right and down from the top left corner, and depth towards the
  /// viewer, m.
  Vec3 seen(const Vec3& point) const;
};

/// Makes a camera in direction `toward` from its target, with z as upright as possible and an empty
/// image.
Camera make_camera(const Vec3& toward);

/// Fits the cameras to the points: centred and at a common scale. Images without points have pixels
/// of 1 m.
void frame(std::span<Camera> cameras, std::span<const Vec3> points, std::uint32_t width,
           std::uint32_t height);

/// Image with depth buffer on a white background.
class Canvas {
 public:
  explicit Canvas(const Camera& camera);

  /// Returns the unshaded colour of a point on a triangle; `behind` is true for back faces.
  using Paint = std::function<Rgb(std::uint32_t triangle, const Vec3& place, bool behind)>;
  /// Draws shaded triangles, lit from the upper left; `paint` is called once per pixel and
  /// triangle.
  /// @param ambient  fraction of ambient light, 0 to 1
  void draw(const TriangleMesh& mesh, const Paint& paint, double ambient = 0.42);
  /// Draws dots of two pixels, nearer ones darker.
  void draw(std::span<const Vec3> points, const Rgb& colour);
  /// Draws the visible parts of lines, 1.5 pixels wide.
  void draw(std::span<const std::array<Vec3, 2>> lines, const Rgb& colour);

  /// True if the point is visible, with a depth tolerance of 0.5 % of the image width.
  bool is_visible(const Vec3& point) const;

  const Camera& camera() const { return camera_; }
  std::vector<Rgb> picture() const;  ///< row-major from the top

 private:
  struct Sample {
    double nearness;
    std::array<float, 3> colour;
  };
  void dot(const Vec3& seen, int size, double bias, const std::array<float, 3>& colour);
  Sample& at(std::int64_t column, std::int64_t row);

  Camera camera_;
  std::int64_t columns_, rows_;  ///< samples, several per pixel
  std::vector<Sample> samples_;
};

}  // namespace clast::report_detail
