// Twins and series of blocks: what `clast vary` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "core/number_text.hpp"
#include "library/series_request.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/json/series_json.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

VariationTargets steps_from(Keywords& given) {
  VariationTargets steps;
  std::vector<std::pair<double, double>> to;
  given.read("to", to);
  for (const auto& [i_l, s_l] : to) {
    steps.ratios.push_back(check_stretch_ratios(
        i_l, s_l, "(" + format_significant(i_l, 6) + ", " + format_significant(s_l, 6) + ")"));
  }
  FormGrid grid;
  std::optional<std::pair<std::string, int>> diagram;
  given.read("least", grid.min_ratio);
  given.read("grid", diagram);
  if (diagram) {
    std::tie(grid.diagram, grid.steps) = *diagram;
    steps.grid = grid;
  }
  given.read("convexity", steps.convexity);
  given.read("rounding", steps.rounding);
  given.read("roundness", steps.roundness);
  given.read("roundness_edge", steps.roundness_edge);
  given.read("vertices", steps.vertices);
  given.read("detail", steps.detail);
  given.read("degree", steps.degree);
  given.read("exponent", steps.exponent);
  steps.reference = given.read_texts("reference");
  steps.inertia = given.read_texts("inertia");
  return steps;
}

VariationSeriesRequest series_request(Keywords& given) {
  VariationSeriesRequest request;
  std::string keep = "mass";
  given.read("library", request.library);
  request.ids = given.read_texts("ids");
  request.target_ratio_ids = given.read_texts("like");
  request.targets = steps_from(given);
  given.read("draw", request.sampled_count);
  given.read("table", request.table);
  given.read("units", request.units);
  given.read("prefix", request.prefix);
  given.read("seed", request.seed);
  given.read("keep", keep);
  given.read("threads", request.options.threads);
  given.read("output", request.output);
  given.read("replace", request.replace);
  given.check_all_used();
  request.options.variation.preserved_size = parse_preserved_size(keep);
  request.check();
  return request;
}

/// (blocks, why bodies could not be made, what `series_json` says)
py::tuple vary(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  VariationSeriesRequest request = series_request(given);
  VariationSeriesResult made = run_with_progress(progress, [&](const ProgressCallback& step) {
    request.options.progress = step;
    return make_variation_series(request);
  });
  const py::object json = to_python_object(series_json(made.series, made.fit));
  py::list blocks;
  for (Block& block : made.series.blocks) blocks.append(std::make_shared<Block>(std::move(block)));
  return py::make_tuple(blocks, made.series.failures, json);
}

}  // namespace

void bind_variations(py::module_& module) { module.def("vary", &vary); }

}  // namespace clast::python_detail
