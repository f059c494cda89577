#pragma once
/// Rendered photos of a textured body on a table with four markers, and their cameras.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "core/pose.hpp"
#include "core/random.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

/// Lengths are relative to the largest extent of the body.
struct RenderedPhotosRecipe {
  int width = 1400, height = 1050;  ///< px
  double focal_length = 1550.0;     ///< px
  /// Number of photos of each ring around the body, and elevation of the ring, rad.
  std::array<std::size_t, 2> photos = {24, 12};
  std::array<double, 2> elevations = {20.0 * kPi / 180.0, 52.0 * kPi / 180.0};
  double distance = 2.8;          ///< of the cameras from the centre of the body
  double marker_side = 0.25;      ///< of the black square of a marker
  double marker_distance = 0.95;  ///< of the markers from the centre of the body
  double grey_noise = 1.5;        ///< standard deviation of a grey value, of 255
  double camera_noise = 5e-5;     ///< standard deviation of rotations in the model, rad
  double unit = 0.4;              ///< of the model, m
};

/// Value noise of a lattice, 0 to 1.
inline float lattice_noise(int x, int y, int z, std::uint32_t salt) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 73856093U ^
                    static_cast<std::uint32_t>(y) * 19349663U ^
                    static_cast<std::uint32_t>(z) * 83492791U ^ salt;
  h = (h ^ (h >> 16)) * 0x7feb352dU;
  h = (h ^ (h >> 15)) * 0x846ca68bU;
  return static_cast<float>(h >> 16) / 65535.0f;
}

/// Sum of value noise at cells of 0.2 to 0.006, 0 to 1.
inline double rock_texture(const Vec3& position, std::uint32_t seed) {
  float sum = 0.0f, weights = 0.0f, cell = 0.2f, weight = 1.0f;
  const auto mix = [](float a, float b, float share) { return a + share * (b - a); };
  for (std::uint32_t octave = 0; octave < 6; ++octave, cell *= 0.5f, weight *= 0.85f) {
    const std::uint32_t salt = (seed * 16 + octave) * 0x9e3779b9U;
    std::array<int, 3> low{};
    std::array<float, 3> share{};
    for (std::size_t k = 0; k < 3; ++k) {
      const float at = static_cast<float>(position[static_cast<int>(k)]) / cell;
      low[k] = static_cast<int>(std::floor(at));
      const float part = at - static_cast<float>(low[k]);
      share[k] = part * part * (3.0f - 2.0f * part);
    }
    const auto [x, y, z] = low;
    const auto along_x = [&](int row, int layer) {
      return mix(lattice_noise(x, row, layer, salt), lattice_noise(x + 1, row, layer, salt),
                 share[0]);
    };
    const auto plane = [&](int layer) {
      return mix(along_x(y, layer), along_x(y + 1, layer), share[1]);
    };
    sum += weight * mix(plane(z), plane(z + 1), share[2]);
    weights += weight;
  }
  return std::clamp(0.5 + 2.0 * (static_cast<double>(sum / weights) - 0.5), 0.0, 1.0);
}

