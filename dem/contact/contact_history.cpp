#include "dem/contact/contact_history.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clast::dem_detail {
namespace {

/// A contact continues another only if their normals differ by at most 45 degrees.
constexpr double kContinuesCosine = 0.7071067811865476;

/// Rotates a vector perpendicular to `before` so that it is perpendicular to `normal`.
Vec3 turned_into_plane(const Vec3& vector, const Vec3& before, const Vec3& normal) {
  if (normal == before) return vector;
  const double length = vector.norm();
  const Vec3 flat = vector - vector.dot(normal) * normal;
  const double flat_length = flat.norm();
  return flat_length > 1e-300 ? Vec3(flat * (length / flat_length)) : Vec3(Vec3::Zero());
}

}  // namespace

void ContactHistory::match_contacts(const std::vector<ContactPoint>& points,
                                    const std::vector<Contact>& before, double max_distance) {
  previous_of_.assign(points.size(), -1);
  continued_.assign(before.size(), 0);
  if (match_features(points, before) == points.size()) return;
  // First the same block feature on another ground feature, or the same ground feature under
  // another block feature. Then any contact near the same position.
  match_by_relation(points, before, [](const ContactPoint& a, const ContactPoint& b) {
    return a.kind == b.kind &&
           (a.block_feature == b.block_feature ||
            (a.kind != ContactKind::kVertexGround && a.ground_feature == b.ground_feature));
  });
  match_by_relation(points, before, [&](const ContactPoint& a, const ContactPoint& b) {
    return (a.surface_point - b.surface_point).squaredNorm() < max_distance * max_distance;
  });
}

std::size_t ContactHistory::match_features(const std::vector<ContactPoint>& points,
                                           const std::vector<Contact>& before) {
  // Both lists have the same order, so that each search starts where the last one ended.
  std::size_t next = 0, found = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t tried = 0; tried < before.size(); ++tried) {
      if (next == before.size()) next = 0;
      const std::size_t j = next++;
      const ContactPoint& a = points[i];
      const ContactPoint& b = before[j].point;
      if (continued_[j] || a.kind != b.kind || a.block_feature != b.block_feature ||
          a.ground_feature != b.ground_feature || a.normal.dot(b.normal) < kContinuesCosine) {
        continue;
      }
      continue_contact(i, j);
      ++found;
      break;
    }
  }
  return found;
}

template <class Related>
void ContactHistory::match_by_relation(const std::vector<ContactPoint>& points,
                                       const std::vector<Contact>& before, const Related& related) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (previous_of_[i] >= 0) continue;
    std::optional<std::size_t> best;
    double best_cosine = kContinuesCosine;
    for (std::size_t j = 0; j < before.size(); ++j) {
      if (continued_[j] || !related(points[i], before[j].point)) continue;
      const double cosine = points[i].normal.dot(before[j].point.normal);
      if (cosine > best_cosine) {
        best_cosine = cosine;
        best = j;
      }
    }
    if (best) continue_contact(i, *best);
  }
}

void ContactHistory::transfer_springs(std::vector<Contact>& now, const std::vector<Contact>& before,
                                      const ContactPatches& patches) {
  spring_transfers_.assign(now.size(), {});
  gained_.resize(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    Contact& contact = now[i];
    double more = contact.weight;
    if (const Contact* previous = this->previous_contact(i, before)) {
      contact.tangential_force = turned_into_plane(previous->tangential_force,
                                                   previous->point.normal, contact.point.normal);
      contact.rolling_moment = previous->rolling_moment;
      more -= previous->weight;
    }
    gained_[i] = more;
    SpringTransfer& transfer = spring_transfers_[patches.patch_index(i)];
    if (more > 0.0) {
      transfer.gained += more;
    } else {
      transfer.lost -= more;
      transfer.tangential_force -= more * contact.tangential_force;
      transfer.rolling_moment -= more * contact.rolling_moment;
    }
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double more = gained_[i];
    if (!(more > 0.0)) continue;
    const SpringTransfer& transfer = spring_transfers_[patches.patch_index(i)];
    if (!(transfer.lost > 0.0)) continue;
    Contact& contact = now[i];
    // If more weight is gained than lost, the surplus keeps the springs of its own point.
    const double taken = more / std::max(transfer.gained, transfer.lost);
    const double own = 1.0 - taken * transfer.lost / contact.weight;
    const Vec3 tangential =
        own * contact.tangential_force + taken / contact.weight * transfer.tangential_force;
    contact.tangential_force =
        tangential - tangential.dot(contact.point.normal) * contact.point.normal;
    contact.rolling_moment =
        own * contact.rolling_moment + taken / contact.weight * transfer.rolling_moment;
  }
}

}  // namespace clast::dem_detail
