#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <sstream>

#include "core/files/text_file.hpp"

namespace clast::architecture {
namespace {

/// Folders of the project. Others, such as build/ or someone's own scans, are not read.
const std::vector<std::string> kFolders = {
    ".ci",         "app",     "benchmarks", "classify", "cmake",     "core",     "dem",
    "docs",        "library", "massprops",  "mesh",     "particles", "pipeline", "python",
    "reconstruct", "report",  "samples",    "shapes",   "study",     "terrain",  "tests"};

}  // namespace

SourceFile source_file(const std::string& path, const std::string& text) {
  SourceFile file{path, {}};
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
  return file;
}

std::vector<SourceFile> read_source_tree(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    // In a worktree, .git is a file that holds a path.
    if (entry.is_regular_file() && entry.path().filename() != ".git") paths.push_back(entry);
  }
  for (const std::string& folder : kFolders) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file()) paths.push_back(entry);
    }
  }
  std::vector<SourceFile> files;
  for (const std::filesystem::path& path : paths) {
    const std::string text = read_text_file(path);
    if (text.find('\0') != std::string::npos) continue;  // binary, for example a PLY scan
    files.push_back(source_file(path.lexically_relative(root).generic_string(), text));
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string finding(const SourceFile& file, std::size_t line, const std::string& what) {
  return file.path + ":" + std::to_string(line) + ": " + what;
}

const std::vector<SourceFile>& project() {
  static const std::vector<SourceFile> files = read_source_tree(CLAST_SOURCE_DIR);
  return files;
}

Findings in_every_file(const std::function<Findings(const SourceFile&)>& rule) {
  Findings all;
  for (const SourceFile& file : project()) {
    const Findings findings = rule(file);
    all.insert(all.end(), findings.begin(), findings.end());
  }
  return all;
}

std::string lines(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += "\n" + finding;
  return text;
}

}  // namespace clast::architecture
