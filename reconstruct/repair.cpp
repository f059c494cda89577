#include "reconstruct/repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/detail/crossing_mends.hpp"
#include "reconstruct/detail/hole_loops.hpp"
#include "reconstruct/detail/holes.hpp"
#include "reconstruct/detail/pieces.hpp"
#include "reconstruct/detail/ragged_holes.hpp"
#include "reconstruct/detail/soup.hpp"
#include "reconstruct/detail/spikes.hpp"
#include "reconstruct/detail/surface_copy.hpp"
#include "reconstruct/detail/touching_sheets.hpp"

namespace clast {

namespace {

/// A piece with less of the block's area than this is no block: dust, a scrap of ground.
constexpr double kIslandArea = 0.05;
/// Share of the diagonal within which an open piece lies on the block: a part scanned twice.
constexpr double kDoubleSheet = 0.02;
/// Welds tried on an open surface, as multiples of the tolerance, while each halves its borders.
constexpr double kWelds[] = {1.0, 10.0, 100.0};
/// ... and joins no more vertices than so many for each open edge.
constexpr std::size_t kJoinedPerOpenEdge = 8;
/// Volume over diagonal cubed below which a surface encloses nothing: a folded sheet.
constexpr double kNoVolume = 1e-9;
/// Above this many diagonals from the origin, the work is done about a nearer one.
constexpr double kFarAway = 10.0;
constexpr std::size_t kHolesNamed = 3;

const char* const kAdvice =
    "; close and clean the scan first, for example in MeshLab (Filters > Remeshing > Close Holes, "
    "or Screened Poisson) or CloudCompare (PoissonRecon)";

/// Near the middle of a mesh that lies far from the origin, and such that taking it from the
/// coordinates and adding it again loses no bit of them; zero for other meshes.
Vec3 local_origin(const Bounds& box) {
  const double diagonal = box.diagonal();
  Vec3 origin = Vec3::Zero();
  if (!(diagonal > 0.0)) return origin;
  const double step = std::exp2(std::floor(std::log2(diagonal)));
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = 0.5 * (box.low[axis] + box.high[axis]);
    if (std::abs(middle) > kFarAway * diagonal) origin[axis] = std::round(middle / step) * step;
  }
  return origin;
}

/// The route itself, about a local origin.
class Route {
 public:
  explicit Route(const RepairOptions& options) : options_(options) {}

  Repaired run(const TriangleMesh& raw) {
    origin_ = local_origin(bounds(raw));
    TriangleMesh local = raw;
    for (Vec3& v : local.vertices) v -= origin_;
    weld(local);
    mend_soup();
    std::vector<reconstruct_detail::Piece> pieces = reconstruct_detail::pieces_of(mesh_);
    reconstruct_detail::put_best_copy_first(pieces);
    mesh_ = std::move(pieces.front().mesh);
    mend_block();
    turn_outward();
    take_pieces(pieces);
    finish_report();
    for (Vec3& v : mesh_.vertices) v += origin_;
    return {std::move(mesh_), std::move(report_)};
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw GeometryError(what); }

  /// The place as it is told.
  Vec3 told(const Vec3& local) const {
    const Vec3 there = local + origin_;
    return options_.place_told ? options_.place_told(there) : there;
  }

  std::string at(const Vec3& local) const { return place(told(local)); }

  void note(DefectKind kind, std::size_t count, double area = 0.0, std::optional<Vec3> where = {},
            double size = 0.0) {
    if (count == 0) return;
    if (where) where = told(*where);
    report_.defects.push_back({kind, count, area / area_as_read_, size, where});
  }

  void note(DefectKind kind, const reconstruct_detail::Mended& mended) {
    note(kind, mended.count, mended.area, mended.place);
  }

  /// Vertices that are equal are joined first; near ones only if that leaves the surface unsound,
  /// so that a sound mesh keeps its volume to the last digit.
  void weld(const TriangleMesh& raw) {
    const double diagonal = bounds(raw).diagonal();
    mesh_ = welded(raw, 0.0);
    if (mesh_.triangles.empty()) {
      fail("no surface is left: its triangles have no area or cancel each other");
    }
    report_.as_read = inspect(mesh_);
    const std::size_t vertices = mesh_.vertices.size();
    double tolerance = 0.0;
    for (const double multiple : kWelds) {
      if (report_.as_read.closed()) break;
      const double trial = multiple * options_.weld_tolerance * diagonal;
      TriangleMesh joined = welded(raw, trial);
      const MeshReport report = inspect(joined);
      const std::size_t before = report_.as_read.boundary_edges;
      const bool better =
          multiple == 1.0 ? report.boundary_edges < before : 2 * report.boundary_edges < before;
      // Vertices that lie close together because the mesh is fine are not torn apart.
      const bool only_borders = multiple == 1.0 || mesh_.vertices.size() - joined.vertices.size() <=
                                                       kJoinedPerOpenEdge * before;
      if (report.triangles == 0 || !only_borders || !(report.closed() || better)) continue;
      mesh_ = std::move(joined);
      report_.as_read = report;
      tolerance = trial;
    }
    area_as_read_ = surface_area(mesh_);
    note(DefectKind::kNearVertices, vertices - mesh_.vertices.size(), 0.0, {}, tolerance);
    note(DefectKind::kNoArea, raw.triangles.size() - mesh_.triangles.size());
  }

