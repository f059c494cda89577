#include "dem/detail/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace clast {
namespace {

/// A contact that vanishes and one that appears are the same contact, carried over to another
/// feature, when they are closer than this share of the block's smallest side ...
constexpr double kHandOverShare = 0.03;
/// ... and their normals are within 45 degrees.
constexpr double kHandOverCosine = 0.7071067811865476;
/// Normals within a patch differ by at most 30 degrees: smoothly curved, not a ridge.
constexpr double kPatchCosine = 0.8660254037844386;
/// How far a point of a patch may stand above the tangent plane of another, as a sine: 3 degrees.
/// More is a valley, and its two sides carry the block apart.
constexpr double kPatchRise = 0.052;
/// A plane of the block joins contact points when it faces the ground within 60 degrees.
constexpr double kFacingCosine = 0.5;

Vec3 turned_into_plane(const Vec3& vector, const Vec3& normal) {
  const double length = vector.norm();
  const Vec3 flat = vector - vector.dot(normal) * normal;
  const double flat_length = flat.norm();
  return flat_length > 1e-300 ? Vec3(flat * (length / flat_length)) : Vec3(Vec3::Zero());
}

void limit(Vec3& vector, double largest) {
  const double length = vector.norm();
  if (length > largest) vector *= largest / length;
}

}  // namespace

ContactForces::ContactForces(const TerrainSurface& terrain, std::span<const GroundParameters> zones,
                             const SurfaceFeatures& block, const RigidBody& body,
                             const ReleaseSettings& settings)
    : terrain_(terrain),
      zones_(zones),
      block_(block),
      stiffness_(settings.stiffness),
      weights_(settings.weights),
      near_(kHandOverShare * body.smallest_side) {}

ContactLoad ContactForces::update(const std::vector<ContactPoint>& points,
                                  const Pose& world_from_body, const Vec3& velocity,
                                  const Vec3& angular_velocity, double duration,
                                  EnergyLedger& ledger) {
  ContactLoad load;
  const Vec3& centre = world_from_body.translation;
  if (points.empty() && contacts_.empty()) return load;
  const double k_n = stiffness_.normal, k_t = stiffness_.tangential, k_r = stiffness_.rolling;

  match(points);
  std::vector<Contact>& now = now_;
  now.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    now[i].point = points[i];
    now[i].ground = &zones_[terrain_.zone(points[i].ground_face)];
  }
  share_weights(now, world_from_body.rotation);

  for (std::size_t i = 0; i < now.size(); ++i) {
    Contact& contact = now[i];
    const Vec3& n = contact.point.normal;
    const double overlap = contact.point.overlap;
    const double restitution = contact.ground->energy_restitution;
    const double w = contact.weight;
    const Vec3 arm = contact.point.point() - centre;
    const Vec3 moving = velocity + angular_velocity.cross(arm);
    const double closing = -moving.dot(n);
    const Vec3 sliding = moving + closing * n;

    // Where it was a step ago. A contact without a past has come from as far as its speed allows;
    // an overlap that this does not explain carries the least that the law allows.
    double before = std::max(0.0, overlap - std::max(0.0, closing) * duration);
    double normal_before = k_n * restitution * before;
    double weight_before = w;
    double restitution_before = restitution;
    Vec3 tangential_before = Vec3::Zero(), rolling_before = Vec3::Zero();
    if (previous_of_[i] >= 0) {
      const Contact& previous = contacts_[previous_of_[i]];
      before = previous.point.overlap;
      normal_before = previous.normal;
      weight_before = previous.weight;
      restitution_before = previous.ground->energy_restitution;
      tangential_before = turned_into_plane(previous.tangential, n);
      rolling_before = previous.rolling;
    } else {
      ledger.reassigned -= 0.5 * w * k_n * restitution * before * before;
    }

    const double deeper = overlap - before;
    contact.normal = deeper > 0.0 ? normal_before + k_n * deeper : k_n * restitution * overlap;
    contact.tangential = tangential_before - k_t * duration * sliding;
    limit(contact.tangential, contact.ground->friction * contact.normal);
    if (contact.ground->rolling_friction > 0.0) {
      contact.rolling = rolling_before - k_r * duration * angular_velocity;
      const double length = contact.rolling.norm();
      // The arm of Eq. 5 is perpendicular to the axis about which the block rolls.
      const double lever = length > 0.0 ? arm.cross(contact.rolling).norm() / length : 0.0;
      limit(contact.rolling, contact.ground->rolling_friction * lever * contact.normal);
    }

    const Vec3 force = w * (contact.normal * n + contact.tangential);
    load.force += force;
    load.torque += arm.cross(force) + w * contact.rolling;

    // Work taken from the block by the mean of the forces at both ends of the step, less what is
    // stored, is dissipated; a change of weight or zone changes what is stored and is booked apart.
    const double taken_normal = 0.5 * (weight_before * normal_before + w * contact.normal) * deeper;
    ledger.normal +=
        taken_normal - 0.5 * w * k_n * restitution * (overlap * overlap - before * before);
    ledger.reassigned -=
        0.5 * k_n * before * before * (w * restitution - weight_before * restitution_before);
    const double taken_sliding =
        -0.5 * duration * (weight_before * tangential_before + w * contact.tangential).dot(sliding);
    const double tangential_squared = tangential_before.squaredNorm();
    ledger.friction +=
        taken_sliding - 0.5 * w / k_t * (contact.tangential.squaredNorm() - tangential_squared);
    const double taken_rolling =
        -0.5 * duration *
        (weight_before * rolling_before + w * contact.rolling).dot(angular_velocity);
    const double rolling_squared = rolling_before.squaredNorm();
    ledger.rolling +=
        taken_rolling - 0.5 * w / k_r * (contact.rolling.squaredNorm() - rolling_squared);
    ledger.reassigned -=
        0.5 * (w - weight_before) * (tangential_squared / k_t + rolling_squared / k_r);
  }

  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (carried_on_[j]) continue;
    const Contact& gone = contacts_[j];
    const Vec3 arm = gone.point.point() - centre;
    const Vec3 moving = velocity + angular_velocity.cross(arm);
    const double given_back = 0.5 * duration * gone.weight *
                              ((gone.normal * gone.point.normal + gone.tangential).dot(moving) +
                               gone.rolling.dot(angular_velocity));
    const bool parted = moving.dot(gone.point.normal) > 0.0;
    (parted ? ledger.normal : ledger.reassigned) += stored(gone) - given_back;
  }
  std::swap(contacts_, now_);
  return load;
}

