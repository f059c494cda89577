#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

namespace {

std::vector<double> numbers_in(const pugi::xml_node& node, std::size_t count) {
  std::istringstream words(node.text().as_string());
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const std::optional<double> value = parse_number(word);
    if (!value)
      throw InputError("<" + std::string(node.name()) + ">: \"" + word + "\" is not a number");
    values.push_back(*value);
  }
  if (values.size() != count) {
    throw InputError("<" + std::string(node.name()) + "> holds " + std::to_string(values.size()) +
                     " numbers instead of " + std::to_string(count));
  }
  return values;
}

double number_of(const pugi::xml_node& parent, const char* name, double otherwise) {
  const pugi::xml_node node = parent.child(name);
  return node ? numbers_in(node, 1)[0] : otherwise;
}

CameraIntrinsics read_metashape_lens(const pugi::xml_node& sensor) {
  pugi::xml_node calibration = sensor.find_child_by_attribute("calibration", "class", "adjusted");
  if (!calibration) calibration = sensor.child("calibration");
  const std::string label = "sensor " + std::string(sensor.attribute("label").as_string());
  if (!calibration) throw InputError(label + " has no calibration; align the photos first");
  pugi::xml_node size = calibration.child("resolution");
  if (!size) size = sensor.child("resolution");
  std::string type = calibration.attribute("type").as_string();
  if (type.empty()) type = sensor.attribute("type").as_string("frame");
  if (type != "frame" && type != "fisheye" && type != "equidistant_fisheye") {
    throw InputError(label + ": cameras of type " + type + " aren't known, only frame and fisheye");
  }
  for (const char* name : {"p3", "p4"}) {
    if (number_of(calibration, name, 0.0) != 0.0) {
      throw InputError(label + ": distortion " + name +
                       " isn't known; optimize the cameras without it");
    }
  }
  CameraIntrinsics lens{.width = size.attribute("width").as_int(),
                        .height = size.attribute("height").as_int()};
  lens.fisheye = type != "frame";
  if (calibration.child("fx")) {  // PhotoScan up to 1.1: the centre from the corner
    lens.fx = number_of(calibration, "fx", 0.0);
    lens.fy = number_of(calibration, "fy", 0.0);
    lens.cx = number_of(calibration, "cx", 0.0) - 0.5;
    lens.cy = number_of(calibration, "cy", 0.0) - 0.5;
    lens.skew = number_of(calibration, "skew", 0.0);
  } else {
    lens.fy = number_of(calibration, "f", 0.0);
    lens.fx = lens.fy + number_of(calibration, "b1", 0.0);
    lens.skew = number_of(calibration, "b2", 0.0);
    lens.cx = 0.5 * lens.width + number_of(calibration, "cx", 0.0) - 0.5;
    lens.cy = 0.5 * lens.height + number_of(calibration, "cy", 0.0) - 0.5;
  }
  lens.radial = {number_of(calibration, "k1", 0.0), number_of(calibration, "k2", 0.0),
                 number_of(calibration, "k3", 0.0), number_of(calibration, "k4", 0.0)};
  // Metashape's P1 goes with r^2 + 2 x^2, OpenCV's with 2 x y.
  lens.p1 = number_of(calibration, "p2", 0.0);
  lens.p2 = number_of(calibration, "p1", 0.0);
  return lens;
}

/// Rotation and scale that take a chunk's or a component's frame to metres. The translation is left
/// out: it is of the order of the earth's radius, and the origin is free.
struct ToMetres {
  Quat rotation = Quat::Identity();
  double scale = 1.0;
  bool known = false;
};

ToMetres to_metres(const pugi::xml_node& transform) {
  ToMetres result;
  if (!transform.child("scale")) return result;
  result.scale = number_of(transform, "scale", 1.0);
  if (!(result.scale > 0.0)) throw InputError("<scale> of the chunk is not positive");
  result.known = true;
  if (transform.child("rotation")) {
    const std::vector<double> r = numbers_in(transform.child("rotation"), 9);
    Mat3 m;
    m << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
    result.rotation = rotation_from_matrix(m, "chunk");
  }
  return result;
}

