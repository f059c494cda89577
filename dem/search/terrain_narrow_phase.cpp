#include "dem/search/terrain_narrow_phase.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dem/search/detail/resolved_contacts.hpp"
#include "dem/surface/trim.hpp"

namespace clast::dem_detail {
namespace {

/// List margin, as a fraction of the block's smallest side. Lists reach some margins ahead, so that
/// they are short but rarely rebuilt.
constexpr double kGroundMarginFraction = 0.05;
/// The ground near a part is collected for this many margins of displacement.
constexpr double kPartMargins = 4.0;
/// The ground near the whole block is collected for this many more margins of displacement.
constexpr double kGroundMargins = 8.0;
/// Largest angle between the axis of a part and the mean ground normal near it, as a cosine.
constexpr double kSameAxis = 0.97;
/// A part this many margins from the ground counts as far again.
constexpr double kFarMargins = 2.0;

}  // namespace

TerrainNarrowPhase::TerrainNarrowPhase(const IndexedSurface& ground, const BlockSurface& block,
                                       double size)
    : ground_(ground),
      surface_(block),
      block_(block.features),
      parts_(block.parts),
      reach_(block.radius + ground.radius),
      size_(size),
      margin_(kGroundMarginFraction * size),
      list_lifetime_(kPartMargins * margin_),
      tests_(ground, block, size),
      part_states_(parts_.parts.size()),
      part_expiry_(parts_.parts.size(), -1.0) {
  for (const Vec3& vertex : block_.vertices) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  for (const BlockPart& part : parts_.parts) {
    farthest_ = std::max(farthest_, part.centre.norm() + part.radius);
  }
  accumulated_per_displacement_ = std::min(1.0, farthest_ / block.bounding_radius);
}

TerrainNarrowPhase::Scratch& TerrainNarrowPhase::scratch() {
  thread_local Scratch of_thread;
  return of_thread;
}

std::vector<ContactPoint>& TerrainNarrowPhase::find_contacts(const Pose& ground_from_body,
                                                             double displacement) {
  FoundContacts& found = scratch().found;
  std::vector<ContactPoint>& contacts = found.contacts;
  const IndexList& near_parts_to_update = scratch().near_parts_to_update;
  set_pose(ground_from_body);
  displacement_ = displacement;
  found.clear();
  list_expired_parts();
  for (const std::uint32_t p : near_parts_to_update) update_vertices(p, {}, found);
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  if (depth_limit_.update(deepest_, margin_)) list_all_parts();
  for (const std::uint32_t p : near_parts_to_update) {
    update_sides(p, {}, found);
    part_expiry_[p] = next_update(p);
  }
  add_side_contacts(found);
  remove_resolved_contacts(contacts, ground_, surface_, ground_from_body, size_);
  deepest_ = 0.0;
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  touches_ = !contacts.empty();
  if (touches_) {
    search_at_ = -1.0;
  } else {
    depth_limit_.reset();
  }
  return contacts;
}

void TerrainNarrowPhase::set_pose(const Pose& ground_from_body) {
  const Mat3 rotation = ground_from_body.rotation.toRotationMatrix();
  const Vec3& position = ground_from_body.translation;
  if (started_) {
    // The rotation moves a point by at most 2 sin(angle/2) times its arm. This factor is the
    // Frobenius norm of the change of the matrix over sqrt(2).
    const double turn = std::sqrt(0.5 * (rotation - tests_.rotation()).squaredNorm());
    accumulated_rotation_ += turn;
    last_move_ = (position - tests_.position()).norm() + turn * farthest_;
    accumulated_displacement_ += last_move_;
  }
  started_ = true;
  tests_.set_pose(rotation, position);
}

void TerrainNarrowPhase::list_expired_parts() {
  const auto parts = static_cast<std::uint32_t>(part_expiry_.size());
  IndexList &expired_parts = scratch().expired_parts,
            &near_parts_to_update = scratch().near_parts_to_update;
  near_parts_to_update.clear(parts);
  expired_parts.fill_if(parts, [expired = part_expiry_.data(), now = accumulated_displacement_](
                                   std::uint32_t p) { return expired[p] <= now; });
  if (expired_parts.size() == 0 || defer_all_parts()) return;
  for (const std::uint32_t p : expired_parts) {
    if (part_states_[p].near) {
      update_displacement(p);
      refresh_ground_list(p, 0.0);
    } else {
      update_part(p, accumulated_displacement_);
    }
    near_parts_to_update.add_if(part_states_[p].near != nullptr, p);
  }
}

void TerrainNarrowPhase::list_all_parts() {
  IndexList& near_parts_to_update = scratch().near_parts_to_update;
  near_parts_to_update.clear(static_cast<std::uint32_t>(part_states_.size()));
  for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
    if (!part_states_[p].near) continue;
    NearPart& part = *part_states_[p].near;
    update_displacement(p);
    for (GroundFeature& feature : part.features) feature.separation_bound = {};
    part.pairs.clear();
    part.all_features = {};
    near_parts_to_update.add_if(true, p);
  }
}

