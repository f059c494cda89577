#include "app/block_report.hpp"

#include "app/text_table.hpp"

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
  if (field.taped) json["taped_m"] = {field.taped->L, field.taped->I, field.taped->S};
  if (field.weighed_mass) json["weighed_kg"] = *field.weighed_mass;
  return json;
}

}  // namespace

Json block_json(const Block& block) {
  const Axes axes = block.axes();
  Json json;
  json["id"] = block.id;
  json["source"] = block.source.file;
  json["vertices"] = block.body.vertices.size();
  json["edges"] = block.body.edges.size();
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
  json["s_c"] = elongation_s_c(axes);
  json["sneed_folk"] = sneed_folk_class(axes);
  json["zingg"] = zingg_class(axes);
  json["shape"] = garcia_class(axes);
  json["indices"] = form_indices(axes);
  json["deviation_m"] = {{"hausdorff", block.deviation.hausdorff},
                         {"mean", block.deviation.mean},
                         {"volume_relative", block.deviation.volume_relative},
                         {"scan_to_body", block.deviation.scan_to_body},
                         {"body_to_scan", block.deviation.body_to_scan},
                         {"area_relative", block.deviation.area_relative},
                         {"moments_relative", block.deviation.moments_relative}};
  json["warnings"] = block.warnings;
  const Json field = field_json(block.field);
  if (!field.empty()) json["field"] = field;
  return json;
}

std::string block_line(const Block& block) {
  const Axes axes = block.axes();
  std::string line = block.id + ": " + std::to_string(block.body.vertices.size()) + " vertices, " +
                     rounded(axes.L, 3) + " x " + rounded(axes.I, 3) + " x " + rounded(axes.S, 3) +
                     " m, " + rounded(block.mass.volume) + " m3, " + rounded(block.mass.mass) +
                     " kg, " + sneed_folk_class(axes) + ", " + zingg_class(axes) + ", " +
                     garcia_class(axes) + ", ";
  if (block.from_core) return line + "core with radius " + rounded(block.body.radius, 3) + " m";
  return line + "within " + rounded(block.deviation.hausdorff, 2) + " m of the scan (" +
         rounded(100.0 * block.deviation.hausdorff / axes.L, 2) + " % of L)";
}

}  // namespace clast
