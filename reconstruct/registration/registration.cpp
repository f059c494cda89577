#include "reconstruct/registration/registration.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/registration/detail/joint_refinement.hpp"
#include "reconstruct/registration/detail/picked_pose.hpp"
#include "reconstruct/registration/detail/pose_check.hpp"
#include "reconstruct/registration/detail/similarity_search.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

constexpr std::size_t kMostScans = 8;
constexpr double kHintAngle = 30.0 / kDegreesPerRadian;
constexpr int kFinalSteps = 30;
/// Fraction of the overlap that may disagree.
constexpr double kMaxDisagreeing = 0.15;

/// Registration in progress.
class Registrar {
 public:
  Registrar(const std::vector<ScanToRegister>& scans, const RegistrationOptions& options)
      : scans_(scans), options_(options) {
    check();
    begin_step("estimating the normals of " + std::to_string(scans.size()) + " scans");
    prepare_surfaces();
  }

  Registration run() {
    join_first_pair();
    while (joined_.size() < scans_.size()) join_next();
    return finish();
  }

 private:
  void begin_step(const std::string& what) const {
    if (options_.progress) options_.progress({.activity = what, .is_slow = true});
  }

  void check() const {
    if (scans_.size() < 2 || scans_.size() > kMostScans) {
      throw InputError(std::to_string(scans_.size()) +
                       " scans are given to be joined; two to eight can be");
    }
    for (const PoseHint& hint : options_.hints) {
      if (hint.scan >= scans_.size())
        throw InputError("a pose is given for a scan that is not there");
      if (hint.scan == 0) {
        throw InputError(scans_[0].name +
                         ": poses are relative to the first scan, which cannot have one");
      }
    }
    check_pairs(options_.pairs, scans_.size());
    if (options_.free_scale && !options_.pairs.empty()) {
      throw InputError("picked places have the scale of their scans; leave `free_scale` out");
    }
  }

