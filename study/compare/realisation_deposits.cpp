#include "study/compare/realisation_deposits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/nice_number.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast {
namespace {

constexpr double kDepositCellFraction = 1.0 / 3.0;  ///< of the mean S
constexpr double kMaxDepositCells = 2000.0;         ///< along the longer side of all stops

double deposit_cell_size(const std::vector<const RunRow*>& deposited_blocks) {
  Bounds box;
  double sum = 0.0;
  for (const RunRow* row : deposited_blocks) {
    box.include(row->stop);
    sum += row->block->axes.S;
  }
  const double wanted = kDepositCellFraction * sum / static_cast<double>(deposited_blocks.size());
  const double longer = (box.high - box.low).head<2>().maxCoeff();
  return std::max(round_down_to_nice_number(wanted),
                  round_up_to_nice_number(longer / kMaxDepositCells));
}

/// The highest surface over the middle of each cell.
class Tops {
 public:
  /// @param origin  of local coordinates on the map
  Tops(double width, const Vec2& origin) : width_(width), origin_(origin) {}

  /// @param skin  in the local frame
  void include(const TriangleMesh& skin) {
    for (const TriangleMesh::Triangle& triangle : skin.triangles) {
      include(skin.vertices[triangle[0]], skin.vertices[triangle[1]], skin.vertices[triangle[2]]);
    }
  }

  Vec2 middle(const MapCell& cell) const {
    return width_ *
               Vec2(static_cast<double>(cell.second) + 0.5, static_cast<double>(cell.first) + 0.5) -
           origin_;
  }
  const std::map<MapCell, double>& heights() const { return heights_; }

 private:
  void include(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec2 pa = a.head<2>(), pb = b.head<2>(), pc = c.head<2>();
    const double whole = twice_area(pa, pb, pc);
    if (!(whole > 0.0)) return;  // faces down, or on edge
    const Vec2 low = pa.cwiseMin(pb).cwiseMin(pc) + origin_;
    const Vec2 high = pa.cwiseMax(pb).cwiseMax(pc) + origin_;
    const auto first = [&](double coordinate) {
      return static_cast<std::int64_t>(std::ceil(coordinate / width_ - 0.5));
    };
    const auto last = [&](double coordinate) {
      return static_cast<std::int64_t>(std::floor(coordinate / width_ - 0.5));
    };
    for (std::int64_t row = first(low.y()); row <= last(high.y()); ++row) {
      for (std::int64_t column = first(low.x()); column <= last(high.x()); ++column) {
        const Vec2 p = middle({row, column});
        const double of_a = twice_area(p, pb, pc), of_b = twice_area(p, pc, pa);
        const double of_c = whole - of_a - of_b;
        if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;
        const double height = (of_a * a.z() + of_b * b.z() + of_c * c.z()) / whole;
        const auto [at, is_new] = heights_.emplace(MapCell{row, column}, height);
        if (!is_new) at->second = std::max(at->second, height);
      }
    }
  }

  double width_;
  Vec2 origin_;
  std::map<MapCell, double> heights_;
};

RigidState first_state(const RunRow& row) { return row.record->start; }
RigidState last_state(const RunRow& row) { return row.record->result.final_state; }

/// Computes the height of blocks above the ground in each covered cell.
/// @param state  of the block of a row
std::map<MapCell, double> thicknesses(const CampaignResults& results, const TerrainSurface& ground,
                                      const std::vector<const RunRow*>& rows,
                                      RigidState (*state)(const RunRow&), double width) {
  Tops tops(width, results.frame.origin.head<2>());
  for (const RunRow* row : rows) {
    const SpheroPolyhedron shape = scaled(results.shapes[row->block->shape], row->block->scale);
    tops.include(transformed(rounded_surface_mesh(shape), state(*row).world_from_body()));
  }
  std::map<MapCell, double> thicknesses;
  for (const auto& [cell, top] : tops.heights()) {
    const Vec2 middle = tops.middle(cell);
    const std::optional<double> below = ground.height_at(middle.x(), middle.y(), top);
    if (below && top > *below) thicknesses[cell] = top - *below;
  }
  return thicknesses;
}

/// Adds up what is said of a realisation.
DepositMeasures deposit_of(std::uint32_t file, std::uint32_t realisation,
                           const std::vector<const RunRow*>& rows,
                           const std::vector<const RunRow*>& deposited_blocks) {
  DepositMeasures deposit;
  deposit.file = file;
  deposit.realisation = realisation;
  deposit.blocks = rows.size();
  deposit.deposited_blocks = deposited_blocks.size();
  for (const RunRow* row : rows) {
    deposit.left_terrain += row->record->result.stop_reason == StopReason::kLeftTerrain;
    if (!(deposit.crest.z() >= row->start.z())) deposit.crest = row->start;
  }
  if (deposited_blocks.empty()) return deposit;
  Vec3 first = Vec3::Zero(), now = Vec3::Zero();
  const auto distance = [&](const Vec3& place) { return (place - deposit.crest).head<2>().norm(); };
  for (const RunRow* row : deposited_blocks) {
    deposit.mass += row->block->mass;
    deposit.volume += row->block->volume;
    first += row->block->mass * row->start;
    now += row->block->mass * row->stop;
    if (!deposit.toe.allFinite() || distance(row->stop) > distance(deposit.toe)) {
      deposit.toe = row->stop;
    }
  }
  deposit.start_centre = first / deposit.mass;
  deposit.centre = now / deposit.mass;
  return deposit;
}

/// Sums over realisations, cell by cell.
class Layers {
 public:
  void include(const std::map<MapCell, double>& thicknesses) {
    ++realisations_;
    for (const auto& [cell, thickness] : thicknesses) {
      Sums& sums = cells_[cell];
      sums.thickness += thickness;
      sums.largest = std::max(sums.largest, thickness);
      ++sums.realisations;
    }
  }

