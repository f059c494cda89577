#include "report/json/block_json.hpp"

#include <algorithm>

#include "classify/axis_orientation.hpp"
#include "core/angle.hpp"
#include "library/block_bracket.hpp"
#include "library/block_measures.hpp"
#include "library/unscaled.hpp"
#include "shapes/edge_convexity.hpp"

namespace clast {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json matrix_json(const Mat3& m) {
  return {vector_json(m.row(0).transpose()), vector_json(m.row(1).transpose()),
          vector_json(m.row(2).transpose())};
}

/// Only what was written down; a block nobody annotated has no field notes.
Json field_json(const FieldNotes& field) {
  Json json = Json::object();
  if (!field.site.empty()) json["site"] = field.site;
  if (!field.note.empty()) json["note"] = field.note;
  if (field.taped_axes)
    json["taped_m"] = {field.taped_axes->L, field.taped_axes->I, field.taped_axes->S};
  if (field.weighed_mass) json["weighed_kg"] = *field.weighed_mass;
  return json;
}

/// L, I, S by every convention.
Json boxes_json(const Block& block) {
  Json json = Json::object();
  for (const BoxConvention convention : kBoxConventions) {
    json[name_of(convention)] = vector_json(block_box(block, convention).lengths);
  }
  return json;
}

Json unseen_json(const Block& block) {
  const VolumeBracket& unseen = *block.volume_bracket;
  const BlockBracket range = derive_block_bracket(block);
  const auto number_or_null = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  const auto sides = [&](Axes AxesBounds::*end) {
    if (!range.axes) return Json(nullptr);
    const Axes& axes = (*range.axes).*end;
    return Json{axes.L, axes.I, axes.S};
  };
  const auto interval = [&](auto&& value) {
    return unseen.intervals ? Json(value(*unseen.intervals)) : Json(nullptr);
  };
  const auto classes = [&](const char* scheme) {
    return range.axes ? Json(range.classes.at(scheme)) : Json(nullptr);
  };
  return {{"invented_share", unseen.filled_fraction},
          {"volume_lower_m3", unseen.lower_volume},
          {"volume_best_m3", unseen.estimated_volume},
          {"volume_upper_m3", number_or_null(unseen.upper_volume)},
          {"volume_lower90_m3", interval([](const SizeIntervals& i) { return i.lower_volume; })},
          {"volume_upper90_m3", interval([](const SizeIntervals& i) { return i.upper_volume; })},
          {"axes_lower90_m",
           interval([](const SizeIntervals& i) { return vector_json(i.sides.lower); })},
          {"axes_upper90_m",
           interval([](const SizeIntervals& i) { return vector_json(i.sides.upper); })},
          {"mass_lower_kg", range.lower_mass},
          {"mass_upper_kg", number_or_null(range.upper_mass)},
          {"density_lower_kg_m3", number_or_null(range.lower_density)},
          {"density_upper_kg_m3", range.upper_density},
          {"axes_lower_m", sides(&AxesBounds::lower)},
          {"axes_upper_m", sides(&AxesBounds::upper)},
          {"s_c_lower", number_or_null(range.lower_s_c)},
          {"s_c_upper", number_or_null(range.upper_s_c)},
          {"sneed_folk", classes("sneed-folk")},
          {"zingg", classes("zingg")},
          {"shape", classes("garcia")},
          {"assumption", unseen.assumption}};
}

Json deposit_json(const Block& block) {
  const DepositRecord& deposit = *block.deposit;
  const AxisOrientation long_axis = axis_orientation(block.box.axes.col(0));
  return {{"points", deposit.points},
          {"spacing_m", deposit.spacing},
          {"visible_fraction", deposit.visible_fraction},
          {"confidence", deposit.confidence},
          {"contacts", deposit.contacts},
          {"blocks", deposit.blocks},
          {"trend_deg", long_axis.trend * kDegreesPerRadian},
          {"plunge_deg", long_axis.plunge * kDegreesPerRadian}};
}

/// Keys of lengths, areas and volumes show that no unit is known; masses and moments are null.
Json without_metres(const Json& metric) {
  Json json = Json::object();
  for (const auto& [key, value] : metric.items()) {
    const std::string unit = key.substr(std::min(key.rfind('_'), key.size()));
    if (key == "field" || key.starts_with("density")) {
      json[key] = value;  // of the rock, not of the model
    } else if (key == "unseen" || key == "deposit") {
      json[key] = without_metres(value);
    } else if (unit == "_kg" || key.ends_with("_kg_m2")) {
      json[key] = nullptr;
    } else if (unit == "_m" || unit == "_m2" || unit == "_m3") {
      json[key.substr(0, key.size() - unit.size()) + "_units" + unit.substr(2)] = value;
    } else {
      json[key] = value;
    }
  }
  return json;
}

}  // namespace

Json equilibria_json(const std::optional<StaticEquilibriumCounts>& sides) {
  if (!sides) return nullptr;
  return {{"stable", sides->stable}, {"unstable", sides->unstable}, {"saddle", sides->saddle}};
}

Json block_json(const Block& block) {
  const Axes axes = block.axes();
  Json json;
  json["id"] = block.id;
  json["source"] = block.source.file;
  if (is_unscaled(block)) json["unscaled"] = explain_unscaled_block();
  json["provenance"] = {{"sha256", block.source.sha256},
                        {"options", block.source.options},
                        {"program_version", block.source.program_version}};
  json["vertices"] = block.body.vertices.size();
  json["edges"] = block.body.edges.size();
  const std::vector<EdgeConvexity> bends = edge_convexities(block.body);
  const auto with = [&](EdgeConvexity bend) {
    return std::count(bends.begin(), bends.end(), bend);
  };
  json["edge_bends"] = {{"convex", with(EdgeConvexity::kConvex)},
                        {"flat", with(EdgeConvexity::kFlat)},
                        {"reflex", with(EdgeConvexity::kReflex)}};
  json["faces"] = block.body.faces.size();
  json["radius_m"] = block.body.radius;
  json["volume_m3"] = block.mass.volume;
  json["area_m2"] = block.area;
  json["density_kg_m3"] = block.density;
  json["mass_kg"] = block.mass.mass;
  json["centre_m"] = vector_json(block.mass.centre);
  json["inertia_kg_m2"] = matrix_json(block.mass.inertia);
  json["principal_moments_kg_m2"] = vector_json(block.principal.moments);
  json["box_m"] = {axes.L, axes.I, axes.S};
  json["boxes_m"] = boxes_json(block);
  json["s_c"] = elongation_index(axes);
  json["sneed_folk"] = sneed_folk_class(axes);
  json["zingg"] = zingg_class(axes);
  json["shape"] = garcia_class(axes);
  json["indices"] = block_indices(block, axes);
  json["equilibria"] = equilibria_json(block_equilibria(block));
  json["deviation_m"] = {{"hausdorff", block.deviation.hausdorff},
                         {"mean", block.deviation.mean},
                         {"volume_relative", block.deviation.volume_relative},
                         {"scan_to_body", block.deviation.scan_to_body},
                         {"body_to_scan", block.deviation.body_to_scan},
                         {"area_relative", block.deviation.area_relative},
                         {"moments_relative", block.deviation.moments_relative}};
  if (block.volume_bracket) json["unseen"] = unseen_json(block);
  if (block.deposit) json["deposit"] = deposit_json(block);
  json["warnings"] = block.warnings;
  const Json field = field_json(block.field);
  if (!field.empty()) json["field"] = field;
  return is_unscaled(block) ? without_metres(json) : json;
}

}  // namespace clast
