#include "reconstruct/field_scan.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/point_cloud.hpp"
#include "reconstruct/detail/cloud.hpp"
#include "reconstruct/detail/cut_out.hpp"
#include "reconstruct/detail/hole_loops.hpp"
#include "reconstruct/detail/holes.hpp"
#include "reconstruct/detail/outliers.hpp"
#include "reconstruct/detail/pieces.hpp"
#include "reconstruct/detail/ragged_holes.hpp"
#include "reconstruct/detail/separate_sets.hpp"
#include "reconstruct/detail/soup.hpp"
#include "reconstruct/detail/spikes.hpp"
#include "reconstruct/detail/stated_bounds.hpp"
#include "reconstruct/detail/stored_digits.hpp"
#include "reconstruct/detail/surface_copy.hpp"
#include "reconstruct/detail/touching_sheets.hpp"
#include "reconstruct/standing_blocks.hpp"
#include "reconstruct/weld.hpp"

namespace clast {

namespace {

constexpr std::size_t kFewestPoints = 500;  ///< of a cloud
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
    raw_ = &raw;
    std::optional<TriangleMesh> sheet = open_sheet(raw);
    if (!sheet) return {cleaned(raw)};
    std::vector<reconstruct_detail::Piece> pieces = reconstruct_detail::pieces_of(*sheet);
    if (drop_copies(pieces)) return {cleaned(raw)};
    if (!mended_.doubled.empty()) {
      sheet = TriangleMesh{};
      for (const reconstruct_detail::Piece& piece : pieces) {
        *sheet = merged(std::move(*sheet), piece.mesh);
      }
    }
    if (options_.find_ground && !only_small_holes(*sheet)) {
      const std::vector<Vec3> points = reconstruct_detail::points_over(*sheet);
      if (const std::optional<Ground> ground = found_ground(points)) {
        return cut_out(*sheet, points, *ground);
      }
    }
    double scraps = 0.0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (pieces[i].area > kScrapArea * pieces[0].area) {
        return {cleaned(raw)};  // says what is wrong
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
    const std::vector<Vec3> once = reconstruct_detail::without_repeats(raw);
    for (const std::uint32_t i : reconstruct_detail::without_isolated(once)) {
      points.push_back(once[i]);
    }
    notes_.push_back("made from " + std::to_string(raw.size()) + " points, " +
                     std::to_string(once.size() - points.size()) + " of them outliers");
    if (once.size() < raw.size()) {
      notes_.push_back(std::to_string(raw.size() - once.size()) +
                       " points repeat another one and were left out");
    }
    reconstruct_detail::NearAndFar sets = reconstruct_detail::near_and_far(points);
    refuse_separate_sets(sets);
    std::optional<Ground> ground;
    if (options_.find_ground) ground = found_ground(points);
    if (!ground) {
      CloudSurface surface = surface_of(without_far(std::move(sets)), notes_);
      return {closed_block(std::move(surface.mesh), {}, Vec3::Zero(), &surface.margin)};
    }
    const StandingBlocks standing = standing_on(points, *ground);
    std::vector<FieldBlock> blocks;
    for (const StandingBlock* block : chosen(standing)) {
      std::vector<Vec3> own;
      for (const std::uint32_t i : block->points) own.push_back(points[i]);
      std::vector<std::string> notes;
      CloudSurface surface = surface_of(own, notes);
      blocks.push_back(closed_block(std::move(surface.mesh), below(*block, own, *ground),
                                    block->centre, &surface.margin));
      std::vector<std::string>& all = blocks.back().scan.notes;
      all.insert(all.end(), notes.begin(), notes.end());
    }
    return blocks;
  }

 private:
  /// Was a little missing, and more than a fan closes?
  static bool hardly_open(const FieldBlock& block) {
    if (block.underside) return block.underside->invented_share < kHardlyOpen;
    const RepairReport& report = block.scan.report;
    return report.invented_share < kHardlyOpen &&
           std::any_of(report.holes.begin(), report.holes.end(), [](const FilledHole& hole) {
             return hole.border_edges > reconstruct_detail::kFanEdges;
           });
  }

