#pragma once
/// A block made of the rendered photos, against the truth.
#include <iostream>

#include "mesh/mesh_io.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"

namespace clast {

/// The block as `clast reconstruct` closes it, with how far off it is.
struct RockBlock {
  FieldBlock block;
  Vec3 sides = Vec3::Zero();  ///< relative errors of L, I, S
  /// Of the extents along the true L, I, S. Both ends of L and S were seen; I runs 17 degrees off
  /// the vertical, down to the side that no photo shows.
  Vec3 extents = Vec3::Zero();
  double true_volume = 0.137;  ///< the set's own statement, m^3

  explicit RockBlock(const PhotoScan& scan) {
    FieldScanOptions reading;
    reading.surface.averaging_cell = 0.003;
    reading.free_space = &scan.cloud.free_space;
    block = extract_field_blocks(scan.cloud.points, "rock", reading).front();
    const TriangleMesh truth = read_mesh(test_data("photos/synthetic_rock/gt_rock.ply"));
    const OrientedBox box = smallest_box(truth.vertices);
    sides = relative(smallest_box(block.scan.mesh.vertices).lengths, box.lengths);
    const ToTruth to_truth(scan.model);
    const Pose back = block.block_from_file.inverse();
    Bounds along;
    for (const Vec3& v : block.scan.mesh.vertices) {
      along.include(box.axes.transpose() * (to_truth * (back * v)));
    }
    extents = relative((along.high - along.low) / to_truth.scale, box.lengths);
    std::cout << "L, I, S " << 100.0 * sides.transpose() << " %, along the true ones "
              << 100.0 * extents.transpose() << " %, volume " << block.underside->lower_volume
              << " " << block.underside->estimated_volume << " "
              << block.underside->upper_volume.value() << " of " << true_volume << "\n";
  }

 private:
  static Vec3 relative(const Vec3& found, const Vec3& truth) {
    return found.cwiseQuotient(truth) - Vec3::Ones();
  }
};

}  // namespace clast
