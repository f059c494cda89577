#pragma once
/// Narrow phase: finds the contact points of one block on a reference body, the terrain or another
/// block. That body is called the ground here, and everything is in its frame.
///
/// Everything is paced by how far any point of the block has moved since the start, `moved_`.
/// Whatever is found to be a distance d away sleeps until it has grown by d, so that nothing can
/// touch unseen and most of the block costs nothing most of the time. The block is cut into parts
/// that sleep as one; a part near the ground keeps a list of the ground near it, in which its
/// vertices and its sides (edges and faces) search for features that they may touch.
#include <cstdint>
#include <vector>

#include "dem/detail/block_surface.hpp"
#include "dem/detail/local_ground.hpp"
#include "dem/detail/number_list.hpp"

namespace clast::dem_detail {

enum class ContactKind : std::uint8_t {
  kVertexGround,  ///< block vertex against a face, edge or vertex of the ground
  kEdgeEdge,
  kEdgeVertex,  ///< block edge against a ground vertex
  kFaceVertex,  ///< block face against a ground vertex
};

/// One point where the rounded block overlaps the ground's skin.
struct ContactPoint {
  ContactKind kind = ContactKind::kVertexGround;
  std::uint32_t block_feature = 0;   ///< vertex, edge or face of the block
  std::uint32_t ground_feature = 0;  ///< edge or vertex of the ground; a face for kVertexGround
  std::uint32_t ground_face = 0;     ///< a face next to the contact: gives the zone
  Vec3 normal = Vec3::UnitZ();       ///< unit, out of the ground into the block
  Vec3 foot = Vec3::Zero();          ///< on the ground's skin
  double overlap = 0.0;              ///< m, positive

  /// Middle of the overlap: where forces act.
  Vec3 point() const { return foot - 0.5 * overlap * normal; }
};

/// How a block flies on from a contact-free place: bounds for every point of its core.
struct FlightBounds {
  Vec3 velocity = Vec3::Zero();  ///< of the centre now, m/s
  Vec3 spin = Vec3::Zero();      ///< now, rad/s
  double acceleration = 0.0;     ///< no point changes its velocity faster, m/s^2
  double top_speed = 0.0;        ///< no point gets faster than this, but for gravity, m/s
  double gravity = 0.0;          ///< m/s^2
};

class ContactSearch {
 public:
  /// @param block  in its body frame; it and the ground must outlive the search
  /// @param size   smallest side of the block, m: lists look ahead a share of it
  ContactSearch(const IndexedSurface& ground, const BlockSurface& block, double size);

  /// Brings everything that is due up to date and lists the contacts, in a fixed order.
  /// @param travel  a bound of how far any point of the block has moved since the start, never
  /// smaller than in the call before
  const std::vector<ContactPoint>& contacts(const Pose& ground_from_body, double travel);

  /// No contact can come before the travel has grown beyond this (valid after `contacts`). Where a
  /// search for it has found little it is not repeated at once, as in `safe_time`.
  double safe_travel();
  /// How long no contact can come on such a flight (valid after `contacts`), s. Away from the
  /// ground the ball around the block gives it. Near it the search costs as much as several
  /// steps, so it is not repeated at once where one has found too little: then 0.
  /// @param worthwhile  s: a shorter time does not help the caller
  double safe_time(const FlightBounds& flight, double worthwhile);

