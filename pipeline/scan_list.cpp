#include "pipeline/scan_list.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/utf8.hpp"
#include "mesh/mesh_io.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

bool is_scan_file(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".shp") return !is_esri_shapefile(path);
  // Files .txt and .csv in folders are usually tables; as scans they must be named explicitly.
  static const std::set<std::string> kClouds = {".las", ".laz", ".pcd", ".pts", ".xyz"};
  if (kClouds.contains(extension)) return true;
  const std::vector<std::string>& known = readable_mesh_extensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// Folders of photographs in one that holds no scan: itself, or those below it.
std::vector<fs::path> photo_folders_in(const fs::path& folder) {
  if (is_photo_folder(folder)) return {folder};
  std::vector<fs::path> found;
  std::vector<fs::path> inner;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const bool hidden = entry.path().filename().string().starts_with(".");
    std::error_code unseen;
    if (!hidden && entry.is_directory(unseen) && !entry.is_symlink(unseen)) {
      inner.push_back(entry.path());
    }
  }
  std::sort(inner.begin(), inner.end());
  for (const fs::path& path : inner) {
    const std::vector<fs::path> deeper = photo_folders_in(path);
    found.insert(found.end(), deeper.begin(), deeper.end());
  }
  return found;
}

/// The unreadable file is named instead of its folder.
void check_searchable(const fs::path& folder) {
  std::error_code code;
  const fs::directory_iterator trial(folder, code);
  if (!code) return;
  throw InputError(folder.string() + ": can't be searched (" + code.message() +
                   "); allow reading it, or move it elsewhere");
}

std::vector<fs::path> scans_in(const fs::path& folder) {
  check_searchable(folder);
  std::vector<fs::path> found;
  std::error_code code;
  for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const bool hidden = entry->path().filename().string().starts_with(".");
    if (hidden) entry.disable_recursion_pending();
    std::error_code unseen;
    const bool searched = entry->is_directory(unseen) && !entry->is_symlink(unseen) && !hidden;
    if (searched) check_searchable(entry->path());
    const bool file = entry->is_regular_file(unseen);
    // A link to nothing is listed, so that it is missed when its turn comes.
    const bool broken = !entry->exists(unseen);
    if (!hidden && (file || broken) && is_scan_file(entry->path())) {
      found.push_back(entry->path());
    }
  }
  if (code) {
    throw InputError(folder.string() + ": can't be searched (" + code.message() +
                     "); allow reading it, or move it elsewhere");
  }
  if (found.empty()) found = photo_folders_in(folder);
  if (found.empty()) {
    std::string known;
    for (const std::string& extension : readable_mesh_extensions()) known += " " + extension;
    throw InputError(
        folder.string() +
        ": this folder holds neither a mesh or cloud file (known formats:" + known +
        " .las .laz .pcd .pts .xyz .shp) nor three photographs (.jpg .png .tif) of a block");
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string folder_name(const fs::path& path) {
  return fs::absolute(path).lexically_normal().parent_path().filename().string();
}

/// Names that say that there are pictures in a folder, and not of what.
bool is_name_of_pictures(const fs::path& folder) {
  static const std::set<std::string> kNames = {
      "images", "image", "imgs", "img",      "photos", "photo", "photographs",
      "fotos",  "foto",  "pics", "pictures", "jpgs",   "jpg",   "jpeg",
      "png",    "tif",   "tiff", "raw",      "dcim",   "camera"};
  std::string name = folder.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return kNames.contains(name);
}

/// The folder whose name says of what its photographs are: B017 of B017/images.
fs::path naming_folder(const fs::path& photos) {
  // A last slash is not part of the name.
  const fs::path folder = (fs::absolute(photos) / "x").lexically_normal().parent_path();
  fs::path named = folder;
  while (is_name_of_pictures(named)) named = named.parent_path();
  return named.has_filename() ? named : folder;
}

/// A name that may be the path of the mesh a shape was made from.
std::string id_from_name(const std::string& name) {
  const bool is_path = name.find_first_of("/\\") != std::string::npos;
  const fs::path path = name.substr(is_path ? name.find_last_of("/\\") + 1 : 0);
  const bool is_file = is_path || lower_case_extension(path) == ".stl";
  return is_file ? path.stem().string() : name;
}

/// One entry for a mesh; one per shape of a .shp file, or one without a shape if the file cannot be
/// read, with the reason reported later.
std::vector<ScanFile> scans_of(const fs::path& path) {
  // A folder of photographs may have dots in its name.
  std::error_code code;
  const bool photos = fs::is_directory(path, code);
  ScanFile file{
      path, photos ? naming_folder(path).filename().string() : path.stem().string(), {}, {}};
  if (!file.is_shp()) return {file};
  try {
    std::vector<ScanFile> scans;
    for (ShpShape& shape : read_shp(path))
      scans.push_back({path, id_from_name(shape.name), shape, {}});
    if (scans.size() == 1) scans[0].id = file.id;
    return scans;
  } catch (const InputError&) {
    return {file};
  }
}

}  // namespace

