#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

namespace clast::architecture {
namespace {

using Folders = std::set<std::string>;

/// The arrows: a part of the project, which is a folder of one library or program, may include
/// these parts and what follows them.
const std::map<std::string, Folders> kArrows = {
    {"core", {}},
    {"core/files", {"core"}},
    {"core/statistics", {"core"}},
    {"mesh", {"core/files", "core/statistics"}},
    {"shapes", {"mesh"}},
    {"reconstruct", {"shapes"}},
    {"massprops", {"shapes"}},
    {"classify", {"massprops"}},
    {"library", {"classify"}},
    {"particles", {"library"}},
    {"dem", {"massprops"}},
    {"terrain", {"dem", "shapes"}},
    {"reconstruct/photos", {"reconstruct"}},
    {"study/campaign", {"library", "terrain"}},
    {"study/results", {"study/campaign"}},
    {"study/simulate", {"study/results"}},
    {"study/compare", {"study/results"}},
    {"study/proposal", {"study/simulate"}},
    {"study/calibrate", {"study/compare", "study/simulate"}},
    {"study/engines", {"study/simulate"}},
    {"report", {"study/calibrate", "study/engines", "study/proposal", "particles"}},
    {"report/scans", {"report", "reconstruct/photos"}},
    {"pipeline", {"library", "reconstruct/photos"}},
    {"app", {"report/scans", "pipeline"}},
    {"python", {"report/scans", "pipeline"}},
};

/// Rooms of a library, which are folders inside its folder, and the rooms of the same library that
/// each may include. Files of the library outside its rooms may include all of them.
const std::map<std::string, Folders> kRooms = {
    {"dem/surface", {}},
    {"dem/motion", {}},
    {"dem/search", {"dem/surface", "dem/motion"}},
    {"dem/contact", {"dem/surface", "dem/motion", "dem/search"}},
    {"dem/simulation", {"dem/surface", "dem/motion", "dem/search", "dem/contact"}},
    {"reconstruct/repair", {}},
    {"reconstruct/cloud", {"reconstruct/repair"}},
    {"reconstruct/underside", {"reconstruct/repair", "reconstruct/cloud"}},
    {"reconstruct/ground", {"reconstruct/cloud", "reconstruct/underside"}},
    {"reconstruct/deposit", {"reconstruct/cloud"}},
    {"reconstruct/registration", {"reconstruct/cloud"}},
    {"terrain/gdal", {}},
    {"terrain/zones", {"terrain/gdal"}},
    {"terrain/repair", {"terrain/gdal", "terrain/zones"}},
    {"terrain/input", {"terrain/gdal", "terrain/repair"}},
};

/// The first two folders of a path, "dem/surface" of "dem/surface/detail/a.hpp".
std::string room_of(const std::string& path) {
  return path.substr(0, path.find('/', path.find('/') + 1));
}

/// What an include breaks of the order of rooms, empty where it breaks nothing.
std::string room_breach(const std::string& path, const std::string& header) {
  const std::string from = room_of(path), to = room_of(header);
  if (from == to || !kRooms.contains(to)) return "";
  // The two rooms that call GDAL share how it is called.
  const bool both_call_gdal = from == "report/gdal" && to == "terrain/gdal";
  if (header.find("/detail/") != std::string::npos && !both_call_gdal) {
    return header + " is private to " + to;
  }
  if (kRooms.contains(from) && part_of(from) == part_of(to) && !kRooms.at(from).contains(to)) {
    return from + " may not include " + header + ", which is in a room above it";
  }
  return "";
}

/// The part of a library or program, by the target's name after "clast::": its folder's name, or
/// "scan_report" for `report/scans`.
std::string part_of_target(const std::string& target) {
  if (target == "scan_report") return "report/scans";
  for (const auto& [part, arrows] : kArrows) {
    if (part.substr(part.find('/') + 1) == target) return part;
  }
  return target;
}

/// A package: how its headers and its CMake targets begin, and the parts that it is for.
struct Package {
  std::string name;
  std::vector<std::string> headers;
  std::vector<std::string> targets;
  Folders folders;
};

const std::vector<Package> kHeavyPackages = {
    {"CGAL", {"CGAL/"}, {"CGAL::"}, {"mesh", "shapes", "reconstruct", "terrain"}},
    {"assimp", {"assimp/"}, {"assimp::"}, {"mesh"}},
    {"PCL", {"pcl/"}, {"pcl"}, {"reconstruct"}},
    {"OpenCV", {"opencv2/"}, {"opencv"}, {"reconstruct/photos"}},
    {"Boost.Math", {"boost/"}, {"Boost::"}, {"core/statistics"}},
    {"HDF5", {"hdf5", "H5"}, {"hdf5::", "HDF5::"}, {"core/files"}},
    {"OpenSSL", {"openssl/"}, {"OpenSSL::"}, {"core/files"}},
    {"libpng", {"png.h"}, {"PNG::"}, {"core/files"}},
    {"zlib", {"zlib.h"}, {"ZLIB::"}, {"core/files"}},
    {"GDAL", {"gdal", "ogr", "cpl_"}, {"GDAL::"}, {"terrain", "report"}},
    {"PROJ", {"proj.h"}, {"PROJ::"}, {"mesh"}},
    {"MPI", {"mpi.h"}, {"MPI::"}, {"study/simulate"}},
    {"toml++", {"toml++/"}, {"tomlplusplus::"}, {"core/files"}},
    {"CLI11", {"CLI/"}, {"CLI11::"}, {"app"}},
    {"nlohmann_json",
     {"nlohmann/"},
     {"nlohmann_json::"},
     {"mesh", "reconstruct/photos", "library", "particles", "terrain", "report", "report/scans",
      "pipeline", "app", "python"}},
    {"pybind11", {"pybind11/"}, {"pybind11::"}, {"python"}},
    {"pugixml", {"pugixml"}, {"pugixml::"}, {"reconstruct/photos"}},
};

/// `dem` opens no file and prints nothing.
const Folders kNotForDem = {"fstream", "iostream", "cstdio", "filesystem", "stdio.h"};

struct Include {
  std::size_t line;
  std::string header;
  bool quoted;
};

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::smatch match;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    if (std::regex_match(file.lines[i], match, kInclude)) {
      includes.push_back({i + 1, match[2], match[1] == "\""});
    }
  }
  return includes;
}

