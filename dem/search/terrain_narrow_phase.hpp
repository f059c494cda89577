#pragma once
/// Narrow phase: finds the contact points of one block on a reference body, the terrain or another
/// block. That body is called the ground here, and everything is in its frame.
///
/// The block is cut into parts. One far from the ground sleeps as a whole, until `moved_`, a bound
/// of how far any of its points has moved, has grown by its gap. One near the ground keeps a list
/// of the ground near it, in which its vertices and its sides (edges and faces) search for what
/// they may touch. What is measured there sleeps too, for as long as the plane between it and the
/// ground keeps them apart: that plane mostly lies along the ground, so what slides or rolls over
/// it sleeps long although it moves far (docs/theory.md, Contact search).
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "dem/search/feature_tests.hpp"
#include "dem/search/index_list.hpp"
#include "dem/search/separation.hpp"

namespace clast::dem_detail {

/// How a block flies on from a contact-free place: bounds for every point of its core.
struct FlightBounds {
  Vec3 velocity = Vec3::Zero();  ///< of the centre now, m/s
  Vec3 spin = Vec3::Zero();      ///< now, rad/s
  double turning = 0.0;  ///< changes the velocity of a point by no more, per m of its arm, 1/s^2
  double acceleration = 0.0;     ///< no point changes its velocity faster, m/s^2
  double max_point_speed = 0.0;  ///< no point gets faster than this, but for gravity, m/s
  double gravity = 0.0;          ///< along -z, m/s^2
};

class TerrainNarrowPhase {
 public:
  /// @param block  in its body frame; it and the ground must outlive the search
  /// @param size   smallest side of the block, m: lists look ahead a share of it
  TerrainNarrowPhase(const IndexedSurface& ground, const BlockSurface& block, double size);

  /// Brings everything that is due up to date and lists the contacts, in a fixed order, until this
  /// is called again for any search in this thread; the caller may change them.
  /// @param travel  a bound of how far any point of the block has moved since the start, never
  /// smaller than in the call before
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body, double displacement);

  /// No contact can come before the travel has grown beyond this (valid after `contacts`). Where a
  /// search for it has found little it is not repeated at once, as in `safe_time`.
  double safe_displacement();
  /// How long no contact can come on such a flight (valid after `contacts`), s. Away from the
  /// ground the ball around the block gives it. Near it the search costs as much as several
  /// steps, so it is not repeated at once where one has found too little: then 0.
  /// @param worthwhile  s: a shorter time does not help the caller
  double safe_time(const FlightBounds& flight, double worthwhile);

