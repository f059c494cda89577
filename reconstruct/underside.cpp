#include "reconstruct/underside.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/detail/bottom_closure.hpp"
#include "reconstruct/detail/hole_patch.hpp"
#include "reconstruct/detail/sections.hpp"
#include "reconstruct/detail/space_below.hpp"
#include "reconstruct/detail/unseen_bounds.hpp"

namespace clast {

namespace {

/// Holes whose flat filling has this share of the surface are bracketed beside the largest one.
constexpr double kBracketed = 0.003;
/// The narrowing at the rim is taken over these shares of the height that was seen: over the longer
/// one for the largest cone below an uneven rim, over the shorter for the likeliest shape.
constexpr double kLargestBand = 0.2, kBestBand = 0.1;
/// Share of its cone that a cap fills. A ball's fills 3/4 when it is shallow and 0.6 when a fifth
/// of the surface is unseen; where walls go straight down, any depth up to the deepest is as
/// likely. See docs/benchmarks.md for how far off this is.
constexpr double kBestShare = 0.6;
/// The cap of the best shape is bulge^(2/3): of a round rim, 0.6 of the cylinder around it.
constexpr double kBestPower = 2.0 / 3.0;
constexpr double kMostPointedBest = 3.0;  ///< ... and may rise to this power
/// Heights of the rim, as shares of it that lie lower, from which the sections are continued: under
/// an uneven rim each stands for a part, and the largest volume counts.
constexpr std::array<double, 3> kRimShares = {0.25, 0.5, 0.75};
/// The likeliest shape goes no deeper below the rim than so many times its width.
constexpr double kDeepestBelowRim = 1.5;
/// A rim is uneven where its heights spread over more than this share of the whole. The sections do
/// not say then what hangs beside them, and the best shape is put at this share between the closure
/// and the largest cone: the median of 100 blocks of which what faces down steeply was removed.
constexpr double kEven = 0.05, kUnevenShare = 0.35;
/// A rim hangs down to the ground where it is no farther above it than the first share of the
/// height, and does not from the second share on.
constexpr double kAtGround = 0.02, kClearOfGround = 0.06;
/// A flank closes where it faces down by the second sine and more, and does not up to the first: a
/// rim above flanks that go straight down says nothing of what is below it, however far above the
/// ground the last points are. The normal is that of the surface within so much of the height.
constexpr double kStraightDown = 0.09, kCloses = 0.26, kFlankReach = 0.1;
/// Where up to the first share of the rim hangs or does not close, the block has sunk into the
/// ground by `kSunk` of its height at most; from the second share on, nothing says how deep it
/// goes.
constexpr double kFewHang = 0.05, kManyHang = 0.15;
constexpr double kSunk = 0.05;
/// A block stands on a foot where photos looked under it but for this share of its plan; where all
/// of it meets the ground, nothing says how deep it goes.
constexpr double kFootShare = 0.5;
/// A hole that faces within this of straight down is the ground's side.
constexpr double kFacesDown = 0.5;  // cos 60 degrees
constexpr int kWithdrawals = 6;     ///< halvings of a cap that meets the walls

struct Rim {
  std::vector<std::uint32_t> loop;
  Vec3 area = Vec3::Zero();  ///< vector, along the outward normal of the filling
  Vec3 centre = Vec3::Zero();
  double length = 0.0;
};

Rim measure_rim(const TriangleMesh& mesh, std::vector<std::uint32_t> loop) {
  Rim rim;
  const Vec3 origin = mesh.vertices[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 p = mesh.vertices[loop[i]] - origin;
    const Vec3 q = mesh.vertices[loop[(i + 1) % loop.size()]] - origin;
    const double side = (q - p).norm();
    rim.area += 0.5 * p.cross(q);
    rim.centre += 0.5 * side * (p + q);
    rim.length += side;
  }
  rim.centre = origin + rim.centre / rim.length;
  rim.loop = std::move(loop);
  return rim;
}

double area_from(const TriangleMesh& mesh, std::size_t first) {
  double doubled = 0.0;
  for (std::size_t i = first; i < mesh.triangles.size(); ++i) {
    doubled += area_vector(mesh, mesh.triangles[i]).norm();
  }
  return 0.5 * doubled;
}

/// Volume below a section of a body whose sqrt(A) falls evenly with depth, cut off at a depth.
/// @param root       sqrt of the area on top
/// @param narrowing  decrease of the root per depth; negative where walls lean out
double cone_below(double root, double narrowing, double deepest) {
  const double depth = narrowing > 0.0 ? std::min(deepest, root / narrowing) : deepest;
  return root * root * depth - root * narrowing * depth * depth +
         narrowing * narrowing * depth * depth * depth / 3.0;
}

class Closing {
 public:
  Closing(const TriangleMesh& open, const UndersideOptions& options)
      : options_(options), seen_triangles_(open.triangles.size()) {
    result_.lower = open;
  }

