// Terrains: what `clast terrain` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/watched_call.hpp"
#include "report/maps/site_map.hpp"
#include "report/maps/svg_map.hpp"
#include "study/campaign/release_points.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_fit.hpp"
#include "terrain/terrain_input.hpp"

namespace clast::python_detail {

namespace py = pybind11;
using namespace pybind11::literals;
namespace fs = std::filesystem;

namespace {

std::shared_ptr<Terrain> read_terrain_files(const py::dict& keywords) {
  Keywords given(keywords);
  TerrainOptions options;
  for (const std::string& input : given.read_texts("inputs")) options.surface.emplace_back(input);
  for (const std::string& zones : given.read_texts("zones")) {
    for (const std::string& zone : split_comma_separated(zones)) options.zones.push_back(zone);
  }
  for (const std::string& lines : given.read_texts("breaklines"))
    options.breaklines.emplace_back(lines);
  given.read("up", options.up);
  options.columns = given.read_texts("columns");
  given.read("resolution", options.resolution);
  given.read("percentile", options.percentile);
  given.read("outliers", options.outliers);
  given.read("fill", options.fill);
  given.read("crack", options.crack);
  given.read("spikes", options.spike_steepness);
  given.read("smoothing", options.smoothing);
  given.read("tolerance", options.tolerance);
  given.read("cut_zones", options.cut_zones);
  given.check_all_used();
  return run_without_gil([&] {
    options.check();
    return std::make_shared<Terrain>(read_terrain(options));
  });
}

py::dict report_of(const Terrain& terrain) {
  const TerrainReport& report = terrain.report;
  return py::dict(
      "triangles_read"_a = report.triangles_read, "welded_vertices"_a = report.welded_vertices,
      "dropped_degenerate"_a = report.removed_degenerate,
      "dropped_duplicates"_a = report.removed_duplicates,
      "turned_triangles"_a = report.flipped_triangles, "closed_cracks"_a = report.closed_cracks,
      "filled_holes"_a = report.filled_holes, "open_holes"_a = report.open_holes,
      "levelled_spikes"_a = report.levelled_spikes, "dropped_pieces"_a = report.removed_components,
      "slivers"_a = report.slivers, "boundary_edges"_a = report.boundary_edges,
      "components"_a = report.components, "notes"_a = report.notes);
}

/// Points in an array, or in a file whose axis `up` points up.
std::vector<Vec3> take_places(Keywords& given) {
  std::string up = "z";
  given.read("up", up);
  if (up != "y" && up != "z") throw InputError("up = \"" + up + "\" must be \"y\" or \"z\"");
  if (!given.has("release")) return {};
  const py::object release = given.given_object("release");
  if (!py::isinstance<py::str>(release) && !py::hasattr(release, "__fspath__")) {
    return parse_points(release, "release");
  }
  std::vector<Vec3> places = read_point_table(py::cast<fs::path>(release));
  if (up == "y") {
    for (Vec3& place : places) place = y_up_to_z_up(place);
  }
  return places;
}

/// Warnings about places that blocks start from, and about the size of blocks.
std::vector<std::string> check_fit(const Terrain& terrain, const py::dict& keywords) {
  Keywords given(keywords);
  const std::vector<Vec3> places = take_places(given);
  std::optional<double> border_distance, block_size;
  given.read("border_distance", border_distance);
  given.read("block_size", block_size);
  given.check_all_used();
  std::vector<std::string> warnings;
  const auto add = [&](const std::optional<std::string>& warning) {
    if (warning) warnings.push_back(*warning);
  };
  if (!places.empty()) {
    check_positions_over_terrain(terrain, places, "release");
    if (border_distance) add(border_warning(terrain, places, *border_distance));
  }
  if (block_size) add(edge_length_warning(terrain, *block_size, *block_size));
  return warnings;
}

void draw(const Terrain& terrain, const fs::path& path, const py::dict& keywords) {
  Keywords given(keywords);
  std::vector<Vec2> releases;
  for (const Vec3& place : take_places(given)) releases.push_back(place.head<2>());
  std::optional<fs::path> barriers;
  bool replace = false;
  given.read("barriers", barriers);
  given.read("replace", replace);
  given.check_all_used();
  run_without_gil([&] {
    if (lower_case_extension(path) != ".svg") {
      throw InputError(path.string() + ": is a map; its name must end in .svg");
    }
    std::vector<std::vector<Vec2>> lines;
    if (barriers) lines = read_barrier_lines(*barriers, terrain);
    write_output(path, draw_svg_map(make_site_map(terrain, releases, lines)),
                 {.kind = file_kind_by_extension(path), .replace = replace});
  });
}

/// Heights of the ground at places on the map; not a number off it.
py::array_t<double> heights(const Terrain& terrain, const py::object& x, const py::object& y) {
  const auto xs = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(x);
  const auto ys = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(y);
  if (!xs || !ys) throw py::type_error("x and y must be arrays of numbers");
  if (xs.ndim() != 1 || ys.ndim() != 1 || xs.size() != ys.size()) {
    throw InputError("x and y must be arrays of one length");
  }
  std::vector<double> found(static_cast<std::size_t>(xs.size()));
  const double* const eastings = xs.data();
  const double* const northings = ys.data();
  run_without_gil([&] {
    const TerrainSurface surface = make_terrain_surface(terrain);
    const double top = surface.extent().high.z();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Vec3 place = terrain.frame.to_local(Vec3(eastings[i], northings[i], 0.0));
      const std::optional<double> height = surface.height_at(place.x(), place.y(), top);
      found[i] = height ? *height + terrain.frame.origin.z() : NAN;
    }
  });
  return make_owning_array(std::move(found));
}

}  // namespace

void bind_terrains(py::module_& module) {
  py::class_<Terrain, std::shared_ptr<Terrain>>(
      module, "TerrainData", "Checked ground: triangles with zones, and its position on the map.")
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               return make_array_view(
                                   py::cast<const Terrain&>(self).surface.vertices, self);
                             })
      .def_property_readonly("triangles",
                             [](const py::object& self) {
                               return make_array_view(
                                   py::cast<const Terrain&>(self).surface.triangles, self);
                             })
      .def_property_readonly("zones",
                             [](const py::object& self) {
                               const Terrain& terrain = py::cast<const Terrain&>(self);
                               py::array_t<std::uint16_t> zones(
                                   static_cast<py::ssize_t>(terrain.zone.size()),
                                   terrain.zone.data(), self);
                               zones.attr("setflags")(py::arg("write") = false);
                               return zones;
                             })
      .def_readonly("zone_names", &Terrain::zone_names)
      .def_property_readonly("origin", [](const Terrain& t) { return to_array(t.frame.origin); })
      .def_property_readonly("crs", [](const Terrain& t) { return t.frame.crs; })
      .def_readonly("sources", &Terrain::sources)
      .def("report", &report_of)
      .def("heights", &heights)
      .def("check_fit", &check_fit)
      .def("draw", &draw)
      .def("write",
           [](const Terrain& terrain, const fs::path& path, bool replace) {
             run_without_gil([&] {
               write_terrain(path, terrain, {.kind = kTerrainFormat, .replace = replace});
             });
           })
      .def("export", [](const Terrain& terrain, const fs::path& path, const std::string& up,
                        double cell, bool replace) {
        run_without_gil([&] {
          export_terrain(path, terrain, up, cell,
                         {.kind = file_kind_by_extension(path), .replace = replace});
        });
      });
  module.def("terrain_read", &read_terrain_files);
}

}  // namespace clast::python_detail
