#include "study/detail/mass_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/detail/run_starts.hpp"

namespace clast::study_detail {
namespace {

/// Width of the cells that a heap is put together in, as a share of the smallest S, unless they
/// were too many.
constexpr double kCellShare = 1.0 / 6.0;
constexpr double kMostCells = 1e6;

BlockPacking packing_of(const PreparedCampaign& prepared) {
  std::vector<Vec2> outline = prepared.campaign.stay->mass->polygon;
  Bounds box;
  for (Vec2& corner : outline) {
    corner -= prepared.header.frame.origin.head<2>();
    box.include({corner.x(), corner.y(), 0.0});
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (const RigidBody& body : prepared.bodies) smallest = std::min(smallest, body.size());
  const Vec3 sides = box.high - box.low;
  const double width =
      std::max(kCellShare * smallest, std::sqrt(sides.x() * sides.y() / kMostCells));
  try {
    return BlockPacking(*prepared.surface, outline, width);
  } catch (const InputError& error) {
    throw InputError(prepared.campaign.file.string() + ": [mass] " + error.what() +
                     "; check its corners and the map frame");
  }
}

}  // namespace

MassStarts::MassStarts(const PreparedCampaign& prepared)
    : prepared_(prepared), plan_(*prepared.campaign.stay->mass) {
  if (!plan_.in_place) packing_.emplace(packing_of(prepared));
}

void MassStarts::begin(const std::string& name) {
  if (packing_) packing_->clear();
  name_ = name;
  count_ = 0;
  placed_ = {};
}

RigidState MassStarts::place(std::uint32_t block, const GroundOverlap& overlap, Random& random) {
  const RigidState state =
      plan_.in_place ? in_place(block, overlap) : on_heap(block, overlap, random);
  ++count_;
  placed_.volume += prepared_.header.blocks[block].volume;
  placed_.mass += prepared_.bodies[block].mass;
  return state;
}

MassStart MassStarts::placed() const {
  MassStart placed = placed_;
  if (!packing_) return placed;
  const Filling filling = packing_->filling();
  placed.area = filling.area;
  placed.mean_thickness = filling.mean_thickness;
  placed.largest_thickness = filling.largest_thickness;
  return placed;
}

RigidState MassStarts::in_place(std::uint32_t block, const GroundOverlap& overlap) const {
  const BlockChoice& choice = prepared_.choice;
  const Pose place = choice.library[choice.blocks[block].library].source_from_body();
  RigidState state;
  state.position = prepared_.header.frame.local(place.translation) + Vec3(0.0, 0.0, plan_.raised);
  state.orientation = place.rotation.normalized();
  const std::string where = prepared_.campaign.file.string() + ": [mass] in_place: block " +
                            prepared_.header.blocks[block].id + " with its centre at " +
                            place_on_map(prepared_.header.frame.map(state.position));
  if (!prepared_.surface->covers(state.position.x(), state.position.y())) {
    throw InputError(where +
                     " is off the terrain; check the map frame and the axis that points up");
  }
  const std::optional<double> depth =
      depth_in_ground(overlap, *prepared_.surface, prepared_.bodies[block], state);
  if (!depth) return state;
  throw SimulationError(where + " starts " + with_decimals(*depth, 3) +
                        " m inside the ground; the terrain must be the one without the mass, or "
                        "give [mass] height_m");
}

RigidState MassStarts::on_heap(std::uint32_t block, const GroundOverlap& overlap, Random& random) {
  const Quat turn = fresh_orientations(prepared_.campaign.releases.front(),
                                       prepared_.choice.blocks[block].id, name_, 1)
                        .front();
  const std::optional<RigidState> start =
      packing_->place(prepared_.bodies[block], overlap, turn, plan_.thickness, random);
  if (!start) refuse_block(block);
  return *start;
}

void MassStarts::refuse_block(std::uint32_t block) const {
  const BlockSummary& summary = prepared_.header.blocks[block];
  const std::string text =
      prepared_.campaign.file.string() + ": [mass] holds " + std::to_string(count_) + " of " +
      std::to_string(prepared_.header.stay->blocks_each) + " blocks of realisation " +
      std::to_string(prepared_.masses.size() + 1) + ", and block " + summary.id +
      " with L = " + with_decimals(summary.axes.L, 3) + " m fits nowhere";
  throw InputError(text +
                   (plan_.thickness
                        ? " below thickness_m = " + with_digits(*plan_.thickness, 6) +
                              "; allow more, widen the polygon, or take fewer or smaller blocks"
                        : "; widen the polygon, or take smaller blocks"));
}

}  // namespace clast::study_detail
