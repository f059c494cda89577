#include <algorithm>
#include <cmath>
#include <functional>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/realisation_traces.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"
#include "report/text/plain_numbers.hpp"
#include "report/text/subject_words.hpp"
#include "study/compare/realisation_energies.hpp"

namespace clast::report_detail {
namespace {

using EnergyRealisations = std::vector<const RealisationEnergies*>;

/// Uses of the energy, in the order of stacking in charts.
struct Use {
  const char* words;
  const char* colour;
  const char* blend;  ///< that the colour is mixed with: paler between blocks
  double DissipatedEnergy::*part;
  DissipatedEnergy EnergySample::*place;
  DissipatedEnergy EnergyFractions::*share;
};

constexpr double kPaler = 0.5;

const std::vector<Use>& uses() {
  static const std::vector<Use> kUses = [] {
    std::vector<Use> uses;
    const auto add = [&](const char* ground, const char* blocks, std::size_t colour,
                         double DissipatedEnergy::*part) {
      uses.push_back({ground, kDataColours[colour], kDataColours[colour], part,
                      &EnergySample::on_ground, &EnergyFractions::on_ground});
      uses.push_back({blocks, kDataColours[colour], "#ffffff", part, &EnergySample::between_bodies,
                      &EnergyFractions::between_blocks});
    };
    add("friction on the ground", "friction between blocks", 0, &DissipatedEnergy::friction);
    add("normal forces on the ground", "normal forces between blocks", 1,
        &DissipatedEnergy::normal);
    add("rolling resistance on the ground", "rolling resistance between blocks", 2,
        &DissipatedEnergy::rolling);
    return uses;
  }();
  return kUses;
}

double kinetic(const EnergySample& sample) { return sample.translational + sample.rotational; }

std::vector<EnergyRealisations> energies_by_file(const std::vector<RealisationEnergies>& all) {
  std::vector<EnergyRealisations> files;
  for (const RealisationEnergies& one : all) {
    if (files.empty() || files.back().front()->file != one.file) files.emplace_back();
    files.back().push_back(&one);
  }
  return files;
}

std::string of_file(const Comparison& comparison, std::uint32_t file) {
  return has_several_files(comparison) ? ", " + results_file_label(comparison, file) : "";
}

/// Draws the energy of a mass against time: its uses stacked, the kinetic energy on top.
std::string uses_chart(const Comparison& comparison, const EnergyRealisations& realisations) {
  std::vector<ChartTrace> traces;
  std::vector<double> below;
  const auto add = [&](const std::string& words, const std::string& colour,
                       const EnergyValue& value) {
    const RealisationCurve curve = compute_energy_curve(
        realisations,
        [&](const EnergySample& sample) { return kKilojoulesPerJoule * value(sample); });
    if (below.empty()) {
      below.assign(curve.time.size(), 0.0);
      ChartTrace zero{words, colour, "", ChartTrace::Kind::kLine, curve.time, below};
      zero.named = false;
      traces.push_back(std::move(zero));
    }
    for (std::size_t i = 0; i < below.size(); ++i) below[i] += curve.mean[i];
    ChartTrace top{words, colour, "", ChartTrace::Kind::kLine, curve.time, below};
    top.filled = true;
    traces.push_back(std::move(top));
  };
  for (const Use& use : uses()) {
    add(use.words, mix_colours(use.colour, use.blend, kPaler),
        [&](const EnergySample& sample) { return sample.*use.place.*use.part; });
  }
  add("kinetic energy", "#555555", kinetic);
  return draw_plotly_chart(
      {"Dissipated and kinetic energy against time" +
           of_file(comparison, realisations.front()->file),
       "time since the first release, s",
       realisations.size() > 1 ? "energy, mean of realisations, kJ" : "energy, kJ"},
      traces);
}

std::string kinetic_chart(const Comparison& comparison,
                          const std::vector<EnergyRealisations>& masses) {
  std::vector<ChartTrace> traces;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const std::string name =
        (has_several_files(comparison) ? results_file_label(comparison, masses[i].front()->file)
                                       : "mean") +
        " of " + format_count(masses[i].size(), "realisation");
    add_realisation_curve(traces, name, series_colour(i), ChartTrace::Kind::kLine,
                          compute_energy_curve(masses[i],
                                               [](const EnergySample& sample) {
                                                 return kKilojoulesPerJoule * kinetic(sample);
                                               }),
                          masses[i].size());
  }
  return draw_plotly_chart({"Kinetic energy of all blocks together",
                            "time since the first release, s", "kinetic energy, kJ"},
                           traces);
}

std::string shares_table(const Comparison& comparison,
                         const std::vector<EnergyRealisations>& files) {
  std::vector<std::string> heads = {"dissipated by"};
  for (const EnergyRealisations& realisations : files) {
    const std::string file = has_several_files(comparison)
                                 ? "file " + std::to_string(realisations.front()->file + 1) + ": "
                                 : "";
    for (const char* head : {"mean, kJ", "fraction", "smallest fraction", "largest fraction"}) {
      heads.push_back(file + head);
    }
  }
  HtmlTable table(heads, 1);
  const auto row = [&](const std::string& words, const EnergyValue& energy,
                       const std::function<double(const EnergyFractions&)>& share) {
    std::vector<std::string> cells = {words};
    for (const EnergyRealisations& realisations : files) {
      std::vector<double> energies, shares;
      for (const RealisationEnergies* one : realisations) {
        energies.push_back(kKilojoulesPerJoule * energy(one->samples.back()));
        shares.push_back(share(compute_energy_fractions(one->samples)));
      }
      const SampleSummary summary = summarise_sample(shares);
      cells.push_back(format_significant_digits(summarise_sample(energies).mean));
      cells.push_back(format_percent(summary.mean));
      cells.push_back(format_percent(*std::min_element(shares.begin(), shares.end())));
      cells.push_back(format_percent(summary.max));
    }
    table.row(std::move(cells));
  };
  for (const Use& use : uses()) {
    row(
        use.words, [&](const EnergySample& sample) { return sample.*use.place.*use.part; },
        [&](const EnergyFractions& shares) { return shares.*use.share.*use.part; });
  }
  row(
      "all between blocks", [](const EnergySample& sample) { return sample.between_bodies.sum(); },
      [](const EnergyFractions& shares) { return shares.between_blocks.sum(); });
  return table.html();
}

/// "53 % of what was dissipated was friction, 31 % ...": means over the realisations of a file.
std::string describe_dissipation(const Comparison& comparison,
                                 const EnergyRealisations& realisations) {
  const auto mean = [&](const std::function<double(const EnergyFractions&)>& share) {
    std::vector<double> shares;
    for (const RealisationEnergies* one : realisations) {
      shares.push_back(share(compute_energy_fractions(one->samples)));
    }
    return summarise_sample(shares).mean;
  };
  const auto by = [&](double DissipatedEnergy::*part) {
    return mean([part](const EnergyFractions& shares) {
      return shares.on_ground.*part + shares.between_blocks.*part;
    });
  };
  const double between =
      mean([](const EnergyFractions& shares) { return shares.between_blocks.sum(); });
  if (!std::isfinite(between)) return "";
  const std::string of = has_several_files(comparison)
                             ? " of " + results_file_label(comparison, realisations.front()->file)
                             : "";
  return format_paragraph(
      "Of the energy dissipated in contacts" + of + ", friction took " +
      format_percentage(by(&DissipatedEnergy::friction)) + ", normal forces " +
      format_percentage(by(&DissipatedEnergy::normal)) + " and rolling resistance " +
      format_percentage(by(&DissipatedEnergy::rolling)) + "; " + format_percentage(between) +
      " was dissipated in contacts between blocks, the rest in contacts with the ground.");
}

}  // namespace

std::string format_energy_section(const ComparisonAnalyses& analyses) {
  const std::vector<EnergyRealisations> files = energies_by_file(analyses.realisation_energies());
  if (files.empty()) return "";
  const Comparison& comparison = analyses.comparison();
  std::vector<EnergyRealisations> masses;
  std::string body;
  for (const EnergyRealisations& realisations : files) {
    body += describe_dissipation(comparison, realisations);
    if (comparison.results[realisations.front()->file].persistent_blocks->at_once) {
      masses.push_back(realisations);
    }
  }
  if (!masses.empty()) body += kinetic_chart(comparison, masses);
  for (const EnergyRealisations& realisations : masses)
    body += uses_chart(comparison, realisations);
  return format_section(
      "Dissipation of energy",
      body + format_folded_section(
                 "Energy dissipated by each mechanism",
                 format_paragraph("Energies are totals at the end of each realisation, averaged "
                                  "over the realisations. Fractions refer to the energy dissipated "
                                  "in contacts; their mean, smallest and largest values are over "
                                  "the realisations. Energies against time are in energies.csv.") +
                     shares_table(comparison, files)));
}

}  // namespace clast::report_detail
