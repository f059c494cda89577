#include <cstdint>
#include <map>

#include "reconstruct/photos/detail/json_model.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

namespace {

using nlohmann::json;

/// Version of the file's layout as one number: 1.2.5 is 10205.
std::int64_t version_of(const json& root) {
  if (!root.contains("version")) return 10000;
  std::int64_t number = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    number = 100 * number + parse_json_count(root.at("version").at(i));
  }
  return number;
}

CameraIntrinsics read_alicevision_lens(const json& intrinsic, std::int64_t version) {
  CameraIntrinsics lens{.width = parse_json_count(intrinsic.at("width")),
                        .height = parse_json_count(intrinsic.at("height"))};
  if (version < 10200) {
    lens.fx = lens.fy = parse_json_number(intrinsic.at("pxFocalLength"));
  } else if (version < 10202) {
    lens.fx = parse_json_number(intrinsic.at("pxFocalLength").at(0));
    lens.fy = parse_json_number(intrinsic.at("pxFocalLength").at(1));
  } else {
    lens.fx = parse_json_number(intrinsic.at("focalLength")) /
              parse_json_number(intrinsic.at("sensorWidth")) * lens.width;
    const double ratio =
        intrinsic.contains("pixelRatio") ? parse_json_number(intrinsic.at("pixelRatio")) : 1.0;
    lens.fy = version < 10205 ? lens.fx / ratio : lens.fx * ratio;
  }
  lens.cx = parse_json_number(intrinsic.at("principalPoint").at(0));
  lens.cy = parse_json_number(intrinsic.at("principalPoint").at(1));
  if (version >= 10201) {  // since then from the middle
    lens.cx += 0.5 * lens.width;
    lens.cy += 0.5 * lens.height;
  }
  std::vector<double> k;
  if (intrinsic.contains("distortionParams") && intrinsic.at("distortionParams").is_array()) {
    for (const json& value : intrinsic.at("distortionParams"))
      k.push_back(parse_json_number(value));
  }
  // Since layout 1.2.6 the kind of distortion has a key of its own.
  std::string kind = intrinsic.at("type").get<std::string>();
  if (intrinsic.contains("distortionType") && kind == "pinhole") {
    kind = intrinsic.at("distortionType").get<std::string>();
    if (kind.empty() || kind == "none") kind = "pinhole";
  }
  const std::map<std::string, std::size_t> known = {
      {"pinhole", 0},  {"radial1", 1}, {"radialk1", 1}, {"radial3", 3},
      {"radialk3", 3}, {"brown", 5},   {"fisheye4", 4}, {"fisheye", 4}};
  if (!known.contains(kind)) {
    throw InputError("camera type " + kind +
                     " isn't known; choose radial3, brown or fisheye4 in Meshroom's CameraInit");
  }
  const std::size_t count = known.at(kind);
  if (k.size() < count)
    throw InputError("camera type " + kind + " has too few distortion parameters");
  if (kind == "brown") {
    lens.radial = {k[0], k[1], k[2], 0.0};
    lens.p1 = k[3];
    lens.p2 = k[4];
  } else {
    lens.fisheye = kind.starts_with("fisheye");
    for (std::size_t i = 0; i < count; ++i) lens.radial[i] = k[i];
  }
  return lens;
}

PhotoModel read_alicevision_model(const json& root) {
  PhotoModel model;
  model.source = "AliceVision";
  const std::int64_t version = version_of(root);
  std::map<std::string, std::size_t> lens_of_id;
  for (const json& intrinsic : root.at("intrinsics")) {
    lens_of_id[parse_json_id(intrinsic.at("intrinsicId"))] = model.lenses.size();
    model.lenses.push_back(read_alicevision_lens(intrinsic, version));
  }
  std::map<std::string, Pose> poses;
  if (!root.contains("poses")) {
    throw InputError("holds no camera poses; give the file that StructureFromMotion wrote");
  }
  for (const json& item : root.at("poses")) {
    const json& transform = item.at("pose").at("transform");
    Mat3 rotation;  // column by column
    for (std::size_t i = 0; i < 9; ++i) {
      rotation(static_cast<int>(i % 3), static_cast<int>(i / 3)) =
          parse_json_number(transform.at("rotation").at(i));
    }
    const Quat quaternion =
        rotation_from_matrix(rotation, "pose " + parse_json_id(item.at("poseId")));
    poses[parse_json_id(item.at("poseId"))] = {
        -(quaternion * parse_json_vector(transform.at("center"))), quaternion};
  }
  std::map<std::string, std::uint32_t> photo_of;
  for (const json& view : root.at("views")) {
    const std::string pose = parse_json_id(view.at("poseId"));
    const std::string lens = parse_json_id(view.at("intrinsicId"));
    if (!poses.contains(pose)) {
      ++model.photos_without_pose;
      continue;
    }
    const std::string name = view.at("path").get<std::string>();
    if (!lens_of_id.contains(lens))
      throw InputError(name + " refers to a camera that does not exist");
    photo_of[parse_json_id(view.at("viewId"))] = static_cast<std::uint32_t>(model.photos.size());
    model.photos.push_back({name, {}, lens_of_id[lens], poses[pose]});
  }
  if (!root.contains("structure")) return model;
  for (const json& landmark : root.at("structure")) {
    SparsePoint point{parse_json_vector(landmark.at("X")), {}};
    for (const json& observation : landmark.at("observations")) {
      const auto photo = photo_of.find(parse_json_id(observation.at("observationId")));
      if (photo != photo_of.end()) point.photos.push_back(photo->second);
    }
    model.points.push_back(std::move(point));
  }
  return model;
}

}  // namespace

PhotoModel read_alicevision(const std::filesystem::path& file) {
  return read_json_model(file, read_alicevision_model);
}

}  // namespace clast::photos_detail