  /// All that the contacts to come, and their order, depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, started_, displacement_, moved_, turned_, last_move_, local_, ground_complete_,
          ground_gathered_at_, part_states_, part_expiry_, search_at_, deepest_, allowed_,
          lowest_face_, touches_);
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      bool near = part_states_[p].near != nullptr;
      bytes(near);
      if constexpr (Bytes::kReads) {
        if (near) part_states_[p].near = std::make_unique<NearPart>(parts_.parts[p]);
      }
      if (near) bytes(*part_states_[p].near);
    }
  }

 private:
  /// An edge or corner of the ground near a part.
  struct GroundFeature {
    bool is_vertex = false;
    std::uint32_t index = 0;           ///< of the edge or vertex
    SeparationBound separation_bound;  ///< until a side that is not listed with it may touch

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(is_vertex, index, separation_bound);
    }
  };
  /// A side of the block with an edge or corner of the ground.
  struct FeaturePair {
    ContactKind kind;
    std::uint32_t side;  ///< of BlockParts::sides
    std::uint32_t ground_feature;
    SeparationBound separation_bound;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, separation_bound);
    }
  };
  /// |n.axis| and |n x axis| of a face of the ground with normal n.
  struct FaceTilt {
    double axial, transverse;
    /// As far as a height over its plane lets anything go that way; 0 at a border, beyond which its
    /// plane goes on.
    double displacement_per_height;

    bool is_at_border() const { return displacement_per_height == 0.0; }
    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(axial, transverse, displacement_per_height);
    }
  };
  struct VertexState {
    bool outside = false;  ///< known to have been out of reach of the ground
    // While outside: entry of the list whose plane it is closest to reach, and until when it is
    // clear of all else.
    std::uint32_t closest_plane = kNoFeature;
    SeparationBound others;
    std::uint32_t near_face = 0;  ///< entry of the part's list that was nearest
    // While its foot stays on `nearest_face`, no other face matters: inside the ground until the
    // one, outside within reach until the other `displacement.total`.
    std::uint32_t nearest_face = kNoFeature;
    double foot_on_face_until = -1.0;  ///< the foot cannot leave the face before
    double inside_until = -1.0;
    double outside_until = -1.0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(outside, closest_plane, others, near_face, nearest_face, foot_on_face_until,
            inside_until, outside_until);
    }
  };
  /// A part near the ground.
  struct NearPart {
    explicit NearPart(const BlockPart& part)
        : first_vertex(part.first_vertex),
          vertices(part.end_vertex - part.first_vertex),
          vertex_bounds(vertices.size()) {}

    LocalFaces ground;
    double complete = 0.0;     ///< from every point of the part so far the list was complete, m ...
    double gathered_at = 0.0;  ///< ... at this `displacement.total`
    Vec3 axis = Vec3::UnitZ();
    Displacement displacement;
    Vec3 centre = Vec3::Zero();  ///< when the way was last read, and `turned_` then
    double turned = 0.0;
    std::vector<FaceTilt> tilts;  ///< of the faces of `ground`
    std::vector<GroundFeature> features;
    std::vector<FeaturePair> pairs;
    std::uint32_t first_vertex;  ///< the first of its vertices in BlockParts::vertices
    // By number of the vertex within the part:
    std::vector<VertexState> vertices;
    std::vector<SeparationBound> vertex_bounds;
    std::vector<std::uint32_t> expired_vertices;  ///< those that touch, mostly; in order
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
  /// A contact of a side, with what it is sorted by.
  struct SideContact {
    std::uint32_t side;
    ContactPoint point;
  };
  /// What touches.
  struct FoundContacts {
    std::vector<ContactPoint> contacts;
    std::vector<SideContact> of_sides;

    void clear() {
      contacts.clear();
      of_sides.clear();
    }
  };
  /// Of one call, shared by all searches of a thread.
  struct Scratch {
    IndexList expired_parts;         ///< parts to look at ...
    IndexList near_parts_to_update;  ///< ... and those of them that are near the ground
    FoundContacts found;             ///< by `contacts` ...
    FoundContacts ahead;             ///< ... and by looks ahead, which need none of it
    std::vector<std::uint32_t>
        near_parts;  ///< of `contact_free_time_over_face`, and those of them ...
    std::vector<std::uint32_t> unseparated_parts;  ///< ... that no plane keeps apart from some face
  };
  static Scratch& scratch();

  void set_pose(const Pose& ground_from_body);
  bool defer_all_parts();
  /// Makes `local_` complete up to this distance from the block.
  void collect_ground(double complete);
  /// Lists the parts to look at in this call.
  void list_expired_parts();
  /// Visits all parts near the ground, with all their features of the ground due.
  void list_all_parts();
  /// Until when it must be known whether a part far from the ground can touch.
  void update_part(std::uint32_t p, double until);
  /// Between the ball around the part and the ground, m.
  double measure_clearance(std::uint32_t p);
  /// Lists the ground near the part.
  /// @param deepest  no point of the part is deeper inside the ground, m
  void collect_part_ground(std::uint32_t p, double deepest);
  /// Takes the mean normal of the ground listed as the axis; what was measured is due.
  void update_axis(std::uint32_t p);
  void update_displacement(std::uint32_t p);
  /// Renews the list of the ground when the part has moved too far for it, or is about to; a part
  /// that has left the ground sleeps as a whole again.
  void refresh_ground_list(std::uint32_t p, double ahead);
  /// When the part must be looked at again, as `moved_`.
  double next_update(std::uint32_t p) const;
  /// The list of the ground must be renewed at this `displacement.total`.
  double list_expiry(const NearPart& part) const { return part.gathered_at + list_holds_; }
  /// How long a part touches nothing, by how far its points move; no more than `wanted` is
  /// measured.
  double part_contact_free_time(std::uint32_t p, const FlightBounds& flight, double wanted);
  /// How long no contact can come on a flight, s, from planes between the block and the ground.
  /// @param horizon  s: no longer time is wanted
  double contact_free_time(const FlightBounds& flight, double horizon);
  /// The same with one face of the ground.
  double contact_free_time_over_face(const LocalFaces::Face& face, const FlightBounds& flight,
                                     double horizon);
  /// The same where the block is not wholly above the plane of the face: from planes that touch it
  /// nearest to the near parts of the block in `scratch`; adds to the doubtful ones.
  double parts_contact_free_time(const LocalFaces::Face& face, bool at_border,
                                 const FlightBounds& flight, double horizon);
  /// A ball that flies with the block.
  struct PartSphere {
    Vec3 centre;
    double radius;
    double turning;  ///< bound of what turning changes the velocity of its centre by, m/s^2
  };
  /// For how long it does not touch a face, s; 0 where it may do so now.
  double sphere_contact_free_time(const LocalFaces::Face& face, const PartSphere& part,
                                  const FlightBounds& flight, double horizon) const;
  double completeness(const NearPart& part) const {
    return part.complete - (part.displacement.total - part.gathered_at);
  }
  /// Asleep while something `distance` away along the unit vector `away` stays out of reach, and
  /// nothing else comes closer than `others`, wherever it is; due at once when either is not above
  /// 0.
  SeparationBound separation_bound(const NearPart& part, const Vec3& away, double distance,
                                   double others) const;

  // Vertices by their number within the part; those that touch are added to `found`.

  /// The vertex of the block.
  std::uint32_t block_vertex(const NearPart& part, std::uint32_t vertex) const {
    return parts_.vertices[part.first_vertex + vertex];
  }

  /// Every vertex of the part that is due.
  /// @param ahead  way for which it must be known whether they can touch
  void update_vertices(std::uint32_t p, const Displacement& ahead, FoundContacts& found);
  void update_vertex(NearPart& part, std::uint32_t vertex, const Displacement& ahead,
                     FoundContacts& found);
  /// Until a vertex that is outside the ground may touch any of it; due when it may touch now.
  SeparationBound ground_separation_bound(NearPart& part, std::uint32_t vertex, const Vec3& centre);
  /// The same from its closest plane, where all else is known to be clear.
  SeparationBound plane_separation_bound(const NearPart& part, std::uint32_t vertex,
                                         const Vec3& centre) const;
  bool update_nearest_face(NearPart& part, std::uint32_t vertex, const Vec3& centre,
                           FoundContacts& found);
  void measure_vertex(NearPart& part, std::uint32_t vertex, const Vec3& centre,
                      FoundContacts& found);
  /// Everything of the part's sides that is due.
  void update_sides(std::uint32_t p, const Displacement& ahead, FoundContacts& found);
  /// Lists the sides of the part near a feature of the ground.
  void update_feature(std::uint32_t p, GroundFeature& feature);
  void update_pair(const NearPart& part, FeaturePair& pair, FoundContacts& found);
  /// Sides closer than this to a feature of the ground may touch it, m.
  double contact_distance() const { return std::max(reach_, allowed_.depth()); }
  void add_side_contacts(FoundContacts& found);
  Vec3 in_ground_frame(const Vec3& in_body) const { return tests_.in_ground_frame(in_body); }

  const IndexedSurface& ground_;
  const IndexedSurface& surface_;  ///< of the block
  const SurfaceFeatures& block_;   ///< its features
  const BlockParts& parts_;        ///< and its parts
  double reach_;                   ///< block radius + skin radius, m
  double bounding_radius_ = 0.0;   ///< of the core about the centre, m
  double farthest_ = 0.0;          ///< of the balls around the parts from the centre, m
  double size_;                    ///< smallest side, m
  double margin_;                  ///< how far lists look ahead, m
  double list_holds_;              ///< way of a part for which its list of the ground holds, m
  FeatureTests tests_;             ///< at the present place

  bool started_ = false;
  double displacement_ = 0.0;  ///< the caller's
  double moved_ = 0.0;         ///< since the start, summed from call to call, m
  double turned_ = 0.0;        ///< likewise: bounds what turning moves a point at an arm of 1 m, m
  double last_move_ = 0.0;     ///< growth of `moved_` in the last call, m
  LocalGround local_;          ///< around the whole block
  // From every point of the block so far `local_` was complete when it was gathered.
  double ground_complete_ = -1.0;
  double ground_gathered_at_ = 0.0;
  std::vector<PartState> part_states_;
  std::vector<double> part_expiry_;  ///< `moved_` at which to look at the part again
  double search_at_ = -1.0;          ///< no longer flight is searched for before
  double deepest_ = 0.0;             ///< largest overlap at the last call, m
  ContactDepthLimit allowed_;        ///< of edges and faces: what sleeps has allowed for it
  std::uint32_t lowest_face_ = 0;    ///< of `local_`: the one that ended the last flight
  bool touches_ = false;             ///< in the last call
};

}  // namespace clast::dem_detail
