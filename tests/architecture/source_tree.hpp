#pragma once
/// The project's own text files, line by line, for the tests of its layout.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace clast::architecture {

/// A text file and its place in the project.
struct SourceFile {
  std::string path;  ///< from the project's root, with forward slashes: "shapes/convex_hull.hpp"
  std::vector<std::string> lines;

  std::string folder() const { return path.substr(0, path.find('/')); }
  bool is_header() const { return path.ends_with(".hpp"); }
  bool is_source() const { return is_header() || path.ends_with(".cpp"); }
};

/// Every text file of the project under `root`, sorted by path.
std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

/// From text, for the tests of the rules themselves.
SourceFile source_file(const std::string& path, const std::string& text);

/// What breaks a rule, one line each: "shapes/convex_hull.hpp:5: what is wrong".
using Findings = std::vector<std::string>;

std::string finding(const SourceFile& file, std::size_t line, const std::string& what);

/// The files of this project, read once.
const std::vector<SourceFile>& project();

/// What breaks `rule` anywhere in this project.
Findings in_every_file(const std::function<Findings(const SourceFile&)>& rule);

/// One under the other, for a test's message.
std::string lines(const Findings& findings);

}  // namespace clast::architecture