  /// Of a scan that was hardly open that much is said.
  static FieldBlock with_doubt(FieldBlock block) {
    if (hardly_open(block)) {
      block.scan.notes.push_back(
          "hardly any surface was missing, so the bounds are narrow; the file does not show "
          "whether the scanning software had already closed an unseen side, such as the bottom: "
          "check the volume by weighing (--mass with --density)");
    }
    return block;
  }

  /// By repair alone.
  FieldBlock cleaned(const TriangleMesh& raw) const {
    FieldBlock block{cleaned_scan(raw, name_, options_.scan), {}, {}};
    if (was_changed(block.scan.report)) {
      const reconstruct_detail::ScannedSurface scanned(raw);
      const TriangleMesh closed = in_file_units(block.scan.mesh);
      block.bounds = reconstruct_detail::closed_bounds(
          {closed, options_.scan.unit, &scanned, nullptr}, block.scan.report);
    }
    return with_doubt(std::move(block));
  }

  /// Is a part of the surface not as it was read? A wrap is off it everywhere, and says so.
  static bool was_changed(const RepairReport& report) {
    return !report.wrap_bias && (report.invented_share > 0.0 || !report.doubled.empty() ||
                                 report.find(DefectKind::kSpike) != nullptr ||
                                 report.find(DefectKind::kCrossing) != nullptr);
  }

  /// From metres, upright.
  TriangleMesh in_file_units(TriangleMesh mesh) const {
    for (Vec3& v : mesh.vertices) {
      v = (options_.scan.up == "y" ? Vec3(v.x(), v.z(), -v.y()) : v) / options_.scan.unit;
    }
    return mesh;
  }

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
    const auto note_mended = [&](DefectKind kind, const reconstruct_detail::Mended& mended) {
      note(kind, mended.count, mended.area, mended.place);
    };
    note(DefectKind::kNearVertices, welded(raw, 0.0).vertices.size() - mesh.vertices.size(), 0.0,
         {}, tolerance * options_.scan.unit);
    note(DefectKind::kNoArea, raw.triangles.size() - mesh.triangles.size());
    const reconstruct_detail::SoupMends mends =
        reconstruct_detail::mend_soup(mesh, reconstruct_detail::kFinArea);
    if (mesh.triangles.empty() || !mends.orientation.orientable) return std::nullopt;
    note_mended(DefectKind::kFolded, mends.folded);
    note_mended(DefectKind::kFin, mends.fins);
    note_mended(DefectKind::kTouchingEdge, mends.touching);
    const std::size_t turned =
        mends.orientation.turned + reconstruct_detail::turn_hanging_scraps(mesh);
    if (turned > 0) {
      note(DefectKind::kMixedWinding, turned, 0.0, mesh.vertices[mends.orientation.first]);
    }
    const std::vector<FilledHole> ragged = reconstruct_detail::close_ragged_holes(mesh);
    if (inspect(mesh).closed()) return std::nullopt;
    note_mended(DefectKind::kPinchedVertex, reconstruct_detail::split_pinched_vertices(mesh));
    const reconstruct_detail::Spikes spikes = reconstruct_detail::flatten_spikes(mesh);
    note(DefectKind::kSpike, spikes.count, 0.0, spikes.place, spikes.highest * options_.scan.unit);
    take_fillings(report, ragged, surface_area(mesh));
    mended_ = std::move(report);
    return mesh;
  }

