#pragma once
/// Narrow phase: contact points of one block on a reference body, which is the terrain or another
/// block. The reference body is called the ground here; all data are in its frame.
///
/// The block is divided into parts. A part far from the ground is skipped until the accumulated
/// displacement `accumulated_displacement_` has grown by its distance from the ground. A part near
/// the ground keeps a list of nearby ground features. All its vertices together, and each of its
/// sides (edges and faces), are tested against them. Each test gives a separation bound; it is not
/// repeated before the bound expires (docs/theory.md, Contact search).
#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dem/search/feature_tests.hpp"
#include "dem/search/index_list.hpp"
#include "dem/search/separation.hpp"
#include "dem/search/vertex_filter.hpp"

namespace clast::dem_detail {

/// State of a body in free flight, with bounds of the motion of all its points.
struct FlightBounds {
  Vec3 velocity = Vec3::Zero();  ///< present velocity of the centre, m/s
  Vec3 spin = Vec3::Zero();      ///< present angular velocity, rad/s
  /// Bound of the acceleration by rotation, per distance from the centre, 1/s^2.
  double rotational_acceleration = 0.0;
  double acceleration = 0.0;     ///< bound of the acceleration of any point, m/s^2
  double max_point_speed = 0.0;  ///< bound of the speed of any point without gravity, m/s
  double gravity = 0.0;          ///< acceleration of gravity along -z, m/s^2
};

class TerrainNarrowPhase {
 public:
  /// Prepares the contact search.
  /// @param block  block in its body frame; must outlive this object, as must the ground
  /// @param size  smallest side of the block, m; the listing distances are proportional to it
  TerrainNarrowPhase(const IndexedSurface& ground, const BlockSurface& block, double size);

  /// Re-evaluates all expired separation bounds and returns the contacts, in a deterministic order.
  /// The caller may modify the returned list. It is valid until the next search in this thread.
  /// @param displacement  upper bound of the accumulated displacement of any block point, m
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_body, double displacement);

  /// Returns the value of the accumulated displacement below which contact is impossible, m. Valid
  /// after `find_contacts`. If it is close to the present value, the search is suspended for a
  /// while and the present value is returned.
  double contact_free_displacement();
  /// Finds a time of flight during which contact is impossible, s. Valid after `find_contacts`.
  /// Near the ground, the search costs as much as several steps. If the result is too small, the
  /// search is suspended for a while; calls then return 0.
  /// @param worthwhile  shortest time that is useful to the caller, s
  double find_contact_free_flight_time(const FlightBounds& flight, double worthwhile);