  std::optional<Underside> run() {
    const MeshReport report = inspect(result_.lower);
    if (report.non_manifold_edges > 0 || !report.oriented() || report.pinched_vertices > 0) {
      throw GeometryError("the surface is not a simple sheet: " + report.summary() +
                          "; repair it in MeshLab or CloudCompare first");
    }
    std::vector<Rim> rims;
    for (std::vector<std::uint32_t>& loop : boundary_loops(result_.lower)) {
      rims.push_back(measure_rim(result_.lower, std::move(loop)));
    }
    if (rims.empty()) return std::nullopt;
    std::stable_sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) {
      return a.area.squaredNorm() > b.area.squaredNorm();
    });
    const double seen_area = surface_area(result_.lower);
    const double flat = rims[0].area.norm();
    if (flat < options_.smallest_share * (seen_area + flat)) return std::nullopt;
    refuse_sheet(rims[0], flat / (seen_area + flat));

    const auto bracketed = [&](const Rim& rim) {
      return &rim == &rims[0] || rim.area.norm() >= kBracketed * (seen_area + flat);
    };
    const auto count = std::count_if(rims.begin(), rims.end(), bracketed);
    result_.open_sides = static_cast<std::size_t>(count);
    for (std::size_t i = result_.open_sides; i < rims.size(); ++i) fill(rims[i]);
    note_filled(rims.size() - result_.open_sides);
    result_.first_invented = result_.lower.triangles.size();
    for (std::size_t i = 1; i < result_.open_sides; ++i) fill(rims[i]);
    first_vertex_ = result_.lower.vertices.size();
    reconstruct_detail::HolePatch patch = fill(rims[0]);
    describe(rims[0]);
    bracket(rims, reconstruct_detail::BottomClosure(result_.lower, std::move(patch), first_vertex_,
                                                    result_.down));
    return std::move(result_);
  }

 private:
  void refuse_sheet(const Rim& rim, double share) const {
    if (share <= options_.largest_share) return;
    throw GeometryError(
        "the largest component is the ground, or one side of a block: a sheet whose "
        "border of " +
        std::to_string(rim.loop.size()) + " edges near " +
        place(result_.lower.vertices[rim.loop[0]]) + " spans " + with_digits(100.0 * share, 3) +
        " % of what a closed surface would have; scan the block from all sides");
  }

  void note_filled(std::size_t small) {
    if (small == 0) return;
    result_.notes.push_back(std::to_string(small) + (small == 1 ? " other hole" : " other holes") +
                            " filled straight across");
  }

  reconstruct_detail::HolePatch fill(const Rim& rim) {
    reconstruct_detail::HolePatch patch = reconstruct_detail::fill_hole(result_.lower, rim.loop);
    TriangleMesh& mesh = result_.lower;
    mesh.vertices.insert(mesh.vertices.end(), patch.vertices.begin(), patch.vertices.end());
    mesh.triangles.insert(mesh.triangles.end(), patch.triangles.begin(), patch.triangles.end());
    return patch;
  }

  void describe(const Rim& rim) {
    result_.down = rim.area.normalized();
    if (options_.ground && -options_.ground->normal.dot(result_.down) > kFacesDown) {
      result_.down = -options_.ground->normal;
    }
    result_.rim_centre = rim.centre;
    result_.rim_edges = rim.loop.size();
    result_.rim_length = rim.length;
  }

