// Campaigns: what `clast new campaign`, `check` and `simulate` do.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/text_file.hpp"
#include "core/files/toml_reader.hpp"
#include "core/parallel.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/json/campaign_json.hpp"
#include "report/json/key_schema.hpp"
#include "report/maps/site_map.hpp"
#include "report/maps/svg_map.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/compare/outcome.hpp"
#include "study/engines/engine_results.hpp"
#include "study/engines/engine_scene.hpp"
#include "study/proposal/new_campaign.hpp"
#include "study/simulate/campaign_check.hpp"
#include "study/simulate/results_place.hpp"

namespace clast::python_detail {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

py::object object_of_node(const TomlNode& node) {
  switch (node.kind) {
    case TomlNode::Kind::kBoolean:
      return py::bool_(node.boolean);
    case TomlNode::Kind::kInteger:
      return py::int_(node.integer);
    case TomlNode::Kind::kFloat:
      return py::float_(node.number);
    case TomlNode::Kind::kString:
      return py::str(node.text);
    case TomlNode::Kind::kDate:  // no key takes one; it is refused as the text it is
      return py::str(node.source_text);
    case TomlNode::Kind::kList: {
      py::list list;
      for (const TomlNode& item : node.list) list.append(object_of_node(item));
      return list;
    }
    case TomlNode::Kind::kTable:
      break;
  }
  py::dict table;
  for (const auto& [name, value] : node.table) table[py::str(name)] = object_of_node(value);
  return table;
}

/// (text, what is in it)
py::tuple read_campaign_text(const fs::path& file) {
  std::string text;
  const TomlNode root = run_without_gil([&] {
    text = read_text_file(file);
    return parse_toml(text, file.string());
  });
  return py::make_tuple(text, object_of_node(root));
}

/// (findings, the plan or None)
py::tuple check(const std::string& text, const fs::path& file) {
  const CampaignCheck check = run_with_progress(
      py::none(), [&](const ProgressCallback&) { return check_campaign_text(text, file); });
  const py::object plan =
      check.prepared ? to_python_object(plan_json(*check.prepared)) : py::none();
  return py::make_tuple(check.findings, plan);
}

std::optional<Shard> take_shard(Keywords& given) {
  std::optional<std::pair<std::uint32_t, std::uint32_t>> pair;
  given.read("shard", pair);
  if (!pair) return std::nullopt;
  const Shard shard{pair->first, pair->second};
  shard.check();
  return shard;
}

/// Refuses places as the program does, before anything runs.
/// @return whether all is done already
bool check_place(const fs::path& target, const CampaignPlan& prepared,
                 const CampaignRunOptions& options) {
  const bool begun = fs::exists(results_journal_path(target));
  if (options.resume && !options.replace && !begun &&
      has_finished_results(target, prepared.header, options.shard.run_count(prepared))) {
    return true;
  }
  if (!options.resume) check_not_interrupted(target);
  return false;
}

/// Returns the path of the results.
std::string run(const std::string& text, const fs::path& file, const fs::path& output,
                const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  CampaignRunOptions options;
  given.read("threads", options.threads);
  given.read("resume", options.resume);
  given.read("replace", options.replace);
  given.read("checkpoint_interval", options.checkpoint_interval);
  const std::optional<Shard> shard = take_shard(given);
  given.check_all_used();
  options.shard = shard.value_or(Shard());
  const fs::path target = shard_results_path(output, shard);
  call_with_progress(progress, [&](const ProgressCallback& step) {
    const bool keep =
        !options.replace && !options.resume && !fs::exists(results_journal_path(target));
    check_results_target(target, !keep);
    const CampaignPlan prepared = prepare_campaign(parse_campaign(text, file));
    if (!check_place(target, prepared, options)) {
      options.progress = step;
      run_campaign(prepared, target, options);
    }
    check_no_failed_runs(read_results(target), target);
  });
  return target.string();
}

/// Returns what `clast simulate --dry-run --json` prints; writes `map` if it is given.
py::object dry_run(const std::string& text, const fs::path& file, const py::dict& keywords) {
  constexpr double kProbeTime = 2.0;  // s
  Keywords given(keywords);
  unsigned threads = 0;
  std::optional<fs::path> map;
  std::optional<double> margin;
  given.read("threads", threads);
  given.read("margin", margin);
  given.read("map", map);
  const Shard shard = take_shard(given).value_or(Shard());
  given.check_all_used();
  const auto summary = run_with_progress(py::none(), [&](const ProgressCallback&) {
    const CampaignPlan prepared = prepare_campaign(parse_campaign(text, file));
    OverwritePolicy rules;
    if (map) {
      rules.kind = file_kind_by_extension(*map);
      check_output_target(*map, rules);
    }
    const RunTimeProbe probe = measure_run_time(prepared, kProbeTime);
    nlohmann::ordered_json json = plan_json(prepared);
    json["expected_time_s"] = estimate_time(prepared, probe, shard, resolve_thread_count(threads));
    PlannedPower power = compute_planned_power(prepared, probe);
    power.margin = margin;
    json.update(power_json(power));
    json["probed_runs"] = probe.runs;
    json["probe_cut_short"] = probe.last_run_stopped;
    json["probe_failure"] = probe.first_failure;
    json["threads"] = resolve_thread_count(threads);
    if (map) {
      write_output(*map, draw_svg_map(make_site_map(prepared.header)), rules);
      json["map"] = map->string();
    }
    return json;
  });
  return to_python_object(summary);
}

/// Doubts about what is proposed, in words.
std::vector<std::string> make_new(const fs::path& library, const py::object& terrain,
                                  const fs::path& output, bool replace) {
  std::vector<fs::path> surface;
  for (const std::string& one : parse_texts(terrain, "terrain")) surface.emplace_back(one);
  return run_with_progress(py::none(), [&](const ProgressCallback&) {
    return write_new_campaign(library, surface, output, {.replace = replace}).proposal_warnings;
  });
}

/// (folders, what the other engine can't say)
py::tuple export_scenes(const std::string& text, const fs::path& file, const fs::path& folder,
                        const py::dict& keywords) {
  Keywords given(keywords);
  EngineSceneOptions options;
  bool replace = false;
  given.read("to", options.engine);
  given.read("runs", options.runs);
  given.read("replace", replace);
  given.check_all_used();
  const EngineScenes scenes = run_with_progress(py::none(), [&](const ProgressCallback&) {
    options.check();
    OutputFolder output(folder, scene_folder_kind(), replace);
    EngineScenes written = write_engine_scenes(prepare_campaign(parse_campaign(text, file)),
                                               options, output.temporary_path());
    output.commit();
    return written;
  });
  std::vector<std::string> folders;
  for (const std::string& name : scenes.folders) folders.push_back((folder / name).string());
  return py::make_tuple(folders, scenes.notes);
}

/// (runs, scenes without results, notes)
py::tuple import_results(const std::string& engine, const fs::path& scenes, const fs::path& output,
                         const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  EngineResultsOptions options{.engine = engine, .scenes = scenes};
  given.read("campaign", options.campaign);
  given.read("replace", options.replace);
  given.check_all_used();
  const EngineImportSummary found = run_with_progress(progress, [&](const ProgressCallback& step) {
    options.progress = step;
    return import_engine_results(options, output);
  });
  return py::make_tuple(found.runs, found.without_output, found.notes);
}

void merge(const py::object& parts, const fs::path& output, bool replace) {
  std::vector<fs::path> files;
  for (const std::string& part : parse_texts(parts, "parts")) files.emplace_back(part);
  run_without_gil([&] {
    check_results_target(output, replace);
    merge_results(files, output);
  });
}

}  // namespace

void bind_campaigns(py::module_& module) {
  module.attr("campaign_tables") = key_tables_to_dict(campaign_key_tables());
  module.def("campaign_schema", [] { return to_python_object(campaign_schema()); });
  module.def("campaign_read", &read_campaign_text);
  module.def("campaign_write", [](const fs::path& file, const std::string& text, bool replace) {
    write_output(file, text, {.kind = "text", .replace = replace});
  });
  module.def("campaign_check", &check);
  module.def("campaign_run", &run);
  module.def("campaign_dry_run", &dry_run);
  module.def("campaign_export", &export_scenes);
  module.def("new_campaign", &make_new);
  module.def("import_results", &import_results);
  module.def("merge_results", &merge);
}

}  // namespace clast::python_detail
