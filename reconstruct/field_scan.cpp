#include "reconstruct/field_scan.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/detail/cloud.hpp"
#include "reconstruct/detail/cut_out.hpp"
#include "reconstruct/detail/holes.hpp"
#include "reconstruct/detail/pieces.hpp"
#include "reconstruct/detail/separate_sets.hpp"
#include "reconstruct/detail/soup.hpp"
#include "reconstruct/detail/spikes.hpp"
#include "reconstruct/detail/stored_digits.hpp"
#include "reconstruct/detail/touching_sheets.hpp"
#include "reconstruct/standing_blocks.hpp"
#include "reconstruct/weld.hpp"
#include "shapes/mesh_io.hpp"
#include "shapes/mesh_topology.hpp"
#include "shapes/point_cloud.hpp"

namespace clast {

namespace {

constexpr std::size_t kFewestPoints = 500;  ///< of a cloud
constexpr int kOutlierNeighbours = 16;
constexpr double kOutlierDeviations = 1.0;
/// A piece beside an open block with more of its area is no scrap.
constexpr double kScrapArea = 0.1;
constexpr double kSmallestHole = 1e-9;  ///< of the area: every hole is closed and told
/// An open scan of which less than this share is filled in was closed by other means before.
constexpr double kHardlyOpen = 0.01;
constexpr double kToldTilt = 1.0;  ///< degrees; a turn by less is not told

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / kPi;
}

[[noreturn]] void refuse_bare_ground(const std::string& name, double share) {
  throw GeometryError(name + ": the largest piece is the ground (" + with_digits(100.0 * share, 3) +
                      " % of the scan) and nothing that rises from it is a block; scan a block and "
                      "the ground around "
                      "it, or, if this is one block alone, use --ground none");
}

class Separation {
 public:
  Separation(std::string name, const FieldScanOptions& options)
      : name_(std::move(name)), options_(options) {}

  std::vector<FieldBlock> of_mesh(const TriangleMesh& raw) {
    std::optional<TriangleMesh> sheet = open_sheet(raw);
    if (!sheet) return {{cleaned_scan(raw, name_, options_.scan), {}}};
    if (options_.find_ground) {
      const std::vector<Vec3> points = detail::points_over(*sheet);
      if (const std::optional<Ground> ground = found_ground(points)) {
        return cut_out(*sheet, points, *ground);
      }
    }
    std::vector<detail::Piece> pieces = detail::pieces_of(*sheet);
    double scraps = 0.0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (pieces[i].area > kScrapArea * pieces[0].area) {
        return {{cleaned_scan(raw, name_, options_.scan), {}}};  // says what is wrong
      }
      scraps += pieces[i].area / surface_area(*sheet);
    }
    if (pieces.size() > 1) {
      mended_.defects.push_back(
          {DefectKind::kIsland, pieces.size() - 1, scraps, 0.0, pieces[1].mesh.vertices[0]});
    }
    return {closed_block(std::move(pieces[0].mesh), {}, Vec3::Zero())};
  }

  std::vector<FieldBlock> of_cloud(const std::vector<Vec3>& raw) {
    if (!all_within_reach(raw)) {
      throw InputError(name_ + ": a point is not finite or farther than " +
                       with_digits(kLargestCoordinate, 3) +
                       " m from the origin: the file is damaged, or its unit is wrong");
    }
    if (raw.size() < kFewestPoints) {
      throw InputError(name_ + ": no block: " + std::to_string(raw.size()) +
                       " points are too few for one; a scan of a block has " +
                       std::to_string(kFewestPoints) + " at least");
    }
    std::vector<Vec3> points;
    for (const std::uint32_t i :
         detail::without_outliers(raw, kOutlierNeighbours, kOutlierDeviations)) {
      points.push_back(raw[i]);
    }
    notes_.push_back("made from " + std::to_string(raw.size()) + " points, " +
                     std::to_string(raw.size() - points.size()) + " of them outliers");
    detail::NearAndFar sets = detail::near_and_far(points);
    refuse_separate_sets(sets);
    std::optional<Ground> ground;
    if (options_.find_ground) ground = found_ground(points);
    if (!ground) {
      return {closed_block(surface_of(without_far(std::move(sets))), {}, Vec3::Zero())};
    }
    const StandingBlocks standing = standing_on(points, *ground);
    std::vector<FieldBlock> blocks;
    for (const StandingBlock* block : chosen(standing)) {
      std::vector<Vec3> own;
      for (const std::uint32_t i : block->points) own.push_back(points[i]);
      blocks.push_back(closed_block(surface_of(own), below(*block, own, *ground), block->centre));
    }
    return blocks;
  }

