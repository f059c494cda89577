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

SeriesTargets steps_from(Keywords& given) {
  SeriesTargets steps;
  std::vector<std::pair<double, double>> to;
  given.take("to", to);
  for (const auto& [i_l, s_l] : to) {
    steps.ratios.push_back(check_stretch_ratios(
        i_l, s_l, "(" + format_significant(i_l, 6) + ", " + format_significant(s_l, 6) + ")"));
  }
  FormGrid grid;
  std::optional<std::pair<std::string, int>> diagram;
  given.take("least", grid.least);
  given.take("grid", diagram);
  if (diagram) {
    std::tie(grid.diagram, grid.steps) = *diagram;
    steps.grid = grid;
  }
  given.take("convexity", steps.convexity);
  given.take("rounding", steps.rounding);
  given.take("roundness", steps.roundness);
  given.take("roundness_edge", steps.roundness_edge);
  given.take("vertices", steps.vertices);
  given.take("detail", steps.detail);
  given.take("degree", steps.degree);
  given.take("exponent", steps.exponent);
  steps.reference = given.texts("reference");
  steps.inertia = given.texts("inertia");
  return steps;
}

SeriesRequest series_request(Keywords& given) {
  SeriesRequest request;
  std::string keep = "mass";
  given.take("library", request.library);
  request.ids = given.texts("ids");
  request.like_ids = given.texts("like");
  request.steps = steps_from(given);
  given.take("draw", request.draw);
  given.take("table", request.table);
  given.take("units", request.units);
  given.take("prefix", request.prefix);
  given.take("seed", request.seed);
  given.take("keep", keep);
  given.take("threads", request.options.threads);
  given.take("output", request.output);
  given.take("replace", request.replace);
  given.check_all_used();
  request.options.variation.keep = parse_preserved_size(keep);
  request.check();
  return request;
}

/// (blocks, why bodies could not be made, what `series_json` says)
py::tuple vary(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  SeriesRequest request = series_request(given);
  SeriesResult made = run_with_progress(progress, [&](const ProgressCallback& step) {
    request.options.progress = step;
    return make_series(request);
  });
  const py::object json = to_python_object(series_json(made.series, made.fit));
  py::list blocks;
  for (Block& block : made.series.blocks) blocks.append(std::make_shared<Block>(std::move(block)));
  return py::make_tuple(blocks, made.series.failures, json);
}

}  // namespace

void bind_variations(py::module_& module) { module.def("vary", &vary); }

}  // namespace clast::python_detail
