// Twins and series of blocks: what `clast vary` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

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

template <class Value>
std::vector<Value> several(Keywords& given, const char* name) {
  std::vector<Value> values;
  given.take(name, values);
  return values;
}

void take_forms(Keywords& given, std::vector<Variation>& variations) {
  for (const auto& [i_l, s_l] : several<std::pair<double, double>>(given, "to")) {
    variations.emplace_back(
        stretch_to(i_l, s_l, "(" + with_digits(i_l, 6) + ", " + with_digits(s_l, 6) + ")"));
  }
  double least = 0.2;
  given.take("least", least);
  std::optional<std::pair<std::string, int>> grid;
  given.take("grid", grid);
  if (!grid) return;
  for (Variation& form : stretches_over(grid->first, grid->second, least)) {
    variations.push_back(std::move(form));
  }
}

void take_bodies(Keywords& given, std::vector<Variation>& variations) {
  for (const double share : several<double>(given, "convexity")) {
    variations.emplace_back(ConvexityOf{share});
  }
  for (const double share : several<double>(given, "rounding")) {
    variations.emplace_back(RoundingOf{share});
  }
  for (const std::size_t count : several<std::size_t>(given, "vertices")) {
    variations.emplace_back(VertexCount{count});
  }
  int degree = 6;
  double exponent = 4.0;
  given.take("degree", degree);
  given.take("exponent", exponent);
  for (const double gain : several<double>(given, "detail")) {
    variations.emplace_back(DetailTimes{gain, degree});
  }
  for (const std::string& form : given.texts("reference")) {
    variations.emplace_back(ReferenceTo{reference_form(form), exponent});
  }
  for (const std::string& form : given.texts("inertia")) {
    variations.emplace_back(InertiaTwin{reference_form(form)});
  }
}

SeriesRequest request_from(Keywords& given) {
  SeriesRequest request;
  std::string keep = "mass";
  given.take("library", request.library);
  request.ids = given.texts("ids");
  request.like = given.texts("like");
  take_forms(given, request.variations);
  take_bodies(given, request.variations);
  given.take("draw", request.draw);
  given.take("table", request.table);
  given.take("units", request.units);
  given.take("prefix", request.prefix);
  given.take("seed", request.seed);
  given.take("keep", keep);
  given.take("threads", request.options.threads);
  given.take("output", request.output);
  given.take("replace", request.replace);
  given.done();
  request.options.variation.keep = kept_size(keep);
  request.check();
  return request;
}

/// (blocks, why bodies could not be made, what `series_json` says)
py::tuple vary(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  SeriesRequest request = request_from(given);
  RequestedSeries made = watched(progress, [&](const Progress& step) {
    request.options.progress = step;
    return make_series(request);
  });
  const py::object json = object_of(series_json(made.series, made.fit));
  py::list blocks;
  for (Block& block : made.series.blocks) blocks.append(std::make_shared<Block>(std::move(block)));
  return py::make_tuple(blocks, made.series.failed, json);
}

}  // namespace

void bind_variations(py::module_& module) { module.def("vary", &vary); }

}  // namespace clast::python_detail
