#pragma once
/// Finds the contact points of one block on the ground, or on another block that takes the ground's
/// place: everything here is in the frame of the ground.
///
/// Everything is paced by `travel`: a running bound of how far any point of the block has moved
/// since the start. Whatever is found to be a distance d away sleeps until the travel has grown by
/// d, so that nothing can touch unseen and most elements cost nothing most of the time.
#include <cstdint>
#include <vector>

#include "dem/detail/indexed_surface.hpp"

namespace clast {

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
  std::uint32_t ground_face = 0;     ///< a face next to the contact: tells the zone
  Vec3 normal = Vec3::UnitZ();       ///< unit, out of the ground into the block
  Vec3 foot = Vec3::Zero();          ///< on the ground's skin
  double overlap = 0.0;              ///< m, positive

  /// Middle of the overlap: where forces act.
  Vec3 point() const { return foot - 0.5 * overlap * normal; }
};

class ContactSearch {
 public:
  /// @param block  surface of the block in its body frame; it and the ground must outlive the
  /// search
  /// @param size   smallest side of the block, m: lists look ahead a share of it
  ContactSearch(const IndexedSurface& ground, const IndexedSurface& block, double size);

  /// Brings everything that is due up to date and lists the contacts, in a fixed order.
  /// @param travel  never smaller than in the call before
  const std::vector<ContactPoint>& contacts(const Pose& ground_from_body, double travel);

  /// No contact can come before the travel has grown beyond this (valid after `contacts`).
  double safe_travel() const;

 private:
  struct VertexState {
    double list_until = -1.0;  ///< travel until which `faces` is complete
    std::vector<std::uint32_t> faces;
    // While its foot stays on `sure_face`, no other face matters: inside the ground until the one
    // travel, outside within reach until the other.
    std::uint32_t sure_face = kNoFeature;
    double sure_inside_until = -1.0;
    double sure_outside_until = -1.0;
  };
  struct Pair {
    ContactKind kind;
    std::uint32_t block_feature;
    std::uint32_t ground_feature;
    double due;
  };

  void look_at_vertex(std::uint32_t vertex, double travel);
  bool look_at_sure_face(std::uint32_t vertex, const Vec3& centre, double travel);
  /// Direction in which a vertex inside the ground is pushed to the surface point.
  static Vec3 push_of(const NearestPoint& nearest, const Vec3& centre);
  /// True when the push would drag the block's vertex out through the block: beside the edge of a
  /// ground that ends where the block does, the nearest way out may be the ground's wall.
  bool pushes_backwards(std::uint32_t vertex, const Vec3& push) const;
  /// The nearest face below which it lies that does not, or `nearest` where there is none.
  NearestPoint nearest_forwards(std::uint32_t vertex, const Vec3& centre,
                                const NearestPoint& nearest) const;
  void add_inside_contact(std::uint32_t vertex, const Vec3& centre, const NearestPoint& nearest);
  void add_outside_contacts(std::uint32_t vertex, const Vec3& centre);
  void refresh_pairs(double travel);
  void look_at_pair(Pair& pair, double travel);
  void look_at_edges(Pair& pair, double travel);
  void look_at_edge_vertex(Pair& pair, double travel);
  void look_at_face_vertex(Pair& pair, double travel);
  double distance(const Pair& pair) const;
  void add(const ContactPoint& contact);
  Vec3 placed(std::uint32_t block_vertex) const {
    return position_ + rotation_ * block_.vertices[block_vertex];
  }
  void touch_corner(const Pair& pair, const Vec3& normal, double distance);
  /// True when the block's own surface falls away from a ground that it touches along `normal`
  /// (out of the ground) with this vertex or edge.
  bool meets_vertex(std::uint32_t vertex, const Vec3& normal) const;
  bool meets_edge(const SurfaceEdge& edge, const Vec3& normal) const;

  const IndexedSurface& ground_;
  const IndexedSurface& surface_;  ///< of the block
  const SurfaceFeatures& block_;   ///< its features
  double reach_;                   ///< block radius + skin radius, m
  double bounding_radius_ = 0.0;   ///< of the core about the centre, m
  double longest_edge_ = 0.0;      ///< of the block, m
  double margin_;                  ///< how far lists look ahead, m
  double depth_limit_;             ///< edge and face contacts deeper than this are not trusted, m

  Mat3 rotation_ = Mat3::Identity();
  Vec3 position_ = Vec3::Zero();
  std::vector<std::uint32_t> pointed_;  ///< block vertices that can touch
  std::vector<VertexState> vertices_;   ///< of every block vertex
  std::vector<double> due_;             ///< travel at which a vertex must be looked at again
  std::vector<double> distances_;       ///< last known signed distance of vertex centres, m
  std::vector<double> seen_at_;         ///< and the travel it was known at
  std::vector<std::uint32_t> awake_;    ///< pointed vertices due before `horizon_`
  double horizon_ = -1.0;
  double deepest_ = 0.0;  ///< largest overlap at the last call, m
  std::vector<Pair> pairs_;
  double pairs_until_ = -1.0;
  std::vector<ContactPoint> contacts_;
};

}  // namespace clast
