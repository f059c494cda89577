#include "reconstruct/underside/underside.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/underside/detail/bottom_closure.hpp"
#include "reconstruct/underside/detail/hole_patch.hpp"
#include "reconstruct/underside/detail/sections.hpp"
#include "reconstruct/underside/detail/space_below.hpp"
#include "reconstruct/underside/detail/unobserved_bounds.hpp"

namespace clast {

namespace {

/// Holes whose flat filling has this share of the surface are bracketed beside the largest one.
constexpr double kBracketed = 0.003;
/// The narrowing at the rim is taken over these shares of the height that was seen: over the longer
/// one for the largest cone below an uneven rim, over the shorter for the likeliest shape.
constexpr double kMaxBand = 0.2, kBestBand = 0.1;
/// Share of its cone that a cap fills. A ball's fills 3/4 when it is shallow and 0.6 when a fifth
/// of the surface is unseen; where walls go straight down, any depth up to the deepest is as
/// likely. See docs/accuracy.md for how far off this is.
constexpr double kBestFraction = 0.6;
/// The cap of the best shape is bulge^(2/3): of a round rim, 0.6 of the cylinder around it.
constexpr double kBestPower = 2.0 / 3.0;
constexpr double kMaxPointedBest = 3.0;  ///< ... and may rise to this power
/// Heights of the rim, as shares of it that lie lower, from which the sections are continued: under
/// an uneven rim each stands for a part, and the largest volume counts.
constexpr std::array<double, 3> kRimFractions = {0.25, 0.5, 0.75};
/// The likeliest shape goes no deeper below the rim than so many times its width.
constexpr double kMaxDepthBelowRim = 1.5;
/// A rim is uneven where its heights spread over more than this share of the whole. The sections do
/// not say then what hangs beside them, and the best shape is put at this share between the closure
/// and the largest cone: the median of 100 blocks of which what faces down steeply was removed.
constexpr double kEven = 0.05, kUnevenFraction = 0.35;
/// A rim hangs down to the ground where it is no farther above it than the first share of the
/// height, and does not from the second share on.
constexpr double kAtGround = 0.02, kClearOfGround = 0.06;
/// Fractions of the rim that hangs. Up to the first, the best shape sinks into the ground by at
/// most `kSunk` of its height; from the second on, as deep as `max_depth_fraction`.
constexpr double kFewHang = 0.05, kManyHang = 0.15;
constexpr double kSunk = 0.05;
/// A block stands on a foot where photos looked under it but for this share of its plan; where all
/// of it meets the ground, nothing says how deep it goes.
constexpr double kBaseAreaFraction = 0.5;
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
    doubled += doubled_area_vector(mesh, mesh.triangles[i]).norm();
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
  Closing(const TriangleMesh& open, const UndersideOptions& options) : options_(options) {
    result_.lower_mesh = open;
  }

  std::optional<Underside> run() {
    const MeshReport report = inspect_mesh(result_.lower_mesh);
    if (report.non_manifold_edges > 0 || !report.is_oriented() || report.pinched_vertices > 0) {
      throw GeometryError("the surface is not a simple sheet: " + report.summary() +
                          "; repair it in MeshLab or CloudCompare first");
    }
    std::vector<Rim> rims;
    for (std::vector<std::uint32_t>& loop : boundary_loops(result_.lower_mesh)) {
      rims.push_back(measure_rim(result_.lower_mesh, std::move(loop)));
    }
    if (rims.empty()) return std::nullopt;
    std::stable_sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) {
      return a.area.squaredNorm() > b.area.squaredNorm();
    });
    const double seen_area = surface_area(result_.lower_mesh);
    const double flat = rims[0].area.norm();
    if (flat < options_.min_hole_fraction * (seen_area + flat)) return std::nullopt;
    refuse_sheet(rims[0], flat / (seen_area + flat));

