// Blocks, their cores and their shape classes.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "classify/certainty.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/block_measures.hpp"
#include "library/unscaled.hpp"
#include "massprops/solid.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/json/block_json.hpp"
#include "report/text/block_text.hpp"

namespace clast::python_detail {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// The name of a scheme as an attribute has it: "sneed_folk".
std::string key_of(std::string scheme) {
  std::replace(scheme.begin(), scheme.end(), '-', '_');
  return scheme;
}

py::dict classes_of(const Axes& axes, double axis_error, const SchemeOptions& options) {
  options.check();
  py::dict classes;
  for (const std::string& scheme : scheme_names()) {
    classes[py::str(key_of(scheme))] = assess_class_certainty(scheme, axes, axis_error, options);
  }
  return classes;
}

SchemeOptions scheme_options(Keywords& given) {
  SchemeOptions options;
  given.read("thirds", options.sneed_folk_thirds);
  given.read("erdogan_limit", options.erdogan_limit);
  return options;
}

/// The scan's extents are within twice the deviation of the block's.
double axis_error_of(const Block& block) { return 2.0 * block.deviation.hausdorff; }

Axes axes_of(const OrientedBox& box) { return {box.lengths[0], box.lengths[1], box.lengths[2]}; }

py::dict classify_block(const Block& block, const py::kwargs& keywords) {
  Keywords given(keywords);
  const SchemeOptions options = scheme_options(given);
  std::string box = "smallest";
  double axis_error = axis_error_of(block);
  given.read("box", box);
  given.read("axis_error", axis_error);
  given.check_all_used();
  return classes_of(axes_of(block_box(block, parse_box_convention(box))), axis_error, options);
}

py::dict classify_axes(double l, double i, double s, const py::kwargs& keywords) {
  Keywords given(keywords);
  const SchemeOptions options = scheme_options(given);
  double axis_error = kTapeError;
  given.read("axis_error", axis_error);
  given.check_all_used();
  return classes_of(Axes::sorted(l, i, s), axis_error, options);
}

/// Value of a block in metres; NaN for an unscaled block, whose mass is undefined.
template <class Value>
auto if_scaled(const Block& block, Value value) {
  if (!is_unscaled(block)) return value;
  if constexpr (std::is_same_v<Value, double>) {
    return static_cast<double>(NAN);
  } else {
    value.setConstant(NAN);
    return value;
  }
}

/// The part of a Python block that a view may refer to.
template <class Part>
auto part(const Part& of) {
  return [of](const py::object& self) { return of(py::cast<const Block&>(self), self); };
}

py::tuple faces_of(const SpheroPolyhedron& core, const py::object& self) {
  py::tuple faces(core.faces.size());
  for (std::size_t i = 0; i < core.faces.size(); ++i)
    faces[i] = make_array_view(core.faces[i], self);
  return faces;
}

py::array edges_of_core(const SpheroPolyhedron& core) {
  py::array_t<std::uint32_t> edges({static_cast<py::ssize_t>(core.edges.size()), py::ssize_t{2}});
  auto cells = edges.mutable_unchecked<2>();
  for (std::size_t i = 0; i < core.edges.size(); ++i) {
    for (py::ssize_t end = 0; end < 2; ++end) {
      cells(static_cast<py::ssize_t>(i), end) = core.edges[i][static_cast<std::size_t>(end)];
    }
  }
  return edges;
}

py::tuple skin_of(const SpheroPolyhedron& shape, int segments) {
  if (segments < 1 || segments > 64) {
    throw InputError("segments = " + std::to_string(segments) + " must be from 1 to 64");
  }
  TriangleMesh skin;
  {
    const py::gil_scoped_release release;
    skin = rounded_surface_mesh(shape, segments);
  }
  return to_arrays(std::move(skin));
}

py::bytes picture_of(const Block& block, std::uint32_t width, std::uint32_t height) {
  if (width < 16 || width > 4096 || height < 16 || height > 4096) {
    throw InputError("width and height of a picture must be from 16 to 4096");
  }
  std::string png;
  {
    const py::gil_scoped_release release;
    png = report_detail::render_thumbnail_png(rounded_surface_mesh(block.body), width, height);
  }
  return py::bytes(png);
}

void bind_shape_class(py::module_& module) {
  py::class_<ClassCertainty>(module, "ShapeClass",
                             "A shape class with its distance from the nearest limit, and whether "
                             "it is certain within the error of the axes.")
      .def_readonly("name", &ClassCertainty::name,
                    "Name of the class, such as \"CB\" or \"compact\".")
      .def_readonly("ratio", &ClassCertainty::nearest_ratio,
                    "Name of the ratio that is nearest to a class limit.")
      .def_readonly("value", &ClassCertainty::ratio_value, "Value of the ratio.")
      .def_readonly("limit", &ClassCertainty::nearest_limit, "Limit nearest to the ratio.")
      .def_readonly("distance", &ClassCertainty::distance, "Distance between value and limit.")
      .def_readonly(
          "near_limit", &ClassCertainty::near_limit,
          "True if the value is closer to the limit than 0.05 or than the error of the axes.")
      .def_readonly("survives", &ClassCertainty::is_certain,
                    "True if the class is the same for all axes within their error.")
      .def_readonly("others", &ClassCertainty::other_possible_classes,
                    "All other classes that are possible for axes within their error.")
      .def("__str__", [](const ClassCertainty& one) { return one.name; })
      .def("__repr__", [](const ClassCertainty& one) {
        return "<" + one.name + ": " + describe_certainty(one) + ">";
      });
}

void bind_core(py::module_& module) {
  py::class_<SpheroPolyhedron, std::shared_ptr<SpheroPolyhedron>>(
      module, "Core",
      "The polyhedron over which a sphere is swept. The block is the set of all points within the "
      "radius of it.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return make_array_view(py::cast<const SpheroPolyhedron&>(self).vertices, self);
          },
          "Corners, m; float64 (n, 3), a view.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return faces_of(py::cast<const SpheroPolyhedron&>(self), self);
          },
          "Planar polygons, counter-clockwise from outside: uint32 arrays of indices, views.")
      .def_property_readonly("edges", &edges_of_core, "Pairs of indices; uint32 (m, 2).")
      .def_readonly("radius", &SpheroPolyhedron::radius, "Minkowski radius, m.")
      .def(
          "mesh", [](const SpheroPolyhedron& core) { return to_arrays(core_mesh(core)); },
          "(vertices (n, 3), triangles (m, 3)): the core, with its polygons divided into "
          "triangles.");
}

}  // namespace