  /// Serialises the state that determines future contacts and their order.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, started_, displacement_, accumulated_displacement_, accumulated_rotation_,
          last_move_, local_, ground_complete_, ground_gathered_at_, part_states_, part_expiry_,
          search_at_, deepest_, depth_limit_, lowest_face_, touches_);
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      bool near = part_states_[p].near != nullptr;  ///< null if the part is far from the ground
      bytes(near);
      if constexpr (Bytes::kReads) {
        if (near) part_states_[p].near = std::make_unique<NearPart>();
      }
      if (near) bytes(*part_states_[p].near);
    }
  }

 private:
  /// Ground edge or vertex near a part.
  struct GroundFeature {
    bool is_vertex = false;
    std::uint32_t index = 0;  ///< index of the edge or vertex
    /// Separation bound from all block edges and faces that have no listed pair with it.
    SeparationBound separation_bound;

    /// Order of the features of a list.
    bool operator<(const GroundFeature& other) const {
      return is_vertex != other.is_vertex ? other.is_vertex : index < other.index;
    }
    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(is_vertex, index, separation_bound);
    }
  };
  /// Pair of a block edge or face and a ground edge or vertex.
  struct FeaturePair {
    ContactKind kind;
    std::uint32_t side;  ///< index into BlockParts::sides
    std::uint32_t ground_feature;
    SeparationBound separation_bound;
    /// Value of `accumulated_displacement_` below which contact is impossible. It is used if the
    /// two features have passed each other and no plane separates them.
    double contact_free_until = -1.0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, separation_bound, contact_free_until);
    }
  };
  /// Components of the normal of a ground face along the axis of a block part and perpendicular to
  /// it.
  struct FaceNormalComponents {
    double axial, transverse;
    /// Displacement before contact, per height above the plane of the face. It is 0 for a face at
    /// the border of the ground.
    double displacement_per_height;

    bool is_at_border() const { return displacement_per_height == 0.0; }
    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(axial, transverse, displacement_per_height);
    }
  };
  struct NearPart {
    LocalFaces ground;
    /// Distance from the part up to which its ground list was complete when made, m.
    double complete_distance = 0.0;
    double collected_at = 0.0;  ///< `displacement.total` at that time
    Vec3 axis = Vec3::UnitZ();
    AccumulatedDisplacement displacement;
    /// Centre of the part in the ground frame at the last update of `displacement`.
    Vec3 centre = Vec3::Zero();
    double turned = 0.0;                      ///< `accumulated_rotation_` at the same time
    std::vector<FaceNormalComponents> tilts;  ///< normal components of each face of `ground`
    std::vector<GroundFeature> features;
    std::vector<FeaturePair> pairs;
    /// True if the overlaps found by the last search bound the depth of all vertices.
    bool depth_known = false;
    /// Groups of vertices with contacts, by index in `BlockParts::vertex_groups`, and those that
    /// had contacts since all were compared. They are compared with the ground in each search.
    std::vector<std::uint32_t> touching_groups;
    /// Indices of the faces of `ground` that may be in contact, while `displacement.total` is below
    /// `close_faces_until` and no vertex is deeper than `close_faces_depth`, m.
    std::vector<std::uint32_t> close_faces;
    double close_faces_until = -1.0, close_faces_depth = -1.0;
    // Combined bounds: of all vertices that are in no touching group, of all features, of all
    // pairs.
    SeparationBound other_vertices, all_features, all_pairs;
    /// Least `contact_free_until` of the pairs that need it, m.
    double pairs_contact_free_until = 1e300;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(ground, complete_distance, collected_at, axis, displacement, centre, turned, tilts,
            features, pairs, depth_known, touching_groups, close_faces, close_faces_until,
            close_faces_depth, other_vertices, all_features, all_pairs, pairs_contact_free_until);
    }
  };
  struct PartState {
    std::unique_ptr<NearPart> near;  ///< null if the part is far from the ground
    // Last measurement while the part was far: its clearance, its centre and
    // `accumulated_rotation_`.
    double clearance = 0.0;
    Vec3 measured_centre = Vec3::Zero();
    double measured_rotation = 0.0;
    std::uint32_t near_face = 0;  ///< entry of `local_` that was nearest then

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(clearance, measured_centre, measured_rotation, near_face);
    }
  };
  /// Contact of a block edge or face, with the sort key `side`.
  struct SideContact {
    std::uint32_t side;
    ContactPoint point;
  };
  struct FoundContacts {
    std::vector<ContactPoint> contacts;
    std::vector<SideContact> side_contacts;

    void clear() {
      contacts.clear();
      side_contacts.clear();
    }
  };
  /// Temporary data of one call, shared by all searches of a thread.
  struct Scratch {
    IndexList expired_parts;         ///< block parts to update
    IndexList near_parts_to_update;  ///< those of `expired_parts` that are near the ground
    FoundContacts found;             ///< contacts found by `find_contacts`
    FoundContacts ahead;             ///< contacts found by flight searches, which are not used
    std::vector<std::uint32_t> near_parts;  ///< used by `contact_free_time_over_face`
    /// Those of `near_parts` that no plane separates from some ground face.
    std::vector<std::uint32_t> unseparated_parts;
    struct VertexTest {
      std::vector<std::uint32_t> groups;  ///< groups of vertices that are compared with the ground
      std::vector<FilteredVertices> vertices;      ///< their results
      std::vector<std::uint32_t> touching_groups;  ///< those of them that have contacts
      std::vector<PrismClearance> clearances;      ///< used by `vertices_separation_bound`
    };
    VertexTest vertex_test;
    std::vector<GroundFeature> features_before;  ///< used by `collect_part_ground`
  };
  static Scratch& scratch();

  void set_pose(const Pose& ground_from_body);
  bool defer_all_parts();
  /// Stores the ground features within the distance `complete` of the block in `local_`.
  void collect_ground(double complete);
  /// Lists the block parts whose separation bounds have expired.
  void list_expired_parts();
  /// Lists all parts near the ground and marks all their features as expired.
  void list_all_parts();
  /// Updates the clearance of a block part that is far from the ground.
  void update_part(std::uint32_t p, double until);
  /// Returns the distance between the bounding sphere of a block part and the ground, m.
  double measure_clearance(std::uint32_t p);
  /// Collects the ground features near a block part.
  /// @param deepest  bound of the depth of any part point inside the ground, m
  void collect_part_ground(std::uint32_t p, double deepest);
  /// Sets the axis of a block part, along which its displacement is measured, to the mean normal of
  /// the nearby ground. All separation bounds of the part become invalid.
  void update_axis(std::uint32_t p);
  void update_displacement(std::uint32_t p);
  /// Renews the list of ground features of a block part if it is about to expire. If the part has
  /// left the ground, its lists are deleted.
  void refresh_ground_list(std::uint32_t p, double ahead);
  /// Returns the value of `accumulated_displacement_` at which a block part must be updated, m.
  double next_update(std::uint32_t p) const;
  /// Returns the total displacement at which the ground list of a block part expires, m.
  double list_expiry(const NearPart& part) const { return part.collected_at + list_lifetime_; }
  /// Returns the time of flight in which a block part cannot touch the ground, s, at most `wanted`.
  double part_contact_free_time(std::uint32_t p, const FlightBounds& flight, double wanted);
  /// Returns the time of flight in which the block cannot touch the ground, s. It follows from
  /// planes that separate block and ground.
  /// @param horizon  largest time that is useful, s
  double contact_free_time(const FlightBounds& flight, double horizon);
  double contact_free_time_over_face(const LocalFaces::Face& face, const FlightBounds& flight,
                                     double horizon);
  /// Returns the time of flight in which the block parts near the ground cannot touch a ground
  /// face, s. Each part is tested on its own. Parts that may touch the face at once are excluded
  /// and added to `Scratch::unseparated_parts`.
  double parts_contact_free_time(const LocalFaces::Face& face, bool at_border,
                                 const FlightBounds& flight, double horizon);
  /// Bounding sphere of a block part in flight.
  struct PartSphere {
    Vec3 centre;
    double radius;
    double centre_acceleration;  ///< bound of the acceleration of the centre by rotation, m/s^2
  };
  /// Returns the time of flight in which the bounding sphere of a block part cannot touch a ground
  /// face, s; 0 if they may touch at once.
  double sphere_contact_free_time(const LocalFaces::Face& face, const PartSphere& part,
                                  const FlightBounds& flight, double horizon) const;
  double remaining_complete_distance(const NearPart& part) const {
    return part.complete_distance - (part.displacement.total - part.collected_at);
  }
  /// Makes the separation bound of a block part. The nearest ground feature is at `distance` along
  /// the unit vector `away`; all others are at least at the distance `others`. The bound is expired
  /// if a distance is not positive.
  SeparationBound separation_bound(const NearPart& part, const Vec3& away, double distance,
                                   double others) const;

  /// Tests the vertices of a block part: all if their separation bound has expired, otherwise those
  /// of the touching groups.
  /// @param ahead  further displacement for which contacts must be found
  void update_vertices(std::uint32_t p, const AccumulatedDisplacement& ahead, FoundContacts& found);
  /// Compares the groups of vertices in `Scratch::vertex_test` with the ground.
  void filter_groups(std::uint32_t p);
  /// Lists the ground faces that may be in contact with vertices of a block part.
  /// @param max_depth  upper bound of the depth of all vertices, m
  void list_close_faces(std::uint32_t p, double max_depth);
  /// True if vertices stay separated from the ground for so long that a bound is worth its cost.
  bool stay_separated(std::span<const FilteredVertices> vertices) const;
  /// Adds the contacts of a group of compared vertices.
  void add_group_contacts(std::uint32_t p, std::uint32_t group, const FilteredVertices& vertices,
                          FoundContacts& found) const;
  /// Makes the contact of a vertex with the only ground face within reach of it, or inside the
  /// ground with the nearest face.
  /// @param centre  position of the vertex in the frame of the ground
  /// @return false if the vertex needs an exact test
  bool add_face_contact(const NearPart& part, std::uint32_t vertex, const Vec3& centre,
                        std::uint32_t listed_face, FoundContacts& found) const;
  /// Tests a vertex against all listed ground faces.
  /// @param near_face  index of a listed face that is probably near
  void test_vertex(const NearPart& part, std::uint32_t vertex, const Vec3& centre,
                   std::uint32_t near_face, FoundContacts& found) const;
  /// Returns the separation bound of vertices of a block part that are not in contact.
  SeparationBound vertices_separation_bound(std::uint32_t p,
                                            std::span<const FilteredVertices> vertices) const;
  /// Updates all edges and faces of a block part whose separation bounds have expired.
  void update_sides(std::uint32_t p, const AccumulatedDisplacement& ahead, FoundContacts& found);
  /// Lists the edges and faces of a block part that are near a ground feature.
  void update_feature(std::uint32_t p, GroundFeature& feature);
  void update_pair(const NearPart& part, FeaturePair& pair, FoundContacts& found);
  /// Returns the largest distance between a block edge or face and a ground feature in contact, m.
  double contact_distance() const { return std::max(reach_, depth_limit_.depth()); }
  /// Returns the largest distance at which block edges on one side of a plane may touch a ground
  /// edge on its other side, m. It is the reach if the plane faces out of the ground.
  /// @param away  normal of the plane towards the block, of any length
  double contact_distance_across(const SurfaceEdge& ground_edge, const Vec3& away) const;
  void add_side_contacts(FoundContacts& found);
  Vec3 in_ground_frame(const Vec3& in_body) const { return tests_.in_ground_frame(in_body); }

  const IndexedSurface& ground_;
  const IndexedSurface& surface_;  ///< indexed surface of the block
  const SurfaceFeatures& block_;   ///< features of the block
  const BlockParts& parts_;        ///< parts of the block
  double reach_;                   ///< sum of the rounding radii of block and ground, m
  double bounding_radius_ = 0.0;   ///< bounding radius of the core about the centre of mass, m
  double farthest_ = 0.0;          ///< largest distance of part spheres from the centre, m
  /// Accumulated displacement per displacement of `FeatureSeparation`, at least.
  double accumulated_per_displacement_ = 1.0;
  double size_;           ///< smallest side of the block, m
  double margin_;         ///< margin of the feature lists, m
  double list_lifetime_;  ///< displacement of a part for which its ground list is valid, m
  FeatureTests tests_;    ///< tests at the present pose

  bool started_ = false;
  double displacement_ = 0.0;              ///< displacement passed to `find_contacts`, m
  double accumulated_displacement_ = 0.0;  ///< accumulated displacement since the start, m
  /// Accumulated rotation, as the displacement of a point at 1 m from the centre, m.
  double accumulated_rotation_ = 0.0;
  double last_move_ = 0.0;  ///< increase of `accumulated_displacement_` in the last call, m
  LocalGround local_;       ///< ground around the whole block
  // Distance from the block to which `local_` was complete when collected, m;
  // `accumulated_displacement_` then.
  double ground_complete_ = -1.0;
  double ground_gathered_at_ = 0.0;
  std::vector<PartState> part_states_;
  std::vector<double>
      part_expiry_;  ///< `accumulated_displacement_` at which each part must be updated
  double search_at_ =
      -1.0;  ///< `accumulated_displacement_` before which the search for flights is suspended
  double deepest_ = 0.0;           ///< largest overlap of the last call, m
  ContactDepthLimit depth_limit_;  ///< depth limit that all separation bounds take into account
  std::uint32_t lowest_face_ = 0;  ///< entry of `local_` that limited the last flight
  bool touches_ = false;           ///< true if the last call found contacts
};

}  // namespace clast::dem_detail
