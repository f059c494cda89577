#include "reconstruct/scan.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/detail/mend.hpp"
#include "reconstruct/weld.hpp"
#include "shapes/detail/half_edges.hpp"
#include "shapes/detail/triangle_tree.hpp"
#include "shapes/mesh_io.hpp"

namespace clast {

namespace {

/// A piece beside the block with less of its area than this is debris (dust, a scrap of ground).
constexpr double kDebrisArea = 0.02;
/// ... and no longer than this share of the block.
constexpr double kDebrisDiagonal = 0.15;
/// Share of the diagonal within which a bubble touches the skin and doesn't pierce it.
constexpr double kTouching = 1e-6;
/// Volume over diagonal cubed below which a surface encloses nothing: a folded sheet.
constexpr double kNoVolume = 1e-9;

const char* const kAdvice =
    "; close and clean the scan first, for example in MeshLab (Filters > Remeshing > Close Holes, "
    "or Screened Poisson) or CloudCompare (PoissonRecon)";

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// "88 open edges in 9 holes, the largest with 30 edges near (...)", in coordinates of the file.
std::string open_defects(TriangleMesh mesh) {
  detail::orient_consistently(mesh);  // or the borders would not chain into holes
  const MeshReport report = inspect(mesh);
  std::string text;
  if (report.boundary_edges > 0) {
    text = counted(report.boundary_edges, "open edge", "open edges");
    const std::vector<std::vector<std::uint32_t>> loops = boundary_loops(mesh);
    if (!loops.empty()) {
      const auto& largest =
          *std::max_element(loops.begin(), loops.end(),
                            [](const auto& a, const auto& b) { return a.size() < b.size(); });
      text += " in " + counted(loops.size(), "hole", "holes") + ", the largest with " +
              std::to_string(largest.size()) + " edges near " +
              place(mesh.vertices[largest.front()]);
    }
  }
  if (report.non_manifold_edges > 0) {
    text += text.empty() ? "" : "; ";
    text += counted(report.non_manifold_edges, "edge", "edges") +
            " shared by more than two triangles, near " +
            place(mesh.vertices[detail::first_non_manifold_edge(mesh)[0]]);
  }
  return text;
}

void turn_over(TriangleMesh& mesh) {
  for (TriangleMesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

/// The pieces of a mesh, largest area first.
struct Piece {
  TriangleMesh mesh;
  double area = 0.0;
};

std::vector<Piece> pieces_of(const TriangleMesh& mesh) {
  std::vector<Piece> pieces;
  for (TriangleMesh& piece : detail::split_components(mesh)) {
    const double area = surface_area(piece);
    pieces.push_back({std::move(piece), area});
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.area > b.area; });
  return pieces;
}

bool is_debris(const Piece& piece, const Piece& main) {
  return piece.area < kDebrisArea * main.area &&
         bounds(piece.mesh).diagonal() < kDebrisDiagonal * bounds(main.mesh).diagonal();
}

/// Is every vertex of the piece inside the block? A second block that overlaps it has some outside.
bool lies_inside(const TriangleMesh& piece, const TriangleMesh& block,
                 const detail::TriangleTree& tree) {
  const Vec3& start = piece.vertices[0];
  if (!detail::encloses(block, start)) return false;
  // The block may still face inwards, so only sides that differ tell something.
  const double side = tree.signed_distance(start) < 0.0 ? -1.0 : 1.0;
  const double touching = -kTouching * bounds(block).diagonal();
  return std::all_of(piece.vertices.begin(), piece.vertices.end(), [&](const Vec3& vertex) {
    return side * tree.signed_distance(vertex) > touching;
  });
}

/// The cleaning itself, in the file's own units and axes so that places in messages can be found.
class Cleaning {
 public:
  Cleaning(std::string name, const ScanOptions& options)
      : name_(std::move(name)), options_(options) {}

  Scan run(const TriangleMesh& raw) {
    weld(raw);
    drop_folds();
    if (scan_.mesh.triangles.empty()) {
      fail("no surface is left: its triangles have no area or cancel each other");
    }
    orient();
    keep_block();
    close_tiny_holes();
    check_closed();
    split_pinches();
    turn_outward();
    count_tunnels();
    return std::move(scan_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw GeometryError(name_ + ": " + what);
  }
  void note(const std::string& text) { scan_.notes.push_back(text); }

  /// Vertices that are equal are joined first; near ones only if that leaves the surface unsound,
  /// so that a sound mesh keeps its volume to the last digit.
  void weld(const TriangleMesh& raw) {
    scan_.mesh = welded(raw, 0.0);
    if (scan_.mesh.triangles.empty()) {
      fail("no surface is left: its triangles have no area or cancel each other");
    }
    scan_.as_read = inspect(scan_.mesh);
    if (!scan_.as_read.closed()) {
      TriangleMesh joined = welded(raw, options_.weld_tolerance * bounds(raw).diagonal());
      const MeshReport report = inspect(joined);
      const bool mends_cracks = report.boundary_edges < scan_.as_read.boundary_edges;
      if (report.closed() || (report.triangles > 0 && mends_cracks)) {
        note(counted(scan_.mesh.vertices.size() - joined.vertices.size(), "vertex", "vertices") +
             " joined to a neighbour closer than " +
             with_digits(options_.weld_tolerance * bounds(raw).diagonal() * options_.unit, 4) +
             " m");
        scan_.mesh = std::move(joined);
        scan_.as_read = report;
      }
    }
    welded_ = scan_.mesh;
    const std::size_t lost = raw.triangles.size() - scan_.mesh.triangles.size();
    if (lost > 0) {
      note(counted(lost, "triangle", "triangles") + " without area or stored twice dropped");
    }
  }

  void drop_folds() {
    const std::size_t dropped = detail::drop_opposite_pairs(scan_.mesh);
    if (dropped > 0) {
      note(counted(dropped, "triangle", "triangles") + " back to back with another dropped");
    }
  }

  void orient() {
    const detail::Orientation result = detail::orient_consistently(scan_.mesh);
    if (!result.orientable) {
      fail("the surface is one-sided near " + place(scan_.mesh.vertices[result.conflict]) +
           " (inside and outside can't be told apart)" + kAdvice);
    }
    if (result.turned > 0) {
      note(counted(result.turned, "triangle", "triangles") + " turned to agree with neighbours");
    }
  }

  /// Leaves the block alone: drops debris, drops or keeps shells inside it, refuses two blocks.
  void keep_block() {
    std::vector<Piece> pieces = pieces_of(scan_.mesh);
    if (pieces.size() == 1) return;
    Piece& main = pieces.front();
    TriangleMesh closed = main.mesh;
    detail::fill_small_holes(closed, options_.fan_hole_edges);
    const bool main_closed = inspect(closed).closed();
    const detail::TriangleTree tree(closed);
    std::vector<const TriangleMesh*> shells;
    std::size_t debris = 0, others = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const TriangleMesh& piece = pieces[i].mesh;
      const bool inside = main_closed && lies_inside(piece, closed, tree);
      const auto holds_piece = [&](const TriangleMesh* shell) {
        return detail::encloses(*shell, piece.vertices[0]);
      };
      // What lies in a bubble has less area than the bubble, so that one comes first.
      if (inside && inspect(piece).closed() &&
          std::none_of(shells.begin(), shells.end(), holds_piece)) {
        shells.push_back(&piece);
      } else if (inside || is_debris(pieces[i], main)) {
        ++debris;
      } else {
        ++others;
      }
    }
    if (others > 0 && main_closed) {
      fail(std::to_string(others + 1) + " separate pieces, the second with " +
           with_digits(100.0 * pieces[1].area / main.area, 4) +
           " % of the area of the first; save each block to a file of its own, or delete what does "
           "not belong to it");
    }
    // An open surface with other large parts is refused whole, with all its defects.
    if (others > 0) return;
    take_shells(shells, main.mesh);
    if (debris > 0) note(counted(debris, "loose scrap", "loose scraps") + " dropped");
    scan_.mesh = std::move(main.mesh);
  }

  /// Counts the shells; where they are to be kept, adds them to `block` facing the other way.
  void take_shells(const std::vector<const TriangleMesh*>& shells, TriangleMesh& block) {
    if (shells.empty()) return;
    const bool block_outward = detail::signed_volume(block) > 0.0;
    scan_.inner_shells = shells.size();
    for (const TriangleMesh* shell : shells) {
      const double volume = detail::signed_volume(*shell);
      scan_.inner_shell_volume += std::abs(volume);
      if (!options_.keep_inner_shells) continue;
      TriangleMesh cavity = *shell;
      if ((volume > 0.0) == block_outward) turn_over(cavity);
      block = merged(std::move(block), cavity);
    }
    note(counted(shells.size(), "inner shell", "inner shells") + " (bubbles) of " +
         with_digits(scan_.inner_shell_volume * std::pow(options_.unit, 3), 4) + " m3 in all " +
         (options_.keep_inner_shells ? "kept as cavities" : "dropped"));
  }

  void close_tiny_holes() {
    const std::vector<std::size_t> closed =
        detail::fill_small_holes(scan_.mesh, options_.fan_hole_edges);
    if (closed.empty()) return;
    std::size_t edges = 0;
    for (const std::size_t size : closed) edges += size;
    note(counted(closed.size(), "hole", "holes") + " with " +
         counted(edges, "border edge", "border edges") + " in all closed by a fan");
  }

  void check_closed() const {
    if (inspect(scan_.mesh).closed()) return;
    fail("the surface is not closed: " + open_defects(welded_) + kAdvice);
  }

  void split_pinches() {
    const std::size_t split = detail::split_pinched_vertices(scan_.mesh);
    if (split > 0) {
      note(counted(split, "vertex", "vertices") + " where the surface touches itself split");
    }
  }

  void turn_outward() {
    const double volume = detail::signed_volume(scan_.mesh);
    if (!(std::abs(volume) > kNoVolume * std::pow(bounds(scan_.mesh).diagonal(), 3))) {
      fail("the surface encloses no volume; is it a folded sheet?");
    }
    if (volume > 0.0) return;
    turn_over(scan_.mesh);
    note("the surface faced inwards and was turned");
  }

  void count_tunnels() {
    const MeshReport report = inspect(scan_.mesh);
    const long handles = static_cast<long>(report.components) - report.euler_characteristic / 2;
    if (handles <= 0) return;
    note(counted(static_cast<std::size_t>(handles), "tunnel goes", "tunnels go") +
         " through the block and stay open; if the rock has none, fill them in the scan");
  }

  std::string name_;
  const ScanOptions& options_;
  TriangleMesh welded_;  ///< before any mend, so that messages count what the file has
  Scan scan_;
};

}  // namespace

void ScanOptions::check() const {
  if (!(unit > 0.0) || !std::isfinite(unit)) {
    throw InputError("unit = " + std::to_string(unit) +
                     ": metres per unit of the file must be positive, for example 0.001 for mm");
  }
  if (up != "y" && up != "z") throw InputError("up = \"" + up + "\": must be \"y\" or \"z\"");
  if (!(weld_tolerance >= 0.0 && weld_tolerance <= 0.01)) {
    throw InputError("weld_tolerance = " + std::to_string(weld_tolerance) +
                     ": a share of the diagonal between 0 and 0.01 is needed");
  }
}

Scan read_scan(const std::filesystem::path& path, const ScanOptions& options) {
  options.check();
  return cleaned_scan(read_mesh(path), path.string(), options);
}

Scan cleaned_scan(TriangleMesh raw, const std::string& name, const ScanOptions& options) {
  options.check();
  for (std::size_t v = 0; v < raw.vertices.size(); ++v) {
    if (!raw.vertices[v].allFinite()) {
      throw GeometryError(name + ": vertex " + std::to_string(v + 1) + " is not a finite point");
    }
  }
  Scan scan = Cleaning(name, options).run(raw);
  for (Vec3& vertex : scan.mesh.vertices) {
    vertex *= options.unit;
    if (options.up == "y") vertex = Vec3(vertex.x(), -vertex.z(), vertex.y());
  }
  scan.inner_shell_volume *= std::pow(options.unit, 3);
  return scan;
}

}  // namespace clast
