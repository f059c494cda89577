#pragma once
/// Cache of the analyses of a comparison.
#include <mutex>
#include <optional>
#include <vector>

#include "study/compare/barrier_statistics.hpp"
#include "study/compare/deposit_quantities.hpp"
#include "study/compare/design_effects.hpp"
#include "study/compare/ensemble_effects.hpp"
#include "study/compare/form_outcomes.hpp"
#include "study/compare/key_results.hpp"
#include "study/compare/mass_mobility.hpp"
#include "study/compare/path_rasters.hpp"
#include "study/compare/profiles.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "study/compare/realisation_energies.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast {

/// Computes the analyses of a comparison, each at its first use. Thread-safe.
class ComparisonAnalyses {
 public:
  /// Stores a reference to the comparison. Implicit, so that a `Comparison` can be passed instead.
  /// @param comparison  must outlive this object and stay unchanged
  ComparisonAnalyses(const Comparison& comparison) : comparison_(comparison) {}

  const Comparison& comparison() const { return comparison_; }

  const KeyResults& key_results() const { return cached(answer_, clast::summarise_key_results); }
  const std::vector<RealisationCrossings>& barrier_crossings() const {
    return cached(passages_, collect_barrier_crossings);
  }
  const std::vector<DesignEffects>& design_effects() const {
    return cached(effects_, compute_design_effects);
  }
  const std::vector<ParameterEffect>& ensemble_effects() const {
    return cached(ensemble_, compute_ensemble_effects);
  }
  const std::vector<OutcomeByShape>& shape_outcomes() const {
    return cached(forms_, compute_outcomes_by_shape);
  }
  const std::vector<DepositMobility>& deposit_mobility() const {
    return cached(mobility_, compute_mass_mobility);
  }
  const MapRasterSet& path_rasters() const { return cached(paths_, compute_path_rasters); }
  const std::vector<ProfileBin>& profiles() const { return cached(profiles_, compute_profiles); }
  const DepositResults& deposit_results() const { return cached(deposits_, measure_deposits); }
  const std::vector<RealisationEnergies>& realisation_energies() const {
    return cached(energies_, collect_realisation_energies);
  }
  const DepositQuantityComparison& deposit_comparison() const {
    return cached(figures_, [this](const Comparison&) {
      return compare_deposit_quantities(deposit_results().realisations);
    });
  }
  const std::vector<ShapeTrends>& shape_trends() const {
    return cached(trends_, compute_shape_trends);
  }

 private:
  template <class Analysis>
  struct CachedAnalysis {
    std::once_flag once;
    std::optional<Analysis> value;
  };

  template <class Analysis, class Compute>
  const Analysis& cached(CachedAnalysis<Analysis>& of, const Compute& compute) const {
    std::call_once(of.once, [&] { of.value = compute(comparison_); });
    return *of.value;
  }

  const Comparison& comparison_;
  mutable CachedAnalysis<KeyResults> answer_;
  mutable CachedAnalysis<std::vector<RealisationCrossings>> passages_;
  mutable CachedAnalysis<std::vector<DesignEffects>> effects_;
  mutable CachedAnalysis<std::vector<ParameterEffect>> ensemble_;
  mutable CachedAnalysis<std::vector<OutcomeByShape>> forms_;
  mutable CachedAnalysis<std::vector<DepositMobility>> mobility_;
  mutable CachedAnalysis<MapRasterSet> paths_;
  mutable CachedAnalysis<std::vector<ProfileBin>> profiles_;
  mutable CachedAnalysis<DepositResults> deposits_;
  mutable CachedAnalysis<std::vector<RealisationEnergies>> energies_;
  mutable CachedAnalysis<DepositQuantityComparison> figures_;
  mutable CachedAnalysis<std::vector<ShapeTrends>> trends_;
};

}  // namespace clast
