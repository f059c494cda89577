#include "reconstruct/detail/mesh_blocks.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/detail/choose_standing.hpp"
#include "reconstruct/detail/close_block.hpp"
#include "reconstruct/detail/cloud.hpp"
#include "reconstruct/detail/cut_out.hpp"
#include "reconstruct/detail/hole_loops.hpp"
#include "reconstruct/detail/holes.hpp"
#include "reconstruct/detail/pieces.hpp"
#include "reconstruct/detail/ragged_holes.hpp"
#include "reconstruct/detail/soup.hpp"
#include "reconstruct/detail/spikes.hpp"
#include "reconstruct/detail/surface_copy.hpp"
#include "reconstruct/detail/touching_sheets.hpp"

namespace clast::reconstruct_detail {

namespace {

/// An open surface of manifold edges that faces one way, and what was repaired to have it.
struct OpenSheet {
  TriangleMesh mesh;
  RepairReport repaired;
};

/// None when cleaning alone does, or has to say what is wrong.
std::optional<OpenSheet> open_sheet(const TriangleMesh& raw, const ScanOptions& options) {
  if (!all_within_reach(raw.vertices, options.unit)) return std::nullopt;
  const double tolerance = options.repair.weld_tolerance * bounds(raw).diagonal();
  TriangleMesh mesh = welded(raw, tolerance);
  RepairReport report;
  report.as_read = inspect(mesh);
  const double area = surface_area(mesh);
  const auto note = [&](DefectKind kind, std::size_t count, double dropped = 0.0,
                        std::optional<Vec3> where = {}, double size = 0.0) {
    if (count > 0) report.defects.push_back({kind, count, dropped / area, size, where});
  };
  const auto note_mended = [&](DefectKind kind, const Mended& mended) {
    note(kind, mended.count, mended.area, mended.place);
  };
  note(DefectKind::kNearVertices, welded(raw, 0.0).vertices.size() - mesh.vertices.size(), 0.0, {},
       tolerance * options.unit);
  note(DefectKind::kNoArea, raw.triangles.size() - mesh.triangles.size());
  const SoupMends mends = mend_soup(mesh, kFinArea);
  if (mesh.triangles.empty() || !mends.orientation.orientable) return std::nullopt;
  note_mended(DefectKind::kFolded, mends.folded);
  note_mended(DefectKind::kFin, mends.fins);
  note_mended(DefectKind::kTouchingEdge, mends.touching);
  const std::size_t turned = mends.orientation.turned + turn_hanging_scraps(mesh);
  if (turned > 0) {
    note(DefectKind::kMixedWinding, turned, 0.0, mesh.vertices[mends.orientation.first]);
  }
  const std::vector<FilledHole> ragged = close_ragged_holes(mesh);
  if (inspect(mesh).closed()) return std::nullopt;
  note_mended(DefectKind::kPinchedVertex, split_pinched_vertices(mesh));
  const Spikes spikes = flatten_spikes(mesh);
  note(DefectKind::kSpike, spikes.count, 0.0, spikes.place, spikes.highest * options.unit);
  report = with_fillings(std::move(report), ragged, surface_area(mesh), options.unit);
  return OpenSheet{std::move(mesh), std::move(report)};
}

/// Notes a copy of the surface that is dropped.
void note_copy(RepairReport& report, DoubledSurface doubled, const Piece& piece, double first_area,
               double unit) {
  doubled.offset *= unit;
  doubled.distance *= unit;
  doubled.volume_change *= unit * unit * unit;
  doubled.kept_volume *= unit * unit * unit;
  report.volume_below = std::max(report.volume_below, -doubled.volume_change);
  report.volume_above = std::max(report.volume_above, doubled.volume_change);
  report.doubled.push_back(doubled);
  report.defects.push_back(
      {DefectKind::kDoubleSheet, 1, piece.area / first_area, 0.0, piece.mesh.vertices[0]});
}

/// Drops copies of the first piece, once that is the best of them, and notes them.
/// @returns whether that piece is closed and nothing but copies and scraps is beside it: repair
/// does the rest
bool drop_copies(std::vector<Piece>& pieces, RepairReport& report, double unit) {
  put_best_copy_first(pieces);
  const TriangleMesh& first = pieces[0].mesh;
  const double diagonal = bounds(first).diagonal();
  const TriangleTree tree(first);
  bool others = false;
  std::vector<Piece> kept;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const bool scrap = pieces[i].area < kScrapArea * pieces[0].area;
    const auto copy = scrap ? std::nullopt : copy_of_surface(pieces[i].mesh, tree, diagonal);
    others |= !scrap && !copy;
    if (copy) {
      note_copy(report, described_copy(*copy, pieces[i], first, tree), pieces[i], pieces[0].area,
                unit);
    } else {
      kept.push_back(std::move(pieces[i]));
    }
  }
  pieces.resize(1);
  for (Piece& piece : kept) pieces.push_back(std::move(piece));
  return !others && inspect(pieces[0].mesh).closed();
}

/// Are all holes of the sheet so small that none is an unseen side?
bool has_only_small_holes(const TriangleMesh& sheet) {
  const double area = surface_area(sheet);
  for (const std::vector<std::uint32_t>& loop : boundary_loops(sheet)) {
    std::vector<Vec3> border;
    for (const std::uint32_t v : loop) border.push_back(sheet.vertices[v]);
    if (is_unseen_side(border, area)) return false;
  }
  return true;
}

/// Of the pieces of what stands at one place the first is the block. Said where another is no
/// scrap.
std::string left_out(const std::vector<Piece>& pieces) {
  if (pieces.size() < 2 || pieces[1].area <= kScrapArea * pieces[0].area) return "";
  return "another piece of the scan that stands close to this block, with " +
         with_digits(100.0 * pieces[1].area / pieces[0].area, 3) + " % of its area, near " +
         place(pieces[1].mesh.vertices[0]) +
         ", was left out; to have both, save each to a file of its own";
}

std::vector<FieldBlock> blocks_on_ground(const OpenSheet& sheet, const TriangleMesh& raw,
                                         const std::vector<Vec3>& points, const Ground& ground,
                                         const std::string& name, const FieldScanOptions& options) {
  const ChosenBlocks chosen = choose_standing(points, ground, name, options.split);
  const NearestPoints tree(points);
  std::vector<FieldBlock> blocks;
  for (const ChosenBlock& block : chosen.blocks) {
    std::vector<Piece> pieces = pieces_nearest_to(sheet.mesh, tree, block.numbers);
    if (pieces.empty()) refuse_bare_ground(name, 1.0);
    const std::string others = left_out(pieces);
    TriangleMesh rock = std::move(pieces.front().mesh);
    split_pinched_vertices(rock);
    blocks.push_back(close_block({.surface = std::move(rock),
                                  .ground = block.ground,
                                  .centre = block.centre,
                                  .raw = &raw,
                                  .repaired = sheet.repaired,
                                  .notes = chosen.notes},
                                 name, options));
    if (!others.empty()) blocks.back().scan.notes.push_back(others);
  }
  return blocks;
}

}  // namespace

