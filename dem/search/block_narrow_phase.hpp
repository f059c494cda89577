#pragma once
/// Narrow phase: contact points of two blocks. The reference block is called the ground here; all
/// data are in its frame.
///
/// Vertices, edges and faces that may touch are kept in a list, which is valid until the relative
/// displacement exceeds a margin (Verlet list). A feature is listed only if it lies between two
/// parallel planes, through the lowest point of the block and the highest point of the ground along
/// one direction (docs/theory.md, Contact search).
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

struct TransformedSide;

class BlockNarrowPhase {
 public:
  /// Prepares the contact search.
  /// @param ground  reference body, which has faces; must outlive this object, as must the block
  /// @param size  smallest side of the smaller body, m; the listing distance is proportional to it
  BlockNarrowPhase(const BlockSurface& ground, const BlockSurface& block, double size);

  /// Finds the contacts, in a deterministic order. The caller may modify the returned list. It is
  /// valid until the next search in this thread.
  /// @param displacement  upper bound of the accumulated displacement of any block point relative
  ///                      to the ground, m
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_block, double displacement);

  /// Returns the value of the accumulated displacement below which contact is impossible, m. Valid
  /// only after a call of `find_contacts` that found no contacts.
  double contact_free_displacement() const { return contact_free_displacement_; }

  /// Serialises the state that determines future contacts and their order.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, direction_, vertices_, faces_, pairs_, near_face_, low_, high_, list_valid_until_,
          displacement_, max_listed_depth_, contact_free_displacement_, deepest_, depth_limit_);
  }

 private:
  /// Block vertex that may touch the ground before the list expires.
  struct CandidateVertex {
    std::uint32_t vertex;
    std::uint32_t near_face;       ///< index in `faces_` of its nearest face
    std::uint32_t end_face;        ///< index in `faces_` behind its last face
    double separated_until = 0.0;  ///< displacement below which contact is impossible, m
    /// Displacement below which `near_face` is the nearest face, m.
    double nearest_face_until = 0.0;

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(vertex, near_face, end_face, separated_until, nearest_face_until);
    }
  };
  /// Candidate pair of a block edge or face and a ground edge or vertex.
  struct CandidatePair {
    ContactKind kind;
    std::uint32_t side;  ///< index into `BlockParts::sides`, which lists edges and faces
    std::uint32_t ground_feature;
    double separated_until;  ///< displacement below which contact is impossible, m

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, separated_until);
    }
  };

  /// Returns the distance up to which features are listed, m.
  double listing_distance() const { return max_listed_depth_ + margin_; }
  /// Returns the largest distance between a block edge or face and a ground feature in contact, m.
  double contact_distance() const {
    return std::max(tests_.reach(), depth_limit_.depth() - tests_.reach());
  }

  /// Returns the displacement below which a block edge or face cannot touch a ground feature, m.
  double separated_until(const FeatureSeparation& separation, bool touches) const {
    return touches ? displacement_
                   : displacement_ + std::max(separation.separation.norm() - max_listed_depth_,
                                              separation.contact_free_displacement);
  }

  void build_candidate_list();
  /// Improves the direction along which the two bodies are separated or overlap least.
  /// @return distance between the bodies along the improved direction, m; negative if they overlap
  double improve_separating_direction();
  /// Lists the features of both bodies that lie between the two separating planes and near the
  /// other body.
  void collect_features();
  void collect_ground_features();
  void collect_vertices(const BlockPart& part);
  void collect_vertex(std::uint32_t vertex, const Vec3& centre, double candidate);
  /// Lists the ground faces within `reach` of a vertex, by ascending index.
  void collect_near_faces(const Vec3& centre, double reach);
  void collect_sides(const BlockPart& part);
  void transform_sides(const BlockPart& part);
  void collect_face_pairs(const TransformedSide& side,
                          std::span<const std::uint32_t> ground_vertices);
  void collect_edge_pairs(const TransformedSide& side, std::span<const std::uint32_t> edges,
                          std::span<const std::uint32_t> ground_vertices);
  void add_candidate_pair(ContactKind kind, std::uint32_t side, std::uint32_t of_ground,
                          const FeatureSeparation& separation, bool touches);

  /// Returns the largest distance outside the space between the two separating planes at which a
  /// feature can touch the other body before the list expires, m.
  /// @param along  smallest component along `direction_` of the feature's possible contact normals
  /// @param slack  angular tolerance of these normals, as the sine of an angle
  double depth_beyond_plane(double along, double slack) const;
  double depth_beyond_plane(const EdgeNormalArc& arc) const {
    const double along = std::min(direction_.dot(arc.first), direction_.dot(arc.second));
    return depth_beyond_plane(arc.is_unbounded ? -1.0 : along, arc.slack);
  }

  // Tests whether two features may touch before the list expires. A contact normal must be in the
  // normal arcs of both, which rotate with the bodies.

  /// True if an edge of the block and an edge of the ground may have opposite contact normals.
  /// @param arc  contact normals of the block's edge, reversed to point out of the ground; their
  ///             tolerance includes the rotation until the list expires
  /// @param direction  direction of the block's edge, unit
  bool can_edge_normals_oppose(const EdgeNormalArc& of_ground, const Vec3& ground_direction,
                               const EdgeNormalArc& arc, const Vec3& direction) const;
  bool can_vertex_normal_oppose(std::uint32_t ground_vertex, const EdgeNormalArc& arc) const;

  /// Contact with a wrong normal, which would push the block vertex through its own block.
  struct InvertedContact {
    std::size_t contact;  ///< index into the contacts found
    std::uint32_t vertex;
    Vec3 centre;
    NearestPoint nearest;
  };
  /// Temporary data of one search, shared by all searches of a thread.
  struct Scratch {
    std::vector<ContactPoint> contacts;
    std::vector<InvertedContact> inverted;
    std::vector<LocalFaces::Face> near_faces;
  };
  static Scratch& scratch();

  void find_all_vertex_contacts();
  /// Replaces each inverted contact by one that pushes the vertex to the nearest ground face
  /// without passing its own block, unless the new contact is much deeper than the other contacts.
  void resolve_inverted_contacts();
  void find_vertex_contacts(CandidateVertex& candidate, std::span<const std::uint32_t> faces);
  NearestPoint find_nearest_ground_face(CandidateVertex& candidate,
                                        std::span<const LocalFaces::Face> faces,
                                        const Vec3& centre);
  void find_side_contacts();

  const BlockSurface& ground_;
  const BlockSurface& block_;
  double size_;    ///< smallest side of the smaller body, m
  double margin_;  ///< displacement after which a list expires, m
  double turn_;    ///< rotation by `angle` after which a list expires, as 2 sin(angle/2)
  FeatureTests tests_;
  Vec3 direction_ = Vec3::Zero();  ///< unit, out of the ground into the block; zero if unknown

  std::vector<CandidateVertex> vertices_;
  std::vector<std::uint32_t> faces_;  ///< ground faces that may be nearest to a listed vertex
  std::vector<CandidatePair> pairs_;
  std::uint32_t near_face_ = 0;  ///< ground face near the last tested vertex
  /// Lowest point of the block and highest point of the ground along `direction_`, m.
  double low_ = 0.0, high_ = 0.0;
  double list_valid_until_ = -1.0;  ///< displacement at which the list expires, m
  double displacement_ = 0.0;       ///< displacement passed to `find_contacts`, m
  double max_listed_depth_ = 0.0;   ///< largest depth of the listed edge and face contacts, m

  double contact_free_displacement_ = 0.0;  ///< displacement before which contact is impossible, m
  double deepest_ = 0.0;                    ///< largest overlap of the last call, m
  ContactDepthLimit depth_limit_;
};

}  // namespace clast::dem_detail
