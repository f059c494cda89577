#include <map>

#include "reconstruct/photos/detail/json_model.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

namespace {

using nlohmann::json;

/// A member of a stored object, or of the base class that is stored inside it.
const json& member(const json& object, const char* name) {
  if (!object.contains(name) && object.contains("value0")) return object.at("value0").at(name);
  return object.at(name);
}

const json& data_of(const json& item) { return item.at("value").at("ptr_wrapper").at("data"); }

Lens read_openmvg_lens(const json& data) {
  Lens lens{.width = json_count(member(data, "width")),
            .height = json_count(member(data, "height"))};
  lens.fx = lens.fy = json_number(member(data, "focal_length"));
  lens.cx = json_number(member(data, "principal_point").at(0));
  lens.cy = json_number(member(data, "principal_point").at(1));
  const auto values = [&](const char* name, std::size_t count) {
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) found.push_back(json_number(data.at(name).at(i)));
    return found;
  };
  if (data.contains("disto_k1")) {
    lens.radial[0] = values("disto_k1", 1)[0];
  } else if (data.contains("disto_k3")) {
    const std::vector<double> k = values("disto_k3", 3);
    lens.radial = {k[0], k[1], k[2], 0.0};
  } else if (data.contains("disto_t2")) {
    const std::vector<double> k = values("disto_t2", 5);
    lens.radial = {k[0], k[1], k[2], 0.0};
    lens.p1 = k[3];
    lens.p2 = k[4];
  } else if (data.contains("fisheye")) {
    const std::vector<double> k = values("fisheye", 4);
    lens.fisheye = true;
    lens.radial = {k[0], k[1], k[2], k[3]};
  }
  return lens;
}

PhotoModel read_openmvg_model(const json& root) {
  PhotoModel model;
  model.source = "OpenMVG";
  std::map<std::string, std::size_t> lens_number;
  for (const json& item : root.at("intrinsics")) {
    lens_number[json_id(item.at("key"))] = model.lenses.size();
    model.lenses.push_back(read_openmvg_lens(data_of(item)));
  }
  std::map<std::string, Pose> poses;
  for (const json& item : root.at("extrinsics")) {
    const json& value = item.at("value");
    Mat3 rotation;
    for (std::size_t i = 0; i < 3; ++i) {
      rotation.row(static_cast<int>(i)) = json_vector(value.at("rotation").at(i)).transpose();
    }
    const Quat turn = rotation_from(rotation, "pose " + json_id(item.at("key")));
    poses[json_id(item.at("key"))] = {-(turn * json_vector(value.at("center"))), turn};
  }
  std::map<std::string, std::uint32_t> photo_of;
  for (const json& item : root.at("views")) {
    const json& data = data_of(item);
    const std::string pose = json_id(member(data, "id_pose"));
    const std::string lens = json_id(member(data, "id_intrinsic"));
    if (!poses.contains(pose)) {
      ++model.unplaced;
      continue;
    }
    const std::string name = member(data, "filename").get<std::string>();
    if (!lens_number.contains(lens)) throw InputError(name + " names a camera that isn't there");
    photo_of[json_id(member(data, "id_view"))] = static_cast<std::uint32_t>(model.photos.size());
    model.photos.push_back({name, {}, lens_number[lens], poses[pose]});
  }
  if (!root.contains("structure")) return model;
  for (const json& item : root.at("structure")) {
    SparsePoint point{json_vector(item.at("value").at("X")), {}};
    for (const json& seen : item.at("value").at("observations")) {
      const auto photo = photo_of.find(json_id(seen.at("key")));
      if (photo != photo_of.end()) point.photos.push_back(photo->second);
    }
    model.points.push_back(std::move(point));
  }
  return model;
}

}  // namespace

PhotoModel read_openmvg(const std::filesystem::path& file) {
  return json_read(file, read_openmvg_model);
}

}  // namespace clast::photos_detail
