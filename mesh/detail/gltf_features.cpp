#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/printable.hpp"
#include "mesh/detail/mesh_readers.hpp"

namespace clast::mesh_detail {
namespace {

using Json = nlohmann::json;

/// Extensions that change looks and not shapes begin so.
constexpr std::array<const char*, 12> kLooks = {"KHR_materials_",    "KHR_texture_",
                                                "EXT_texture_",      "KHR_lights_",
                                                "EXT_lights_",       "KHR_xmp",
                                                "MSFT_texture_",     "KHR_techniques_",
                                                "EXT_mesh_features", "EXT_structural_metadata",
                                                "MSFT_packing_",     "CESIUM_primitive_outline"};
/// Extensions that change shapes even where a file does not require them.
constexpr std::array<const char*, 2> kShapes = {"EXT_mesh_gpu_instancing", "KHR_mesh_quantization"};

constexpr const char* kAdvice =
    "; save it without that extension, for example by importing it into Blender and exporting it "
    "as glTF without compression";

constexpr std::int64_t kFloat = 5126;  ///< type of components

/// The JSON text of a .gltf or .glb file.
std::string_view json_text(std::string_view content) {
  constexpr std::size_t kHead = 20;  // of the file and of its first chunk
  if (!content.starts_with("glTF") || content.size() < kHead) return content;
  std::uint32_t size = 0;
  std::memcpy(&size, content.data() + 12, sizeof size);
  return content.substr(kHead, size);
}

[[noreturn]] void refuse_extension(const std::string& name, const std::string& why) {
  throw InputError("its extension " + escape_nonprintable(name) + " is not read" + why + kAdvice);
}

std::string text_at(const Json& list, std::size_t i) {
  return list[i].is_string() ? list[i].get<std::string>() : std::string();
}

void check_extensions(const Json& file) {
  for (const char* key : {"extensionsRequired", "extensionsUsed"}) {
    const auto list = file.find(key);
    if (list == file.end() || !list->is_array()) continue;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string name = text_at(*list, i);
      const auto begins = [&](const char* beginning) { return name.starts_with(beginning); };
      const bool required = std::string_view(key) == "extensionsRequired";
      if (required ? std::none_of(kLooks.begin(), kLooks.end(), begins)
                   : std::any_of(kShapes.begin(), kShapes.end(), begins)) {
        refuse_extension(name, required ? ", and the file requires it" : "");
      }
    }
  }
}

Json list_in(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_array() ? *found : Json::array();
}

/// Refuses meshes whose shape depends on bones or on weights: the vertices as stored are not it.
void check_deformations(const Json& file) {
  constexpr const char* kApply =
      "; apply it to the mesh in a 3-D program, and save the file without it";
  for (const Json& skin : list_in(file, "skins")) {
    if (!skin.is_object() || !skin.contains("inverseBindMatrices")) {
      throw InputError(std::string("has a skin (bones that move the vertices) without "
                                   "inverseBindMatrices") +
                       kApply);
    }
  }
  const auto is_active = [](const Json& holder) {
    const Json weights = list_in(holder, "weights");
    return std::any_of(weights.begin(), weights.end(), [](const Json& weight) {
      return weight.is_number() && weight.get<double>() != 0.0;
    });
  };
  for (const char* key : {"meshes", "nodes"}) {
    const Json holders = list_in(file, key);
    if (std::any_of(holders.begin(), holders.end(), is_active)) {
      throw InputError(std::string("has a morph target with a weight that is not 0") + kApply);
    }
  }
}

/// Coordinates are floats that are in the file.
void check_positions(const Json& file) {
  const auto number = [](const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : -1;
  };
  const Json accessors = list_in(file, "accessors");
  for (const Json& mesh : list_in(file, "meshes")) {
    for (const Json& primitive : list_in(mesh, "primitives")) {
      if (!primitive.is_object() || !primitive.contains("attributes")) continue;
      const std::int64_t index = number(primitive["attributes"], "POSITION");
      if (index < 0 || index >= static_cast<std::int64_t>(accessors.size())) continue;
      const Json& accessor = accessors[static_cast<std::size_t>(index)];
      if (number(accessor, "componentType") != kFloat) {
        refuse_extension("KHR_mesh_quantization", ": its coordinates are whole numbers");
      }
      if (number(accessor, "bufferView") < 0 && !accessor.contains("sparse")) {
        throw InputError(std::string("has coordinates in compressed form only, as of the extension "
                                     "KHR_draco_mesh_compression or EXT_meshopt_compression") +
                         kAdvice);
      }
    }
  }
}

}  // namespace

void check_gltf_extensions(std::string_view content) {
  const Json file = Json::parse(json_text(content), nullptr, false);
  if (!file.is_object()) return;  // the reader says what is wrong
  check_extensions(file);
  check_deformations(file);
  check_positions(file);
}

}  // namespace clast::mesh_detail