 private:
  struct PartState {
    bool near = false;
    double due = -1.0;  ///< asleep until, or its list of the ground holds until
    // What was measured last: the gap, where the centre was, and `turned_`.
    double gap = 0.0;
    Vec3 seen = Vec3::Zero();
    double seen_turned = 0.0;
    std::uint32_t near_face = 0;  ///< entry of `local_` that was nearest
    LocalGround ground;
    double complete = 0.0;     ///< from every point of the part so far the list was complete, m ...
    double gathered_at = 0.0;  ///< ... when it was gathered
  };
  struct VertexState {
    std::uint32_t part = 0;
    double distance = 0.0;        ///< last known, signed, m
    double seen_at = 0.0;         ///< `moved_` it was known at
    Vec3 seen = Vec3::Zero();     ///< and where the vertex was
    std::uint32_t near_face = 0;  ///< entry of the part's list that was nearest
    // While its foot stays on `sure_face`, no other face matters: inside the ground until the one,
    // outside within reach until the other.
    std::uint32_t sure_face = kNoFeature;
    double sure_foot_until = -1.0;  ///< the foot cannot leave the face before
    double sure_inside_until = -1.0;
    double sure_outside_until = -1.0;
  };
  /// A side of the block with an edge or vertex of the ground.
  struct FeaturePair {
    ContactKind kind;
    std::uint32_t ground_feature;
    double due;          ///< check it again
    double clear_until;  ///< cannot touch before

    bool same_features(const FeaturePair& other) const {
      return kind == other.kind && ground_feature == other.ground_feature;
    }
  };
  /// What every check of a side reads: one cache line, and the pairs themselves. In a pile this is
  /// most of what comes from memory.
  struct alignas(64) SideState {
    double clear_until = -1.0;
    // `due` and `clear_until` of the pairs that are not due soon: of the first of them.
    // Until when the list of pairs holds, and until when what is not listed cannot touch.
    double sleepers_due = -1.0, sleepers_clear_until = -1.0;
    double list_until = -1.0;
    double others_clear_until = -1.0;
    std::vector<FeaturePair>
        awake;  ///< copies of the listed pairs that are due soon, in their order
  };
  /// What is needed only where a side's lists are renewed.
  struct SideList {
    std::uint32_t part = 0;
    std::vector<FeaturePair> pairs;  ///< all listed; of those awake the copies count
    // When the list ends and what is not listed can touch, as movement from where the middle was
    // when listed, and `turned_` then.
    double list_holds = 0.0, others_clear = 0.0;
    Vec3 listed = Vec3::Zero();
    double listed_turned = 0.0;
  };

  void move_to(const Pose& ground_from_body);
  void wake();
  bool sleep_whole();
  /// Makes `local_` complete up to this distance from the block.
  void gather_ground(double complete);
  /// How far lists of what is due look ahead, m.
  double list_ahead() const;
  /// Until when it must be known whether the part can touch.
  void update_part(std::uint32_t p, double until);
  void gather(std::uint32_t p, double distance);
  void find_next_part();
  void list_awake(double horizon);
  double search_time(const FlightBounds& flight, double first);
  double completeness(const PartState& part) const {
    return part.complete - (moved_ - part.gathered_at);
  }

  /// Until when it must be known whether the vertex can touch.
  void update_vertex(std::uint32_t vertex, double until);
  bool update_sure_face(std::uint32_t vertex, const Vec3& centre);
  void measure_vertex(std::uint32_t vertex, const Vec3& centre);
  /// Direction in which a vertex inside the ground is pushed: to the surface point, or up to the
  /// plane in which a ground that ends there goes on.
  Vec3 push_of(const NearestPoint& nearest, const Vec3& centre) const;
  /// True when the push would drag the block's vertex out through the block: beside the edge of a
  /// ground that ends where the block does, the nearest way out may be the ground's wall.
  bool pushes_backwards(std::uint32_t vertex, const Vec3& push) const;
  /// The nearest face below which it lies that does not, or `nearest` where there is none.
  NearestPoint nearest_forwards(std::uint32_t vertex, const Vec3& centre,
                                const NearestPoint& nearest) const;
  void add_inside_contact(std::uint32_t vertex, const Vec3& centre, const NearestPoint& nearest);
  void add_outside_contacts(std::uint32_t vertex, const Vec3& centre);

