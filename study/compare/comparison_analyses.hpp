#pragma once
/// The analyses of a comparison, each computed when it is first asked for and then kept: tables,
/// pages, maps and sentences take them from here.
#include <mutex>
#include <optional>
#include <vector>

#include "study/compare/answer.hpp"
#include "study/compare/barrier_passages.hpp"
#include "study/compare/design_effects.hpp"
#include "study/compare/ensemble_effects.hpp"
#include "study/compare/form_outcomes.hpp"
#include "study/compare/mass_mobility.hpp"
#include "study/compare/path_rasters.hpp"
#include "study/compare/profiles.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "study/compare/realisation_energies.hpp"
#include "study/compare/realisation_figures.hpp"
#include "study/compare/shape_trends.hpp"

namespace clast {

/// May be used from several threads at once.
class ComparisonAnalyses {
 public:
  /// Implicit, so that a comparison can be passed where a single analysis of it is read.
  /// @param comparison  lives longer than the analyses and does not change
  ComparisonAnalyses(const Comparison& comparison) : comparison_(comparison) {}

  const Comparison& comparison() const { return comparison_; }

  const Answer& answer() const { return kept(answer_, clast::answer); }
  const std::vector<RealisationPassages>& passages() const {
    return kept(passages_, barrier_passages);
  }
  const std::vector<DesignEffects>& effects() const { return kept(effects_, design_effects); }
  const std::vector<ParameterEffect>& ensemble() const { return kept(ensemble_, ensemble_effects); }
  const std::vector<OutcomeOfForms>& forms() const { return kept(forms_, outcomes_of_forms); }
  const std::vector<Mobility>& mobility() const { return kept(mobility_, mass_mobility); }
  const MapRasters& paths() const { return kept(paths_, path_rasters); }
  const std::vector<ProfileBin>& profiles() const { return kept(profiles_, clast::profiles); }
  const RealisationDeposits& deposits() const { return kept(deposits_, realisation_deposits); }
  const std::vector<RealisationEnergies>& energies() const {
    return kept(energies_, realisation_energies);
  }
  const FiguresOfFiles& figures() const {
    return kept(figures_,
                [this](const Comparison&) { return figures_of_files(deposits().realisations); });
  }
  const std::vector<ShapeTrends>& trends() const { return kept(trends_, shape_trends); }

 private:
  template <class Analysis>
  struct Kept {
    std::once_flag once;
    std::optional<Analysis> value;
  };

  template <class Analysis, class Compute>
  const Analysis& kept(Kept<Analysis>& of, const Compute& compute) const {
    std::call_once(of.once, [&] { of.value = compute(comparison_); });
    return *of.value;
  }

  const Comparison& comparison_;
  mutable Kept<Answer> answer_;
  mutable Kept<std::vector<RealisationPassages>> passages_;
  mutable Kept<std::vector<DesignEffects>> effects_;
  mutable Kept<std::vector<ParameterEffect>> ensemble_;
  mutable Kept<std::vector<OutcomeOfForms>> forms_;
  mutable Kept<std::vector<Mobility>> mobility_;
  mutable Kept<MapRasters> paths_;
  mutable Kept<std::vector<ProfileBin>> profiles_;
  mutable Kept<RealisationDeposits> deposits_;
  mutable Kept<std::vector<RealisationEnergies>> energies_;
  mutable Kept<FiguresOfFiles> figures_;
  mutable Kept<std::vector<ShapeTrends>> trends_;
};

}  // namespace clast