bool TerrainNarrowPhase::defer_all_parts() {
  for (const PartState& part : part_states_) {
    if (part.near) return false;
  }
  const double look = bounding_radius_ + reach_ + 8.0 * margin_;
  double above = ground_.height_clearance(tests_.position(), 2.0 * look);
  if (above < look) {
    const std::optional<NearestPoint> nearest =
        ground_.nearest_point(tests_.position(), 2.0 * look);
    above = nearest ? nearest->distance : 2.0 * look;
  }
  if (above <= bounding_radius_ + reach_ + margin_) return false;
  for (double& expired : part_expiry_)
    expired = std::max(expired, accumulated_displacement_ + above - bounding_radius_ - reach_);
  return true;
}

void TerrainNarrowPhase::collect_ground(double complete) {
  if (ground_complete_ - (accumulated_displacement_ - ground_gathered_at_) >= complete) return;
  ground_complete_ = complete + kGroundMargins * margin_;
  ground_gathered_at_ = accumulated_displacement_;
  local_.collect_near(ground_, tests_.position(), bounding_radius_ + ground_complete_);
  for (PartState& part : part_states_) part.near_face = 0;
}

void TerrainNarrowPhase::update_part(std::uint32_t p, double until) {
  const BlockPart& part = parts_.parts[p];
  PartState& state = part_states_[p];
  const Vec3 centre = in_ground_frame(part.centre);
  const double touching = part.radius + reach_;
  // Often the last measurement or the bounding plane gives a sufficient bound.
  collect_ground(touching + 2.0 * kPartMargins * margin_);
  const double complete = ground_complete_ - (accumulated_displacement_ - ground_gathered_at_);
  const double enough = std::max(margin_, until - accumulated_displacement_);
  double clearance = std::min(local_.plane.clearance(centre) - part.radius, complete) - reach_;
  clearance =
      std::max(clearance, state.clearance - (centre - state.measured_centre).norm() -
                              part.radius * (accumulated_rotation_ - state.measured_rotation));
  if (clearance <= enough) {
    clearance = measure_clearance(p);
  }
  if (clearance > margin_) {
    part_expiry_[p] = accumulated_displacement_ + clearance;
    return;
  }
  // A part that was skipped is outside the ground. At the start, this is not known.
  const bool slept = !(part_expiry_[p] < 0.0);
  const double deepest = slept ? 0.0 : part.radius - clearance - touching;
  state.near = std::make_unique<NearPart>();
  state.near->depth_known = slept;
  state.near->centre = centre;
  state.near->turned = accumulated_rotation_;
  collect_part_ground(p, deepest);
}

double TerrainNarrowPhase::measure_clearance(std::uint32_t p) {
  PartState& state = part_states_[p];
  const double touching = parts_.parts[p].radius + reach_;
  const double complete = ground_complete_ - (accumulated_displacement_ - ground_gathered_at_);
  const Vec3 centre = in_ground_frame(parts_.parts[p].centre);
  double distance = complete;
  if (part_expiry_[p] < 0.0) {
    // The part has not been measured yet and may be deep inside the ground.
    const double far = touching + 8.0 * margin_ + 4.0 * bounding_radius_;
    const std::optional<NearestPoint> nearest = ground_.nearest_point(centre, far);
    distance = nearest ? nearest->distance : far;
  } else {
    const LocalFaces::NearestFace found =
        local_.nearest(ground_.features, centre, complete, 0.0, state.near_face);
    state.near_face = found.entry;
    if (std::abs(found.nearest.distance) < complete) distance = found.nearest.distance;
  }
  state.clearance = distance - touching;
  state.measured_centre = centre;
  state.measured_rotation = accumulated_rotation_;
  return state.clearance;
}

void TerrainNarrowPhase::update_displacement(std::uint32_t p) {
  NearPart& part = *part_states_[p].near;
  const Vec3 centre = in_ground_frame(parts_.parts[p].centre);
  const Vec3 shift = centre - part.centre;
  const double turn = parts_.parts[p].radius * (accumulated_rotation_ - part.turned);
  const double axial = part.axis.dot(shift), squared = shift.squaredNorm();
  part.displacement.axial += std::abs(axial) + turn;
  part.displacement.transverse += std::sqrt(std::max(0.0, squared - axial * axial)) + turn;
  part.displacement.total += std::sqrt(squared) + turn;
  part.centre = centre;
  part.turned = accumulated_rotation_;
}

