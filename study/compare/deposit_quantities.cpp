#include "study/compare/deposit_quantities.hpp"

#include <cmath>

#include "core/angle.hpp"
#include "study/compare/differences.hpp"

namespace clast {
namespace {

constexpr Interval kPositive{0.0, INFINITY};
constexpr Interval kPossibleFraction{0.0, 1.0};

double plan_distance(const Vec3& from, const Vec3& to) { return (to - from).head<2>().norm(); }

DepositQuantitySummary figure_of_file(const std::vector<DepositMeasures>& realisations,
                                      std::uint32_t file, std::size_t figure) {
  DepositQuantitySummary found;
  found.file = file;
  found.quantity = figure;
  std::vector<double> values;
  for (const DepositMeasures& deposit : realisations) {
    if (deposit.file != file) continue;
    const double value = deposit_quantities()[figure].value(deposit);
    if (!std::isfinite(value)) continue;
    if (!(found.minimum <= value)) found.minimum = value;
    values.push_back(value);
  }
  found.summary = summarise_sample(values);
  found.interval = mean_interval(found.summary, deposit_quantities()[figure].possible_range);
  return found;
}

/// The pairs of files in each figure, uncorrected.
std::vector<DepositQuantityDifference> pairs_of(
    const std::vector<std::vector<DepositQuantitySummary>>& by_file) {
  std::vector<DepositQuantityDifference> pairs;
  for (std::size_t i = 0; i < by_file.size(); ++i) {
    for (std::size_t k = i + 1; k < by_file.size(); ++k) {
      for (std::size_t figure = 0; figure < deposit_quantities().size(); ++figure) {
        const DepositQuantitySummary &first = by_file[i][figure], &second = by_file[k][figure];
        if (first.summary.count == 0 || second.summary.count == 0) continue;
        pairs.push_back({welch_difference(first.summary, second.summary), first, second});
      }
    }
  }
  return pairs;
}

}  // namespace

const std::vector<DepositQuantity>& deposit_quantities() {
  using Row = DepositMeasures;
  const auto of_energy = [](auto value) {
    return [value](const Row& row) { return row.energy ? value(*row.energy) : NAN; };
  };
  static const std::vector<DepositQuantity> kFigures = {
      {"lying", "", "blocks in the deposit", 1,
       [](const Row& row) { return static_cast<double>(row.deposited_blocks); }, kPositive},
      {"lying_share", "", "fraction of blocks in the deposit", 3,
       [](const Row& row) {
         return static_cast<double>(row.deposited_blocks) / static_cast<double>(row.blocks);
       },
       kPossibleFraction},
      {"left_terrain", "", "blocks that left the terrain", 1,
       [](const Row& row) { return static_cast<double>(row.left_terrain); }, kPositive},
      {"volume_m3", "m\xC2\xB3", "volume of the blocks in the deposit", 2, &Row::volume, kPositive},
      {"centre_distance_m", "m", "distance of the centre of mass", 2,
       [](const Row& row) { return plan_distance(row.start_centre, row.centre); }, kPositive},
      {"centre_drop_m", "m", "drop of the centre of mass", 2,
       [](const Row& row) { return row.start_centre.z() - row.centre.z(); }},
      {"centre_drop_ratio", "", "drop / distance of the centre of mass", 3,
       [](const Row& row) { return height_length_ratio(row.start_centre, row.centre); }},
      {"toe_distance_m", "m", "distance L from crest to toe", 2,
       [](const Row& row) { return plan_distance(row.crest, row.toe); }, kPositive},
      {"toe_drop_m", "m", "drop H from crest to toe", 2,
       [](const Row& row) { return row.crest.z() - row.toe.z(); }},
      {"toe_drop_ratio", "", "H / L from crest to toe", 3,
       [](const Row& row) { return height_length_ratio(row.crest, row.toe); }},
      {"travel_angle_deg", "\xC2\xB0", "travel angle", 1,
       [](const Row& row) {
         return kDegreesPerRadian * std::atan(height_length_ratio(row.crest, row.toe));
       }},
      {"area_m2", "m\xC2\xB2", "area", 1, &Row::area, kPositive},
      {"bulk_volume_m3", "m\xC2\xB3", "bulk volume", 2, &Row::bulk_volume, kPositive},
      {"solid_share", "", "rock fraction of the bulk volume", 3,
       [](const Row& row) { return row.volume / row.bulk_volume; }, kPositive},
      {"first_solid_share", "", "rock fraction of the bulk volume at the start", 3,
       [](const Row& row) { return row.start_volume / row.start_bulk_volume; }, kPositive},
      {"mean_thickness_m", "m", "mean thickness", 2,
       [](const Row& row) { return row.bulk_volume / row.area; }, kPositive},
      {"thickness_m", "m", "largest thickness", 2, &Row::thickness, kPositive},
      {"largest_kinetic_j", "J", "largest total kinetic energy of all blocks", 0,
       of_energy([](const EnergyFractions& energy) { return energy.largest_kinetic; }), kPositive},
      {"dissipated_by_friction", "", "fraction dissipated by friction", 3,
       of_energy([](const EnergyFractions& energy) {
         return energy.on_ground.friction + energy.between_blocks.friction;
       }),
       kPossibleFraction},
      {"dissipated_by_rolling", "", "fraction dissipated by rolling resistance", 3,
       of_energy([](const EnergyFractions& energy) {
         return energy.on_ground.rolling + energy.between_blocks.rolling;
       }),
       kPossibleFraction},
      {"dissipated_between_blocks", "", "fraction dissipated between blocks", 3,
       of_energy([](const EnergyFractions& energy) { return energy.between_blocks.sum(); }),
       kPossibleFraction}};
  return kFigures;
}

DepositQuantityComparison compare_deposit_quantities(
    const std::vector<DepositMeasures>& realisations) {
  DepositQuantityComparison found;
  std::vector<std::vector<DepositQuantitySummary>> by_file;
  for (const DepositMeasures& deposit : realisations) {
    if (!by_file.empty() && by_file.back().front().file == deposit.file) continue;
    std::vector<DepositQuantitySummary>& of_file = by_file.emplace_back();
    for (std::size_t figure = 0; figure < deposit_quantities().size(); ++figure) {
      of_file.push_back(figure_of_file(realisations, deposit.file, figure));
      if (of_file.back().summary.count > 0) found.files.push_back(of_file.back());
    }
  }
  if (by_file.size() > kMaxComparedGroups) return found;
  found.differences = pairs_of(by_file);
  correct_multiple_tests(found.differences);
  return found;
}

}  // namespace clast