/// Renders photos of a body on the table z = 0.
class PhotoRenderer {
 public:
  /// @param body  closed, outward; its largest extent is one metre
  /// @param scene_from_body  pose of the body on the table
  PhotoRenderer(const TriangleMesh& body, const Pose& scene_from_body,
                const RenderedPhotosRecipe& recipe)
      : placed_(body), recipe_(recipe), body_from_scene_(scene_from_body.inverse()) {
    for (Vec3& v : placed_.vertices) v = scene_from_body * v;
    const Bounds box = bounds(placed_);
    centre_ = 0.5 * (box.low + box.high);
    for (std::size_t ring = 0; ring < 2; ++ring) {
      for (std::size_t i = 0; i < recipe.photos[ring]; ++i) {
        const double azimuth =
            2.0 * kPi * static_cast<double>(i) / static_cast<double>(recipe.photos[ring]);
        const double elevation = recipe.elevations[ring];
        const Vec3 towards(std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        cameras_.push_back(looking_at_centre(centre_ + recipe.distance * towards));
      }
    }
  }

  /// Writes the photos to `folder/images` and a COLMAP model with a unit of its own to
  /// `folder/sparse`.
  void write(const std::filesystem::path& folder, Random& random) const {
    std::filesystem::create_directories(folder / "images");
    std::vector<std::uint64_t> seeds;
    for (std::size_t i = 0; i < cameras_.size(); ++i) seeds.push_back(random.next_bits());
    parallel_for(cameras_.size(), 0, [&](std::size_t i) {
      cv::imwrite((folder / "images" / name_of(i)).string(), render(cameras_[i], seeds[i]),
                  {cv::IMWRITE_JPEG_QUALITY, 90});
    });
    write_model(folder / "sparse", random);
  }

 private:
  static std::string name_of(std::size_t photo) {
    return "photo_" + std::to_string(100 + photo) + ".jpg";
  }

  Pose looking_at_centre(const Vec3& eye) const {
    const Vec3 ahead = (centre_ - eye).normalized();
    const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
    Mat3 rotation;
    rotation << right.transpose(), ahead.cross(right).transpose(), ahead.transpose();
    return {-(rotation * eye), Quat(rotation)};
  }

  /// Depths of the body, infinite beside it.
  std::vector<double> body_depths(const Pose& camera) const {
    const int w = recipe_.width, h = recipe_.height;
    std::vector<double> depths(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
                               std::numeric_limits<double>::infinity());
    std::vector<Vec3> pixels;  // column, row, inverse depth
    for (const Vec3& v : placed_.vertices) {
      const Vec3 p = camera * v;
      pixels.push_back({recipe_.focal_length * p.x() / p.z() + 0.5 * (w - 1),
                        recipe_.focal_length * p.y() / p.z() + 0.5 * (h - 1), 1.0 / p.z()});
    }
    for (const auto& [a, b, c] : placed_.triangles) {
      const Vec3 &p = pixels[a], &q = pixels[b], &r = pixels[c];
      const Vec2 u = (q - p).head<2>(), v = (r - p).head<2>();
      const double area = u.x() * v.y() - u.y() * v.x();
      if (area == 0.0) continue;
      const int left = std::max(0, static_cast<int>(std::ceil(std::min({p.x(), q.x(), r.x()}))));
      const int right =
          std::min(w - 1, static_cast<int>(std::floor(std::max({p.x(), q.x(), r.x()}))));
      const int top = std::max(0, static_cast<int>(std::ceil(std::min({p.y(), q.y(), r.y()}))));
      const int bottom =
          std::min(h - 1, static_cast<int>(std::floor(std::max({p.y(), q.y(), r.y()}))));
      for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
          const Vec2 d(x - p.x(), y - p.y());
          const double s = (d.x() * v.y() - d.y() * v.x()) / area;
          const double t = (u.x() * d.y() - u.y() * d.x()) / area;
          if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
          double& depth = depths[static_cast<std::size_t>(y * w + x)];
          depth = std::min(depth, 1.0 / (p.z() + s * (q.z() - p.z()) + t * (r.z() - p.z())));
        }
      }
    }
    return depths;
  }

  /// Brightness of a marker (DICT_4X4_50, ids 0 to 3) or of its white border; empty beside them.
  std::optional<double> marker_brightness(const Vec2& place) const {
    constexpr std::array<std::uint16_t, 4> kBits = {0xb532, 0x0f9a, 0x332d, 0x9946};
    constexpr double kBlack = 0.05, kWhite = 0.95;
    for (std::size_t id = 0; id < 4; ++id) {
      const double azimuth = 0.5 * kPi * static_cast<double>(id) + 0.6;
      const Vec2 off = place - centre_.head<2>() -
                       recipe_.marker_distance * Vec2(std::cos(azimuth), std::sin(azimuth));
      const double cell = recipe_.marker_side / 6.0;
      const double column = off.x() / cell + 3.0, row = 3.0 - off.y() / cell;
      if (std::min(column, row) < -1.0 || std::max(column, row) > 7.0) continue;
      if (std::min(column, row) < 0.0 || std::max(column, row) > 6.0) return kWhite;
      const int i = static_cast<int>(column) - 1, k = static_cast<int>(row) - 1;
      if (std::min(i, k) < 0 || std::max(i, k) > 3) return kBlack;
      return kBits[id] >> (15 - 4 * k - i) & 1 ? kWhite : kBlack;
    }
    return {};
  }

  /// Brightness of the table in a pixel. Markers are averaged over the pixel.
  double table_pixel(const Vec3& eye, const Mat3& scene_from_camera, double x, double y) const {
    constexpr int kPerSide = 4;
    constexpr double kBackground = 0.6, kHalfTable = 3.0;
    const auto place_at = [&](double column, double row) {
      const Vec3 ray = scene_from_camera * ray_of(column, row);
      return ray.z() < 0.0 ? Vec3(eye - eye.z() / ray.z() * ray) : Vec3(1e9, 0.0, 0.0);
    };
    const Vec3 middle = place_at(x, y);
    if ((middle - centre_).norm() > kHalfTable) return kBackground;
    const double table = 0.15 + 0.6 * rock_texture(middle, 2);
    const double off = (middle - centre_).head<2>().norm() - recipe_.marker_distance;
    if (std::abs(off) > recipe_.marker_side) return table;
    double sum = 0.0;
    for (int i = 0; i < kPerSide * kPerSide; ++i) {
      const double right = (i % kPerSide + 0.5) / kPerSide - 0.5;
      const double down = (std::floor(i / kPerSide) + 0.5) / kPerSide - 0.5;
      sum += marker_brightness(place_at(x + right, y + down).head<2>()).value_or(table);
    }
    return sum / (kPerSide * kPerSide);
  }

  Vec3 ray_of(double x, double y) const {
    return {(x - 0.5 * (recipe_.width - 1.0)) / recipe_.focal_length,
            (y - 0.5 * (recipe_.height - 1.0)) / recipe_.focal_length, 1.0};
  }

  cv::Mat render(const Pose& camera, std::uint64_t seed) const {
    Random random(seed);
    const std::vector<double> depths = body_depths(camera);
    const Pose scene_from_camera = camera.inverse();
    const Mat3 turn = scene_from_camera.rotation.toRotationMatrix();
    cv::Mat photo(recipe_.height, recipe_.width, CV_8UC1);
    for (int y = 0; y < recipe_.height; ++y) {
      for (int x = 0; x < recipe_.width; ++x) {
        const double depth = depths[static_cast<std::size_t>(y * recipe_.width + x)];
        double brightness = 0.0;
        if (std::isfinite(depth)) {
          const Vec3 place = scene_from_camera * (depth * ray_of(x, y));
          brightness = 0.2 + 0.7 * rock_texture(body_from_scene_ * place, 1);
        } else {
          brightness = table_pixel(scene_from_camera.translation, turn, x, y);
        }
        const double grey = 255.0 * brightness + recipe_.grey_noise * random.normal();
        photo.at<unsigned char>(y, x) = cv::saturate_cast<unsigned char>(grey);
      }
    }
    return photo;
  }

  /// Writes cameras and sparse points.
  void write_model(const std::filesystem::path& folder, Random& random) const {
    std::filesystem::create_directories(folder);
    const Pose model_from_scene{Vec3(0.3, -1.2, 2.1), random.rotation()};
    std::ofstream cameras(folder / "cameras.txt"), images(folder / "images.txt"),
        points(folder / "points3D.txt");
    for (std::ofstream* file : {&cameras, &images, &points}) file->precision(17);
    cameras << "1 PINHOLE " << recipe_.width << ' ' << recipe_.height << ' ' << recipe_.focal_length
            << ' ' << recipe_.focal_length << ' ' << 0.5 * recipe_.width << ' '
            << 0.5 * recipe_.height << '\n';
    for (std::size_t i = 0; i < cameras_.size(); ++i) {
      Pose camera = cameras_[i];
      const Quat off(
          Eigen::AngleAxisd(recipe_.camera_noise * random.normal(), random.unit_vector()));
      camera.rotation = off * camera.rotation;
      const Pose from_model = camera * model_from_scene.inverse();
      const Quat& q = from_model.rotation;
      const Vec3 t = from_model.translation / recipe_.unit;
      images << i + 1 << ' ' << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' '
             << t.x() << ' ' << t.y() << ' ' << t.z() << " 1 " << name_of(i) << "\n\n";
    }
    write_sparse_points(points, model_from_scene, random);
  }

  /// Points of the body and of the table that are seen in three photos or more.
  void write_sparse_points(std::ofstream& file, const Pose& model_from_scene,
                           Random& random) const {
    constexpr int kPoints = 6000;
    constexpr double kNoise = 0.0005;
    const SurfaceSampler sampler(placed_);
    std::vector<std::vector<double>> depths;
    for (const Pose& camera : cameras_) depths.push_back(body_depths(camera));
    for (int i = 0; i < kPoints; ++i) {
      const Vec3 place = i % 2 == 0 ? sampler.draw(random).point
                                    : Vec3(centre_.x() + random.uniform(-1.5, 1.5),
                                           centre_.y() + random.uniform(-1.5, 1.5), 0.0);
      std::string track;
      int seen = 0;
      for (std::size_t k = 0; k < cameras_.size(); ++k) {
        const Vec3 p = cameras_[k] * place;
        const double x = recipe_.focal_length * p.x() / p.z() + 0.5 * (recipe_.width - 1.0);
        const double y = recipe_.focal_length * p.y() / p.z() + 0.5 * (recipe_.height - 1.0);
        if (p.z() <= 0.0 || x < 0.0 || y < 0.0) continue;
        const int column = static_cast<int>(std::lround(x)), row = static_cast<int>(std::lround(y));
        if (column >= recipe_.width || row >= recipe_.height) continue;
        const auto pixel = static_cast<std::size_t>(row * recipe_.width + column);
        if (p.z() > depths[k][pixel] + 0.01) continue;
        track += " " + std::to_string(k + 1) + " 0";
        ++seen;
      }
      if (seen < 3) continue;
      const Vec3 noise(random.normal(), random.normal(), random.normal());
      const Vec3 position = model_from_scene * (place + kNoise * noise) / recipe_.unit;
      file << i + 1 << ' ' << position.x() << ' ' << position.y() << ' ' << position.z()
           << " 128 128 128 0.5" << track << '\n';
    }
  }

  TriangleMesh placed_;
  RenderedPhotosRecipe recipe_;
  Pose body_from_scene_;
  Vec3 centre_ = Vec3::Zero();
  std::vector<Pose> cameras_;  ///< camera_from_scene
};

/// Pose of a body that touches the table z = 0 with its lowest point.
inline Pose placed_on_table(const TriangleMesh& body, const Quat& rotation) {
  Bounds box;
  for (const Vec3& v : body.vertices) box.include(rotation * v);
  return {
      Vec3(-0.5 * (box.low.x() + box.high.x()), -0.5 * (box.low.y() + box.high.y()), -box.low.z()),
      rotation};
}

}  // namespace clast
