#pragma once
/// The rendered photo set, its COLMAP model and its truth.
#include <Eigen/SVD>
#include <map>
#include <sstream>
#include <string>

#include "core/files/text_file.hpp"
#include "reconstruct/photos/model_files.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {

/// True pose of each photo by name.
inline std::map<std::string, Pose> true_poses() {
  std::map<std::string, Pose> poses;
  std::istringstream lines(read_text_file(test_data("photos/synthetic_rock/gt_poses.txt")));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    std::string name;
    Mat3 rotation;
    Pose pose;
    words >> name;
    for (int i = 0; i < 9; ++i) words >> rotation(i / 3, i % 3);
    for (int i = 0; i < 3; ++i) words >> pose.translation[i];
    pose.rotation = Quat(rotation);
    poses[name] = pose;
  }
  return poses;
}

/// The photos with their true cameras, in metres.
inline PhotoModel true_model() {
  PhotoModel model;
  model.lenses.push_back({.width = 1600,
                          .height = 1200,
                          .fx = 1500.0,
                          .fy = 1500.0,
                          .cx = 799.5,
                          .cy = 599.5,
                          .radial = {-0.04, 0.0, 0.0, 0.0}});
  for (const auto& [name, pose] : true_poses()) model.photos.push_back({name, {}, 0, pose});
  model.metric = true;
  return locate_photo_files(std::move(model), test_data("photos/synthetic_rock/images"));
}

inline PhotoModel colmap_model() {
  return locate_photo_files(read_photo_model(test_data("photos/synthetic_rock/colmap_txt")),
                            test_data("photos/synthetic_rock/images"));
}

/// Takes a model to the true frame: scale, rotation and place by least squares over the centres of
/// its cameras (Umeyama 1991).
struct ToTruth {
  double scale = 1.0;
  Pose pose;

  explicit ToTruth(const PhotoModel& model) {
    const std::map<std::string, Pose> truth = true_poses();
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    const auto n = static_cast<double>(model.photos.size());
    for (const Photo& photo : model.photos) {
      from += photo.centre() / n;
      to += truth.at(photo.name).inverse().translation / n;
    }
    Mat3 product = Mat3::Zero();
    double spread = 0.0;
    for (const Photo& photo : model.photos) {
      const Vec3 a = photo.centre() - from;
      product += (truth.at(photo.name).inverse().translation - to) * a.transpose();
      spread += a.squaredNorm();
    }
    const Eigen::JacobiSVD<Mat3> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 sign = Vec3::Ones();
    sign.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Mat3 rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
    scale = svd.singularValues().cwiseProduct(sign).sum() / spread;
    pose = {to - scale * (rotation * from), Quat(rotation)};
  }
  Vec3 operator*(const Vec3& p) const { return pose * (scale * p); }
};

/// True centres of the four markers.
inline std::map<int, Vec3> true_marker_centres() {
  std::map<int, Vec3> centres;
  std::istringstream lines(read_text_file(test_data("photos/synthetic_rock/gt_markers.txt")));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    int id = 0, corner = 0;
    Vec3 p;
    words >> id >> corner >> p.x() >> p.y() >> p.z();
    centres.try_emplace(id, Vec3::Zero()).first->second += 0.25 * p;
  }
  return centres;
}

}  // namespace clast