    const auto bracketed = [&](const Rim& rim) {
      return &rim == &rims[0] || rim.area.norm() >= kBracketed * (seen_area + flat);
    };
    const auto count = std::count_if(rims.begin(), rims.end(), bracketed);
    result_.open_sides = static_cast<std::size_t>(count);
    for (std::size_t i = result_.open_sides; i < rims.size(); ++i) fill(rims[i]);
    note_filled(rims.size() - result_.open_sides);
    result_.first_filling = result_.lower_mesh.triangles.size();
    for (std::size_t i = 1; i < result_.open_sides; ++i) fill(rims[i]);
    first_vertex_ = result_.lower_mesh.vertices.size();
    reconstruct_detail::HolePatch patch = fill(rims[0]);
    describe(rims[0]);
    bracket(rims, reconstruct_detail::BottomClosure(result_.lower_mesh, std::move(patch),
                                                    first_vertex_, result_.down));
    return std::move(result_);
  }

 private:
  void refuse_sheet(const Rim& rim, double fraction) const {
    if (fraction <= options_.max_filling_fraction) return;
    throw GeometryError(
        "the largest component is the ground, or one side of a block: a sheet whose "
        "border of " +
        std::to_string(rim.loop.size()) + " edges near " +
        format_point(result_.lower_mesh.vertices[rim.loop[0]]) + " spans " +
        format_significant(100.0 * fraction, 3) +
        " % of the area of a closed surface; scan the block from all sides");
  }

  void note_filled(std::size_t small) {
    if (small == 0) return;
    result_.notes.push_back(std::to_string(small) + (small == 1 ? " other hole" : " other holes") +
                            " filled straight across");
  }

  reconstruct_detail::HolePatch fill(const Rim& rim) {
    reconstruct_detail::HolePatch patch =
        reconstruct_detail::fill_with_membrane(result_.lower_mesh, rim.loop);
    TriangleMesh& mesh = result_.lower_mesh;
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
    const reconstruct_detail::HorizontalSections sections(result_.lower_mesh, -result_.down);
    closure_volume_ = sections.volume_above(sections.min_height());
    if (!(closure_volume_ > 0.0)) {
      throw GeometryError("the surface faces inwards, or encloses nothing once it is closed (" +
                          format_significant(closure_volume_, 3) +
                          " m3); turn its faces outward, and check that it is one side of a block");
    }
    const std::vector<double> heights = rim_heights(rims[0]);
    const double bottom =
        likely_bottom(heights, heights[(heights.size() - 1) / 2], sections.max_height());
    bound(sections.max_height());
    rim_root_ = std::sqrt(std::abs(rims[0].area.dot(result_.down)));
    guess(heights, sections, bottom, closure);
    const double filling = area_from(result_.best_estimate, result_.first_filling);
    result_.filled_fraction = filling / surface_area(result_.best_estimate);
  }

  /// Marks the triangles of `lower_mesh` that were not scanned.
  std::vector<bool> closures() const {
    std::vector<bool> closure(result_.lower_mesh.triangles.size(), false);
    for (std::size_t t = 0; t < closure.size(); ++t) {
      closure[t] = t >= result_.first_filling;
      if (closure[t] || !options_.is_observed) continue;
      const auto& [a, b, c] = result_.lower_mesh.triangles[t];
      const std::vector<Vec3>& at = result_.lower_mesh.vertices;
      closure[t] = !options_.is_observed((at[a] + at[b] + at[c]) / 3.0);
    }
    return closure;
  }

  /// Bounds the unobserved part. The ends of the flanks do not show how deep a block is buried.
  /// Only observed free space below it shows that it lies on the ground.
  void bound(double highest) {
    const std::optional<reconstruct_detail::OccludedSpace> below = occupiable_space(highest);
    std::optional<double> bottom;
    if (below && base_fraction(*below) <= kBaseAreaFraction) {
      bottom = options_.ground->distance - sunk_depth(highest);
    }
    reconstruct_detail::UnobservedParts parts{closures(), {}, faces_ground(), options_.uncertainty};
    result_.assumption = "the unobserved part lies within the planes of the observed flanks";
    if (bottom) {
      parts.floor = Plane{options_.ground->normal, *bottom};
      const double depth = (options_.ground->distance - *bottom) / (highest - *bottom);
      result_.assumption += " and reaches into the ground by no more than " +
                            format_significant(100.0 * std::max(0.0, depth), 2) +
                            " % of its height";
    }
    const reconstruct_detail::UnobservedPartBounds bounds =
        reconstruct_detail::bound_unobserved_parts(result_.lower_mesh, parts);
    result_.lower_volume = bounds.lower_volume;
    result_.upper_volume = bounds.upper_volume;
    result_.sides = bounds.sides;
    for (std::string& note : reconstruct_detail::describe_hollows(bounds.hollows, options_.unit)) {
      result_.notes.push_back(std::move(note));
    }
    if (result_.upper_volume) {
      if (bottom) look_under(*below, highest);
    } else {
      result_.assumption.clear();
    }
  }

  /// The shape that the sections make likeliest, no larger than the upper one.
  void guess(const std::vector<double>& heights,
             const reconstruct_detail::HorizontalSections& sections, double bottom,
             const reconstruct_detail::BottomClosure& closure) {
    const auto quantile = [&](double fraction) {
      return heights[static_cast<std::size_t>(fraction * static_cast<double>(heights.size() - 1))];
    };
    double largest = closure_volume_, deepest = 0.0;
    result_.estimated_volume = closure_volume_;
    for (const double fraction : kRimFractions) {
      const double level = quantile(fraction);
      const Continued below = continued(sections, level, bottom);
      if (below.largest_volume > largest) {
        largest = below.largest_volume;
        deepest = level - bottom;
      }
      result_.estimated_volume = std::max(result_.estimated_volume, below.estimated_volume);
    }
    const bool uneven = quantile(0.9) - quantile(0.1) > kEven * (sections.max_height() - bottom);
    if (uneven) result_.estimated_volume = std::lerp(closure_volume_, largest, kUnevenFraction);
    if (result_.upper_volume) {
      result_.estimated_volume = std::min(result_.estimated_volume, *result_.upper_volume);
    }
    choose_best_closure(closure, deepest);
  }

  /// Maximum depth to which a block that lies on the ground has sunk, m.
  double sunk_depth(double highest) const { return kSunk * (highest - options_.ground->distance); }

  std::optional<reconstruct_detail::OccludedSpace> occupiable_space(double highest) const {
    if (options_.free_space == nullptr || !(options_.free_space->side > 0.0) || !faces_ground()) {
      return std::nullopt;
    }
    return reconstruct_detail::measure_occluded_space(result_.lower_mesh, *options_.ground,
                                                      sunk_depth(highest), *options_.free_space);
  }

  static double base_fraction(const reconstruct_detail::OccludedSpace& below) {
    return below.base_area / below.plan_area;
  }

  /// Limits the upper volume to all that is not free space, with the base sunk into the ground.
  void look_under(const reconstruct_detail::OccludedSpace& below, double highest) {
    const double fraction = base_fraction(below);
    const double hull = closure_volume_ + below.volume + below.base_area * sunk_depth(highest);
    if (hull >= *result_.upper_volume) return;
    result_.notes.push_back(
        "photos show " + format_significant(100.0 * (1.0 - fraction), 3) +
        " % of its plan to be above the ground, which reduces the largest volume by " +
        format_significant(100.0 * (1.0 - hull / *result_.upper_volume), 3) + " %");
    result_.upper_volume = hull;
  }

  /// Volumes with the sections continued below a level.
  struct Continued {
    double largest_volume = 0.0, estimated_volume = 0.0;
  };

  Continued continued(const reconstruct_detail::HorizontalSections& sections, double level,
                      double bottom) const {
    const double height = sections.max_height() - level;
    // Just above the level, where a flat filling does not count any more.
    const double root = std::sqrt(std::max(0.0, sections.area(level + 1e-6 * height)));
    const auto narrowing = [&](double band) {
      const double higher = std::sqrt(std::max(0.0, sections.area(level + band * height)));
      return (higher - root) / (band * height);
    };
    const double above = sections.volume_above(level);
    // A section may go through much more of the block than what ends at the rim.
    const double rim = std::min(root, rim_root_);
    const double deepest = std::min(level - bottom, kMaxDepthBelowRim * rim_root_);
    return {above + cone_below(rim, narrowing(kMaxBand), deepest),
            above + kBestFraction * cone_below(rim, narrowing(kBestBand), deepest)};
  }

  /// Returns the heights in ascending order.
  std::vector<double> rim_heights(const Rim& rim) const {
    std::vector<double> heights;
    for (const std::uint32_t v : rim.loop) {
      heights.push_back(-result_.down.dot(result_.lower_mesh.vertices[v]));
    }
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  bool faces_ground() const { return options_.ground && result_.down == -options_.ground->normal; }

  /// Height below which the best shape goes nowhere. A rim that is clear of the ground nearly all
  /// around suggests that the block lies on the ground; in between it is in between, so that a
  /// hair's breadth of the rim decides nothing.
  /// @param rim  heights, ascending
  double likely_bottom(const std::vector<double>& rim, double mean_rim, double highest) {
    const double below = mean_rim - options_.max_depth_fraction * (highest - mean_rim);
    if (!faces_ground()) return below;
    const double ground = options_.ground->distance, height = highest - mean_rim;
    result_.ground_clearance = mean_rim - ground;
    double hanging = 0.0;
    for (const double z : rim) {
      const double above = (z - ground) / height;
      hanging += std::clamp((kClearOfGround - above) / (kClearOfGround - kAtGround), 0.0, 1.0);
    }
    hanging /= static_cast<double>(rim.size());
    const double fraction = std::clamp((hanging - kFewHang) / (kManyHang - kFewHang), 0.0, 1.0);
    // Something holds it up: under an overhang it reaches the ground however far below that is.
    const double sunk = ground - kSunk * height;
    return std::lerp(sunk, std::min(below, sunk), fraction);
  }

  /// The best shape lies on the ground. A cap under an uneven rim may meet the walls: it is made
  /// more pointed, then drawn back, until it does not.
  void choose_best_closure(const reconstruct_detail::BottomClosure& closure, double deepest) {
    const double added = result_.estimated_volume - closure_volume_;
    reconstruct_detail::ClosureDisplacement start =
        closure.displacement_for_volume(added, kBestPower, deepest);
    if (faces_ground())
      start = closure.displacement_touching_ground(*options_.ground, start, added, kMaxPointedBest);
    deepest = std::max(deepest, start.depth);
    const std::size_t crossings = find_self_intersections(result_.lower_mesh).size();
    const auto fits = [&] {
      return find_self_intersections(result_.best_estimate).size() <= crossings;
    };
    for (double power = start.power; power <= kMaxPointedBest; power *= 1.5) {
      result_.best_estimate =
          closure.lowered_mesh(closure.displacement_for_volume(added, power, deepest));
      if (fits()) break;
    }
    double fraction = 1.0;
    const TriangleMesh whole = result_.best_estimate;
    for (int i = 0; i < kWithdrawals && !fits(); ++i) {
      fraction = i + 1 < kWithdrawals ? 0.5 * fraction : 0.0;
      for (std::size_t v = first_vertex_; v < whole.vertices.size(); ++v) {
        result_.best_estimate.vertices[v] =
            result_.lower_mesh.vertices[v] +
            fraction * (whole.vertices[v] - result_.lower_mesh.vertices[v]);
      }
    }
    if (fraction < 1.0) {
      result_.notes.push_back("the filling was reduced to " +
                              format_significant(100.0 * fraction, 3) +
                              " % of its depth, where it does not meet the walls");
    }
    const reconstruct_detail::HorizontalSections sections(result_.best_estimate, -result_.down);
    result_.estimated_volume = sections.volume_above(sections.min_height());
    if (result_.upper_volume) {
      result_.estimated_volume = std::min(result_.estimated_volume, *result_.upper_volume);
    }
  }

  const UndersideOptions& options_;
  Underside result_;
  std::size_t first_vertex_ = 0;
  double closure_volume_ = 0.0;  ///< of `lower_mesh`, m^3
  double rim_root_ = 0.0;        ///< square root of the area of the rim, seen from below, m
};

}  // namespace

void UndersideOptions::check() const {
  if (ground && !(std::abs(ground->normal.norm() - 1.0) < 1e-6)) {
    throw InputError("ground normal has length " + format_significant(ground->normal.norm(), 3) +
                     "; it must be 1");
  }
  if (!(max_depth_fraction > 0.0 && max_depth_fraction <= 10.0)) {
    throw InputError("max_depth_fraction = " + format_significant(max_depth_fraction, 3) +
                     ": the buried fraction of the observed height must be above 0, up to 10");
  }
  if (!(min_hole_fraction > 0.0 && min_hole_fraction < max_filling_fraction &&
        max_filling_fraction < 1.0)) {
    throw InputError("smallest_share = " + format_significant(min_hole_fraction, 3) +
                     " and largest_share = " + format_significant(max_filling_fraction, 3) +
                     ": must be fractions between 0 and 1, the smaller first");
  }
}

std::optional<Underside> close_underside(const TriangleMesh& open,
                                         const UndersideOptions& options) {
  options.check();
  return Closing(open, options).run();
}

}  // namespace clast
