#include "app/scan_list.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "core/error.hpp"
#include "shapes/mesh_io.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

bool is_mesh_file(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string>& known = readable_mesh_extensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

std::vector<fs::path> meshes_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code code;
  for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const bool hidden = entry->path().filename().string().starts_with(".");
    if (!hidden && entry->is_regular_file() && is_mesh_file(entry->path())) {
      found.push_back(entry->path());
    }
  }
  if (code) throw InputError(folder.string() + ": can't be searched (" + code.message() + ")");
  if (found.empty()) {
    std::string known;
    for (const std::string& extension : readable_mesh_extensions()) known += " " + extension;
    throw InputError(folder.string() + ": no mesh file in this folder; known are" + known);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string folder_name(const fs::path& path) {
  return fs::absolute(path).lexically_normal().parent_path().filename().string();
}

}  // namespace

std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs) {
  std::vector<ScanFile> scans;
  std::set<fs::path> seen;
  for (const std::string& input : inputs) {
    std::error_code code;
    const std::vector<fs::path> paths =
        fs::is_directory(input, code) ? meshes_in(input) : std::vector<fs::path>{input};
    for (const fs::path& path : paths) {
      const fs::path canonical = fs::weakly_canonical(path, code);
      if (seen.insert(code ? path : canonical).second) {
        scans.push_back({path, path.stem().string()});
      }
    }
  }

  std::map<std::string, int> stems;
  for (const ScanFile& scan : scans) ++stems[scan.id];
  std::map<std::string, fs::path> ids;
  for (ScanFile& scan : scans) {
    if (stems[scan.id] > 1) scan.id = folder_name(scan.path) + "_" + scan.id;
    const auto [other, is_new] = ids.emplace(scan.id, scan.path);
    if (!is_new) {
      throw InputError(scan.path.string() + " and " + other->second.string() +
                       " would both be block " + scan.id + "; rename one of the files");
    }
  }
  return scans;
}

}  // namespace clast
