#include "report/scans/json/deposit_json.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "report/html/packed_numbers.hpp"

namespace clast::report_detail {

namespace {

using DepositJson = nlohmann::ordered_json;

constexpr double kLastStep = 65535.0;
constexpr std::size_t kFewestOfBlock = 200;  ///< points of each block in a view, where it has them
constexpr int kShadeNeighbours = 12;
constexpr double kDarkestShade = 0.45;

DepositJson vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

DepositJson points_json(const std::vector<Vec3>& points) {
  DepositJson list = DepositJson::array();
  for (const Vec3& point : points) list.push_back(vector_json(point));
  return list;
}

/// Selects points evenly in their order, of small blocks more than of others.
std::vector<std::uint32_t> choose_view_points(const DepositViewContents& deposit,
                                              const PlanWindow& window) {
  const std::size_t total = deposit.points.size(), labels = deposit.ids.size() + 1;
  std::vector<std::size_t> count(labels, 0), stride(labels), seen(labels, 0);
  for (const std::uint32_t block : deposit.block_of_point) ++count[block];
  const std::size_t fewest = std::min(kFewestOfBlock, kMaxViewPoints / (2 * labels));
  const std::size_t common = (total + kMaxViewPoints - 1) / kMaxViewPoints;
  for (std::size_t block = 0; block < labels; ++block) {
    stride[block] = std::max<std::size_t>(
        1, block == 0 ? common : std::min(common, count[block] / std::max<std::size_t>(1, fewest)));
  }
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < total; ++i) {
    const std::uint32_t block = deposit.block_of_point[i];
    const Vec2 plan = deposit.points[i].head<2>();
    if ((plan - window.low).minCoeff() < 0.0 || (window.high - plan).minCoeff() < 0.0) continue;
    if (seen[block]++ % stride[block] == 0) chosen.push_back(i);
  }
  return chosen;
}

/// Brightness of a surface that is lit from the north-west.
std::vector<std::uint8_t> shade_points(std::span<const Vec3> points) {
  const Vec3 light = Vec3(-1.0, 1.0, std::sqrt(2.0)).normalized();
  std::vector<std::uint8_t> shades;
  for (const Vec3& normal : reconstruct_detail::estimate_normals(points, kShadeNeighbours)) {
    const double lit = std::max(0.0, (normal.z() < 0.0 ? Vec3(-normal) : normal).dot(light));
    const double shade = kDarkestShade + (1.0 - kDarkestShade) * lit;
    shades.push_back(std::isfinite(shade) ? static_cast<std::uint8_t>(std::lround(255.0 * shade))
                                          : 255);
  }
  return shades;
}

DepositJson cloud_json(const DepositViewContents& deposit, const PlanWindow& window) {
  std::vector<Vec3> places;
  std::vector<std::uint32_t> blocks;
  for (const std::uint32_t i : choose_view_points(deposit, window)) {
    places.push_back(deposit.points[i]);
    blocks.push_back(deposit.block_of_point[i]);
  }
  Bounds box;
  box.low = box.high = places.front();
  for (const Vec3& place : places) {
    box.low = box.low.cwiseMin(place);
    box.high = box.high.cwiseMax(place);
  }
  const double step = (box.high - box.low).maxCoeff() / kLastStep;
  std::vector<std::uint16_t> steps;
  for (Vec3& place : places) {
    place -= box.low;
    for (int axis = 0; axis < 3; ++axis) {
      steps.push_back(static_cast<std::uint16_t>(step > 0.0 ? std::lround(place[axis] / step) : 0));
    }
  }
  return {{"origin", vector_json(box.low)},
          {"step", step},
          {"count", places.size()},
          {"places", encode_packed_array<std::uint16_t>(steps)},
          {"blocks", encode_packed_array<std::uint32_t>(blocks)},
          {"shades", encode_packed_array<std::uint8_t>(shade_points(places))}};
}

}  // namespace

DepositJson deposit_edits_json(const std::vector<DepositEdit>& edits) {
  DepositJson list = DepositJson::array();
  for (const DepositEdit& edit : edits) {
    DepositJson json = {{"kind", name_of(edit.kind)}, {"points", points_json(edit.points)}};
    if (edit.kind == DepositEditKind::kCut) {
      json["line"] = points_json(edit.line);
      json["view"] = vector_json(edit.view);
    }
    list.push_back(std::move(json));
  }
  return list;
}

std::string format_deposit_json(const DepositViewContents& deposit, const DepositPlan& plan) {
  DepositJson parts = DepositJson::array();
  for (const LeftOutPart& part : deposit.left_out) {
    parts.push_back({{"at", vector_json(part.centre)}, {"points", part.points}});
  }
  const DepositJson json = {{"ids", deposit.ids},
                            {"accepted", deposit.accepted},
                            {"edits", deposit_edits_json(deposit.edits)},
                            {"leftOut", parts},
                            {"plan",
                             {{"columns", plan.relief.columns},
                              {"rows", plan.relief.rows},
                              {"cell", plan.relief.cell},
                              {"low", {plan.window.low.x(), plan.window.low.y()}},
                              {"blocks", encode_packed_array<std::uint32_t>(plan.blocks)}}},
                            {"cloud", cloud_json(deposit, plan.window)}};
  return json.dump(-1, ' ', false, DepositJson::error_handler_t::replace);
}

}  // namespace clast::report_detail
