#include "tests/architecture/text_rules.hpp"

#include <algorithm>
#include <map>
#include <regex>

namespace clast::architecture {
namespace {

/// Keys of a BibTeX file with the line of each.
std::multimap<std::string, std::size_t> bibliography_keys(const SourceFile& references) {
  static const std::regex kEntry(R"(^@\w+\{\s*([^,\s]+)\s*,.*)");
  std::multimap<std::string, std::size_t> keys;
  std::smatch match;
  for (std::size_t i = 0; i < references.lines.size(); ++i) {
    if (std::regex_match(references.lines[i], match, kEntry)) keys.emplace(match[1], i + 1);
  }
  return keys;
}

std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// The text literals of a line.
std::vector<std::string> literals(const std::string& line) {
  static const std::regex kLiteral(R"x("((?:[^"\\]|\\.)*)")x");
  static const std::regex kComment(R"(^\s*//.*)");
  std::vector<std::string> found;
  if (line.size() > 2000 || std::regex_match(line, kComment)) return found;
  for (const std::smatch& match : matches(line, kLiteral)) found.push_back(match[1]);
  return found;
}

bool is_of_library(const SourceFile& file) {
  return file.is_source() && file.folder() != "app" && file.folder() != "tests" &&
         file.folder() != "benchmarks";
}

/// Programs beside `app`, such as those that make samples: their options are their own.
bool is_program(const SourceFile& file) {
  return std::any_of(file.lines.begin(), file.lines.end(),
                     [](const std::string& line) { return line.starts_with("int main("); });
}

/// Runs of other programs, whose options are theirs.
bool speaks_of_another_program(const SourceFile& file) {
  return file.path == "reconstruct/photos/colmap_run.cpp" || file.path == "report/page_pdf.cpp" ||
         file.path == "mesh/detail/laz_unpacker.cpp" || file.path == "terrain/gdal/gdal_raster.cpp";
}

bool declares_columns(const SourceFile& file) {
  return file.path == "study/compare/run_columns.cpp" ||
         file.path == "study/results/detail/results_layout.hpp" ||
         file.path.starts_with("report/tables/");
}

}  // namespace

Findings guard_findings(const SourceFile& file) {
  if (!file.is_header() || (!file.lines.empty() && file.lines.front() == "#pragma once")) return {};
  return {finding(file, 1, "a header starts with #pragma once")};
}

Findings machine_path_findings(const SourceFile& file) {
  // In pieces, so that this file is not among the findings. A path is absolute where nothing that
  // could be the folder above stands before it, as in ${CMAKE_BINARY_DIR}/home/.
  static const std::regex kPath(std::string(R"((^|[^\w.\-})*/])/()") +
                                R"((home|Users|root|mnt|work|workspace)/[\w.\-]+|tmp/\w+))");
  Findings findings;
  std::smatch match;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    // Text lines are short; a long one is data, where std::regex would recurse too deep.
    if (file.lines[i].size() < 2000 && std::regex_search(file.lines[i], match, kPath)) {
      findings.push_back(finding(file, i + 1, "path of one machine: /" + match[2].str()));
    }
  }
  return findings;
}

Findings citation_findings(const SourceFile& file, const SourceFile& references) {
  static const std::regex kInHeader(R"([@\\]cite\s+([\w\-]+))");
  static const std::regex kBrackets(R"(\[[a-z]{3,}\d{3,4}[a-z]?[^\]]*\])");
  static const std::regex kInBrackets(R"(([a-z]{3,}\d{3,4}[a-z]?))");
  const bool document = file.path.starts_with("docs/") && file.path.ends_with(".md");
  if (!file.is_header() && !document) return {};
  const std::multimap<std::string, std::size_t> keys = bibliography_keys(references);
  Findings findings;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::string text = file.lines[i];
    if (document) {
      std::string cited;
      for (const std::smatch& match : matches(text, kBrackets)) cited += match.str();
      text = cited;
    }
    for (const std::smatch& match : matches(text, document ? kInBrackets : kInHeader)) {
      if (!keys.contains(match[1].str())) {
        findings.push_back(finding(
            file, i + 1, "cites " + match[1].str() + ", which " + references.path + " lacks"));
      }
    }
  }
  return findings;
}

Findings docs_comment_findings(const SourceFile& file) {
  static const std::regex kComment(R"(^\s*///(?!<)\s?(.*))");
  static const std::regex kBadStart(
      "(As|At|By|For|From|How|In|Of|On|To|What|When|Where|Whether|Which|Whose|With|[a-z]+)\\b.*");
  static const std::regex kQuestion(R"(.*\?(\s.*)?$)");
  Findings findings;
  if (!is_of_library(file) && file.folder() != "app") return findings;
  if (!file.is_header()) return findings;
  bool inside = false;
  std::smatch match;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const bool comment = std::regex_match(file.lines[i], match, kComment);
    const std::string text = comment ? match[1].str() : "";
    if (comment && !inside && std::regex_match(text, kBadStart)) {
      findings.push_back(finding(
          file, i + 1,
          "begins with \"" + text.substr(0, text.find(' ')) + "\"; begin with a noun or a verb"));
    }
    if (comment && std::regex_match(text, kQuestion)) {
      findings.push_back(finding(file, i + 1, "asks a question; state what holds"));
    }
    inside = comment;
  }
  return findings;
}

Findings long_line_findings(const SourceFile& document) {
  Findings findings;
  if (!document.path.ends_with(".md")) return findings;
  for (std::size_t i = 0; i < document.lines.size(); ++i) {
    const auto characters =
        std::count_if(document.lines[i].begin(), document.lines[i].end(),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    if (characters <= 120) continue;
    findings.push_back(
        finding(document, i + 1, "has " + std::to_string(characters) + " characters, 120 at most"));
  }
  return findings;
}

Findings renamed_name_findings(const SourceFile& file) {
  static const std::map<std::string, std::string> kRenamed = {
      {"Asleep", "SeparationBound"},
      {"BlockDraw", "BlockSampling"},
      {"CameraSeat", "CameraPosition"},
      {"DoubledSurface", "DuplicateSurface"},
      {"EnergyLedger", "EnergyBalance"},
      {"FormDoubt", "ShapeAnomaly"},
      {"HoldingFaces", "ConfiningWalls"},
      {"PlaceMark", "PositionMark"},
      {"SeenThrough", "FreeSpaceGrid"},
      {"SkinPiece", "OffsetPiece"},
      {"SleepWatch", "SleepDetector"},
      {"StandingBlock", "BlockOnGround"},
      {"StayRecord", "PersistentBlockRecord"},
      {"UnseenBounds", "UnobservedPartBounds"},
      {"UnseenRange", "BlockBracket"},
      {"asleep_until", "separated_until"},
      {"cloud_margin", "compute_surface_uncertainty"},
      {"drop_ratio", "height_length_ratio"},
      {"drop_triangles", "remove_triangles"},
      {"drop_fins", "remove_fins"},
      {"edge_bend", "edge_convexity"},
      {"foot_share", "base_fraction"},
      {"free_heading", "any_heading_width"},
      {"friction_after", "slip_dependent_friction"},
      {"gap_in_words", "describe_difference"},
      {"kept_volume", "retained_volume"},
      {"leave_dents_in", "store_indentations"},
      {"list_anew", "request_broad_phase"},
      {"looked_through", "carve_free_space"},
      {"mass_in_words", "format_mass"},
      {"pierced_depth", "edge_penetration_depth"},
      {"reading_step", "find_reading_resolution"},
      {"redraw_blocks", "resample_blocks"},
      {"refuse_if_there", "refuse_if_present"},
      {"runs_in_words", "describe_runs"},
      {"scale_in_words", "describe_block_scale"},
      {"share_in_words", "format_percentage"},
      {"standing_blocks", "find_blocks_on_ground"},
      {"sure_until", "nearest_face_until"},
      {"time_beside", "sphere_contact_free_time"},
      {"turned_one_step", "integrate_rotation_step"},
      {"turn_over", "flip_orientation"},
      {"unseen_range", "derive_block_bracket"},
      {"unseen_sides", "fill_unobserved_sides"},
      {"values_of", "measure_values"},
  };
  static const std::regex kIdentifier(R"([A-Za-z_]\w*)");
  Findings findings;
  if (!file.is_header() || !is_of_library(file)) return findings;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    for (const std::smatch& match : matches(file.lines[i], kIdentifier)) {
      const auto renamed = kRenamed.find(match.str());
      if (renamed == kRenamed.end()) continue;
      findings.push_back(finding(file, i + 1, match.str() + " is called " + renamed->second));
    }
  }
  return findings;
}

Findings flag_findings(const SourceFile& file) {
  static const std::regex kFlag(R"((^|[\s(])--[a-z])");
  Findings findings;
  if (!is_of_library(file) || is_program(file) || speaks_of_another_program(file)) return findings;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    for (const std::string& text : literals(file.lines[i])) {
      if (!std::regex_search(text, kFlag)) continue;
      findings.push_back(finding(
          file, i + 1, "names an option of the command line; name the field, as in `radius`"));
    }
  }
  return findings;
}