std::vector<FieldBlock> mesh_blocks(const TriangleMesh& raw, const std::string& name,
                                    const FieldScanOptions& options) {
  std::optional<OpenSheet> sheet = open_sheet(raw, options.scan);
  if (!sheet) return {clean_block(raw, name, options)};
  std::vector<Piece> pieces = pieces_of(sheet->mesh);
  if (drop_copies(pieces, sheet->repaired, options.scan.unit)) {
    return {clean_block(raw, name, options)};
  }
  if (!sheet->repaired.doubled.empty()) {
    sheet->mesh = {};
    for (const Piece& piece : pieces) sheet->mesh = merged(std::move(sheet->mesh), piece.mesh);
  }
  if (options.find_ground && !has_only_small_holes(sheet->mesh)) {
    const std::vector<Vec3> points = points_over(sheet->mesh);
    if (const std::optional<Ground> ground = found_ground(points)) {
      return blocks_on_ground(*sheet, raw, points, *ground, name, options);
    }
  }
  double scraps = 0.0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].area > kScrapArea * pieces[0].area) {
      return {clean_block(raw, name, options)};  // says what is wrong
    }
    scraps += pieces[i].area / surface_area(sheet->mesh);
  }
  if (pieces.size() > 1) {
    sheet->repaired.defects.push_back(
        {DefectKind::kIsland, pieces.size() - 1, scraps, 0.0, pieces[1].mesh.vertices[0]});
  }
  return {close_block(
      {.surface = std::move(pieces[0].mesh), .raw = &raw, .repaired = std::move(sheet->repaired)},
      name, options)};
}

}  // namespace clast::reconstruct_detail