  /// Adds fillings of holes to a report, in metres.
  /// @param area  of the surface with them, in the file's units
  void take_fillings(RepairReport& report, const std::vector<FilledHole>& fillings,
                     double area) const {
    if (fillings.empty()) return;
    const double unit = options_.scan.unit;
    RepairReport filled;
    double share = 0.0;
    for (FilledHole hole : fillings) {
      hole.area_share = hole.area / area;
      share += hole.area_share;
      hole.perimeter *= unit;
      hole.radius *= unit;
      hole.area *= unit * unit;
      hole.volume_below *= unit * unit * unit;
      hole.volume_above *= unit * unit * unit;
      filled.volume_below += hole.volume_below;
      filled.volume_above += hole.volume_above;
      filled.invented_share += hole.area_share;
      filled.holes.push_back(hole);
    }
    std::stable_sort(filled.holes.begin(), filled.holes.end(),
                     [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
    filled.defects.push_back({DefectKind::kHole, fillings.size(), share, filled.holes[0].radius,
                              filled.holes[0].centre});
    report = joined(std::move(report), std::move(filled));
  }

  /// Drops copies of the first piece, once that is the best of them, and notes them.
  /// @returns whether that piece is closed and nothing but copies and scraps is beside it: repair
  /// does the rest
  bool drop_copies(std::vector<reconstruct_detail::Piece>& pieces) {
    reconstruct_detail::put_best_copy_first(pieces);
    const TriangleMesh& first = pieces[0].mesh;
    const double diagonal = bounds(first).diagonal(), unit = options_.scan.unit;
    const TriangleTree tree(first);
    bool others = false;
    std::vector<reconstruct_detail::Piece> kept;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const bool scrap = pieces[i].area < kScrapArea * pieces[0].area;
      const auto copy = scrap ? std::nullopt
                              : reconstruct_detail::copy_of_surface(pieces[i].mesh, tree, diagonal);
      others |= !scrap && !copy;
      if (!copy) {
        kept.push_back(std::move(pieces[i]));
        continue;
      }
      DoubledSurface doubled = reconstruct_detail::described_copy(*copy, pieces[i], first, tree);
      doubled.offset *= unit;
      doubled.distance *= unit;
      doubled.volume_change *= unit * unit * unit;
      doubled.kept_volume *= unit * unit * unit;
      mended_.volume_below = std::max(mended_.volume_below, -doubled.volume_change);
      mended_.volume_above = std::max(mended_.volume_above, doubled.volume_change);
      mended_.doubled.push_back(doubled);
      mended_.defects.push_back({DefectKind::kDoubleSheet, 1, pieces[i].area / pieces[0].area, 0.0,
                                 pieces[i].mesh.vertices[0]});
    }
    pieces.resize(1);
    for (reconstruct_detail::Piece& piece : kept) pieces.push_back(std::move(piece));
    return !others && inspect(pieces[0].mesh).closed();
  }

  /// Are all holes of the sheet so small that none is an unseen side?
  static bool only_small_holes(const TriangleMesh& sheet) {
    const double area = surface_area(sheet);
    for (const std::vector<std::uint32_t>& loop : boundary_loops(sheet)) {
      std::vector<Vec3> border;
      for (const std::uint32_t v : loop) border.push_back(sheet.vertices[v]);
      if (reconstruct_detail::is_unseen_side(border, area)) return false;
    }
    return true;
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
  void refuse_separate_sets(const reconstruct_detail::NearAndFar& found) const {
    if (found.far_share <= kScrapArea) return;
    throw GeometryError(name_ + ": separate sets of points, the second with about " +
                        std::to_string(std::lround(100.0 * found.far_share)) +
                        " % of the area of the first, near " + place(found.far_place) +
                        "; save each block to a file of its own, or delete what does not belong "
                        "to it");
  }

  /// Points of a block by itself, without what lies far from it.
  std::vector<Vec3> without_far(reconstruct_detail::NearAndFar found) {
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

  /// Also notes what the surface leaves out and fills.
  CloudSurface surface_of(const std::vector<Vec3>& points, std::vector<std::string>& notes) const {
    try {
      CloudSurface surface = cloud_surface(points, options_.surface);
      if (surface.outliers > 0) {
        notes.push_back(std::to_string(surface.outliers) +
                        " more points left out as outliers off the surface of their neighbours");
      }
      if (surface.gaps > 0) {
        notes.push_back(std::to_string(surface.gaps) + (surface.gaps == 1 ? " gap" : " gaps") +
                        " between the points filled, " + with_digits(100.0 * surface.gap_share, 2) +
                        " % of the surface, the largest near " + place(surface.gap_place));
      }
      return surface;
    } catch (const GeometryError& error) {
      throw GeometryError(name_ + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(name_ + ": " + error.what());
    }
  }

  std::vector<FieldBlock> cut_out(const TriangleMesh& sheet, const std::vector<Vec3>& points,
                                  const Ground& ground) {
    const StandingBlocks standing = standing_on(points, ground);
    const reconstruct_detail::NearestPoints tree(points);
    std::vector<FieldBlock> blocks;
    for (const StandingBlock* block : chosen(standing)) {
      std::vector<Vec3> own;
      for (const std::uint32_t i : block->points) own.push_back(points[i]);
      std::vector<reconstruct_detail::Piece> pieces =
          reconstruct_detail::pieces_nearest_to(sheet, tree, block->points);
      if (pieces.empty()) refuse_bare_ground(name_, 1.0);
      const std::string others = left_out(pieces);
      TriangleMesh rock = std::move(pieces.front().mesh);
      reconstruct_detail::split_pinched_vertices(rock);
      blocks.push_back(closed_block(std::move(rock), below(*block, own, ground), block->centre));
      if (!others.empty()) blocks.back().scan.notes.push_back(others);
    }
    return blocks;
  }

  /// Of the pieces of what stands at one place the first is the block. Said where another is no
  /// scrap.
  static std::string left_out(const std::vector<reconstruct_detail::Piece>& pieces) {
    if (pieces.size() < 2 || pieces[1].area <= kScrapArea * pieces[0].area) return "";
    return "another piece of the scan that stands close to this block, with " +
           with_digits(100.0 * pieces[1].area / pieces[0].area, 3) + " % of its area, near " +
           place(pieces[1].mesh.vertices[0]) +
           ", was left out; to have both, save each to a file of its own";
  }

  /// Closes, cleans, and turns to metres with z up.
  /// @param margin  of a cloud; null: of a mesh
  FieldBlock closed_block(TriangleMesh open, const std::optional<Plane>& ground, const Vec3& centre,
                          const SurfaceMargin* margin = nullptr) const {
    RepairReport mended = mended_;
    if (turn_outward(open)) {
      std::swap(mended.volume_below, mended.volume_above);
      for (FilledHole& hole : mended.holes) std::swap(hole.volume_below, hole.volume_above);
      for (DoubledSurface& copy : mended.doubled) {
        copy.offset = -copy.offset;
        copy.volume_change = -copy.volume_change;
      }
    }
    if (mended.as_read.triangles > 0) {  // the surface of a cloud has no small holes
      const std::vector<FilledHole> filled = reconstruct_detail::fill_holes(open, false);
      take_fillings(mended, filled, surface_area(open));
    }
    std::optional<reconstruct_detail::ScannedSurface> scanned;
    if (margin != nullptr) {
      scanned.emplace(std::span<const Vec3>(open.vertices));
    } else if (was_changed(mended)) {
      scanned.emplace(*raw_);
    }
    UndersideOptions closing{
        .ground = ground, .smallest_share = kSmallestHole, .through = options_.through};
    if (scanned) closing.was_seen = [&](const Vec3& place) { return scanned->holds(place); };
    closing.margin = margin;
    std::optional<Underside> side;
    try {
      side = closed_underside(open, closing);
    } catch (const GeometryError& error) {
      throw GeometryError(name_ + ": " + error.what());
    }
    ScanOptions options = options_.scan;
    FieldBlock block{cleaned_scan(side ? side->best : open, name_, options), {}, {}};
    block.scan.report = joined(std::move(mended), std::move(block.scan.report));
    if (!side) {
      block.bounds = reconstruct_detail::closed_bounds(
          {open, options.unit, scanned ? &*scanned : nullptr, margin}, block.scan.report);
    }
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
      block.underside = moved(std::move(*side), [&](const Vec3& p) { return turn * to_metres(p); });
      block.bounds = reconstruct_detail::underside_bounds(*block.underside, block.scan.report);
    }
    return with_doubt(std::move(block));
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
  /// @returns whether it faced inwards
  static bool turn_outward(TriangleMesh& open) {
    const std::vector<std::vector<std::uint32_t>> loops = boundary_loops(open);
    if (loops.empty()) return false;
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
    if (sixfold >= 0.0) return false;
    reconstruct_detail::turn_over(open);
    return true;
  }

  std::string name_;
  const FieldScanOptions& options_;
  std::vector<std::string> notes_;
  const TriangleMesh* raw_ = nullptr;  ///< null: a cloud
  RepairReport mended_;                ///< before the surface was closed; empty for a cloud
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
  const std::string note = reconstruct_detail::digits_note(scan.raw, path, options.scan.unit);
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