  /// After this every edge has one triangle or two, and neighbours face the same way.
  void mend_soup() {
    welded_ = mesh_;
    reconstruct_detail::SoupMends mends;
    if (options_.invent) {
      mends = reconstruct_detail::mend_soup(mesh_, reconstruct_detail::kFinArea);
    } else {
      mends.folded = reconstruct_detail::drop_opposite_pairs(mesh_);
      mends.orientation = reconstruct_detail::orient_consistently(mesh_);
    }
    if (mesh_.triangles.empty()) {
      fail("no surface is left: its triangles have no area or cancel each other");
    }
    const reconstruct_detail::Orientation& facing = mends.orientation;
    if (!facing.orientable) {
      fail("the surface is one-sided near " + at(mesh_.vertices[facing.conflict]) +
           " (inside and outside can't be told apart)" + kAdvice);
    }
    note(DefectKind::kFolded, mends.folded);
    note(DefectKind::kFin, mends.fins);
    note(DefectKind::kTouchingEdge, mends.touching);
    std::size_t turned = facing.turned;
    if (options_.invent) {
      turned += reconstruct_detail::turn_hanging_scraps(mesh_);
      report_.holes = reconstruct_detail::close_ragged_holes(mesh_);
    }
    if (turned > 0) {
      note(DefectKind::kMixedWinding, turned, 0.0, mesh_.vertices[facing.first]);
    }
  }

  /// The largest piece becomes closed and free of crossings.
  void mend_block() {
    const reconstruct_detail::Mended split = reconstruct_detail::split_pinched_vertices(mesh_);
    const reconstruct_detail::Spikes first =
        options_.invent ? reconstruct_detail::flatten_spikes(mesh_) : reconstruct_detail::Spikes{};
    fill();
    if (!inspect(mesh_).closed()) fail_open();
    const reconstruct_detail::Spikes second =
        options_.invent ? reconstruct_detail::flatten_spikes(mesh_) : reconstruct_detail::Spikes{};
    note(DefectKind::kPinchedVertex, split);
    const reconstruct_detail::Spikes& highest = first.highest > second.highest ? first : second;
    note(DefectKind::kSpike, first.count + second.count, 0.0, highest.place, highest.highest);
    check_volume();
    if (options_.invent) free_of_crossings();
  }

