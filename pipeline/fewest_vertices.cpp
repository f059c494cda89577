#include "pipeline/fewest_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "reconstruct/simplify.hpp"

namespace clast {
namespace {

/// More vertices than the last make a simulation slow for little.
constexpr std::size_t kMinVertices = 8, kMaxVertices = 2000;
/// Trials start at this number over the tolerance: distances of inscribed polyhedra from a smooth
/// body are inversely proportional to their numbers of vertices.
constexpr double kFirstVerticesTimesTolerance = 1.2;
constexpr double kMinLeap = 1.275, kMaxLeap = 3.0;  ///< from one number of vertices to the next
/// More vertices are in vain if this many times the number of the closest block is no closer.
constexpr double kInVain = 1.5;
/// Factor by which the tolerance is raised repeatedly to find the closest block if none is within
/// it, and the largest multiple of the tolerance that is tried.
constexpr double kRelaxation = 1.15, kMaxRelaxation = 10.0;
/// A corner of a cube loses 0.73 radii, one of a tetrahedron 2: 0.0025 of S keeps even that.
constexpr int kRadiusHalvings = 3;

/// Every trial starts from the largest count, so that a large scan is simplified once. A scan that
/// can't be simplified to that one may still lose its flaws on the way to a smaller one.
TriangleMesh simplify_for_trials(const TriangleMesh& scan) {
  try {
    return simplify_mesh(scan, {.target_vertices = kMaxVertices});
  } catch (const GeometryError&) {
    return scan;
  }
}

}  // namespace

FewestVerticesSearch::FewestVerticesSearch(const std::string& id, const ScanSurface& scan,
                                           const BlockSource& source)
    : id_(id), scan_(scan), source_(source), fine_(simplify_for_trials(scan.mesh())) {}

Block FewestVerticesSearch::find_block(const BlockOptions& options, bool radius_given,
                                       double refinement) {
  refinement_ = refinement;
  BlockOptions tried = options;
  auto first = static_cast<std::size_t>(std::clamp(kFirstVerticesTimesTolerance / options.tolerance,
                                                   static_cast<double>(kMinVertices),
                                                   static_cast<double>(kMaxVertices)));
  for (int halving = 0; halving <= kRadiusHalvings; ++halving) {
    const bool is_last = radius_given || halving == kRadiusHalvings;
    if (const std::optional<Trial> trial = search_at_radius(tried, first, is_last)) {
      Block lightest = block_of(*trial);
      if (halving > 0) {
        lightest.warnings.push_back(
            "the radius is " + format_rounded(100.0 * tried.radius_fraction, 3) + " % of S: with " +
            format_rounded(200.0 * tried.radius_fraction, 3) +
            " % no block was within the tolerance");
      }
      return lightest;
    }
    if (is_last) break;
    tried.radius_fraction /= 2.0;
  }
  std::optional<Trial> closest = find_closest(tried);
  if (!closest) closest = std::move(nearest_);
  if (!closest) throw GeometryError(refusal_);
  Block kept = block_of(*closest);
  kept.warnings.push_back(
      "no block of up to " + std::to_string(kMaxVertices) +
      " vertices is within the tolerance of this scan; this is the closest block");
  return kept;
}

/// @param first  number of vertices to begin with; if no block is within tolerance, set to the
///               number that came closest
/// @param is_last  true if no smaller radius will be tried, so that more vertices are never in vain
std::optional<FewestVerticesSearch::Trial> FewestVerticesSearch::search_at_radius(
    const BlockOptions& options, std::size_t& first, bool is_last) {
  std::optional<Trial> lightest;
  const std::size_t most = std::min(kMaxVertices, fine_.vertices.size());
  std::size_t enough = most + 1, too_few = std::min(kMinVertices, most) - 1;
  std::size_t count = std::min(first, most);
  double least_ratio = 1e300;
  while (too_few < count && count < enough) {
    std::optional<Trial> trial = try_vertex_count(count, options);
    const double ratio = trial ? trial->fitted.deviation_ratio : kMaxLeap;
    if (trial && trial->fitted.is_within_tolerance()) {
      enough = count;
      lightest = std::move(trial);
    } else {
      too_few = count;
      const bool is_in_vain = !is_last && enough > most &&
                              static_cast<double>(count) >= kInVain * static_cast<double>(first);
      if (trial && ratio < least_ratio) {
        least_ratio = ratio;
        first = count;
      } else if (trial && is_in_vain) {
        break;
      }
      if (trial) keep_nearest(std::move(*trial));
    }
    const auto low = static_cast<double>(too_few), high = static_cast<double>(enough);
    if (enough > most) {  // distances fall about as 1 over the number of vertices
      const double leap = std::clamp(ratio, kMinLeap, kMaxLeap);
      count = std::max(count + 1, std::min(most, static_cast<std::size_t>(low * leap)));
    } else if (too_few < kMinVertices) {
      count = std::max(kMinVertices, static_cast<std::size_t>(high / 2.0));
      if (count == enough) break;
    } else {
      if (high <= refinement_ * low) break;
      count = static_cast<std::size_t>(std::sqrt(low * high));
    }
  }
  return lightest;
}

/// Finds a body within the smallest multiple of the tolerance, with the number of vertices and the
/// radius of the nearest trial, or with the most vertices. A fit is given up where it can't be
/// within the tolerance, and may then be far from the closest.
std::optional<FewestVerticesSearch::Trial> FewestVerticesSearch::find_closest(
    const BlockOptions& options) {
  const std::size_t most = std::min(kMaxVertices, fine_.vertices.size());
  for (double relaxation = kRelaxation; relaxation <= kMaxRelaxation; relaxation *= kRelaxation) {
    std::optional<Trial> trial =
        nearest_ ? try_vertex_count(nearest_->vertices, nearest_->options, relaxation)
                 : std::nullopt;
    if (trial && trial->fitted.is_within_tolerance()) return trial;
    trial = try_vertex_count(most, options, relaxation);
    if (trial && trial->fitted.is_within_tolerance()) return trial;
  }
  return std::nullopt;
}

std::optional<FewestVerticesSearch::Trial> FewestVerticesSearch::try_vertex_count(
    std::size_t count, const BlockOptions& options, double relaxation) {
  BlockOptions tried = options;
  tried.tolerance = std::min(1.0, relaxation * options.tolerance);
  tried.suggest_radius = refusal_.empty();  // the first refusal is the one that is reported
  try {
    const TriangleMesh surface = simplify_mesh(fine_, {.target_vertices = count});
    return with_error_context("block " + id_, [&] {
      return Trial{count, fit_body(surface, scan_, tried), options};
    });
  } catch (const GeometryError& error) {
    if (refusal_.empty()) refusal_ = error.what();
    return std::nullopt;
  }
}

void FewestVerticesSearch::keep_nearest(Trial trial) {
  if (nearest_ && nearest_->fitted.distance <= trial.fitted.distance) return;
  nearest_ = std::move(trial);
}

Block FewestVerticesSearch::block_of(const Trial& trial) const {
  BlockSource source = source_;
  source.options += " vertices=" + std::to_string(trial.vertices);
  return make_block(id_, trial.fitted, scan_, source, trial.options);
}

}  // namespace clast