 private:
  bool all_within_reach(const std::vector<Vec3>& points) const {
    return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return p.allFinite() && p.cwiseAbs().maxCoeff() * options_.scan.unit <= kLargestCoordinate &&
             p.cwiseAbs().maxCoeff() <= kLargestCoordinate;
    });
  }

  /// The mesh welded and turned one way, when it is an open surface and nothing worse; none when
  /// cleaning alone does, or has to say what is wrong.
  std::optional<TriangleMesh> open_sheet(const TriangleMesh& raw) {
    if (!all_within_reach(raw.vertices)) return std::nullopt;
    const double tolerance = options_.scan.repair.weld_tolerance * bounds(raw).diagonal();
    TriangleMesh mesh = welded(raw, tolerance);
    RepairReport report;
    report.as_read = inspect(mesh);
    const double area = surface_area(mesh);
    const auto note = [&](DefectKind kind, std::size_t count, double dropped = 0.0,
                          std::optional<Vec3> where = {}, double size = 0.0) {
      if (count > 0) report.defects.push_back({kind, count, dropped / area, size, where});
    };
    const auto note_mended = [&](DefectKind kind, const detail::Mended& mended) {
      note(kind, mended.count, mended.area, mended.place);
    };
    note(DefectKind::kNearVertices, welded(raw, 0.0).vertices.size() - mesh.vertices.size(), 0.0,
         {}, tolerance * options_.scan.unit);
    note(DefectKind::kNoArea, raw.triangles.size() - mesh.triangles.size());
    const detail::SoupMends mends = detail::mend_soup(mesh, detail::kFinArea);
    if (mesh.triangles.empty() || !mends.orientation.orientable) return std::nullopt;
    note_mended(DefectKind::kFolded, mends.folded);
    note_mended(DefectKind::kFin, mends.fins);
    note_mended(DefectKind::kTouchingEdge, mends.touching);
    if (mends.orientation.turned > 0) {
      note(DefectKind::kMixedWinding, mends.orientation.turned, 0.0,
           mesh.vertices[mends.orientation.first]);
    }
    const std::vector<FilledHole> fans = detail::close_by_fans(mesh, detail::kFanEdges);
    if (inspect(mesh).closed()) return std::nullopt;
    note_mended(DefectKind::kPinchedVertex, detail::split_pinched_vertices(mesh));
    const detail::Spikes spikes = detail::flatten_spikes(mesh);
    note(DefectKind::kSpike, spikes.count, 0.0, spikes.place, spikes.highest * options_.scan.unit);
    take_fans(report, fans, surface_area(mesh));
    mended_ = std::move(report);
    return mesh;
  }

  void take_fans(RepairReport& report, const std::vector<FilledHole>& fans, double area) const {
    if (fans.empty()) return;
    const double unit = options_.scan.unit;
    double share = 0.0;
    for (FilledHole hole : fans) {
      hole.area_share = hole.area / area;
      share += hole.area_share;
      hole.perimeter *= unit;
      hole.radius *= unit;
      hole.area *= unit * unit;
      report.holes.push_back(hole);
    }
    std::stable_sort(report.holes.begin(), report.holes.end(),
                     [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
    report.defects.push_back(
        {DefectKind::kHole, fans.size(), share, report.holes[0].radius, report.holes[0].centre});
  }

  StandingBlocks standing_on(const std::vector<Vec3>& points, const Ground& ground) const {
    StandingBlocks standing = standing_blocks(points, ground);
    if (standing.blocks.empty()) {
      refuse_bare_ground(
          name_, static_cast<double>(standing.ground.size()) / static_cast<double>(points.size()));
    }
    return standing;
  }

  std::vector<const StandingBlock*> chosen(const StandingBlocks& standing) {
    notes_.push_back("the ground around it was found and taken away");
    std::vector<const StandingBlock*> blocks;
    if (options_.split) {
      for (const StandingBlock& block : standing.blocks) blocks.push_back(&block);
      return blocks;
    }
    if (standing.blocks.size() > 1) {
      notes_.push_back(std::to_string(standing.blocks.size()) +
                       " blocks stand on the ground; the one near the middle was taken, --split "
                       "takes them all");
    }
    return {&standing.blocks[standing.central]};
  }

  /// A ground would join what stands on it: without one, far sets are not of one block.
  void refuse_separate_sets(const detail::NearAndFar& found) const {
    if (found.far_share <= kScrapArea) return;
    throw GeometryError(name_ + ": separate sets of points, the second with about " +
                        std::to_string(std::lround(100.0 * found.far_share)) +
                        " % of the area of the first, near " + place(found.far_place) +
                        "; save each block to a file of its own, or delete what does not belong "
                        "to it");
  }

  /// Points of a block by itself, without what lies far from it.
  std::vector<Vec3> without_far(detail::NearAndFar found) {
    if (found.far > 0) {
      notes_.push_back(std::to_string(found.far) +
                       " points far from the block were left out, some near " +
                       place(found.far_place));
    }
    return std::move(found.near);
  }

  static Plane below(const StandingBlock& block, const std::vector<Vec3>& points,
                     const Ground& ground) {
    Bounds box;
    for (const Vec3& p : points) box.include(p);
    return ground.plane_below(block.centre, 0.5 * box.diagonal());
  }

  TriangleMesh surface_of(const std::vector<Vec3>& points) const {
    try {
      return cloud_surface(points, options_.surface);
    } catch (const GeometryError& error) {
      throw GeometryError(name_ + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(name_ + ": " + error.what());
    }
  }

  std::vector<FieldBlock> cut_out(const TriangleMesh& sheet, const std::vector<Vec3>& points,
                                  const Ground& ground) {
    const StandingBlocks standing = standing_on(points, ground);
    const detail::NearestPoints tree(points);
    std::vector<FieldBlock> blocks;
    for (const StandingBlock* block : chosen(standing)) {
      std::vector<Vec3> own;
      for (const std::uint32_t i : block->points) own.push_back(points[i]);
      std::vector<detail::Piece> pieces = detail::pieces_nearest_to(sheet, tree, block->points);
      if (pieces.empty()) refuse_bare_ground(name_, 1.0);
      const std::string others = left_out(pieces);
      TriangleMesh rock = std::move(pieces.front().mesh);
      detail::split_pinched_vertices(rock);
      blocks.push_back(closed_block(std::move(rock), below(*block, own, ground), block->centre));
      if (!others.empty()) blocks.back().scan.notes.push_back(others);
    }
    return blocks;
  }

  /// Of the pieces of what stands at one place the first is the block. Said where another is no
  /// scrap.
  static std::string left_out(const std::vector<detail::Piece>& pieces) {
    if (pieces.size() < 2 || pieces[1].area <= kScrapArea * pieces[0].area) return "";
    return "another piece of the scan that stands close to this block, with " +
           with_digits(100.0 * pieces[1].area / pieces[0].area, 3) + " % of its area, near " +
           place(pieces[1].mesh.vertices[0]) +
           ", was left out; to have both, save each to a file of its own";
  }

  /// Closes, cleans, and turns to metres with z up.
  FieldBlock closed_block(TriangleMesh open, const std::optional<Plane>& ground,
                          const Vec3& centre) const {
    turn_outward(open);
    std::optional<Underside> side;
    try {
      side = closed_underside(
          open, {.ground = ground, .smallest_share = kSmallestHole, .through = options_.through});
    } catch (const GeometryError& error) {
      throw GeometryError(name_ + ": " + error.what());
    }
    ScanOptions options = options_.scan;
    FieldBlock block{cleaned_scan(side ? side->best : std::move(open), name_, options), {}};
    block.scan.report = joined(mended_, std::move(block.scan.report));
    block.scan.notes = repair_notes(block.scan.report);
    std::vector<std::string>& notes = block.scan.notes;
    notes.insert(notes.begin(), notes_.begin(), notes_.end());
    const auto to_metres = [&](Vec3 p) -> Vec3 {
      p *= options.unit;
      return options.up == "y" ? Vec3(p.x(), -p.z(), p.y()) : p;
    };
    Pose turn{Vec3::Zero(), Quat::Identity()};
    if (ground && !options_.up_given) {
      const Vec3 normal = to_metres(ground->normal).normalized();
      const Vec3 pivot = to_metres(centre);
      const Quat rotation = Quat::FromTwoVectors(normal, Vec3::UnitZ());
      turn = {pivot - rotation * pivot, rotation};
      const double tilt = degrees_between(normal, Vec3::UnitZ());
      if (tilt > kToldTilt) {
        notes.push_back("turned by " + with_digits(tilt, 3) +
                        " degrees so that z points up from the ground; --up keeps the file's axes");
      }
      for (Vec3& vertex : block.scan.mesh.vertices) vertex = turn * vertex;
      block.block_from_file = turn;
    }
    if (side) {
      notes.insert(notes.end(), side->notes.begin(), side->notes.end());
      if (side->invented_share < kHardlyOpen) {
        notes.push_back(
            "hardly any surface was missing, so the bounds are narrow; whether the scanning "
            "software had closed a side before that nobody saw, such as the bottom, the file does "
            "not tell: check the volume by weighing (--mass with --density)");
      }
      block.underside = moved(std::move(*side), [&](const Vec3& p) { return turn * to_metres(p); });
    }
    return block;
  }

  /// The same underside with every length scaled and every place moved.
  template <class Move>
  Underside moved(Underside side, const Move& move) const {
    for (TriangleMesh* mesh : {&side.lower, &side.best}) {
      for (Vec3& vertex : mesh->vertices) vertex = move(vertex);
    }
    const double unit = options_.scan.unit, cubed = unit * unit * unit;
    side.lower_volume *= cubed;
    side.best_volume *= cubed;
    if (side.upper_volume) *side.upper_volume *= cubed;
    if (side.sides) side.sides = SideBounds{unit * side.sides->lower, unit * side.sides->upper};
    const Vec3 centre = move(side.rim_centre);
    side.down = (move(side.rim_centre + side.down) - centre).normalized();
    side.rim_centre = centre;
    side.rim_length *= unit;
    side.gap *= unit;
    return side;
  }

  /// By the volume that the surface would have with its largest hole filled flat.
  static void turn_outward(TriangleMesh& open) {
    const std::vector<std::vector<std::uint32_t>> loops = boundary_loops(open);
    if (loops.empty()) return;
    const auto& largest =
        *std::max_element(loops.begin(), loops.end(),
                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t v : largest) {
      middle += open.vertices[v] / static_cast<double>(largest.size());
    }
    double sixfold = 0.0;
    for (const auto& [a, b, c] : open.triangles) {
      sixfold += (open.vertices[a] - middle)
                     .dot((open.vertices[b] - middle).cross(open.vertices[c] - middle));
    }
    if (sixfold >= 0.0) return;
    for (TriangleMesh::Triangle& t : open.triangles) std::swap(t[1], t[2]);
  }

  std::string name_;
  const FieldScanOptions& options_;
  std::vector<std::string> notes_;
  RepairReport mended_;  ///< before the surface was closed; empty for a cloud
};

bool is_cloud(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::string>& known = cloud_extensions();
  return extension == ".asc" || std::find(known.begin(), known.end(), extension) != known.end();
}

}  // namespace

void FieldScanOptions::check() const {
  scan.check();
  surface.check();
}

std::vector<FieldBlock> field_blocks(const TriangleMesh& raw, const std::string& name,
                                     const FieldScanOptions& options) {
  options.check();
  return Separation(name, options).of_mesh(raw);
}

std::vector<FieldBlock> field_blocks(const std::vector<Vec3>& points, const std::string& name,
                                     const FieldScanOptions& options) {
  options.check();
  return Separation(name, options).of_cloud(points);
}

FieldScan read_field_scan(const std::filesystem::path& path, const FieldScanOptions& options) {
  options.check();
  FieldScan scan;
  CloudSummary summary;
  if (is_cloud(path)) {
    summary = stream_cloud(path, [&](const PointBatch& batch) {
      scan.raw.vertices.insert(scan.raw.vertices.end(), batch.points.begin(), batch.points.end());
    });
  } else {
    scan.raw = read_mesh_or_points(path);
  }
  const std::string note = detail::digits_note(scan.raw, path, options.scan.unit);
  scan.blocks = scan.raw.triangles.empty() ? field_blocks(scan.raw.vertices, path.string(), options)
                                           : field_blocks(scan.raw, path.string(), options);
  for (FieldBlock& block : scan.blocks) {
    std::vector<std::string>& notes = block.scan.notes;
    if (!note.empty()) notes.push_back(note);
    const auto left_out = [&](std::size_t count, const char* why) {
      if (count > 0) notes.push_back(std::to_string(count) + " points left out: " + why);
    };
    left_out(summary.without_place, "a coordinate is not finite");
    left_out(summary.withheld, "the file flags them as withheld or classes them as noise");
  }
  return scan;
}

}  // namespace clast
