#pragma once
/// The tables of groups of runs and of what they ran with, as CSV text; columns in docs/formats.md.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/profiles.hpp"
#include "study/compare/realisation_deposits.hpp"
#include "study/compare/realisation_figures.hpp"

namespace clast {

std::string barriers_csv(const Comparison& comparison);
std::string deposits_csv(const Comparison& comparison);
/// A row for each difference.
std::string differences_csv(const Comparison& comparison);
/// A row for each group that has measured stops; the header alone without measured stops.
std::string measured_csv(const Comparison& comparison);
/// A row for each outcome and factor ; the header alone where there is none.
std::string effects_csv(const Comparison& comparison);
/// A row for each outcome and property of blocks; the header alone below four blocks.
std::string trends_csv(const Comparison& comparison);
/// A row for each outcome and form of files with six forms or more; else the header alone.
std::string responses_csv(const Comparison& comparison);
/// A row for each drawn ground parameter and outcome; the header alone without ensembles.
std::string ensemble_csv(const Comparison& comparison);
/// @param bins  `profiles` of the comparison
std::string profiles_csv(const Comparison& comparison, const std::vector<ProfileBin>& bins);
/// A row for each barrier and realisation; the header alone where no block stayed.
std::string passages_csv(const Comparison& comparison);
/// A row for each passage of them.
std::string passage_curves_csv(const Comparison& comparison);
/// A row for each instant of each realisation; the header alone where no block stayed.
std::string energies_csv(const Comparison& comparison);
/// A row for each realisation; the header alone where no block stayed.
/// @param deposits  `realisation_deposits` of the comparison
std::string realisations_csv(const RealisationDeposits& deposits);
/// A row for each file and figure of its realisations; the header alone where no block stayed.
/// @param figures  `figures_of_files` of the realisations
std::string realisation_figures_csv(const FiguresOfFiles& figures);
/// A row for each pair of files and figure.
std::string realisation_differences_csv(const FiguresOfFiles& figures);
/// A row for each file of realisations, file of single runs of the same blocks, and class.
std::string mobility_csv(const Comparison& comparison);
/// The ground parameters of every ground set, by zone.
std::string ground_sets_csv(const Comparison& comparison);

}  // namespace clast
