#pragma once
/// The folder of real data, and the table of reference values of its meshes.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_file.hpp"

namespace clast {

/// A file or folder of the test data: in the folder that CLAST_DATA names, else beside the project.
/// @throws InputError  it is not there; a test that needs it must fail, not pass unseen
inline std::filesystem::path test_data(const std::string& name) {
  const char* named = std::getenv("CLAST_DATA");
  const std::filesystem::path folder =
      named != nullptr ? std::filesystem::path(named)
                       : std::filesystem::path(CLAST_SOURCE_DIR) / ".." / "shared" / "data";
  const std::filesystem::path path = folder / name;
  if (!std::filesystem::exists(path)) {
    throw InputError(path.string() + " is missing: set CLAST_DATA to the folder of the test data");
  }
  return path;
}

/// One row of meshes/reference.csv by column names.
using ReferenceRow = std::map<std::string, std::string>;

inline double value(const ReferenceRow& row, const std::string& column) {
  return std::stod(row.at(column));
}

inline std::vector<ReferenceRow> mesh_reference() {
  std::istringstream lines(read_text_file(test_data("meshes/reference.csv")));
  std::vector<std::string> header;
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> fields;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) fields.push_back(cell);
    if (header.empty()) {
      header = fields;
      continue;
    }
    fields.resize(header.size());
    ReferenceRow row;
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace clast