void ContactForces::match(const std::vector<ContactPoint>& points) {
  previous_of_.assign(points.size(), -1);
  carried_on_.assign(contacts_.size(), 0);
  const auto carry_on = [&](std::size_t i, std::size_t j) {
    previous_of_[i] = static_cast<int>(j);
    carried_on_[j] = 1;
  };
  // The same pair of features. Both lists are in the same order, so the search goes on where the
  // last one ended.
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t tried = 0; tried < contacts_.size(); ++tried) {
      const std::size_t j = (next + tried) % contacts_.size();
      const ContactPoint& a = points[i];
      const ContactPoint& b = contacts_[j].point;
      if (carried_on_[j] || a.kind != b.kind || a.block_feature != b.block_feature ||
          a.ground_feature != b.ground_feature || a.normal.dot(b.normal) < kHandOverCosine) {
        continue;
      }
      carry_on(i, j);
      next = j + 1;
      break;
    }
  }
  const auto hand_over = [&](const auto& related) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (previous_of_[i] >= 0) continue;
      std::optional<std::size_t> best;
      double best_cosine = kHandOverCosine;
      for (std::size_t j = 0; j < contacts_.size(); ++j) {
        if (carried_on_[j] || !related(points[i], contacts_[j].point)) continue;
        const double cosine = points[i].normal.dot(contacts_[j].point.normal);
        if (cosine > best_cosine) {
          best_cosine = cosine;
          best = j;
        }
      }
      if (best) carry_on(i, *best);
    }
  };
  // The same block feature on the next ground feature, or the same ground feature under the next
  // block feature; then whatever took over at the same place.
  hand_over([](const ContactPoint& a, const ContactPoint& b) {
    return a.kind == b.kind &&
           (a.block_feature == b.block_feature ||
            (a.kind != ContactKind::kVertexGround && a.ground_feature == b.ground_feature));
  });
  hand_over([&](const ContactPoint& a, const ContactPoint& b) {
    return (a.foot - b.foot).squaredNorm() < near_ * near_;
  });
}

