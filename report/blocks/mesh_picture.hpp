#pragma once
/// Pictures of meshes and points, drawn in memory without a display.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/files/png.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::report_detail {

/// Parallel rays that meet a rectangle of square pixels.
struct Camera {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ(), toward = -Vec3::UnitY();  ///< unit; to the eye
  Vec3 target = Vec3::Zero();  ///< in the middle of the picture, m
  double pixel = 1.0;          ///< side, m
  std::uint32_t width = 0, height = 0;

  /// Right and down from the top left corner, in pixels, and nearness to the eye, m.
  Vec3 seen(const Vec3& point) const;
};

/// A camera in direction `toward` of what it looks at, z up as far as it can be; nothing is in the
/// picture yet.
Camera make_camera(const Vec3& toward);

/// Moves the cameras so that every point is in each picture, in the middle and at the same scale.
/// Pictures without points have pixels of 1 m.
void frame(std::span<Camera> cameras, std::span<const Vec3> points, std::uint32_t width,
           std::uint32_t height);

/// A picture that is drawn on: near things hide far ones. White where nothing is.
class Canvas {
 public:
  explicit Canvas(const Camera& camera);

  /// Colour of a place on a triangle before it is shaded. `behind`: its back is seen.
  using Paint = std::function<Rgb(std::uint32_t triangle, const Vec3& place, bool behind)>;
  /// Triangles shaded by a light from the upper left of the eye; `paint` is called once for a pixel
  /// of each.
  /// @param ambient  light that comes from all around, 0 to 1; much of it keeps colours readable
  void draw(const TriangleMesh& mesh, const Paint& paint, double ambient = 0.42);
  /// Dots of two pixels, nearer ones darker.
  void draw(std::span<const Vec3> points, const Rgb& colour);
  /// Lines, of a pixel and a half, where nothing hides them.
  void draw(std::span<const std::array<Vec3, 2>> lines, const Rgb& colour);

  /// Is nothing nearer the eye than this point? Half a per cent of the picture's width more does
  /// not count.
  bool sees(const Vec3& point) const;

  const Camera& camera() const { return camera_; }
  std::vector<Rgb> picture() const;  ///< row by row from the top

 private:
  struct Sample {
    double nearness;
    std::array<float, 3> colour;
  };
  void dot(const Vec3& seen, int size, double bias, const std::array<float, 3>& colour);
  Sample& at(std::int64_t column, std::int64_t row);

  Camera camera_;
  std::int64_t columns_, rows_;  ///< samples: several for each pixel
  std::vector<Sample> samples_;
};

}  // namespace clast::report_detail
