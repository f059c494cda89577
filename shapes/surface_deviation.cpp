#include "shapes/surface_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/error.hpp"
#include "mesh/surface_samples.hpp"
#include "shapes/detail/deviation_search.hpp"

namespace clast {

SurfaceDeviation measure_surface_deviation(const ScanSurface& scan, const SpheroPolyhedron& body,
                                           const DeviationOptions& options) {
  if (body.faces.empty()) {
    throw GeometryError("a deviation needs two surfaces, but the body has none");
  }
  const TriangleMesh core = core_mesh(body);
  ThreadPool pool(options.threads);
  shapes_detail::DeviationSearch search(scan, core, body.radius, pool);
  SurfaceDeviation result;
  double known = 0.0;
  const auto measure = [&](std::span<const Vec3> points) {
    double sum = 0.0;
    for (const shapes_detail::SurfaceDistance& distance : search.distances_from_body(points)) {
      sum += std::abs(distance.value);
      if (distance.is_exact) known = std::max(known, std::abs(distance.value));
    }
    return sum / static_cast<double>(points.size());
  };
  result.mean = measure(sample_surface(scan.mesh(), std::max<std::size_t>(options.samples, 1)));
  measure(scan.mesh().vertices);  // corners stick out farthest: little is left to search
  shapes_detail::DeviationSearch::Limits limits;
  if (options.limit) limits = {.accepted = *options.limit, .refused = *options.limit};
  result.scan_to_body = search.scan_to_body(known, limits);
  const bool is_refused = options.limit && result.scan_to_body > *options.limit;
  if (!is_refused) result.body_to_scan = search.body_to_scan(limits);
  result.hausdorff = std::max(result.scan_to_body, result.body_to_scan);
  return result;
}

}  // namespace clast