std::span<const std::uint32_t> ContactForces::joints_of(
    const ContactPoint& point, std::array<std::uint32_t, 3>& buffer) const {
  if (point.kind == ContactKind::kVertexGround) return block_.joints_of(point.block_feature);
  if (point.kind == ContactKind::kFaceVertex) {
    buffer[0] = block_.faces[point.block_feature].plane;
    return {buffer.data(), 1};
  }
  const SurfaceEdge& edge = block_.edges[point.block_feature];
  std::size_t count = 0;
  buffer[count++] = block_.joint_of_line(edge.line);
  for (const std::uint32_t face : edge.faces) {
    if (face != kNoFeature) buffer[count++] = block_.faces[face].plane;
  }
  return {buffer.data(), count};
}

std::size_t ContactForces::patch_of(std::size_t contact) {
  while (patch_[contact] != contact) contact = patch_[contact] = patch_[patch_[contact]];
  return contact;
}

void ContactForces::join_patches(const std::vector<Contact>& contacts, const Quat& orientation) {
  // Flat or smoothly convex ground between the two.
  const auto smooth_between = [](const ContactPoint& a, const ContactPoint& b) {
    if (a.normal.dot(b.normal) < kPatchCosine) return false;
    const Vec3 between = b.foot - a.foot;
    const double rise = kPatchRise * between.norm();
    return a.normal.dot(between) <= rise && b.normal.dot(between) >= -rise;
  };
  patch_.resize(contacts.size());
  std::iota(patch_.begin(), patch_.end(), std::size_t{0});
  on_joint_.resize(block_.faces.size() + block_.edges.size());
  const Mat3 body_from_world = orientation.toRotationMatrix().transpose();
  std::array<std::uint32_t, 3> buffer;
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const Vec3 in_body = body_from_world * contacts[i].point.normal;
    for (const std::uint32_t joint : joints_of(contacts[i].point, buffer)) {
      // A side wall joins nothing that stands on the ground: two feet stay two.
      const bool wall =
          joint < block_.faces.size() && block_.faces[joint].normal.dot(in_body) > -kFacingCosine;
      if (wall) continue;
      if (on_joint_[joint].empty()) joints_used_.push_back(joint);
      for (const std::uint32_t j : on_joint_[joint]) {
        const std::size_t a = patch_of(i), b = patch_of(j);
        if (a == b || !smooth_between(contacts[i].point, contacts[j].point)) continue;
        patch_[std::max(a, b)] = std::min(a, b);
      }
      on_joint_[joint].push_back(i);
    }
  }
  for (const std::uint32_t joint : joints_used_) on_joint_[joint].clear();
  joints_used_.clear();
}

void ContactForces::share_weights(std::vector<Contact>& contacts, const Quat& orientation) {
  const std::size_t count = contacts.size();
  if (weights_ == ContactWeights::kNone || count == 0) return;
  if (weights_ == ContactWeights::kCount) {
    for (Contact& contact : contacts) contact.weight = 1.0 / static_cast<double>(count);
    return;
  }
  if (weights_ == ContactWeights::kPatch) {
    join_patches(contacts, orientation);
  } else {
    patch_.assign(count, 0);
  }
  patch_overlap_.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    patch_overlap_[patch_of(i)] += contacts[i].point.overlap;
  }
  for (std::size_t i = 0; i < count; ++i) {
    contacts[i].weight = contacts[i].point.overlap / patch_overlap_[patch_of(i)];
  }
}

double ContactForces::stored(const Contact& contact) const {
  const double overlap = contact.point.overlap;
  return 0.5 * contact.weight *
         (stiffness_.normal * contact.ground->energy_restitution * overlap * overlap +
          contact.tangential.squaredNorm() / stiffness_.tangential +
          contact.rolling.squaredNorm() / stiffness_.rolling);
}

double ContactForces::stored_energy() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += stored(contact);
  return sum;
}

double ContactForces::max_overlap() const {
  double largest = 0.0;
  for (const Contact& contact : contacts_) largest = std::max(largest, contact.point.overlap);
  return largest;
}

double ContactForces::settled_depth() {
  // One law carries with its weighted mean overlap: that is the depth that Eq. 2 speaks of.
  const bool alone = weights_ == ContactWeights::kNone;
  std::vector<double> depth(contacts_.size(), 0.0);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const bool shared = weights_ == ContactWeights::kPatch;
    const std::size_t law = alone ? i : shared ? patch_of(i) : 0;
    const ContactPoint& point = contacts_[i].point;
    depth[law] += contacts_[i].weight * point.overlap * std::max(0.0, point.normal.z());
  }
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

double ContactForces::smallest_restitution() const {
  double smallest = 1.0;
  for (const Contact& contact : contacts_) {
    smallest = std::min(smallest, contact.ground->energy_restitution);
  }
  return smallest;
}

}  // namespace clast