void TerrainNarrowPhase::refresh_ground_list(std::uint32_t p, double ahead) {
  if (const NearPart& part = *part_states_[p].near;
      part.displacement.total + ahead < list_expiry(part)) {
    return;
  }
  const double touching = parts_.parts[p].radius + reach_;
  collect_ground(touching + 2.0 * kPartMargins * margin_);
  const double clearance = measure_clearance(p);
  if (clearance > kFarMargins * margin_) {
    part_states_[p].near.reset();
    part_expiry_[p] = accumulated_displacement_ + clearance;
    return;
  }
  collect_part_ground(p, deepest_ + last_move_);
}

void TerrainNarrowPhase::collect_part_ground(std::uint32_t p, double deepest) {
  const BlockPart& part = parts_.parts[p];
  NearPart& state = *part_states_[p].near;
  const bool is_new = !(state.complete_distance > 0.0);
  state.complete_distance = std::max(reach_, deepest) + 2.0 * kPartMargins * margin_;
  state.collected_at = state.displacement.total;
  collect_ground(state.complete_distance);
  const double reach = part.radius + state.complete_distance;
  state.ground.collect_near(ground_.features, local_, state.centre, reach);
  if (is_new || state.axis.dot(state.ground.plane.normal) < kSameAxis) update_axis(p);
  state.close_faces_until = -1.0;
  state.tilts.clear();
  for (const LocalFaces::Face& face : state.ground.faces) {
    const double axial = std::min(std::abs(face.normal.dot(state.axis)), 1.0);
    const double transverse = std::sqrt(1.0 - axial * axial);
    state.tilts.push_back(
        {axial, transverse,
         is_at_border(ground_.features, face.face) ? 0.0 : 2.0 / (axial + transverse)});
  }
  // Features that are listed again keep their bound and their pairs. Lists are sorted.
  std::vector<GroundFeature>& before = scratch().features_before;
  before.swap(state.features);
  state.features.clear();
  state.all_features = state.all_pairs = {};
  const SurfaceFeatures& features = ground_.features;
  auto known = before.cbegin();
  const auto list_near = [&](bool is_vertex, std::uint32_t index, const Vec3& nearest) {
    if ((state.centre - nearest).squaredNorm() > reach * reach) return;
    const GroundFeature listed{.is_vertex = is_vertex, .index = index, .separation_bound = {}};
    known = std::lower_bound(known, before.cend(), listed);
    const bool is_known = known != before.cend() && !(listed < *known);
    state.features.push_back(is_known ? *known : listed);
  };
  for (const std::uint32_t edge : local_.edges) {
    list_near(false, edge, features.segment(features.edges[edge]).nearest_point(state.centre));
  }
  for (const std::uint32_t pointed_vertex : local_.pointed_vertices) {
    list_near(true, pointed_vertex, features.vertices[pointed_vertex]);
  }
  std::erase_if(state.pairs, [&](const FeaturePair& pair) {
    return !std::binary_search(state.features.begin(), state.features.end(),
                               GroundFeature{.is_vertex = pair.kind != ContactKind::kEdgeEdge,
                                             .index = pair.ground_feature,
                                             .separation_bound = {}});
  });
  shrink_capacity(state.tilts, state.features, state.pairs);
}

void TerrainNarrowPhase::update_axis(std::uint32_t p) {
  NearPart& part = *part_states_[p].near;
  part.axis = part.ground.plane.normal;
  part.other_vertices = {};
  for (GroundFeature& feature : part.features) feature.separation_bound = {};
  part.pairs.clear();
}

double TerrainNarrowPhase::next_update(std::uint32_t p) const {
  const NearPart& part = *part_states_[p].near;
  if (!part.touching_groups.empty()) return accumulated_displacement_;
  double least = list_expiry(part) - part.displacement.total;
  for (const SeparationBound* separation_bound :
       {&part.other_vertices, &part.all_features, &part.all_pairs}) {
    const double remaining = separation_bound->remaining(part.displacement);
    if (!(remaining > 0.0)) return accumulated_displacement_;
    // No point of the part moves farther than the bound for the block, along or across the axis.
    const double used =
        separation_bound->axial_coefficient + separation_bound->transverse_coefficient;
    if (remaining < least * used) least = remaining / used;
  }
  return std::min(accumulated_displacement_ + least, part.pairs_contact_free_until);
}

SeparationBound TerrainNarrowPhase::separation_bound(const NearPart& part, const Vec3& away,
                                                     double distance, double others) const {
  if (!(distance > 0.0 && others > 0.0)) return {};
  const double axial = std::min(std::abs(away.dot(part.axis)), 1.0);
  const double transverse = std::sqrt(1.0 - axial * axial);
  const double per = 1.0 / distance, per_other = 1.0 / others;
  SeparationBound result{std::max(axial * per, per_other), std::max(transverse * per, per_other),
                         1.0};
  result.until += result.axial_coefficient * part.displacement.axial +
                  result.transverse_coefficient * part.displacement.transverse;
  return result;
}

}  // namespace clast::dem_detail