Findings field_findings(const SourceFile& file, const SourceFile& flags) {
  static const std::regex kField(R"(`([^`]*)`)");
  Findings findings;
  // The columns of tables are described for a document, where backticks mark what a cell holds.
  if (!is_of_library(file) || declares_columns(file)) return findings;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    for (const std::string& text : literals(file.lines[i])) {
      for (const std::smatch& match : matches(text, kField)) {
        const std::string entry = "{\"" + match[1].str() + "\", \"";
        const bool known = std::any_of(
            flags.lines.begin(), flags.lines.end(),
            [&](const std::string& line) { return line.find(entry) != std::string::npos; });
        if (known) continue;
        findings.push_back(
            finding(file, i + 1, "names `" + match[1].str() + "`, which " + flags.path + " lacks"));
      }
    }
  }
  return findings;
}

Findings repeated_key_findings(const SourceFile& references) {
  const std::multimap<std::string, std::size_t> keys = bibliography_keys(references);
  Findings findings;
  for (const auto& [key, line] : keys) {
    if (keys.lower_bound(key)->second != line) {
      findings.push_back(finding(references, line, "key " + key + " stands twice"));
    }
  }
  return findings;
}

Findings named_file_findings(const SourceFile& document, const std::vector<SourceFile>& tree) {
  static const std::regex kSource(R"(`([\w/.-]+\.[ch]pp)`)");
  Findings findings;
  if (!document.path.ends_with(".md")) return findings;
  for (std::size_t i = 0; i < document.lines.size(); ++i) {
    for (const std::smatch& match : matches(document.lines[i], kSource)) {
      const std::string name = match[1].str();
      const bool exists = std::any_of(tree.begin(), tree.end(),
                                      [&](const SourceFile& file) { return file.path == name; });
      if (!exists)
        findings.push_back(finding(document, i + 1, "names " + name + ", which is gone"));
    }
  }
  return findings;
}

}  // namespace clast::architecture
