#pragma once
/// Narrow phase: contact points of one block on a reference body, the terrain or another block,
/// which is called the ground here; all data are in its frame.
///
/// The block is divided into parts. A part far from the ground is skipped as a whole until the
/// accumulated displacement `moved_` has grown by its distance. A part near the ground keeps a list
/// of nearby ground features, against which its vertices and sides (edges and faces) are tested.
/// Each test gives a separation bound, during which it is not repeated; because the separating
/// planes are mostly parallel to the ground, bounds last long for sliding and rolling blocks
/// (docs/theory.md, Contact search).
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "dem/search/feature_tests.hpp"
#include "dem/search/index_list.hpp"
#include "dem/search/separation.hpp"

namespace clast::dem_detail {

/// Bounds of a free flight, for all points of the core.
struct FlightBounds {
  Vec3 velocity = Vec3::Zero();  ///< present velocity of the centre, m/s
  Vec3 spin = Vec3::Zero();      ///< present angular velocity, rad/s
  double turning = 0.0;          ///< bound of the acceleration of its centre due to rotation, m/s^2
  double acceleration = 0.0;     ///< bound for any point, m/s^2
  double max_point_speed = 0.0;  ///< bound for any point without gravity, m/s
  double gravity = 0.0;          ///< along -z, m/s^2
};

class TerrainNarrowPhase {
 public:
  /// Prepares the search.
  /// @param block  in its body frame; must outlive this object, as must the ground
  /// @param size  smallest side of the block, m, which scales the list margin
  TerrainNarrowPhase(const IndexedSurface& ground, const BlockSurface& block, double size);

  /// Re-evaluates all expired separation bounds and returns the contacts in a deterministic order,
  /// valid and modifiable until the next call of any search in this thread.
  /// @param displacement  bound of the displacement of any block point since the start, never
  ///                      decreasing
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body, double displacement);

  /// Returns the displacement before which contact is impossible (valid after `find_contacts`).
  /// After a search that gained little, later calls reuse its result for a while, as in
  /// `safe_time`.
  double safe_displacement();
  /// Returns a contact-free flight time (valid after `find_contacts`), s: from the bounding sphere
  /// far from the ground; otherwise by a search that costs several steps and, after gaining too
  /// little, is suspended for a while, returning 0.
  /// @param worthwhile  s: shorter times do not help the caller
  double safe_time(const FlightBounds& flight, double worthwhile);

