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

#include "dem/search/feature_contacts.hpp"

namespace clast::dem_detail {

struct PlacedSide;

class BlockContacts {
 public:
  /// @param ground  with faces; it and the block must outlive the search
  /// @param size    smallest side of the smaller one, m: lists look ahead a share of it
  BlockContacts(const BlockSurface& ground, const BlockSurface& block, double size);

  /// The contacts, in a fixed order, until this is called again for any search in this thread; the
  /// caller may change them.
  /// @param travel  a bound of how far any point of the block has moved against the ground, m:
  /// grows from call to call by no less than the shift of its centre and the chord of its turn
  /// times its bounding radius together
  std::vector<ContactPoint>& contacts(const Pose& ground_from_block, double travel);

  /// No contact can come before the travel has grown beyond this (valid after `contacts`, without
  /// any).
  double safe_travel() const { return safe_until_; }

  /// All that the contacts to come, and their order, depend on.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(tests_, direction_, vertices_, faces_, pairs_, near_face_, low_, high_, list_until_,
          travel_, list_touching_, safe_until_, deepest_, allowed_);
  }

 private:
  /// A vertex of the block that may be inside the ground or within reach of it before the list
  /// ends.
  struct ListedVertex {
    std::uint32_t vertex;
    std::uint32_t near_face;   ///< entry of its faces that was nearest
    std::uint32_t end_face;    ///< its faces are those in `faces_` since the vertex before
    double clear_until = 0.0;  ///< travel before which it cannot touch, m
    double sure_until = 0.0;   ///< and before which, while its foot lies on that face, no other one
                               ///< is nearer or within reach of it, m

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(vertex, near_face, end_face, clear_until, sure_until);
    }
  };
  /// An edge or face of the block with an edge or corner of the ground.
  struct ListedPair {
    ContactKind kind;
    std::uint32_t side;  ///< of BlockParts::sides
    std::uint32_t ground_feature;
    double clear_until;  ///< travel before which they cannot touch, m

    template <class Bytes>
    void serialize(Bytes& bytes) {
      bytes(kind, side, ground_feature, clear_until);
    }
  };

  /// How near features must be to be listed, m.
  double listed_within() const { return list_touching_ + margin_; }
  /// Edges and faces closer than this to a feature of the ground may touch it, m.
  double touching_distance() const {
    return std::max(tests_.reach(), allowed_.depth() - tests_.reach());
  }

  /// Travel before which an edge or face cannot touch one of the ground, m.
  double clear_until(const FeaturesApart& apart, bool touches) const {
    return touches ? travel_
                   : travel_ + std::max(apart.between.norm() - list_touching_, apart.clear);
  }

  void make_list();
  /// Turns `direction_` towards one that separates the two farther.
  /// @return  gap between the planes along it, m; negative where they overlap
  double widen_gap();
  /// Lists what lies between the planes and near each other.
  void list_features();
  void list_ground();
  void list_vertices(const BlockPart& part);
  void list_vertex(std::uint32_t vertex, const Vec3& centre, double listed);
  /// Lists the faces of the ground within reach of a vertex, in order.
  void list_faces(const Vec3& centre, double reach);
  void list_sides(const BlockPart& part);
  void place_sides(const BlockPart& part);
  void list_face(const PlacedSide& side, std::span<const std::uint32_t> corners);
  void list_edge(const PlacedSide& side, std::span<const std::uint32_t> edges,
                 std::span<const std::uint32_t> corners);
  void list(ContactKind kind, std::uint32_t side, std::uint32_t of_ground,
            const FeaturesApart& apart, bool touches);

  /// How far below the block's lowest point, or above the ground's highest, a feature may still
  /// touch, m.
  /// @param along  least component along the direction of the normals with which it may touch
  /// @param slack  of these normals, a sine
  double depth_beyond(double along, double slack) const;
  double depth_beyond(const EdgeArc& arc) const {
    const double along = std::min(direction_.dot(arc.first), direction_.dot(arc.second));
    return depth_beyond(arc.any ? -1.0 : along, arc.slack);
  }

  // Whether the two may face each other before the list ends. They touch only along normals that
  // both allow, and those turn with the bodies.

  /// @param arc        of the block's edge, out of the ground, with the slack of its turn
  /// @param direction  of that edge
  bool may_face(const EdgeArc& of_ground, const Vec3& ground_direction, const EdgeArc& arc,
                const Vec3& direction) const;
  bool corner_may_face(std::uint32_t ground_vertex, const EdgeArc& arc) const;

  /// A contact whose push would lead the vertex out through its own block.
  struct Backwards {
    std::size_t contact;  ///< of those found so far
    std::uint32_t vertex;
    Vec3 centre;
    NearestPoint nearest;
  };
  /// Of one call, shared by all searches of a thread.
  struct Scratch {
    std::vector<ContactPoint> contacts;
    std::vector<Backwards> backwards;
    std::vector<LocalFaces::Face> near_faces;
  };
  static Scratch& scratch();

  void find_at_vertices();
  /// Gives contacts that push backwards the nearest way out that does not, where that is not much
  /// deeper than the other contacts are.
  void turn_forwards();
  void find_at_vertex(ListedVertex& listed, std::span<const std::uint32_t> faces);
  NearestPoint nearest_of_all(ListedVertex& listed, std::span<const LocalFaces::Face> faces,
                              const Vec3& centre);
  void find_at_sides();

  const BlockSurface& ground_;
  const BlockSurface& block_;
  double size_;    ///< smallest side, m
  double margin_;  ///< way for which a list holds, m ...
  double turn_;    ///< ... which turns no direction by more than this chord
  FeatureContacts tests_;
  Vec3 direction_ = Vec3::Zero();  ///< unit, out of the ground into the block; zero: none known

  std::vector<ListedVertex> vertices_;
  std::vector<std::uint32_t> faces_;  ///< of the ground that may be nearest to a listed vertex
  std::vector<ListedPair> pairs_;
  std::uint32_t near_face_ = 0;    ///< of the ground, near the last vertex that was looked at
  double low_ = 0.0, high_ = 0.0;  ///< lowest point of the block, highest of the ground along the
                                   ///< direction, m
  double list_until_ = -1.0;       ///< travel to which the list holds ...
  double travel_ = 0.0;            ///< the caller's
  double list_touching_ = 0.0;     ///< ... for contacts of edges and faces no deeper than this, m

  double safe_until_ = 0.0;  ///< travel to which nothing that is listed can touch, m
  double deepest_ = 0.0;     ///< largest overlap at the last call, m
  AllowedDepth allowed_;
};

}  // namespace clast::dem_detail
