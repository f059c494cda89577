#pragma once
/// Narrow phase of two blocks: finds the contact points of one on the other, which is called the
/// ground here; everything is in its frame.
///
/// Features that may touch are listed with a margin (Verlet's neighbour list), and the list holds
/// until the two have moved by the margin against each other. It is made from what lies between two
/// parallel planes: along any direction, nothing of the ground that lies lower than the lowest
/// point of the block can touch it, and nothing of the block that lies higher than the highest
/// point of the ground. Along the contact normal, or a direction that separates the two, that
/// leaves few (docs/theory.md, Contact search).
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

struct TransformedSide;

class BlockNarrowPhase {
 public:
  /// @param ground  with faces; it and the block must outlive the search
  /// @param size    smallest side of the smaller one, m: lists look ahead a share of it
  BlockNarrowPhase(const BlockSurface& ground, const BlockSurface& block, double size);

  /// The contacts, in a fixed order, until this is called again for any search in this thread; the
  /// caller may change them.
  /// @param travel  a bound of how far any point of the block has moved against the ground, m:
  /// grows from call to call by no less than the shift of its centre and the chord of its turn
  /// times its bounding radius together
  std::vector<ContactPoint>& find_contacts(const Pose& ground_from_block, double displacement);

  /// No contact can come before the travel has grown beyond this (valid after `contacts`, without
  /// any).
  double safe_displacement() const { return safe_displacement_; }

  /// All that the contacts to come, and their order, depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, direction_, vertices_, faces_, pairs_, near_face_, low_, high_, list_valid_until_,
          displacement_, list_touching_, safe_displacement_, deepest_, allowed_);
  }

 private:
  /// A vertex of the block that may be inside the ground or within reach of it before the list
  /// ends.
  struct CandidateVertex {
    std::uint32_t vertex;
    std::uint32_t near_face;          ///< entry of its faces that was nearest
    std::uint32_t end_face;           ///< its faces are those in `faces_` since the vertex before
    double separated_until = 0.0;     ///< travel before which it cannot touch, m
    double nearest_face_until = 0.0;  ///< and before which, while its foot lies on that face, no
                                      ///< other one is nearer or within reach of it, m

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(vertex, near_face, end_face, separated_until, nearest_face_until);
    }
  };
  /// An edge or face of the block with an edge or corner of the ground.
  struct CandidatePair {
    ContactKind kind;
    std::uint32_t side;  ///< of BlockParts::sides
    std::uint32_t ground_feature;
    double separated_until;  ///< travel before which they cannot touch, m

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, separated_until);
    }
  };

  /// How near features must be to be listed, m.
  double listing_distance() const { return list_touching_ + margin_; }
  /// Edges and faces closer than this to a feature of the ground may touch it, m.
  double contact_distance() const {
    return std::max(tests_.reach(), allowed_.depth() - tests_.reach());
  }

  /// Travel before which an edge or face cannot touch one of the ground, m.
  double separated_until(const FeatureSeparation& separation, bool touches) const {
    return touches ? displacement_
                   : displacement_ + std::max(separation.separation.norm() - list_touching_,
                                              separation.safe_displacement);
  }

  void build_candidate_list();
  /// Turns `direction_` towards one that separates the two farther.
  /// @return  gap between the planes along it, m; negative where they overlap
  double improve_separating_direction();
  /// Lists what lies between the planes and near each other.
  void collect_features();
  void collect_ground_features();
  void collect_vertices(const BlockPart& part);
  void collect_vertex(std::uint32_t vertex, const Vec3& centre, double candidate);
  /// Lists the faces of the ground within reach of a vertex, in order.
  void collect_near_faces(const Vec3& centre, double reach);
  void collect_sides(const BlockPart& part);
  void transform_sides(const BlockPart& part);
  void collect_face_pairs(const TransformedSide& side,
                          std::span<const std::uint32_t> ground_vertices);
  void collect_edge_pairs(const TransformedSide& side, std::span<const std::uint32_t> edges,
                          std::span<const std::uint32_t> ground_vertices);
  void add_candidate_pair(ContactKind kind, std::uint32_t side, std::uint32_t of_ground,
                          const FeatureSeparation& separation, bool touches);

  /// How far below the block's lowest point, or above the ground's highest, a feature may still
  /// touch, m.
  /// @param along  least component along the direction of the normals with which it may touch
  /// @param slack  of these normals, a sine
  double depth_beyond_plane(double along, double slack) const;
  double depth_beyond_plane(const EdgeNormalArc& arc) const {
    const double along = std::min(direction_.dot(arc.first), direction_.dot(arc.second));
    return depth_beyond_plane(arc.is_unbounded ? -1.0 : along, arc.slack);
  }

  // Whether the two may face each other before the list ends. They touch only along normals that
  // both allow, and those turn with the bodies.

  /// @param arc        of the block's edge, out of the ground, with the slack of its turn
  /// @param direction  of that edge
  bool arcs_may_oppose(const EdgeNormalArc& of_ground, const Vec3& ground_direction,
                       const EdgeNormalArc& arc, const Vec3& direction) const;
  bool vertex_may_oppose(std::uint32_t ground_vertex, const EdgeNormalArc& arc) const;

  /// A contact whose push would lead the vertex out through its own block.
  struct InvertedContact {
    std::size_t contact;  ///< of those found so far
    std::uint32_t vertex;
    Vec3 centre;
    NearestPoint nearest;
  };
  /// Of one call, shared by all searches of a thread.
  struct Scratch {
    std::vector<ContactPoint> contacts;
    std::vector<InvertedContact> inverted;
    std::vector<LocalFaces::Face> near_faces;
  };
  static Scratch& scratch();

  void find_all_vertex_contacts();
  /// Gives contacts that push backwards the nearest way out that does not, where that is not much
  /// deeper than the other contacts are.
  void resolve_inverted_contacts();
  void find_vertex_contacts(CandidateVertex& candidate, std::span<const std::uint32_t> faces);
  NearestPoint find_nearest_ground_face(CandidateVertex& candidate,
                                        std::span<const LocalFaces::Face> faces,
                                        const Vec3& centre);
  void find_side_contacts();

  const BlockSurface& ground_;
  const BlockSurface& block_;
  double size_;    ///< smallest side, m
  double margin_;  ///< way for which a list holds, m ...
  double turn_;    ///< ... which turns no direction by more than this chord
  FeatureTests tests_;
  Vec3 direction_ = Vec3::Zero();  ///< unit, out of the ground into the block; zero: none known

  std::vector<CandidateVertex> vertices_;
  std::vector<std::uint32_t> faces_;  ///< of the ground that may be nearest to a listed vertex
  std::vector<CandidatePair> pairs_;
  std::uint32_t near_face_ = 0;     ///< of the ground, near the last vertex that was looked at
  double low_ = 0.0, high_ = 0.0;   ///< lowest point of the block, highest of the ground along the
                                    ///< direction, m
  double list_valid_until_ = -1.0;  ///< travel to which the list holds ...
  double displacement_ = 0.0;       ///< the caller's
  double list_touching_ = 0.0;      ///< ... for contacts of edges and faces no deeper than this, m

  double safe_displacement_ = 0.0;  ///< travel to which nothing that is listed can touch, m
  double deepest_ = 0.0;            ///< largest overlap at the last call, m
  ContactDepthLimit allowed_;
};

}  // namespace clast::dem_detail
