#pragma once
/// The real meshes of the test data and their table of reference values.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_file.hpp"

namespace clast {

inline std::filesystem::path data_folder() {
  const char* named = std::getenv("CLAST_DATA");
  return named ? std::filesystem::path(named)
               : std::filesystem::path(CLAST_SOURCE_DIR) / ".." / "shared" / "data";
}

inline std::filesystem::path data_file(const std::string& name) {
  const std::filesystem::path path = data_folder() / name;
  if (!std::filesystem::exists(path)) {
    throw InputError(path.string() + " is missing: set CLAST_DATA to the folder of the test data");
  }
  return path;
}

/// Column name to text, for every file of the reference table.
inline std::map<std::string, std::map<std::string, std::string>> reference() {
  std::istringstream table(read_text_file(data_file("meshes/reference.csv")));
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(table, line);
  const std::vector<std::string> names = split(line);
  std::map<std::string, std::map<std::string, std::string>> rows;
  while (std::getline(table, line)) {
    const std::vector<std::string> cells = split(line);
    for (std::size_t i = 0; i < cells.size(); ++i) rows[cells[0]][names[i]] = cells[i];
  }
  return rows;
}

}  // namespace clast
