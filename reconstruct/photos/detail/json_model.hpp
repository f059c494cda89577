#pragma once
/// What the readers of camera models in JSON share.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/types.hpp"

namespace clast::photos_detail {

/// The file's content. @throws nlohmann::json::exception  it is no JSON
nlohmann::json load_json(const std::filesystem::path& file);

/// A number that may be written as a text, as AliceVision does.
double parse_json_number(const nlohmann::json& value);
/// A whole number from 0 to a million: a size in pixels, a part of a version.
/// @throws InputError  any other number
int parse_json_count(const nlohmann::json& value);

/// Three numbers.
Vec3 parse_json_vector(const nlohmann::json& value);

/// A number or a text as text: the ids of items.
std::string parse_json_id(const nlohmann::json& value);

/// What `read` makes of the file; what the JSON library throws becomes an InputError.
template <class Read>
auto read_json_model(const std::filesystem::path& file, const Read& read) {
  try {
    return read(load_json(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string() + ": not the layout of a camera model (" + error.what() + ")");
  }
}

}  // namespace clast::photos_detail