  /// The sides that are due: fetches what the first of them need.
  void list_due_sides();
  void update_due_sides(double within);
  /// Everything of the side that is due until then; lists pairs within a distance.
  void update_side(std::uint32_t s, double until, double within);
  bool list_holds(std::uint32_t s, double until);
  void list_awake_pairs(std::uint32_t s, double horizon);
  void list_pairs(std::uint32_t s, double within);
  void update_edges(std::uint32_t block_edge, FeaturePair& pair);
  void update_edge_vertex(std::uint32_t block_edge, FeaturePair& pair);
  void update_face_vertex(std::uint32_t block_face, FeaturePair& pair);
  void update_pair(std::uint32_t block_feature, FeaturePair& pair);
  /// How deep an edge or a face may be in contact without having been seen before, m.
  double deepest_pair() const;
  /// How far the block can move before features this far apart must be looked at again.
  double sleep_distance(double apart) const;
  void sleep(FeaturePair& pair, double apart) const;
  void touch_corner(std::uint32_t block_feature, FeaturePair& pair, const Vec3& normal,
                    double distance);
  void touch(FeaturePair& pair, const ContactPoint& contact);

  void add(const ContactPoint& contact);
  Vec3 placed(const Vec3& in_body) const { return position_ + rotation_ * in_body; }
  /// True when the block's own surface falls away from a ground that it touches along `normal`
  /// (out of the ground) with this vertex or edge.
  bool meets_vertex(std::uint32_t vertex, const Vec3& normal) const;
  bool meets_edge(std::uint32_t edge, const Vec3& normal) const;
  /// True when an edge of the ground and one of the block may carry along `normal`.
  bool edges_carry(const SurfaceEdge& of_ground, const SurfaceEdge& of_block,
                   const Vec3& normal) const;

  const IndexedSurface& ground_;
  const IndexedSurface& surface_;  ///< of the block
  const SurfaceFeatures& block_;   ///< its features
  const BlockParts& parts_;        ///< and its parts
  double reach_;                   ///< block radius + skin radius, m
  double bounding_radius_ = 0.0;   ///< of the core about the centre, m
  double size_;                    ///< smallest side, m
  double margin_;                  ///< how far lists look ahead, m
  double depth_limit_;             ///< edge and face contacts deeper than this are not trusted, m

  Mat3 rotation_ = Mat3::Identity();
  Vec3 position_ = Vec3::Zero();
  bool started_ = false;
  double travel_ = 0.0;     ///< the caller's
  double moved_ = 0.0;      ///< since the start, summed from call to call, m
  double turned_ = 0.0;     ///< likewise: bounds what turning moves a point at an arm of 1 m, m
  double last_move_ = 0.0;  ///< growth of `moved_` in the last call, m
  LocalGround local_;       ///< around the whole block
  // From every point of the block so far `local_` was complete when it was gathered.
  double ground_complete_ = -1.0;
  double ground_gathered_at_ = 0.0;
  std::vector<PartState> part_states_;
  std::vector<VertexState> vertex_states_;  ///< in the order of parts_.vertices
  std::vector<SideState> side_states_;      ///< in the order of parts_.sides, likewise ...
  std::vector<SideList> side_lists_;
  std::vector<double> vertex_due_, side_due_;  ///< `moved_` at which to check again
  double next_part_ = -1.0;                    ///< the first part is due then
  double horizon_ = -1.0;                      ///< everything due before it is listed as awake
  bool listed_for_flight_ = false;             ///< the list is longer than contact steps need
  NumberList awake_vertices_, awake_sides_;
  NumberList due_sides_;                ///< of this call
  double sleepers_clear_until_ = -1.0;  ///< no other vertex or side of parts near the ground
                                        ///< touches before
  double search_at_ = -1.0;             ///< no longer flight is searched for before
  double deepest_ = 0.0;                ///< largest overlap at the last call, m
  std::vector<ContactPoint> contacts_;
};

}  // namespace clast::dem_detail
