#include "app/commands/scene_export.hpp"

#include <charconv>
#include <iostream>

#include "app/option_flags.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "study/engines/engine_scene.hpp"

namespace clast {

namespace {

constexpr std::uint32_t kMaxRuns = 100000;

std::uint32_t run_number(const std::string& text) {
  std::uint32_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, number);
  if (code != std::errc() || stop != end || number >= kMaxRuns) {
    throw CLI::ValidationError("--runs",
                               "\"" + text + "\" is not a run number; give for example 0-15,20");
  }
  return number;
}

/// "0-2,7" is 0, 1, 2, 7.
std::vector<std::uint32_t> run_numbers(const std::string& text) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t at = 0; at <= text.size() && !text.empty();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string item = text.substr(at, comma - at);
    const std::size_t dash = item.find('-');
    const std::uint32_t first = run_number(item.substr(0, dash));
    const std::uint32_t last =
        dash == std::string::npos ? first : run_number(item.substr(dash + 1));
    if (last < first) {
      throw CLI::ValidationError("--runs", "\"" + item + "\" has its larger number first");
    }
    for (std::uint32_t number = first; number <= last; ++number) numbers.push_back(number);
    at = comma + 1;
  }
  return numbers;
}

}  // namespace

void add_scene_options(CLI::App& command, SceneExportArgs& args) {
  command
      .add_option(
          "--runs", args.runs,
          "Runs of the campaign, or realisations of its rock mass, to export, for example 0-15,20; "
          "default: all")
      ->type_name("LIST");
}

void export_scenes(const std::filesystem::path& campaign, const std::filesystem::path& folder,
                   bool replace, const SceneExportArgs& args) {
  const std::vector<std::uint32_t> runs = run_numbers(args.runs);
  OutputFolder output(folder, scene_folder_kind(), replace);
  const CampaignPlan prepared = prepare_campaign(read_campaign(campaign));
  for (const std::string& warning : prepared.header.warnings) {
    std::cerr << "warning: " << format_for_terminal(warning) << "\n";
  }
  const EngineScenes scenes =
      write_engine_scenes(prepared, {.engine = args.engine, .runs = runs}, output.temporary_path());
  output.commit();
  for (const std::string& note : scenes.notes) std::cout << "note: " << note << "\n";
  std::cout << escape_nonprintable(folder.string()) << ": "
            << format_count(scenes.folders.size(), "scene") << " for " << args.engine
            << " written; SCENE.txt there describes their files\n";
}

}  // namespace clast