  MapRasterSet rasters(double width) const {
    if (cells_.empty()) return {};
    std::vector<MapCell> covered;
    for (const auto& [cell, sums] : cells_) covered.push_back(cell);
    MapRasterSet rasters = rasterize_cells(
        covered, width,
        {{"Deposit_mean", "thickness of the deposit, mean over realisations, m", {}},
         {"Deposit_max", "largest thickness of the deposit, m", {}},
         {"Deposit_probability", "fraction of realisations with a block in the cell", {}}});
    const auto count = static_cast<double>(realisations_);
    for (const auto& [cell, sums] : cells_) {
      const std::size_t at = rasters.index(cell);
      const double values[] = {sums.thickness / count, sums.largest,
                               static_cast<double>(sums.realisations) / count};
      for (std::size_t i = 0; i < rasters.layers.size(); ++i) {
        rasters.layers[i].values[at] = static_cast<float>(values[i]);
      }
    }
    return rasters;
  }

 private:
  struct Sums {
    double thickness = 0.0, largest = 0.0;
    std::size_t realisations = 0;
  };
  std::map<MapCell, Sums> cells_;
  std::size_t realisations_ = 0;
};

}  // namespace

bool is_in_deposit(const Comparison& comparison, const RunRow& row) {
  if (row.record->result.stop_reason != StopReason::kRest) return false;
  const PersistentBlockRecord* stay =
      comparison.results[row.file].find_persistent_block(row.record->run);
  return stay && !std::isfinite(stay->removed_at);
}

double height_length_ratio(const Vec3& from, const Vec3& to) {
  return (from.z() - to.z()) / (to - from).head<2>().norm();
}

DepositResults measure_deposits(const Comparison& comparison) {
  DepositResults deposits;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<const RunRow*>> rows;
  std::vector<const RunRow*> all_lying;
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    if (!results.persistent_blocks) continue;
    rows[{row.file, row.record->run / results.persistent_blocks->blocks_per_realisation}].push_back(
        &row);
    if (is_in_deposit(comparison, row)) all_lying.push_back(&row);
  }
  if (rows.empty()) return deposits;
  const double width = all_lying.empty() ? 1.0 : deposit_cell_size(all_lying);
  Layers layers;
  std::optional<TerrainSurface> ground;
  std::optional<std::uint32_t> file_of_ground;
  for (const auto& [key, of_realisation] : rows) {
    const auto [file, realisation] = key;
    const CampaignResults& results = comparison.results[file];
    if (file_of_ground != file) {
      ground.emplace(make_terrain_surface(results.terrain));
      file_of_ground = file;
    }
    std::vector<const RunRow*> deposited_blocks;
    for (const RunRow* row : of_realisation) {
      if (is_in_deposit(comparison, *row)) deposited_blocks.push_back(row);
    }
    DepositMeasures deposit = deposit_of(file, realisation, of_realisation, deposited_blocks);
    const std::map<MapCell, double> cells =
        thicknesses(results, *ground, deposited_blocks, last_state, width);
    if (!deposited_blocks.empty()) deposit.area = deposit.bulk_volume = deposit.thickness = 0.0;
    for (const auto& [cell, thickness] : cells) {
      deposit.area += width * width;
      deposit.bulk_volume += width * width * thickness;
      deposit.thickness = std::max(deposit.thickness, thickness);
    }
    layers.include(cells);
    if (results.persistent_blocks->at_once) {
      deposit.start_volume = deposit.start_bulk_volume = 0.0;
      for (const RunRow* row : of_realisation) deposit.start_volume += row->block->volume;
      for (const auto& [cell, thickness] :
           thicknesses(results, *ground, of_realisation, first_state, width)) {
        deposit.start_bulk_volume += width * width * thickness;
      }
    }
    deposits.realisations.push_back(deposit);
  }
  for (const RealisationEnergies& energies : collect_realisation_energies(comparison)) {
    for (DepositMeasures& deposit : deposits.realisations) {
      if (deposit.file != energies.file || deposit.realisation != energies.realisation) continue;
      deposit.energy = compute_energy_fractions(energies.samples);
    }
  }
  deposits.rasters = layers.rasters(width);
  return deposits;
}

}  // namespace clast
