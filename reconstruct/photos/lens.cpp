#include "reconstruct/photos/lens.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

constexpr int kNewtonSteps = 50;
constexpr double kNewtonEnd = 1e-12;  ///< of the tangent of an angle

struct Distorted {
  Vec2 position;
  Eigen::Matrix2d slope;  ///< derivative by the undistorted place
};

Distorted distorted(const CameraIntrinsics& lens, const Vec2& p) {
  const auto& k = lens.radial;
  const auto& d = lens.radial_divisor;
  const double a = p.x(), b = p.y(), r2 = p.squaredNorm();
  const double above = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * (k[2] + r2 * k[3])));
  const double below = 1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[2]));
  const double above_slope = k[0] + r2 * (2.0 * k[1] + r2 * (3.0 * k[2] + r2 * 4.0 * k[3]));
  const double below_slope = d[0] + r2 * (2.0 * d[1] + r2 * 3.0 * d[2]);
  const double g = above / below;
  const double g_slope = (above_slope - g * below_slope) / below;  // by r^2
  Distorted result;
  result.position = {g * a + 2.0 * lens.p1 * a * b + lens.p2 * (r2 + 2.0 * a * a),
                     g * b + lens.p1 * (r2 + 2.0 * b * b) + 2.0 * lens.p2 * a * b};
  const double cross = 2.0 * a * b * g_slope + 2.0 * lens.p1 * a + 2.0 * lens.p2 * b;
  result.slope << g + 2.0 * a * a * g_slope + 2.0 * lens.p1 * b + 6.0 * lens.p2 * a, cross, cross,
      g + 2.0 * b * b * g_slope + 6.0 * lens.p1 * b + 2.0 * lens.p2 * a;
  return result;
}

}  // namespace

void CameraIntrinsics::check() const {
  const auto refuse = [](const std::string& what, double value) {
    throw InputError("camera: " + what + " = " + format_significant(value, 6) +
                     " is impossible for a lens; check the camera model");
  };
  if (width < 1 || width > 100000) refuse("width", width);
  if (height < 1 || height > 100000) refuse("height", height);
  const double size = std::hypot(width, height);
  for (const double f : {fx, fy}) {
    if (!(f > 0.01 * size && f < 1000.0 * size)) refuse("focal length in pixels", f);
  }
  if (!(std::abs(cx - 0.5 * width) < size)) refuse("principal point x", cx);
  if (!(std::abs(cy - 0.5 * height) < size)) refuse("principal point y", cy);
  if (!(std::abs(skew) < fx)) refuse("skew", skew);
  for (const double value : {radial[0], radial[1], radial[2], radial[3], radial_divisor[0],
                             radial_divisor[1], radial_divisor[2], p1, p2}) {
    if (!(std::abs(value) < 1e6)) refuse("distortion", value);
  }
}

std::optional<Vec2> project(const CameraIntrinsics& lens, const Vec3& in_camera) {
  if (!(in_camera.z() > 0.0)) return std::nullopt;
  Vec2 p(in_camera.x() / in_camera.z(), in_camera.y() / in_camera.z());
  if (lens.fisheye) {
    const double r = p.norm();
    if (r > 0.0) p *= std::atan(r) / r;
  }
  const Distorted there = distorted(lens, p);
  if (!(there.slope.determinant() > 0.0 && there.slope.trace() > 0.0)) return std::nullopt;
  const Vec2& q = there.position;
  return Vec2(lens.fx * q.x() + lens.skew * q.y() + lens.cx, lens.fy * q.y() + lens.cy);
}

std::optional<Vec3> unproject(const CameraIntrinsics& lens, const Vec2& pixel) {
  const double y = (pixel.y() - lens.cy) / lens.fy;
  const Vec2 target((pixel.x() - lens.cx - lens.skew * y) / lens.fx, y);
  Vec2 p = target;
  bool found = false;
  for (int step = 0; step < kNewtonSteps && !found; ++step) {
    const Distorted there = distorted(lens, p);
    const double det = there.slope.determinant();
    if (!(det > 0.0)) return std::nullopt;
    const Vec2 miss = target - there.position;
    const Vec2 move((there.slope(1, 1) * miss.x() - there.slope(0, 1) * miss.y()) / det,
                    (there.slope(0, 0) * miss.y() - there.slope(1, 0) * miss.x()) / det);
    p += move;
    found = move.norm() < kNewtonEnd;
  }
  if (!found) return std::nullopt;
  if (lens.fisheye) {
    const double angle = p.norm();
    if (angle >= 0.5 * kPi) return std::nullopt;
    if (angle > 0.0) p *= std::tan(angle) / angle;
  }
  return Vec3(p.x(), p.y(), 1.0);
}

CameraIntrinsics resized_intrinsics(const CameraIntrinsics& lens, int width, int height) {
  if (width == lens.width && height == lens.height) return lens;
  const double factor = static_cast<double>(width) / lens.width;
  if (std::abs(factor * lens.height - height) > 1.0 + factor) {
    throw InputError("the photo has " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels, but its camera " + std::to_string(lens.width) + " x " +
                     std::to_string(lens.height) +
                     "; give the photos from which the model was made, not cropped or rotated");
  }
  const double factor_y = static_cast<double>(height) / lens.height;
  CameraIntrinsics result = lens;
  result.width = width;
  result.height = height;
  result.fx *= factor;
  result.skew *= factor;
  result.fy *= factor_y;
  // The edge of the photo, not the centre of its first pixel, stays in its place.
  result.cx = (lens.cx + 0.5) * factor - 0.5;
  result.cy = (lens.cy + 0.5) * factor_y - 0.5;
  return result;
}

}  // namespace clast
