#pragma once
/// JSON helpers for readers of camera models.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "core/types.hpp"

namespace clast::photos_detail {

/// Reads and parses a JSON file.
/// @throws nlohmann::json::exception  if it is not JSON
nlohmann::json load_json(const std::filesystem::path& file);

/// Parses a number that may be stored as text, as in AliceVision files.
double parse_json_number(const nlohmann::json& value);
/// Parses an integer from 0 to a million: a size in pixels or part of a version.
/// @throws InputError  if it is not such an integer
int parse_json_count(const nlohmann::json& value);

Vec3 parse_json_vector(const nlohmann::json& value);

/// Parses an id given as number or text.
std::string parse_json_id(const nlohmann::json& value);

/// Calls `read` with the parsed file. Exceptions of the JSON library become InputError.
template <class Read>
auto read_json_model(const std::filesystem::path& file, const Read& read) {
  try {
    return read(load_json(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string() + ": not the layout of a camera model (" + error.what() + ")");
  }
}

}  // namespace clast::photos_detail