  void bracket(const std::vector<Rim>& rims, const reconstruct_detail::BottomClosure& closure) {
    const reconstruct_detail::Sections sections(result_.lower, -result_.down);
    closure_volume_ = sections.volume_above(sections.lowest());
    if (!(closure_volume_ > 0.0)) {
      throw GeometryError("the surface faces inwards, or encloses nothing once it is closed (" +
                          with_digits(closure_volume_, 3) +
                          " m3); turn its faces outward, and check that it is one side of a block");
    }
    const std::vector<double> heights = rim_heights(rims[0]);
    const Bottom bottom =
        bottom_below(rims[0], heights[(heights.size() - 1) / 2], sections.highest());
    bound(bottom.lowest, sections.highest());
    rim_root_ = std::sqrt(std::abs(rims[0].area.dot(result_.down)));
    guess(heights, sections, bottom.likely, closure);
    const double filling = area_from(result_.best, result_.first_invented);
    result_.invented_share = filling / surface_area(result_.best);
  }

  /// Which triangles of `lower` were not scanned.
  std::vector<bool> closures() const {
    std::vector<bool> closure(result_.lower.triangles.size(), false);
    for (std::size_t t = 0; t < closure.size(); ++t) {
      closure[t] = t >= result_.first_invented;
      if (closure[t] || !options_.was_seen) continue;
      const auto& [a, b, c] = result_.lower.triangles[t];
      const std::vector<Vec3>& at = result_.lower.vertices;
      closure[t] = !options_.was_seen((at[a] + at[b] + at[c]) / 3.0);
    }
    return closure;
  }

  /// @param bottom  height below which nothing of the block can be; none if nothing shows it
  void bound(std::optional<double> bottom, double highest) {
    const std::optional<reconstruct_detail::SpaceBelow> below = space_not_looked_through(highest);
    if (below && !bottom && foot_share(*below) <= kFootShare) {
      bottom = options_.ground->distance - sunk_depth(highest);
    }
    reconstruct_detail::UnseenParts parts{closures(), {}, options_.margin};
    result_.assumption = "the unseen part lies within the planes of the flanks that were seen";
    if (bottom && faces_ground()) {
      parts.floor = Plane{options_.ground->normal, *bottom};
      const double depth = (options_.ground->distance - *bottom) / (highest - *bottom);
      result_.assumption += " and reaches into the ground by no more than " +
                            with_digits(100.0 * std::max(0.0, depth), 2) + " % of its height";
    }
    const reconstruct_detail::UnseenBounds bounds =
        reconstruct_detail::unseen_bounds(result_.lower, parts);
    result_.lower_volume = bounds.lower_volume;
    result_.upper_volume = bounds.upper_volume;
    result_.sides = bounds.sides;
    for (std::string& note : reconstruct_detail::hollow_notes(bounds.hollows, options_.unit)) {
      result_.notes.push_back(std::move(note));
    }
    if (result_.upper_volume) {
      if (below && bottom) look_under(*below, *bottom, highest);
    } else {
      result_.assumption.clear();
    }
  }