  void prepare_surfaces() {
    double cell = 0.0, first_diagonal = 0.0;
    for (const ScanToRegister& scan : scans_) {
      Bounds box;
      for (const Vec3& p : scan.points) box.include(p);
      if (first_diagonal == 0.0) first_diagonal = box.diagonal();
      // Surfaces with free scales start at the size of the first.
      const double unit = options_.free_scale ? first_diagonal / box.diagonal() : 1.0;
      units_.push_back(unit);
      middles_.push_back(0.5 * unit * (box.low + box.high));
      cell = std::max(cell, unit * registration_cell(scan.points));
    }
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      std::vector<Vec3> points;
      for (const Vec3& p : scans_[s].points) points.push_back(units_[s] * p - middles_[s]);
      std::optional<Plane> ground = scans_[s].ground;
      if (ground) {
        ground->distance = units_[s] * ground->distance - ground->normal.dot(middles_[s]);
      }
      surfaces_.push_back(std::make_unique<SampledSurface>(orient_surface(points, cell, ground)));
    }
  }

  /// Poses of scan `moving` in the frame of scan `fixed`, the best first.
  const std::vector<PoseCandidate>& candidates(std::size_t fixed, std::size_t moving) {
    const auto key = std::pair(fixed, moving);
    if (const auto known = found_.find(key); known != found_.end()) return known->second;
    if (options_.nearly_aligned) {
      const Similarity given{{middles_[moving] - middles_[fixed], Quat::Identity()}, 1.0};
      return found_
          .emplace(key, std::vector<PoseCandidate>{refine_near_pose(*surfaces_[fixed],
                                                                    *surfaces_[moving], given)})
          .first->second;
    }
    begin_step("searching the pose of " + scans_[moving].name + " relative to " +
               scans_[fixed].name);
    std::vector<PoseCandidate> poses =
        options_.free_scale
            ? search_similarities(*surfaces_[fixed], *surfaces_[moving], options_.threads)
            : search_poses(*surfaces_[fixed], *surfaces_[moving], options_.threads);
    return found_.emplace(key, std::move(poses)).first->second;
  }

  bool is_picked(std::size_t scan) const {
    return std::any_of(options_.pairs.begin(), options_.pairs.end(), [&](const PickedPair& pair) {
      return pair.scan_a == scan || pair.scan_b == scan;
    });
  }

  /// Joins the two scans that agree best. One of them is the first scan of the input if poses are
  /// given, since these are relative to it.
  void join_first_pair() {
    std::size_t best_a = 0, best_b = 1;
    double best = -1e300;
    if (scans_.size() > 2) {
      for (std::size_t b = 1; b < scans_.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a) {
          if (is_picked(b) && a == 0) return start_with(0, b);
          if (a != 0 && !options_.hints.empty()) continue;
          const auto& poses = candidates(a, b);
          if (poses.empty() || poses[0].agreement.score <= best) continue;
          best = poses[0].agreement.score;
          best_a = a;
          best_b = b;
        }
      }
    }
    start_with(best_a, best_b);
  }

  void start_with(std::size_t a, std::size_t b) {
    joined_ = {a};
    poses_.assign(scans_.size(), Similarity{});
    add(b, poses_of(b));
  }

  /// Hypotheses for the pose of a scan in the frame of the group.
  std::vector<PoseCandidate> poses_of(std::size_t scan) {
    if (is_picked(scan)) {
      if (const auto pose = picked_pose(scan)) {
        return {refine_in_group(group(), {surfaces_[scan].get(), *pose})};
      }
    }
    std::vector<PoseCandidate> all;
    for (const std::size_t member : joined_) {
      const bool forward = member < scan;
      for (const PoseCandidate& one :
           forward ? candidates(member, scan) : candidates(scan, member)) {
        const Similarity relative =
            forward ? one.fixed_from_moving : one.fixed_from_moving.inverse();
        PoseCandidate pose = one;
        pose.fixed_from_moving = poses_[member] * relative;
        if (!fits_hint(scan, pose.fixed_from_moving)) continue;
        if (joined_.size() > 1) {
          pose = refine_in_group(group(), {surfaces_[scan].get(), pose.fixed_from_moving});
        }
        all.push_back(pose);
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const PoseCandidate& a, const PoseCandidate& b) {
      return a.agreement.score > b.agreement.score;
    });
    return all;
  }

  /// True unless a hint excludes the pose. With hints, the first scan is joined first.
  bool fits_hint(std::size_t scan, const Similarity& pose) const {
    for (const PoseHint& hint : options_.hints) {
      if (hint.scan != scan) continue;
      const Quat relative = poses_[0].pose.rotation.conjugate() * pose.pose.rotation;
      if (relative.angularDistance(hint.first_from_scan) > kHintAngle) return false;
    }
    return true;
  }

  std::optional<Similarity> picked_pose(std::size_t scan) const {
    std::vector<std::pair<Vec3, Vec3>> pairs;  // in the frame of the group, in that of the scan
    for (const PickedPair& pair : options_.pairs) {
      for (const bool swapped : {false, true}) {
        const std::size_t own = swapped ? pair.scan_a : pair.scan_b;
        const std::size_t other = swapped ? pair.scan_b : pair.scan_a;
        if (own != scan || std::find(joined_.begin(), joined_.end(), other) == joined_.end()) {
          continue;
        }
        const Vec3& own_point = swapped ? pair.point_a : pair.point_b;
        const Vec3& other_point = swapped ? pair.point_b : pair.point_a;
        pairs.emplace_back(poses_[other] * (other_point - middles_[other]),
                           own_point - middles_[own]);
      }
    }
    if (pairs.size() < 3) return {};
    return fit_picked_pairs(pairs, scans_[scan].name, surfaces_[scan]->diagonal);
  }

  ScanGroup group() const {
    ScanGroup members;
    for (const std::size_t member : joined_) {
      members.push_back({surfaces_[member].get(), poses_[member]});
    }
    return members;
  }

  void join_next() {
    std::optional<std::size_t> next;
    std::vector<PoseCandidate> best;
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      if (std::find(joined_.begin(), joined_.end(), s) != joined_.end()) continue;
      std::vector<PoseCandidate> poses = poses_of(s);
      const bool better =
          !next ||
          (!poses.empty() && (best.empty() || poses[0].agreement.score > best[0].agreement.score));
      if (!better) continue;
      next = s;
      best = std::move(poses);
    }
    add(*next, std::move(best));
  }

  std::string names_of_joined() const {
    std::string names;
    for (const std::size_t member : joined_) {
      names += (names.empty() ? "" : ", ") + scans_[member].name;
    }
    return names;
  }

  /// Adds a scan at the best of its poses, or refuses.
  void add(std::size_t scan, const std::vector<PoseCandidate>& poses) {
    const std::size_t same =
        check_best_pose({.surface = surfaces_[scan].get(),
                         .name = scans_[scan].name,
                         .group = group(),
                         .group_names = names_of_joined(),
                         .first_from_group = poses_[0].pose.rotation.conjugate(),
                         .is_picked = is_picked(scan),
                         .is_near = options_.nearly_aligned,
                         .has_free_scale = options_.free_scale},
                        poses);
    if (same > 1) {
      notes_.push_back(scans_[scan].name + " fits in " + std::to_string(same) +
                       " poses that give the same body");
    }
    poses_[scan] = poses[0].fixed_from_moving;
    joined_.push_back(scan);
  }

  Registration finish() {
    begin_step("refining the poses");
    // Joint refinement starts from the first scan of the input.
    const Similarity first = poses_[0].inverse();
    std::vector<const SampledSurface*> surfaces;
    std::vector<Similarity> start;
    double tolerance = 0.0, size = 1e300;
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      surfaces.push_back(surfaces_[s].get());
      start.push_back(s == 0 ? Similarity{} : first * poses_[s]);
      size = std::min(size, surfaces_[s]->diagonal);
    }
    for (std::size_t s = 1; s < scans_.size(); ++s) {
      tolerance =
          std::max(tolerance, fine_tolerance(surfaces_[0]->surface, surfaces_[s]->surface, size));
    }
    const Refinement refined =
        refine_jointly(surfaces, std::move(start),
                       {.tolerance = tolerance,
                        .iterations = kFinalSteps,
                        .free_scale = std::vector<bool>(scans_.size(), options_.free_scale)});
    poses_ = refined.first_from;
    return summarize(refined);
  }

  Registration summarize(const Refinement& refined) {
    Registration result;
    result.covariance = refined.covariance;
    result.deviation = refined.deviation;
    result.centre = middles_[0];
    result.overlap = 1.0;
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      Similarity pose = poses_[s];
      pose.pose.translation += middles_[0] - pose.pose.rotation * (pose.scale * middles_[s]);
      pose.scale *= units_[s];
      if (options_.free_scale && s > 0) {
        const auto row = static_cast<Eigen::Index>(7 * s - 1);
        result.scales.push_back(
            {s, pose.scale, scale_error(pose.scale, refined.covariance(row, row))});
      }
      result.first_from_scan.push_back(s == 0 ? Similarity{} : pose);
      result.noise = std::max(result.noise, surfaces_[s]->surface.noise);
      ScanGroup others;
      for (std::size_t other = 0; other < scans_.size(); ++other) {
        if (other != s) others.push_back({surfaces_[other].get(), poses_[other]});
      }
      check_scan(s, others, result);
    }
    result.notes = notes_;
    return result;
  }

  /// Scale of a scan if it differs from that of the others.
  std::optional<ScaleEstimate> scale_difference(const ScanGroup& others,
                                                const PlacedSurface& own) const {
    if (options_.nearly_aligned || options_.free_scale) return {};
    const ScaleEstimate scale = estimate_scale(others, own);
    return is_scale_different(scale) ? std::optional(scale) : std::nullopt;
  }

  /// Measures a scan against all others, and refuses it if it does not fit.
  void check_scan(std::size_t scan, const ScanGroup& others, Registration& result) const {
    const PlacedSurface own{surfaces_[scan].get(), poses_[scan]};
    const Disagreement found = measure_disagreement(others, own);
    result.overlap = std::min(result.overlap, found.overlap);
    if (found.fraction > result.disagreeing_fraction) {
      result.disagreeing_fraction = found.fraction;
      result.disagreement = found.distance;
    }
    if (scan == 0) return;
    if (const auto scale = scale_difference(others, own)) {
      throw GeometryError(scans_[scan].name +
                          ": its scale differs from that of the other scans: "
                          "they fit if its lengths are multiplied by " +
                          format_significant(scale->scale, 5) + " +- " +
                          format_significant(scale->standard_error, 1) +
                          "; check `units` and `scale_factor`");
    }
    if (found.fraction > kMaxDisagreeing) {
      throw GeometryError(scans_[scan].name + " disagrees with the other scans by " +
                          format_significant(found.distance, 2) + " m over " +
                          format_percent_of(found.fraction) +
                          " of their overlap: scale, movement or another block?");
    }
  }

  const std::vector<ScanToRegister>& scans_;
  const RegistrationOptions& options_;
  std::vector<double> units_;  ///< factors of the lengths of the scans
  std::vector<Vec3> middles_;  ///< of the scans: surfaces are relative to them
  std::vector<std::unique_ptr<SampledSurface>> surfaces_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<PoseCandidate>> found_;
  std::vector<std::size_t> joined_;  ///< in the order in which they were joined
  std::vector<Similarity> poses_;    ///< in the frame of the first joined scan
  std::vector<std::string> notes_;
};

}  // namespace

Registration register_scans(const std::vector<ScanToRegister>& scans,
                            const RegistrationOptions& options) {
  return Registrar(scans, options).run();
}

}  // namespace clast