void bind_blocks(py::module_& module) {
  bind_shape_class(module);
  bind_core(module);
  py::class_<Block, std::shared_ptr<Block>> block(
      module, "Block",
      "A rock block: a polyhedron swept by a sphere, with exact mass properties.\n\n"
      "Geometric values are in the frame of the scan, in metres, z up. If unscaled is true, "
      "lengths are in\nunits of the scan, and mass, inertia and moments are NaN.");
  block.def_readonly("id", &Block::id, "Name in its library.")
      .def_property_readonly(
          "mass", [](const Block& b) { return if_scaled(b, b.mass.mass); }, "kg")
      .def_property_readonly(
          "volume", [](const Block& b) { return b.mass.volume; }, "m^3")
      .def_readonly("density", &Block::density, "kg/m^3")
      .def_readonly("area", &Block::area, "Area of the rounded surface, m^2.")
      .def_property_readonly(
          "centre", [](const Block& b) { return to_array(b.mass.centre); },
          "Centre of mass, m; float64 (3,).")
      .def_property_readonly(
          "inertia", [](const Block& b) { return to_array(if_scaled(b, b.mass.inertia)); },
          "Inertia tensor about the centre of mass, along the axes of the scan, kg m^2; float64 "
          "(3, 3).")
      .def_property_readonly(
          "principal_moments",
          [](const Block& b) { return to_array(if_scaled(b, b.principal.moments)); },
          "Principal moments, ascending, kg m^2; float64 (3,).")
      .def_property_readonly(
          "principal_axes",
          [](const Block& b) { return to_array(Mat3(b.principal.rotation.toRotationMatrix())); },
          "Matrix whose columns are the principal axes in the frame of the scan; float64 (3, 3).")
      .def_property_readonly(
          "box_lengths", [](const Block& b) { return to_array(b.box.lengths); },
          "Sides L >= I >= S of the smallest box, m; float64 (3,).")
      .def_property_readonly(
          "box_axes", [](const Block& b) { return to_array(b.box.axes); },
          "Matrix whose columns are the directions of L, I, S; float64 (3, 3).")
      .def_property_readonly(
          "box_centre", [](const Block& b) { return to_array(b.box.centre); }, "m; float64 (3,).");
  block
      .def_property_readonly(
          "core", [](const Block& b) { return &b.body; },
          py::return_value_policy::reference_internal, "The polyhedron with its radius.")
      .def_property_readonly("surface", part([](const Block& b, const py::object& self) {
                               return py::make_tuple(make_array_view(b.surface.vertices, self),
                                                     make_array_view(b.surface.triangles, self));
                             }),
                             "(vertices (n, 3) m, triangles (m, 3)): the simplified, closed scan "
                             "from which the block was made; views.")
      .def(
          "skin", [](const Block& b, int segments) { return skin_of(b.body, segments); },
          "segments"_a = 4,
          "(vertices (n, 3) m, triangles (m, 3)): the rounded surface.\n\n"
          "segments: segments per quarter circle, 1 to 64.")
      .def_property_readonly(
          "classes", [](const Block& b) { return classes_of(b.axes(), axis_error_of(b), {}); },
          "ShapeClass by scheme: \"sneed_folk\", \"zingg\", \"garcia\", ...; the error of the axes "
          "is twice the deviation from the scan.")
      .def(
          "classify", &classify_block,
          "Shape classes for another box, error or limits.\n\n"
          "box: \"smallest\", \"inertia\", \"feret\" or \"pca\"; axis_error: m; thirds: limits 1/3 "
          "and 2/3 of Sneed & Folk; erdogan_limit: ratio.")
      .def_property_readonly(
          "indices", [](const Block& b) { return block_indices(b, b.axes()); },
          "Indices of form and surface by name (docs/theory.md).")
      .def(
          "roundness",
          [](const Block& b, double edge_length) {
            const Roundness measured =
                run_without_gil([&] { return block_roundness(b, edge_length); });
            return measured.value;
          },
          "edge_length"_a,
          "Wadell's roundness, measured on triangles with edges of this length, m.")
      .def_readonly("warnings", &Block::warnings, "Warnings about the block.")
      .def_property_readonly("unscaled", &is_unscaled,
                             "True if the scale of the scan is not known.")
      .def_property_readonly(
          "deviation", [](const Block& b) { return b.deviation.hausdorff; },
          "Hausdorff distance to the scan, m.")
      .def(
          "to_dict", [](const Block& b) { return to_python_object(block_json(b)); },
          "All data of the block, as printed by clast show as JSON.")
      .def("picture", &picture_of, "width"_a = 320, "height"_a = 256,
           "PNG of the rounded surface, seen from the front and above.")
      .def("_repr_png_", [](const Block& b) { return picture_of(b, 320, 256); })
      .def("__repr__", [](const Block& b) { return "<clast.Block " + format_block_line(b) + ">"; });
  module.def("shape_classes", &classify_axes, "L"_a, "I"_a, "S"_a,
             "ShapeClass by scheme for axes in metres, in any order.\n\n"
             "axis_error: error of the axes, m, default 0.05 (tape); thirds, erdogan_limit: as in "
             "Block.classify.");
  module.def(
      "mass_properties",
      [](const py::object& vertices, const py::object& triangles, double density) {
        const TriangleMesh mesh = parse_mesh(vertices, triangles);
        const MassProperties found =
            run_without_gil([&] { return solid_mass_properties(mesh, density); });
        return py::dict("volume_m3"_a = found.volume, "mass_kg"_a = found.mass,
                        "centre_m"_a = to_array(found.centre),
                        "inertia_kg_m2"_a = to_array(found.inertia));
      },
      "vertices"_a, "triangles"_a, "density"_a = 2650.0,
      "Mass properties of the solid that a closed mesh bounds, in closed form.\n\n"
      "vertices: (n, 3) m; triangles: (m, 3) indices, counter-clockwise from outside; read in "
      "place. density: kg/m^3.");
}

}  // namespace clast::python_detail
