// Twins and series of blocks: what `clast vary` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>
#include <set>

#include "classify/dimension_table.hpp"
#include "classify/form_grid.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/block_ranges.hpp"
#include "library/block_series.hpp"
#include "library/library_update.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/json/series_json.hpp"

namespace clast::python_detail {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

constexpr NumberRange kRatio{0.01, 1.0};

/// What is asked of a series.
struct SeriesRequest {
  fs::path library;
  std::vector<std::string> ids, like;
  std::vector<Variation> variations;
  std::optional<std::size_t> draw;
  std::optional<fs::path> table;
  std::optional<std::string> units;  ///< of the table
  std::string prefix = "V";
  std::uint64_t seed = 1;
  SeriesOptions options;
  std::optional<fs::path> output;
  bool replace = false;
};

template <class Value>
std::vector<Value> several(Keywords& given, const char* name) {
  std::vector<Value> values;
  given.take(name, values);
  return values;
}

void take_forms(Keywords& given, std::vector<Variation>& variations) {
  for (const auto& [i_l, s_l] : several<std::pair<double, double>>(given, "to")) {
    if (!kRatio.holds(i_l) || !kRatio.holds(s_l) || s_l > i_l) {
      throw InputError("to: (" + with_digits(i_l, 6) + ", " + with_digits(s_l, 6) +
                       ") must be I/L and S/L, both " + kRatio.words() + " and S/L at most I/L");
    }
    variations.emplace_back(StretchTo{{i_l, s_l}});
  }
  double least = 0.2;
  given.take("least", least);
  std::optional<std::pair<std::string, int>> grid;
  given.take("grid", grid);
  if (!grid) return;
  const auto& [diagram, steps] = *grid;
  const bool known = diagram == "sneed-folk" || diagram == "zingg";
  if (!known || steps < 1 || steps > 100 || !(least >= 0.01 && least <= 0.99)) {
    throw InputError(
        "grid: give (\"sneed-folk\" or \"zingg\", steps from 1 to 100), and least "
        "from 0.01 to 0.99");
  }
  for (const Axes& axes :
       diagram == "zingg" ? zingg_grid(steps, least) : sneed_folk_grid(steps, least)) {
    variations.emplace_back(StretchTo{{axes.I / axes.L, axes.S / axes.L}});
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
  check_block_id(request.prefix + "0001");
  if (request.variations.empty() && request.like.empty() && !request.draw) {
    throw InputError("nothing is asked for; give for example to, grid, like, convexity or draw");
  }
  return request;
}

std::vector<DrawnBlock> population_of(const SeriesRequest& request,
                                      std::span<const Block* const> parents) {
  if (!request.table) return drawn_from(parents);
  std::vector<DrawnBlock> population;
  DimensionColumns columns;
  if (request.units) columns.units = length_unit(*request.units);
  for (const MeasuredBlock& block : read_dimension_table(*request.table, columns).blocks) {
    if (!kBlockLength.holds(block.axes.L) || !kBlockLength.holds(block.axes.S)) {
      throw InputError(request.table->string() + ": block " + block.name + " is " +
                       with_digits(block.axes.L, 4) + " x " + with_digits(block.axes.S, 4) +
                       " m; L and S must be " + kBlockLength.words() + "; give their units");
    }
    population.push_back({block.axes, std::nullopt});
  }
  return population;
}

std::vector<VariationRequest> bodies_wanted(const SeriesRequest& request,
                                            const BlockLibrary& library,
                                            std::optional<CopulaFit>& fit) {
  const std::vector<const Block*> parents = library.chosen(request.ids);
  std::vector<Variation> variations = request.variations;
  for (const std::string& id : request.like) {
    variations.emplace_back(StretchTo{box_ratios(library.block(id).box)});
  }
  std::vector<VariationRequest> wanted = variations_of(parents, variations);
  if (request.draw) {
    DrawnSeries drawn = draw_series(parents, population_of(request, parents), *request.draw,
                                    request.seed, request.prefix);
    fit = std::move(drawn.fit);
    wanted.insert(wanted.end(), drawn.requests.begin(), drawn.requests.end());
  }
  std::set<std::string> ids;
  for (const VariationRequest& one : wanted) {
    if (ids.insert(one.id).second) continue;
    throw InputError("\"" + one.id + "\" is asked for twice; ask for each body once");
  }
  return wanted;
}

/// (blocks, why bodies could not be made, what `series_json` says)
py::tuple vary(const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  SeriesRequest request = request_from(given);
  std::optional<CopulaFit> fit;
  BlockSeries series = watched(progress, [&](const Progress& step) {
    if (request.output) check_library_place(*request.output);
    const BlockLibrary library = BlockLibrary::read(request.library);
    BlockSource source{as_utf8(request.library.string()), sha256_of_file(request.library), "", ""};
    if (request.draw) source.options = "seed=" + std::to_string(request.seed);
    if (request.table) source.options += " population_sha256=" + sha256_of_file(*request.table);
    request.options.progress = step;
    BlockSeries made = make_series(bodies_wanted(request, library, fit), source, request.options);
    if (made.blocks.empty()) {
      throw GeometryError("no body could be made; the first: " + made.failed.front());
    }
    if (request.output) {
      update_library(*request.output, {.make = true}, [&](BlockLibrary& changed) {
        for (const Block& block : made.blocks) changed.add(block, request.replace);
      });
    }
    return made;
  });
  const py::object json = object_of(series_json(series, fit));
  py::list blocks;
  for (Block& block : series.blocks) blocks.append(std::make_shared<Block>(std::move(block)));
  return py::make_tuple(blocks, series.failed, json);
}

}  // namespace

void bind_variations(py::module_& module) { module.def("vary", &vary); }

}  // namespace clast::python_detail
