#include "study/compare/realisation_energies.hpp"

#include <algorithm>
#include <map>

namespace clast {
namespace {

constexpr std::size_t kEnergyCurvePoints = 300;

/// Goes along the samples of one realisation.
class Along {
 public:
  Along(const RealisationEnergies& energies, const EnergyValue& value)
      : samples_(energies.samples), value_(value) {}

  /// @param time  not before that of the last call
  double at(double time) {
    while (next_ < samples_.size() && samples_[next_].time <= time) ++next_;
    if (next_ == 0) return value_(samples_.front());
    const EnergySample& before = samples_[next_ - 1];
    if (next_ == samples_.size()) return value_(before);
    const EnergySample& after = samples_[next_];
    const double share = (time - before.time) / (after.time - before.time);
    return (1.0 - share) * value_(before) + share * value_(after);
  }

 private:
  const std::vector<EnergySample>& samples_;
  const EnergyValue& value_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<RealisationEnergies> collect_realisation_energies(const Comparison& comparison) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, RealisationEnergies> found;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (const EnergyRecord& record : results.energies) {
      const std::uint32_t realisation = record.run / results.runs_per_realisation();
      RealisationEnergies& energies = found[{file, realisation}];
      energies.file = file;
      energies.realisation = realisation;
      energies.samples.push_back(record.energy);
    }
  }
  std::vector<RealisationEnergies> all;
  for (auto& [key, energies] : found) all.push_back(std::move(energies));
  return all;
}

RealisationCurve compute_energy_curve(const std::vector<const RealisationEnergies*>& realisations,
                                      const EnergyValue& value) {
  RealisationCurve curve;
  double last = 0.0;
  std::vector<Along> along;
  for (const RealisationEnergies* one : realisations) {
    last = std::max(last, one->samples.back().time);
    along.emplace_back(*one, value);
  }
  if (!(last > 0.0)) return curve;
  std::vector<double> values(realisations.size());
  for (std::size_t i = 0; i < kEnergyCurvePoints; ++i) {
    const double time = last * static_cast<double>(i) / static_cast<double>(kEnergyCurvePoints - 1);
    for (std::size_t k = 0; k < along.size(); ++k) values[k] = along[k].at(time);
    curve.time.push_back(time);
    curve.mean.push_back(summarise_sample(values).mean);
    curve.minimum.push_back(*std::min_element(values.begin(), values.end()));
    curve.maximum.push_back(*std::max_element(values.begin(), values.end()));
  }
  return curve;
}

EnergyFractions compute_energy_fractions(const std::vector<EnergySample>& samples) {
  EnergyFractions shares;
  const auto share_of = [lost =
                             samples.back().on_ground.sum() + samples.back().between_bodies.sum()](
                            const DissipatedEnergy& part) -> DissipatedEnergy {
    if (!(lost > 0.0)) return {NAN, NAN, NAN};
    return {part.normal / lost, part.friction / lost, part.rolling / lost};
  };
  shares.on_ground = share_of(samples.back().on_ground);
  shares.between_blocks = share_of(samples.back().between_bodies);
  shares.largest_kinetic = 0.0;
  for (const EnergySample& sample : samples) {
    shares.largest_kinetic =
        std::max(shares.largest_kinetic, sample.translational + sample.rotational);
  }
  return shares;
}

}  // namespace clast
