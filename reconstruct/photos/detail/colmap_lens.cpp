#include <map>

#include "core/error.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

CameraIntrinsics make_colmap_intrinsics(const std::string& model, int width, int height,
                                        const std::vector<double>& p) {
  // Parameters of COLMAP's models, in its order: one focal length or two, centre, and distortion.
  struct Layout {
    std::size_t focals;
    std::size_t distortions;
    bool fisheye;
  };
  static const std::map<std::string, Layout> kModels = {
      {"SIMPLE_PINHOLE", {1, 0, false}}, {"PINHOLE", {2, 0, false}},
      {"SIMPLE_RADIAL", {1, 1, false}},  {"RADIAL", {1, 2, false}},
      {"OPENCV", {2, 4, false}},         {"FULL_OPENCV", {2, 8, false}},
      {"OPENCV_FISHEYE", {2, 4, true}},  {"SIMPLE_RADIAL_FISHEYE", {1, 1, true}},
      {"RADIAL_FISHEYE", {1, 2, true}}};
  const auto known = kModels.find(model);
  if (known == kModels.end()) {
    std::string names;
    for (const auto& [name, layout] : kModels) names += " " + name;
    throw InputError("camera model " + model + " isn't known; known are" + names);
  }
  const Layout& layout = known->second;
  if (p.size() != layout.focals + 2 + layout.distortions) {
    throw InputError("camera model " + model + " has " + std::to_string(p.size()) +
                     " parameters instead of " +
                     std::to_string(layout.focals + 2 + layout.distortions));
  }
  CameraIntrinsics lens{.width = width, .height = height, .fx = p[0], .fy = p[layout.focals - 1]};
  lens.cx = p[layout.focals] - 0.5;
  lens.cy = p[layout.focals + 1] - 0.5;
  lens.fisheye = layout.fisheye;
  const double* k = p.data() + layout.focals + 2;
  if (model == "OPENCV" || model == "FULL_OPENCV") {
    lens.radial = {k[0], k[1], 0.0, 0.0};
    lens.p1 = k[2];
    lens.p2 = k[3];
    if (layout.distortions == 8) {
      lens.radial[2] = k[4];
      lens.radial_divisor = {k[5], k[6], k[7]};
    }
  } else {
    for (std::size_t i = 0; i < layout.distortions; ++i) lens.radial[i] = k[i];
  }
  return lens;
}

}  // namespace clast::photos_detail