  /// The shape that the sections make likeliest, no larger than the upper one.
  void guess(const std::vector<double>& heights, const reconstruct_detail::Sections& sections,
             double bottom, const reconstruct_detail::BottomClosure& closure) {
    const auto quantile = [&](double share) {
      return heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))];
    };
    double largest = closure_volume_, deepest = 0.0;
    result_.best_volume = closure_volume_;
    for (const double share : kRimShares) {
      const double level = quantile(share);
      const Continued below = continued(sections, level, bottom);
      if (below.largest_volume > largest) {
        largest = below.largest_volume;
        deepest = level - bottom;
      }
      result_.best_volume = std::max(result_.best_volume, below.best_volume);
    }
    const bool uneven = quantile(0.9) - quantile(0.1) > kEven * (sections.highest() - bottom);
    if (uneven) result_.best_volume = std::lerp(closure_volume_, largest, kUnevenShare);
    if (result_.upper_volume) {
      result_.best_volume = std::min(result_.best_volume, *result_.upper_volume);
    }
    settle_best(closure, deepest);
  }

  /// How deep a block that lies on the ground has sunk into it at most, m.
  double sunk_depth(double highest) const { return kSunk * (highest - options_.ground->distance); }

  std::optional<reconstruct_detail::SpaceBelow> space_not_looked_through(double highest) const {
    if (options_.through == nullptr || !(options_.through->side > 0.0) || !faces_ground()) {
      return std::nullopt;
    }
    return reconstruct_detail::space_below(result_.lower, *options_.ground, sunk_depth(highest),
                                           *options_.through);
  }

  static double foot_share(const reconstruct_detail::SpaceBelow& below) {
    return below.foot_area / below.plan_area;
  }

  /// The upper volume is no larger than all that nobody looked through. A block that can be looked
  /// under stands on a foot; the less so, the deeper it may be buried.
  void look_under(const reconstruct_detail::SpaceBelow& below, double bottom, double highest) {
    const double ground = options_.ground->distance, sunk = sunk_depth(highest);
    const double share = foot_share(below);
    const double buried = std::clamp((share - kFootShare) / (1.0 - kFootShare), 0.0, 1.0);
    const double depth = sunk + buried * std::max(0.0, ground - bottom - sunk);
    const double hull = closure_volume_ + below.volume + below.foot_area * depth;
    if (hull >= *result_.upper_volume) return;
    result_.notes.push_back("photos show " + with_digits(100.0 * (1.0 - share), 3) +
                            " % of its plan to be clear of the ground: that takes " +
                            with_digits(100.0 * (1.0 - hull / *result_.upper_volume), 3) +
                            " % off the largest volume");
    result_.upper_volume = hull;
  }

  /// Volumes with the sections continued below a level.
  struct Continued {
    double largest_volume = 0.0, best_volume = 0.0;
  };

  Continued continued(const reconstruct_detail::Sections& sections, double level,
                      double bottom) const {
    const double height = sections.highest() - level;
    // Just above the level, where a flat filling does not count any more.
    const double root = std::sqrt(std::max(0.0, sections.area(level + 1e-6 * height)));
    const auto narrowing = [&](double band) {
      const double higher = std::sqrt(std::max(0.0, sections.area(level + band * height)));
      return (higher - root) / (band * height);
    };
    const double above = sections.volume_above(level);
    // A section may go through much more of the block than what ends at the rim.
    const double rim = std::min(root, rim_root_);
    const double deepest = std::min(level - bottom, kDeepestBelowRim * rim_root_);
    return {above + cone_below(rim, narrowing(kLargestBand), deepest),
            above + kBestShare * cone_below(rim, narrowing(kBestBand), deepest)};
  }

  /// Ascending.
  std::vector<double> rim_heights(const Rim& rim) const {
    std::vector<double> heights;
    for (const std::uint32_t v : rim.loop) {
      heights.push_back(-result_.down.dot(result_.lower.vertices[v]));
    }
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  bool faces_ground() const { return options_.ground && result_.down == -options_.ground->normal; }

  /// Heights below which nothing of the block is looked for.
  struct Bottom {
    std::optional<double> lowest;  ///< by the bounds; none: nothing shows how deep it goes
    double likely = 0.0;           ///< by the best shape
  };

  /// 0 where the flank above a vertex of the rim goes straight down or leans out, 1 where it
  /// closes.
  std::vector<double> closing_flanks(const Rim& rim, double height) const {
    const double reach = kFlankReach * height;
    std::vector<Vec3> areas(rim.loop.size(), Vec3::Zero());
    const std::vector<Vec3>& at = result_.lower.vertices;
    for (std::size_t t = 0; t < seen_triangles_; ++t) {
      const auto& [a, b, c] = result_.lower.triangles[t];
      const Vec3 centre = (at[a] + at[b] + at[c]) / 3.0;
      const Vec3 area = (at[b] - at[a]).cross(at[c] - at[a]);
      for (std::size_t i = 0; i < rim.loop.size(); ++i) {
        if ((centre - at[rim.loop[i]]).squaredNorm() < reach * reach) areas[i] += area;
      }
    }
    std::vector<double> closing;
    for (const Vec3& area : areas) {
      const double down = area.norm() > 0.0 ? area.normalized().dot(result_.down) : 0.0;
      closing.push_back(std::clamp((down - kStraightDown) / (kCloses - kStraightDown), 0.0, 1.0));
    }
    return closing;
  }

  /// A rim that is clear of the ground nearly all around, below flanks that close, shows that the
  /// block lies on the ground; else nothing says how deep it goes. In between it is in between, so
  /// that a hair's breadth of the rim decides nothing.
  Bottom bottom_below(const Rim& rim, double mean_rim, double highest) {
    const auto below = [&](double level) { return level - options_.deepest * (highest - level); };
    if (!faces_ground()) return {below(mean_rim), below(mean_rim)};
    const double ground = options_.ground->distance, height = highest - mean_rim;
    result_.gap = mean_rim - ground;
    const std::vector<double> closing = closing_flanks(rim, height);
    double hanging = 0.0, open = 0.0;
    for (std::size_t i = 0; i < rim.loop.size(); ++i) {
      const double above =
          (-result_.down.dot(result_.lower.vertices[rim.loop[i]]) - ground) / height;
      const double hangs =
          std::clamp((kClearOfGround - above) / (kClearOfGround - kAtGround), 0.0, 1.0);
      hanging += hangs;
      open += std::max(hangs, 1.0 - closing[i]);
    }
    const auto share = [&](double sum) {
      const double part = sum / static_cast<double>(rim.loop.size());
      return std::clamp((part - kFewHang) / (kManyHang - kFewHang), 0.0, 1.0);
    };
    // Something holds it up: under an overhang it reaches the ground however far below that is.
    const double sunk = ground - kSunk * height;
    // Of a block that leans, most of the rim may hang far above the ground that an end is in.
    Bottom bottom{std::nullopt, std::lerp(sunk, std::min(below(mean_rim), sunk), share(hanging))};
    if (share(open) < 1.0) {
      bottom.lowest = std::lerp(sunk, below(std::min(mean_rim, ground)), share(open));
    }
    return bottom;
  }

  /// The best shape lies on the ground. A cap under an uneven rim may meet the walls: it is made
  /// more pointed, then drawn back, until it does not.
  void settle_best(const reconstruct_detail::BottomClosure& closure, double deepest) {
    const double added = result_.best_volume - closure_volume_;
    reconstruct_detail::Move start = closure.holding(added, kBestPower, deepest);
    if (faces_ground()) start = closure.lying(*options_.ground, start, added, kMostPointedBest);
    deepest = std::max(deepest, start.depth);
    const std::size_t crossings = crossing_triangles(result_.lower).size();
    const auto fits = [&] { return crossing_triangles(result_.best).size() <= crossings; };
    for (double power = start.power; power <= kMostPointedBest; power *= 1.5) {
      result_.best = closure.lowered(closure.holding(added, power, deepest));
      if (fits()) break;
    }
    double share = 1.0;
    const TriangleMesh whole = result_.best;
    for (int i = 0; i < kWithdrawals && !fits(); ++i) {
      share = i + 1 < kWithdrawals ? 0.5 * share : 0.0;
      for (std::size_t v = first_vertex_; v < whole.vertices.size(); ++v) {
        result_.best.vertices[v] =
            result_.lower.vertices[v] + share * (whole.vertices[v] - result_.lower.vertices[v]);
      }
    }
    if (share < 1.0) {
      result_.notes.push_back("the filling was drawn back to " + with_digits(100.0 * share, 3) +
                              " % of its depth, where it does not meet the walls");
    }
    const reconstruct_detail::Sections sections(result_.best, -result_.down);
    result_.best_volume = sections.volume_above(sections.lowest());
    if (result_.upper_volume) {
      result_.best_volume = std::min(result_.best_volume, *result_.upper_volume);
    }
  }

  const UndersideOptions& options_;
  const std::size_t seen_triangles_;
  Underside result_;
  std::size_t first_vertex_ = 0;
  double closure_volume_ = 0.0;  ///< of `lower`, m^3
  double rim_root_ = 0.0;        ///< square root of the area of the rim, seen from below, m
};

}  // namespace

void UndersideOptions::check() const {
  if (ground && !(std::abs(ground->normal.norm() - 1.0) < 1e-6)) {
    throw InputError("ground normal has length " + with_digits(ground->normal.norm(), 3) +
                     "; it must be 1");
  }
  if (!(deepest > 0.0 && deepest <= 10.0)) {
    throw InputError("deepest = " + with_digits(deepest, 3) +
                     ": the share of the seen height that may be buried must be above 0, up to 10");
  }
  if (!(smallest_share > 0.0 && smallest_share < largest_share && largest_share < 1.0)) {
    throw InputError("smallest_share = " + with_digits(smallest_share, 3) +
                     " and largest_share = " + with_digits(largest_share, 3) +
                     ": shares between 0 and 1 in that order are needed");
  }
}

std::optional<Underside> close_underside(const TriangleMesh& open,
                                         const UndersideOptions& options) {
  options.check();
  return Closing(open, options).run();
}

}  // namespace clast
