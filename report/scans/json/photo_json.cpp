#include "report/scans/json/photo_json.hpp"

#include "core/angle.hpp"
#include "core/utf8.hpp"

namespace clast {

namespace {

using Json = nlohmann::ordered_json;

Json ring_json(const CameraRing& ring, const std::string& unit) {
  Json cameras = Json::array(), gaps = Json::array();
  for (const CameraPosition& seat : ring.cameras) {
    cameras.push_back({{"photo", to_utf8(seat.name)},
                       {"azimuth_deg", seat.azimuth * kDegreesPerRadian},
                       {"elevation_deg", seat.elevation * kDegreesPerRadian},
                       {"distance" + unit, seat.distance},
                       {"pairs", seat.pairs},
                       {"blurred", seat.blurred}});
  }
  for (const AzimuthGap& gap : ring.gaps) {
    gaps.push_back(
        {{"from_deg", gap.from * kDegreesPerRadian},
         {"width_deg", gap.width * kDegreesPerRadian},
         {"between",
          {to_utf8(ring.cameras[gap.first].name), to_utf8(ring.cameras[gap.second].name)}}});
  }
  return {{"cameras", cameras},
          {"gaps", gaps},
          {"largest_gap_deg", ring.largest_gap * kDegreesPerRadian}};
}

Json marker_json(const MarkerUsage& marker, const std::string& unit) {
  const bool placed = marker.side > 0.0;
  Json json = {{"id", marker.id}, {"photos", marker.photos}, {"used", marker.used}};
  json["error_px"] = placed ? Json(marker.error) : Json();
  json["side" + unit] = placed ? Json(marker.side) : Json();
  if (!marker.used) json["why_not"] = marker.reason;
  return json;
}

Json scale_json(const PhotoScan& scan) {
  Json json = {{"source", scan.scale_source}};
  if (!scan.scale) return json;
  const PhotoScale& scale = *scan.scale;
  json["metres_per_unit"] = scale.metres_per_unit;
  json["spread"] = scale.spread;
  if (scale.marker_side_ratio) json["side_check"] = *scale.marker_side_ratio;
  json["lengths"] = Json::array();
  for (const ComparedLength& one : scale.measures) {
    Json length = {{"name", one.name},
                   {"stated_m", one.length},
                   {"in_model_m", one.length / one.factor * scale.metres_per_unit},
                   {"metres_per_unit", one.factor},
                   {"used", one.used}};
    length["off_by_the_others"] =
        scale.measures.size() > 1 ? Json(one.leave_one_out_error) : Json();
    json["lengths"].push_back(length);
  }
  json["notes"] = scale.notes;
  return json;
}

}  // namespace

Json photo_json(const PhotoScan& scan, const PhotoSummary& evidence) {
  const std::string unit = scan.metric ? "_m" : "_units";
  Json json = {{"cameras_by", scan.model.source},  {"with_camera", scan.model.photos.size()},
               {"without_camera", Json::array()},  {"blurred", Json::array()},
               {"pairs", scan.cloud.pairs.size()}, {"points", scan.cloud.points.size()}};
  for (const std::string& name : scan.photos_without_camera)
    json["without_camera"].push_back(to_utf8(name));
  for (const std::size_t photo : scan.cloud.blurred) {
    json["blurred"].push_back(to_utf8(scan.model.photos[photo].name));
  }
  json["ring"] = ring_json(evidence.ring, unit);
  json["coverage"] = Json::array();
  for (const ViewCoverage& one : evidence.coverage) {
    json["coverage"].push_back(
        {{"at_least", one.min_views}, {"photos_share", one.photos}, {"pairs_share", one.pairs}});
  }
  json["markers"] = Json::array();
  for (const MarkerUsage& marker : evidence.markers) {
    json["markers"].push_back(marker_json(marker, unit));
  }
  json["scale"] = scale_json(scan);
  return json;
}

}  // namespace clast