/// The chunk that holds the cameras.
/// @throws InputError  not XML, no cameras
pugi::xml_node load_chunk(pugi::xml_document& document, const std::filesystem::path& file) {
  const pugi::xml_parse_result parsed = document.load_file(file.c_str());
  if (!parsed) {
    throw InputError(file.string() + ": not XML at byte " + std::to_string(parsed.offset) + " (" +
                     parsed.description() + ")");
  }
  const pugi::xml_node chunk = document.child("document").child("chunk");
  if (!chunk.child("cameras")) {
    throw InputError(file.string() +
                     ": no <chunk> with <cameras>; write it with File > Export > Export Cameras");
  }
  return chunk;
}

/// Cameras, those in groups too.
std::vector<pugi::xml_node> camera_nodes(const pugi::xml_node& chunk) {
  std::vector<pugi::xml_node> cameras;
  for (const pugi::xml_node node : chunk.child("cameras").children()) {
    if (std::string(node.name()) == "camera") cameras.push_back(node);
    for (const pugi::xml_node inner : node.children("camera")) cameras.push_back(inner);
  }
  return cameras;
}

/// Frames of the components by id; where the file does not say, that of the chunk holds.
class Frames {
 public:
  explicit Frames(const pugi::xml_node& chunk) : of_chunk_(to_metres(chunk.child("transform"))) {
    for (const pugi::xml_node component : chunk.child("components").children("component")) {
      components_[component.attribute("id").as_string()] = to_metres(component.child("transform"));
    }
  }

  const ToMetres& of(const std::string& component) const {
    const auto found = components_.find(component);
    return found != components_.end() && found->second.known ? found->second : of_chunk_;
  }

 private:
  ToMetres of_chunk_;
  std::map<std::string, ToMetres> components_;
};

/// Lenses by the id of their sensor, each read when a photo first names it.
class Lenses {
 public:
  explicit Lenses(const pugi::xml_node& chunk) {
    for (const pugi::xml_node sensor : chunk.child("sensors").children("sensor")) {
      sensors_[sensor.attribute("id").as_string()] = sensor;
    }
  }

  /// Returns the index of the lens in `lenses`; adds it if it is new.
  std::size_t number(const std::string& sensor, const std::string& photo,
                     std::vector<CameraIntrinsics>& lenses) {
    const auto known = sensors_.find(sensor);
    if (known == sensors_.end()) {
      throw InputError("photo " + photo + " names sensor " + sensor + ", which does not exist");
    }
    if (!number_.contains(sensor)) {
      lenses.push_back(read_metashape_lens(known->second));
      number_[sensor] = lenses.size() - 1;
    }
    return number_[sensor];
  }

 private:
  std::map<std::string, pugi::xml_node> sensors_;
  std::map<std::string, std::size_t> number_;
};

Pose world_from(const pugi::xml_node& camera, const std::string& label, const ToMetres& metres) {
  const std::vector<double> t = numbers_in(camera.child("transform"), 16);
  Mat3 rotation;
  rotation << t[0], t[1], t[2], t[4], t[5], t[6], t[8], t[9], t[10];
  return {metres.scale * (metres.rotation * Vec3(t[3], t[7], t[11])),
          metres.rotation * rotation_from_matrix(rotation, "photo " + label)};
}

}  // namespace

PhotoModel read_metashape(const std::filesystem::path& file) {
  pugi::xml_document document;
  const pugi::xml_node chunk = load_chunk(document, file);
  PhotoModel model;
  model.source = "Metashape";
  Lenses lenses(chunk);
  const Frames frames(chunk);
  std::string component;
  for (const pugi::xml_node& camera : camera_nodes(chunk)) {
    if (!camera.attribute("enabled").as_bool(true)) continue;
    if (!camera.child("transform")) {
      ++model.photos_without_pose;
      continue;
    }
    const std::string label = camera.attribute("label").as_string();
    const std::string own = camera.attribute("component_id").as_string();
    if (!model.photos.empty() && own != component) {
      throw InputError("photo " + label +
                       " is in a different component from the photos before it: the photos are in "
                       "separate groups; add photos between them and align again");
    }
    component = own;
    const std::size_t lens =
        lenses.number(camera.attribute("sensor_id").as_string(), label, model.lenses);
    const ToMetres& metres = frames.of(own);
    model.metric = metres.known;
    model.photos.push_back({label, {}, lens, world_from(camera, label, metres).inverse()});
  }
  return model;
}

}  // namespace clast::photos_detail