  void fill() {
    std::vector<FilledHole>& holes = report_.holes;
    for (const FilledHole& hole :
         reconstruct_detail::close_by_fans(mesh_, reconstruct_detail::kFanEdges)) {
      holes.push_back(hole);
    }
    if (options_.invent && inspect(mesh_).boundary_edges > 0) {
      for (const FilledHole& hole : reconstruct_detail::fill_holes(mesh_)) holes.push_back(hole);
    }
    const double area = surface_area(mesh_);
    for (FilledHole& hole : holes) {
      hole.area_share = hole.area / area;
      report_.invented_share += hole.area_share;
      report_.volume_below += hole.volume_below;
      report_.volume_above += hole.volume_above;
      if (hole.area_share <= options_.largest_hole || hole.fan) continue;
      fail("the surface is an open sheet and no block: " + open_edges(welded_) +
           "; closing it would invent " + with_digits(100.0 * hole.area_share, 3) +
           " % of its surface. A piece of ground is read by clast terrain; of a block, scan more "
           "sides");
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
    for (FilledHole& hole : holes) hole.centre = told(hole.centre);
  }

  void check_volume() const {
    const double volume = signed_volume(mesh_);
    if (!(std::abs(volume) > kNoVolume * std::pow(bounds(mesh_).diagonal(), 3))) {
      fail("the surface encloses no volume; is it a folded sheet?");
    }
  }

  /// "88 open edges in 9 holes: 30 edges and 0.41 m round near (...), ..."
  std::string open_edges(TriangleMesh mesh) const {
    reconstruct_detail::orient_consistently(mesh);  // or the borders would not chain into holes
    const std::size_t open = inspect(mesh).boundary_edges;
    if (open == 0) return "";
    std::string text = counted(open, "open edge", "open edges");
    std::vector<std::vector<std::uint32_t>> loops = boundary_loops(mesh);
    if (loops.empty()) return text;
    text += " in " + counted(loops.size(), "hole", "holes");
    std::stable_sort(loops.begin(), loops.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    const std::size_t named = std::min(kHolesNamed, loops.size());
    for (std::size_t i = 0; i < named; ++i) {
      double around = 0.0;
      for (std::size_t k = 0; k < loops[i].size(); ++k) {
        around += (mesh.vertices[loops[i][(k + 1) % loops[i].size()]] - mesh.vertices[loops[i][k]])
                      .norm();
      }
      text += (i == 0 ? ": " : ", ") + counted(loops[i].size(), "edge", "edges") + " and " +
              with_digits(around, 3) + " m round near " + at(mesh.vertices[loops[i].front()]);
    }
    return text + (named < loops.size() ? ", and smaller ones" : "");
  }

  [[noreturn]] void fail_open() const {
    std::string text = open_edges(welded_);
    const std::size_t shared = inspect(welded_).non_manifold_edges;
    if (shared > 0) {
      text += text.empty() ? "" : "; ";
      text += counted(shared, "edge", "edges") + " shared by more than two triangles, near " +
              at(welded_.vertices[triangle_neighbours(welded_).first_non_manifold[0]]);
    }
    fail("the surface is not closed: " + text + kAdvice);
  }

  /// Triangles that cross are replaced.
  void free_of_crossings() {
    mesh_ = reconstruct_detail::on_grid(std::move(mesh_), origin_);
    const auto crossings = crossing_triangles(mesh_);
    if (crossings.empty()) return;
    const Vec3 where = mesh_.vertices[mesh_.triangles[crossings[0][0]][0]];
    std::optional<reconstruct_detail::FreedSurface> freed =
        reconstruct_detail::freed_of_crossings(mesh_, origin_);
    if (!freed) {
      fail("the surface passes through itself at " + std::to_string(crossings.size()) +
           " pairs of triangles, the first near " + at(where) +
           ", and can't be freed of that without changing its volume by more than " +
           with_digits(100.0 * reconstruct_detail::kCrossingVolume, 2) + " %" + kAdvice);
    }
    report_.crossing_volume_change =
        std::abs(signed_volume(freed->mesh)) / std::abs(signed_volume(mesh_)) - 1.0;
    report_.wrap_bias = freed->wrap_bias;
    note(DefectKind::kCrossing, crossings.size(), 0.0, where);
    mesh_ = std::move(freed->mesh);
  }

  /// What the other pieces are, now that the block is closed: bubbles, sheets scanned twice,
  /// islands, or other blocks.
  void take_pieces(const std::vector<reconstruct_detail::Piece>& pieces) {
    if (pieces.size() == 1) return;
    const TriangleTree tree(mesh_);
    const double diagonal = bounds(mesh_).diagonal(), on_block = kDoubleSheet * diagonal;
    std::vector<const TriangleMesh*> shells;
    Dropped islands, sheets, copies;
    std::size_t others = 0;
    bool open = false;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const TriangleMesh& piece = pieces[i].mesh;
      const bool closed = inspect(piece).closed();
      if (pieces[i].area >= kIslandArea * pieces[0].area) {
        if (const auto copy = reconstruct_detail::copy_of_surface(piece, tree, diagonal)) {
          (closed ? copies : sheets).add(pieces[i]);
          note_copy(reconstruct_detail::described_copy(*copy, pieces[i], mesh_, tree));
          continue;
        }
      }
      const bool inside = reconstruct_detail::lies_inside(piece, mesh_, tree);
      const auto holds_piece = [&](const TriangleMesh* shell) {
        return reconstruct_detail::encloses(*shell, piece.vertices[0]);
      };
      // What lies in a bubble has less area than the bubble, so that one comes first.
      if (inside && closed && std::none_of(shells.begin(), shells.end(), holds_piece)) {
        shells.push_back(&piece);
      } else if (options_.invent && !closed && reconstruct_detail::lies_on(piece, tree, on_block)) {
        sheets.add(pieces[i]);
      } else if (inside || pieces[i].area < kIslandArea * pieces[0].area) {
        islands.add(pieces[i]);
      } else {
        ++others;
        open |= !closed;
      }
    }
    if (others > 0) fail_pieces(others, open, pieces[1].area / pieces[0].area);
    note(DefectKind::kDoubleSheet, sheets.count, sheets.area, sheets.place);
    note(DefectKind::kDoubledShell, copies.count, copies.area, copies.place);
    note(DefectKind::kIsland, islands.count, islands.area, islands.place);
    take_shells(shells);
  }

  void note_copy(const DoubledSurface& copy) {
    report_.doubled.push_back(copy);
    // One of the copies is the rock: the farthest from the one kept bounds it.
    report_.volume_below = std::max(report_.volume_below, -copy.volume_change);
    report_.volume_above = std::max(report_.volume_above, copy.volume_change);
  }

  struct Dropped {
    std::size_t count = 0;
    double area = 0.0;
    Vec3 place = Vec3::Zero();

    void add(const reconstruct_detail::Piece& piece) {
      if (count++ == 0) place = piece.mesh.vertices[0];
      area += piece.area;
    }
  };

  [[noreturn]] static void fail_pieces(std::size_t others, bool open, double share) {
    fail(std::to_string(others + 1) + " separate pieces, the second with " +
         with_digits(100.0 * share, 4) + " % of the area of the first; " +
         (open ? "if they are parts of one block, align and merge them first (CloudCompare: Fine "
                 "registration, then Merge); otherwise "
               : "") +
         "save each block to a file of its own, or delete what does not belong to it");
  }

  /// Counts the shells; where they are to be kept, adds them facing the other way than the block.
  void take_shells(const std::vector<const TriangleMesh*>& shells) {
    if (shells.empty()) return;
    const bool block_outward = signed_volume(mesh_) > 0.0;
    report_.inner_shells = shells.size();
    report_.inner_shells_kept = options_.keep_inner_shells;
    double area = 0.0;
    for (const TriangleMesh* shell : shells) {
      const double volume = signed_volume(*shell);
      report_.inner_shell_volume += std::abs(volume);
      area += surface_area(*shell);
      if (!options_.keep_inner_shells) continue;
      TriangleMesh cavity = *shell;
      reconstruct_detail::split_pinched_vertices(cavity);
      if ((volume > 0.0) == block_outward) turn_over(cavity);
      mesh_ = merged(std::move(mesh_), cavity);
    }
    note(DefectKind::kInnerShell, shells.size(), area, shells[0]->vertices[0]);
  }

  void turn_outward() {
    if (signed_volume(mesh_) > 0.0) return;
    turn_over(mesh_);
    std::swap(report_.volume_below, report_.volume_above);
    for (FilledHole& hole : report_.holes) std::swap(hole.volume_below, hole.volume_above);
    note(DefectKind::kInward, 1);
  }

  void finish_report() {
    double filled = 0.0;
    for (const FilledHole& hole : report_.holes) filled += hole.area_share;
    if (!report_.holes.empty()) {
      report_.defects.push_back({DefectKind::kHole, report_.holes.size(), filled,
                                 report_.holes[0].radius, report_.holes[0].centre});
    }
    const MeshReport report = inspect(mesh_);
    const long handles = static_cast<long>(report.components) - report.euler_characteristic / 2;
    if (handles > 0) note(DefectKind::kTunnel, static_cast<std::size_t>(handles));
    std::stable_sort(report_.defects.begin(), report_.defects.end(),
                     [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
  }

  const RepairOptions& options_;
  Vec3 origin_ = Vec3::Zero();
  TriangleMesh mesh_;
  TriangleMesh welded_;  ///< before any mend, so that messages count what the file has
  double area_as_read_ = 1.0;
  RepairReport report_;
};

}  // namespace

void RepairOptions::check() const {
  if (!(weld_tolerance >= 0.0 && weld_tolerance <= 0.01)) {
    throw InputError("weld_tolerance = " + with_digits(weld_tolerance, 6) +
                     ": a share of the diagonal between 0 and 0.01 is needed");
  }
  if (!(largest_hole > 0.0 && largest_hole < 1.0)) {
    throw InputError("largest_hole = " + with_digits(largest_hole, 6) +
                     ": a share of the surface between 0 and 1 is needed");
  }
}

Repaired repaired(const TriangleMesh& dirty, const RepairOptions& options) {
  options.check();
  for (std::size_t v = 0; v < dirty.vertices.size(); ++v) {
    if (!dirty.vertices[v].allFinite()) {
      throw GeometryError("vertex " + std::to_string(v + 1) +
                          " is not a finite point; clean the file in the program that wrote it");
    }
    const double farthest = dirty.vertices[v].cwiseAbs().maxCoeff();
    if (farthest > kLargestCoordinate) {
      throw GeometryError("vertex " + std::to_string(v + 1) + " lies " + with_digits(farthest, 3) +
                          " m from the origin: the file is damaged, or its unit is wrong; check "
                          "the unit it was read in");
    }
  }
  return Route(options).run(dirty);
}

}  // namespace clast