std::string listed(const Folders& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

/// The part of the project that a header is in, none for a package's or the standard library's.
std::optional<std::string> project_part(const std::string& header) {
  static const Folders kOthers = {"tests", "samples", "benchmarks"};
  const std::string part = part_of(header);
  if (part == header || !(kArrows.contains(part) || kOthers.contains(part))) return {};
  return part;
}

/// A target named in a CMakeLists.txt.
struct Link {
  std::size_t line;
  std::string target;
};

std::vector<Link> links_of(const SourceFile& cmake_lists) {
  static const std::regex kTarget(R"([A-Za-z_0-9]+(::[A-Za-z_0-9+]+)+|\b(pcl|opencv)_\w+)");
  std::vector<Link> links;
  for (std::size_t i = 0; i < cmake_lists.lines.size(); ++i) {
    const std::string line = cmake_lists.lines[i].substr(0, cmake_lists.lines[i].find('#'));
    for (std::sregex_iterator it(line.begin(), line.end(), kTarget), end; it != end; ++it) {
      links.push_back({i + 1, it->str()});
    }
  }
  return links;
}

/// True if the file is in a part of the project, and not in tests, samples, benchmarks or docs.
bool is_in_a_part(const SourceFile& file) { return kArrows.contains(part_of(file.path)); }

/// The CMakeLists.txt of the part that a file is in.
std::string lists_of(const SourceFile& file) { return part_of(file.path) + "/CMakeLists.txt"; }

}  // namespace

std::string part_of(const std::string& path) {
  const std::string inner = path.substr(0, path.find('/', path.find('/') + 1));
  return kArrows.contains(inner) ? inner : path.substr(0, path.find('/'));
}

bool is_public_header(const SourceFile& file) {
  return file.is_header() && is_in_a_part(file) && file.folder() != "app" &&
         file.folder() != "python" && file.path.find("/detail/") == std::string::npos &&
         file.path.find("/scans/json/") == std::string::npos;  // not installed either
}

Folders reachable(const std::string& part) {
  Folders all = {part};
  for (const std::string& next : kArrows.at(part)) all.merge(reachable(next));
  return all;
}

Findings include_findings(const SourceFile& file) {
  Findings findings;
  if (!file.is_source() || !is_in_a_part(file)) return findings;
  const std::string own = part_of(file.path);
  const Folders allowed = reachable(own);
  for (const Include& include : includes_of(file)) {
    const std::optional<std::string> part = project_part(include.header);
    if (include.quoted && !part) {
      findings.push_back(finding(file, include.line,
                                 "\"" + include.header +
                                     "\" is not written from the project's root "
                                     "(\"folder/header.hpp\")"));
    }
    if (!part) continue;
    if (!allowed.contains(*part)) {
      findings.push_back(
          finding(file, include.line,
                  own + " may not include " + include.header + ", only from " + listed(allowed)));
    }
    const std::string breach = room_breach(file.path, include.header);
    if (!breach.empty()) findings.push_back(finding(file, include.line, breach));
    if (is_public_header(file) && include.header.find("/detail/") != std::string::npos) {
      findings.push_back(
          finding(file, include.line,
                  "public header includes " + include.header + ", which is not installed"));
    }
  }
  return findings;
}

