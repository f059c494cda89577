#include "study/simulate/detail/multi_block_placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/simulate/detail/block_distribution.hpp"
#include "study/simulate/detail/run_starts.hpp"

namespace clast::study_detail {
namespace {

/// Cell width of heaps over the smallest S, unless there were too many cells.
constexpr double kStartCellFraction = 1.0 / 6.0;
constexpr double kMaxStartCells = 1e6;

/// Outline of each mass, local frame.
std::vector<std::vector<Vec2>> outlines(const CampaignPlan& prepared) {
  std::vector<std::vector<Vec2>> outlines;
  for (const MultiBlockRelease& mass : prepared.campaign.persistent_blocks->masses) {
    std::vector<Vec2>& outline = outlines.emplace_back(mass.polygon);
    for (Vec2& corner : outline) corner -= prepared.header.frame.origin.head<2>();
  }
  return outlines;
}

/// One width for all heaps, so that no cell belongs to two of them.
double width_of_cells(const CampaignPlan& prepared,
                      const std::vector<std::vector<Vec2>>& outlines) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < prepared.bodies.size(); ++i) {
    if (prepared.bodies.first_equal_body(i) < i) continue;
    smallest = std::min(smallest, prepared.bodies[i].size());
  }
  double width = kStartCellFraction * smallest;
  for (const std::vector<Vec2>& outline : outlines) {
    Bounds box;
    for (const Vec2& corner : outline) box.include({corner.x(), corner.y(), 0.0});
    const Vec3 sides = box.high - box.low;
    width = std::max(width, std::sqrt(sides.x() * sides.y() / kMaxStartCells));
  }
  return width;
}

}  // namespace

MultiBlockPlacement::MultiBlockPlacement(const CampaignPlan& prepared)
    : prepared_(prepared), plans_(prepared.campaign.persistent_blocks->masses) {
  if (plans_.front().in_place) return;
  const std::vector<std::vector<Vec2>> all = outlines(prepared);
  const double width = width_of_cells(prepared, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    try {
      packings_.emplace_back(*prepared.surface, all[i], width);
    } catch (const InputError& error) {
      throw InputError(prepared.campaign.file.string() + ": " +
                       multi_block_release_name(prepared.campaign, i) + " " + error.what() +
                       "; check its corners and the map frame");
    }
  }
  check_no_overlapping_heaps();
}

void MultiBlockPlacement::check_no_overlapping_heaps() const {
  for (std::size_t i = 0; i < packings_.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      const double area = packings_[i].overlapping_area(packings_[other]);
      if (area == 0.0) continue;
      throw InputError(prepared_.campaign.file.string() + ": the polygons of " +
                       multi_block_release_name(prepared_.campaign, other) + " and " +
                       multi_block_release_name(prepared_.campaign, i) + " overlap on " +
                       format_significant(area, 3) +
                       " m^2, where their blocks would overlap; move one of them, or draw one "
                       "polygon around both");
    }
  }
}

void MultiBlockPlacement::begin(const std::string& name, const std::vector<std::size_t>& blocks) {
  for (BlockPacking& packing : packings_) packing.clear();
  name_ = name;
  expected_ = blocks;
  placed_.assign(plans_.size(), {});
}

RigidState MultiBlockPlacement::place(std::size_t mass, std::uint32_t block,
                                      const GroundOverlapBody& body, Random& random) {
  const RigidState state = plans_[mass].in_place ? in_place_state(mass, block, body)
                                                 : sample_heap_start(mass, block, body, random);
  MultiBlockStart& placed = placed_[mass];
  ++placed.blocks;
  placed.volume += prepared_.header.blocks[block].volume;
  placed.mass += prepared_.header.blocks[block].mass;
  return state;
}

std::vector<MultiBlockStart> MultiBlockPlacement::placed() const {
  std::vector<MultiBlockStart> placed = placed_;
  for (std::size_t i = 0; i < packings_.size(); ++i) {
    const HeapExtent filling = packings_[i].heap_extent();
    placed[i].area = filling.area;
    placed[i].mean_thickness = filling.mean_thickness;
    placed[i].largest_thickness = filling.largest_thickness;
  }
  return placed;
}

RigidState MultiBlockPlacement::in_place_state(std::size_t mass, std::uint32_t block,
                                               const GroundOverlapBody& body) const {
  const CampaignBlocks& choice = prepared_.choice;
  const Pose place = choice.library[choice.blocks[block].library].source_from_body();
  RigidState state;
  state.position = prepared_.header.frame.to_local(place.translation) +
                   Vec3(0.0, 0.0, plans_[mass].height_offset);
  state.orientation = place.rotation.normalized();
  const std::string where = prepared_.campaign.file.string() + ": [mass] in_place: block " +
                            prepared_.header.blocks[block].id + " with its centre at " +
                            format_map_point(prepared_.header.frame.to_map(state.position));
  if (!prepared_.surface->covers(state.position.x(), state.position.y())) {
    throw InputError(where +
                     " is off the terrain; check the map frame and the axis that points up");
  }
  const std::optional<double> depth =
      find_depth_in_ground(body.overlap, *prepared_.surface, body.body, state);
  if (!depth) return state;
  throw SimulationError(where + " starts " + format_decimals(*depth, 3) +
                        " m inside the ground; the terrain must be the one without the mass, or "
                        "give [mass] height_m");
}

RigidState MultiBlockPlacement::sample_heap_start(std::size_t mass, std::uint32_t block,
                                                  const GroundOverlapBody& body, Random& random) {
  const Quat turn = sample_run_orientations(prepared_.campaign.releases.front(),
                                            prepared_.choice.blocks[block].id, name_, 1)
                        .front();
  const std::optional<RigidState> start =
      packings_[mass].place(body.body, body.overlap, turn, plans_[mass].thickness, random);
  if (!start) throw_no_place_for_block(mass, block);
  return *start;
}

void MultiBlockPlacement::throw_no_place_for_block(std::size_t mass, std::uint32_t block) const {
  const BlockSummary& summary = prepared_.header.blocks[block];
  const std::size_t realisation = prepared_.masses.size() / plans_.size() + 1;
  const std::string text =
      prepared_.campaign.file.string() + ": " + multi_block_release_name(prepared_.campaign, mass) +
      " holds " + std::to_string(placed_[mass].blocks) + " of " + std::to_string(expected_[mass]) +
      " blocks of realisation " + std::to_string(realisation) + ", and block " + summary.id +
      " with L = " + format_decimals(summary.axes.L, 3) + " m fits nowhere";
  const std::optional<double>& thickness = plans_[mass].thickness;
  throw InputError(text + (thickness
                               ? " below thickness_m = " + format_significant(*thickness, 6) +
                                     "; raise it, widen the polygon, or use fewer or smaller blocks"
                               : "; widen the polygon, or use smaller blocks"));
}

}  // namespace clast::study_detail