bool ScanFile::is_shp() const { return lower_case_extension(path) == ".shp"; }

std::vector<fs::path> ScanFile::paths() const {
  std::vector<fs::path> all = {path};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::vector<ScanFile> list_scans(const std::vector<std::string>& inputs) {
  std::vector<ScanFile> scans;
  std::set<fs::path> seen;
  for (const std::string& input : inputs) {
    std::error_code code;
    fs::path named = input;
    if (!named.has_filename() && named.has_relative_path()) named = named.parent_path();
    const std::vector<fs::path> paths =
        fs::is_directory(named, code) ? scans_in(named) : std::vector<fs::path>{named};
    for (const fs::path& path : paths) {
      const fs::path canonical = fs::weakly_canonical(path, code);
      if (!seen.insert(code ? path : canonical).second) continue;
      for (ScanFile& scan : scans_of(path)) scans.push_back(std::move(scan));
    }
  }

  for (ScanFile& scan : scans) scan.id = to_utf8(scan.id);
  std::map<std::string, int> stems;
  for (const ScanFile& scan : scans) ++stems[scan.id];
  std::map<std::string, int> in_folders;
  for (ScanFile& scan : scans) {
    if (stems[scan.id] > 1) {
      std::error_code code;
      const bool photos = fs::is_directory(scan.path, code);
      const fs::path named = photos ? naming_folder(scan.path) : scan.path;
      scan.id = to_utf8(folder_name(named)) + "_" + scan.id;
    }
    ++in_folders[scan.id];
  }
  std::map<std::string, fs::path> ids;
  for (ScanFile& scan : scans) {
    // The user decides whether these are one scan in two formats or two scans.
    if (in_folders[scan.id] > 1 && scan.path.has_extension()) {
      scan.id += "_" + to_utf8(scan.path.extension().string().substr(1));
    }
    const auto [other, is_new] = ids.emplace(scan.id, scan.path);
    if (!is_new) {
      throw InputError(scan.path.string() + " and " + other->second.string() +
                       " would both be block " + scan.id + "; rename one of them");
    }
  }
  return scans;
}

namespace {

/// Joins scans to one entry.
ScanFile joined_entry(const std::vector<fs::path>& paths, const std::string& id) {
  constexpr std::size_t kMost = 8;
  if (paths.size() < 2 || paths.size() > kMost) {
    throw InputError(id + ": " + std::to_string(paths.size()) +
                     (paths.size() == 1 ? " scan is" : " scans are") +
                     " given to be joined; two to eight can be");
  }
  ScanFile joined{paths[0], id, {}, {paths.begin() + 1, paths.end()}};
  std::set<fs::path> seen;
  for (const fs::path& path : paths) {
    if (ScanFile{path, "", {}, {}}.is_shp()) {
      throw InputError(path.string() + ": is a shape and no scan, and cannot be joined");
    }
    std::error_code code;
    const fs::path canonical = fs::weakly_canonical(path, code);
    if (!seen.insert(code ? path : canonical).second) {
      throw InputError(path.string() + ": is given twice; each scan is joined once");
    }
  }
  return joined;
}

}  // namespace

ScanFile list_joined_scans(const std::vector<std::string>& inputs, const std::string& id) {
  std::vector<fs::path> paths;
  for (const std::string& input : inputs) {  // in the given order: the first gives the frame
    for (const ScanFile& scan : list_scans({input})) paths.push_back(scan.path);
  }
  return joined_entry(paths, id);
}

std::vector<ScanFile> list_joined_folders(const std::vector<std::string>& folders) {
  std::map<fs::path, std::vector<fs::path>> by_folder;
  for (const ScanFile& scan : list_scans(folders)) {
    by_folder[fs::absolute(scan.path).lexically_normal().parent_path()].push_back(scan.path);
  }
  std::vector<ScanFile> joined;
  std::map<std::string, fs::path> ids;
  for (const auto& [folder, paths] : by_folder) {
    const std::string id = to_utf8(folder.filename().string());
    const auto [other, is_new] = ids.emplace(id, folder);
    if (!is_new) {
      throw InputError(folder.string() + " and " + other->second.string() +
                       " would both be block " + id + "; rename one of them");
    }
    joined.push_back(paths.size() == 1 ? ScanFile{paths[0], id, {}, {}} : joined_entry(paths, id));
  }
  return joined;
}

}  // namespace clast