Findings package_findings(const SourceFile& file) {
  Findings findings;
  if (!file.is_source() || !is_in_a_part(file)) return findings;
  for (const Include& include : includes_of(file)) {
    if (project_part(include.header)) continue;
    for (const Package& package : kHeavyPackages) {
      if (!starts_with_any(include.header, package.headers)) continue;
      // The headers of report/json are about JSON.
      const bool is_subject =
          package.name == "nlohmann_json" && file.path.starts_with("report/json/");
      if (is_public_header(file) && !is_subject) {
        findings.push_back(finding(file, include.line,
                                   "public header includes " + include.header + " of " +
                                       package.name + "; convert at the edge of the .cpp"));
      }
      if (package.name == "GDAL" && !room_of(file.path).ends_with("/gdal")) {
        findings.push_back(
            finding(file, include.line, "GDAL is called in terrain/gdal and report/gdal alone"));
      } else if (!package.folders.contains(part_of(file.path))) {
        findings.push_back(finding(file, include.line,
                                   package.name + " is not for " + part_of(file.path) +
                                       ", only for " + listed(package.folders)));
      }
    }
    if (file.folder() == "dem" && kNotForDem.contains(include.header)) {
      findings.push_back(
          finding(file, include.line,
                  "dem opens no file and prints nothing, but includes <" + include.header + ">"));
    }
  }
  return findings;
}

Findings link_findings(const SourceFile& cmake_lists) {
  Findings findings;
  const std::string part = part_of(cmake_lists.path);
  if (!is_in_a_part(cmake_lists) || cmake_lists.path != lists_of(cmake_lists)) return findings;
  const Folders allowed = reachable(part);
  for (const Link& link : links_of(cmake_lists)) {
    if (link.target.starts_with("clast::") &&
        !allowed.contains(part_of_target(link.target.substr(7)))) {
      findings.push_back(
          finding(cmake_lists, link.line,
                  part + " may not link " + link.target + ", only " + listed(allowed)));
    }
    for (const Package& package : kHeavyPackages) {
      if (starts_with_any(link.target, package.targets) && !package.folders.contains(part)) {
        findings.push_back(finding(
            cmake_lists, link.line,
            package.name + " is not for " + part + ", only for " + listed(package.folders)));
      }
    }
  }
  return findings;
}

Findings unlinked_findings(const std::vector<SourceFile>& tree) {
  std::map<std::string, Folders> linked;
  for (const SourceFile& file : tree) {
    if (file.path != lists_of(file)) continue;
    for (const Link& link : links_of(file)) {
      if (link.target.starts_with("clast::"))
        linked[part_of(file.path)].insert(part_of_target(link.target.substr(7)));
    }
  }
  // Links of links, until nothing is added; the folders are few.
  for (bool grew = true; grew;) {
    grew = false;
    for (auto& [part, targets] : linked) {
      const Folders before = targets;
      for (const std::string& target : before) {
        if (linked.contains(target)) targets.insert(linked[target].begin(), linked[target].end());
      }
      grew = grew || targets.size() > before.size();
    }
  }
  Findings findings;
  for (const SourceFile& file : tree) {
    if (!file.is_source() || !is_in_a_part(file)) continue;
    for (const Include& include : includes_of(file)) {
      const std::string own = part_of(file.path);
      const std::optional<std::string> part = project_part(include.header);
      if (part && *part != own && !linked[own].contains(*part)) {
        findings.push_back(
            finding(file, include.line,
                    "includes " + include.header + ", but " + lists_of(file) +
                        " does not link clast::" + part->substr(part->find('/') + 1)));
      }
    }
  }
  return findings;
}

Findings unlisted_findings(const std::vector<SourceFile>& tree) {
  std::map<std::string, Folders> listed_files;
  for (const SourceFile& file : tree) {
    if (file.path != lists_of(file)) continue;
    const std::string part = part_of(file.path);
    for (const std::string& line : file.lines) {
      std::istringstream words(std::regex_replace(line, std::regex("[()]"), " "));
      for (std::string word; words >> word && word[0] != '#';) {
        listed_files[part].insert(part + "/" + word);
      }
    }
  }
  Findings findings;
  for (const SourceFile& file : tree) {
    if (!is_in_a_part(file)) continue;
    const bool must_be_listed = file.path.ends_with(".cpp") || is_public_header(file);
    if (must_be_listed && !listed_files[part_of(file.path)].contains(file.path)) {
      findings.push_back(finding(file, 1, "not listed in " + lists_of(file)));
    }
  }
  return findings;
}

}  // namespace clast::architecture