  /// Serialises the state that determines future contacts and their order.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, started_, displacement_, moved_, turned_, last_move_, local_, ground_complete_,
          ground_gathered_at_, part_states_, part_expiry_, search_at_, deepest_, allowed_,
          lowest_face_, touches_);
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      bool near = part_states_[p].near != nullptr;  ///< null if the part is far from the ground
      bytes(near);
      if constexpr (Bytes::kReads) {
        if (near) part_states_[p].near = std::make_unique<NearPart>(parts_.parts[p]);
      }
      if (near) bytes(*part_states_[p].near);
    }
  }

 private:
  /// Ground edge or vertex near a part.
  struct GroundFeature {
    bool is_vertex = false;
    std::uint32_t index = 0;           ///< of the edge or vertex
    SeparationBound separation_bound;  ///< valid until an unlisted side may touch it

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(is_vertex, index, separation_bound);
    }
  };
  /// Pair of a block side and a ground edge or vertex.
  struct FeaturePair {
    ContactKind kind;
    std::uint32_t side;  ///< index into BlockParts::sides
    std::uint32_t ground_feature;
    SeparationBound separation_bound;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, separation_bound);
    }
  };
  /// Components |n.axis| and |n x axis| of the normal n of a ground face.
  struct FaceTilt {
    double axial, transverse;
    /// Displacement allowed per height above its plane; 0 at a border, beyond which the plane
    /// continues.
    double displacement_per_height;

    bool is_at_border() const { return displacement_per_height == 0.0; }
    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(axial, transverse, displacement_per_height);
    }
  };
  struct VertexState {
    bool outside = false;  ///< known to be out of reach of the ground
    // While outside: entry of the list whose plane it is closest to reach, and until when it is
    // clear of all else.
    std::uint32_t closest_plane = kNoFeature;
    SeparationBound others;
    std::uint32_t near_face = 0;  ///< entry of the nearest face in the part's list
    // While its foot stays on `nearest_face`, no other face matters: inside the ground until the
    // one, outside within reach until the other `displacement.total`.
    std::uint32_t nearest_face = kNoFeature;
    double foot_on_face_until = -1.0;  ///< bound before which the foot stays on the face
    double inside_until = -1.0;
    double outside_until = -1.0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(outside, closest_plane, others, near_face, nearest_face, foot_on_face_until,
            inside_until, outside_until);
    }
  };
  struct NearPart {
    explicit NearPart(const BlockPart& part)
        : first_vertex(part.first_vertex),
          vertices(part.end_vertex - part.first_vertex),
          vertex_bounds(vertices.size()) {}

    LocalFaces ground;
    double complete =
        0.0;  ///< distance from all points of the part within which the list was complete, m
    double gathered_at = 0.0;  ///< `displacement.total` at that time
    Vec3 axis = Vec3::UnitZ();
    Displacement displacement;
    Vec3 centre = Vec3::Zero();  ///< when the way was last read, and `turned_` then
    double turned = 0.0;
    std::vector<FaceTilt> tilts;  ///< of the faces of `ground`
    std::vector<GroundFeature> features;
    std::vector<FeaturePair> pairs;
    std::uint32_t first_vertex;  ///< index into BlockParts::vertices
    // By number of the vertex within the part:
    std::vector<VertexState> vertices;
    std::vector<SeparationBound> vertex_bounds;
    std::vector<std::uint32_t> expired_vertices;  ///< mostly in contact; in order
    SeparationBound other_vertices, all_features,
        all_pairs;  ///< until the first of each may be due

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(ground, complete, gathered_at, axis, displacement, centre, turned, tilts, features,
            pairs, vertices, vertex_bounds, expired_vertices, other_vertices, all_features,
            all_pairs);
    }
  };
  struct PartState {
    std::unique_ptr<NearPart> near;  ///< none: it is far from the ground
    // What was measured last while it was far: the gap, where the centre was, and `turned_`.
    double clearance = 0.0;
    Vec3 measured_centre = Vec3::Zero();
    double measured_rotation = 0.0;
    std::uint32_t near_face = 0;  ///< entry of `local_` that was nearest

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(clearance, measured_centre, measured_rotation, near_face);
    }
  };
  /// Contact of a side with its sort key.
  struct SideContact {
    std::uint32_t side;
    ContactPoint point;
  };
  struct FoundContacts {
    std::vector<ContactPoint> contacts;
    std::vector<SideContact> of_sides;

    void clear() {
      contacts.clear();
      of_sides.clear();
    }
  };
  /// Temporary data of one call, shared by all searches of a thread.
  struct Scratch {
    IndexList expired_parts;         ///< parts to update
    IndexList near_parts_to_update;  ///< those of them near the ground
    FoundContacts found;             ///< by `contacts` ...
    FoundContacts ahead;             ///< ... and by looks ahead, which need none of it
    std::vector<std::uint32_t>
        near_parts;  ///< of `contact_free_time_over_face`, and those of them ...
    std::vector<std::uint32_t>
        unseparated_parts;  ///< those not separated from some face by a plane
  };
  static Scratch& scratch();

  void set_pose(const Pose& ground_from_body);
  bool defer_all_parts();
  /// Collects the ground features within this distance of the block in `local_`.
  void collect_ground(double complete);
  /// Lists the parts to update in this call.
  void list_expired_parts();
  /// Lists all parts near the ground, with all their features expired.
  void list_all_parts();
  /// Updates the expiry of a part far from the ground.
  void update_part(std::uint32_t p, double until);
  /// Returns the distance between the part's bounding sphere and the ground, m.
  double measure_clearance(std::uint32_t p);
  /// Collects the ground features near a part.
  /// @param deepest  bound of the depth of any part point inside the ground, m
  void collect_part_ground(std::uint32_t p, double deepest);
  /// Sets the axis to the mean normal of the listed ground; existing bounds expire.
  void update_axis(std::uint32_t p);
  void update_displacement(std::uint32_t p);
  /// Renews the ground list of a part if it is about to expire; a part that has left the ground is
  /// treated as a whole again.
  void refresh_ground_list(std::uint32_t p, double ahead);
  /// Returns the value of `moved_` at which a part must be updated.
  double next_update(std::uint32_t p) const;
  /// Returns the `displacement.total` at which the ground list expires.
  double list_expiry(const NearPart& part) const { return part.gathered_at + list_holds_; }
  /// Returns the contact-free time of a part, limited by `wanted`.
  double part_contact_free_time(std::uint32_t p, const FlightBounds& flight, double wanted);
  /// Returns the contact-free time of a flight, s, from planes between block and ground.
  /// @param horizon  s: longer times are not needed
  double contact_free_time(const FlightBounds& flight, double horizon);
  double contact_free_time_over_face(const LocalFaces::Face& face, const FlightBounds& flight,
                                     double horizon);
  /// Returns the contact-free time over a face whose plane does not separate the whole block, from
  /// planes through the nearest points of the near parts; unseparated parts are added to `scratch`.
  double parts_contact_free_time(const LocalFaces::Face& face, bool at_border,
                                 const FlightBounds& flight, double horizon);
  /// Bounding sphere of a part in flight.
  struct PartSphere {
    Vec3 centre;
    double radius;
    double turning;  ///< bound of what turning changes the velocity of its centre by, m/s^2
  };
  /// Returns the contact-free time of a part sphere over a face, s; 0 if contact is possible.
  double sphere_contact_free_time(const LocalFaces::Face& face, const PartSphere& part,
                                  const FlightBounds& flight, double horizon) const;
  double completeness(const NearPart& part) const {
    return part.complete - (part.displacement.total - part.gathered_at);
  }
  /// Makes a separation bound from a feature at `distance` along the unit vector `away`, and a
  /// lower bound `others` of all other distances; expired if either is not positive.
  SeparationBound separation_bound(const NearPart& part, const Vec3& away, double distance,
                                   double others) const;

  // Vertices by their number within the part; those that touch are added to `found`.

  std::uint32_t block_vertex(const NearPart& part, std::uint32_t vertex) const {
    return parts_.vertices[part.first_vertex + vertex];
  }

  /// Updates all expired vertices of a part.
  /// @param ahead  displacement for which contacts must be known
  void update_vertices(std::uint32_t p, const Displacement& ahead, FoundContacts& found);
  void update_vertex(NearPart& part, std::uint32_t vertex, const Displacement& ahead,
                     FoundContacts& found);
  /// Returns the separation bound of a vertex outside the ground; expired if contact is possible.
  SeparationBound ground_separation_bound(NearPart& part, std::uint32_t vertex, const Vec3& centre);
  /// Returns the separation bound of a vertex from its closest plane, if all other features are
  /// known to be clear.
  SeparationBound plane_separation_bound(const NearPart& part, std::uint32_t vertex,
                                         const Vec3& centre) const;
  bool update_nearest_face(NearPart& part, std::uint32_t vertex, const Vec3& centre,
                           FoundContacts& found);
  void measure_vertex(NearPart& part, std::uint32_t vertex, const Vec3& centre,
                      FoundContacts& found);
  /// Updates all expired sides of a part.
  void update_sides(std::uint32_t p, const Displacement& ahead, FoundContacts& found);
  /// Lists the sides of a part near a ground feature.
  void update_feature(std::uint32_t p, GroundFeature& feature);
  void update_pair(const NearPart& part, FeaturePair& pair, FoundContacts& found);
  /// Returns the distance below which sides may touch a ground feature, m.
  double contact_distance() const { return std::max(reach_, allowed_.depth()); }
  void add_side_contacts(FoundContacts& found);
  Vec3 in_ground_frame(const Vec3& in_body) const { return tests_.in_ground_frame(in_body); }

  const IndexedSurface& ground_;
  const IndexedSurface& surface_;  ///< of the block
  const SurfaceFeatures& block_;   ///< its features
  const BlockParts& parts_;        ///< its parts
  double reach_;                   ///< block radius + ground radius, m
  double bounding_radius_ = 0.0;   ///< of the core about the centre, m
  double farthest_ = 0.0;          ///< largest distance of part spheres from the centre, m
  double size_;                    ///< smallest side, m
  double margin_;                  ///< list margin, m
  double list_holds_;              ///< displacement of a part for which its ground list is valid, m
  FeatureTests tests_;             ///< at the present pose

  bool started_ = false;
  double displacement_ = 0.0;  ///< as passed by the caller
  double moved_ = 0.0;         ///< accumulated displacement since the start, m
  double turned_ = 0.0;     ///< accumulated rotation: displacement of a point at an arm of 1 m, m
  double last_move_ = 0.0;  ///< increase of `moved_` in the last call, m
  LocalGround local_;       ///< ground around the whole block
  // From every point of the block so far `local_` was complete when it was gathered.
  double ground_complete_ = -1.0;
  double ground_gathered_at_ = 0.0;
  std::vector<PartState> part_states_;
  std::vector<double> part_expiry_;  ///< `moved_` at which each part must be updated
  double search_at_ = -1.0;          ///< time before which no longer flight is searched
  double deepest_ = 0.0;             ///< largest overlap of the last call, m
  ContactDepthLimit allowed_;        ///< depth limit considered by all separation bounds
  std::uint32_t lowest_face_ = 0;    ///< of `local_`: the one that ended the last flight
  bool touches_ = false;             ///< true if the last call found contacts
};

}  // namespace clast::dem_detail
