#include "study/calibrate/calibration_study.hpp"

#include <algorithm>
#include <set>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "study/calibrate/detail/study_reading.hpp"
#include "study/calibrate/observation_reading.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

using namespace study_detail;
namespace {

Kernel kernel_named(const std::string& word) {
  return word == "squared-exponential" ? Kernel::kSquaredExponential : Kernel::kMatern52;
}

const MemberTable<CalibrationDesign>& design_keys() {
  using Design = CalibrationDesign;
  static const MemberTable<Design> keys(
      {.name = "design", .meaning = "Settings of the calibration"},
      {{"members", "", "number of simulated parameter sets", count_format(8, 4096),
        &Design::member_count},
       {"releases", "", "number of runs of each member at each site",
        count_format(kMinSelectedOutcomes, 100'000), &Design::releases_per_member},
       {"seed", "", "seed of all random draws", seed_format(), &Design::seed},
       {"draws", "", "number of draws from the posterior", count_format(100, 100'000),
        &Design::draw_count},
       {"kernel", "", "correlation function of the surrogates",
        word_format({"matern-5/2", "squared-exponential"}), &kernel_named, &Design::kernel}});
  return keys;
}

const MemberTable<CalibrationSite>& site_keys() {
  static const MemberTable<CalibrationSite> keys(
      {"site", "A site at which blocks were released", KeyTable::Repeat::kEither, {}, true},
      {{"name", "", "name of the site", required_format("a text in quotes", text_format()),
        &CalibrationSite::name},
       {"campaign", "", "campaign file, with [run] downslope",
        required_format("a campaign file", text_format())}});
  return keys;
}

/// Names of parameters, with any name in place of that of a zone or class.
std::string parameter_pattern() {
  std::string names;
  for (const auto& [name, range] : calibratable_parameters()) {
    names += names.empty() ? "" : "|";
    for (const char letter : name) names += letter == '.' ? "\\." : std::string(1, letter);
  }
  for (const std::string any : {"ZONE", "CLASS"}) {
    for (std::size_t at; (at = names.find(any)) != std::string::npos;) {
      names.replace(at, any.size(), ".+");
    }
  }
  return "^(" + names + ")$";
}

/// Holds the ranges of all parameters.
NumberRange any_parameter() {
  NumberRange all{0.0, 0.0};
  for (const auto& [name, range] : calibratable_parameters()) {
    all.low = std::min(all.low, range.low);
    all.high = std::max(all.high, range.high);
  }
  return all;
}

bool is_logarithmic(const std::string& scale) { return scale == "log"; }

const MemberTable<UnknownParameter>& unknown_keys() {
  static const MemberTable<UnknownParameter> keys(
      {"unknown",
       "An unknown parameter, with one value for all sites that have it",
       KeyTable::Repeat::kEither,
       {},
       true},
      {{"parameter", "",
        "name of the parameter, such as ground.ZONE.friction, release.height_m or "
        "blocks.mass_median_kg",
        required_format("such as \"ground.ZONE.friction\"", pattern_format(parameter_pattern())),
        &UnknownParameter::parameter},
       {"range", "", "range of the parameter, [low, high]",
        required_format("two numbers, [low, high]",
                        list_format(number_format(any_parameter()), 2, 2))},
       {"scale", "", "prior: uniform in the value or in its logarithm",
        word_format({"linear", "log"}), &is_logarithmic, &UnknownParameter::logarithmic}});
  return keys;
}

CalibrationDesign read_design(const TomlTable& top) {
  CalibrationDesign design;
  for (const DeclaredTable& table : find_tables(top, design_keys())) {
    design_keys().read(table, design);
  }
  return design;
}

/// Refuses campaigns that a calibration cannot simulate.
void check_site(const TomlTable& table, const Campaign& campaign) {
  const auto refuse = [&](const std::string& why) { table.refuse("campaign", why); };
  if (campaign.persistent_blocks) {
    refuse("its blocks are persistent; a calibration needs single releases");
  }
  if (!campaign.downslope) {
    refuse("has no [run] downslope, along which positions of stops are measured; add it");
  }
  if (!campaign.groups.empty()) {
    refuse("has block groups with their own ground; leave [[block_group]] out");
  }
}

std::vector<CalibrationSite> read_sites(const TomlTable& top) {
  std::vector<CalibrationSite> sites;
  for (const DeclaredTable& table : find_tables(top, site_keys())) {
    CalibrationSite site;
    site_keys().read(table, site);
    check_unique_name(table, site.name, sites, "site");
    site.campaign = read_campaign(*table.value<std::filesystem::path>("campaign"));
    check_site(table, site.campaign);
    site.campaign.ensemble = {};
    site.campaign.trajectory_interval = 0.0;
    sites.push_back(std::move(site));
  }
  if (sites.empty()) {
    throw InputError(top.file() +
                     ": no site: write a table [[site]] with name and campaign for each site");
  }
  return sites;
}

UnknownParameter read_unknown(const DeclaredTable& table) {
  UnknownParameter unknown;
  unknown_keys().read(table, unknown);
  const NumberRange allowed =
      table.run_check("parameter", [&] { return calibratable_range(unknown.parameter); });
  const TomlNode& range = *table.find("range");
  const std::vector<double> ends =
      table.read_numbers("range", range, 2, 2, "two numbers, [low, high]", allowed);
  unknown.low = ends[0];
  unknown.high = ends[1];
  if (!(unknown.low < unknown.high)) {
    table.refuse("range", range, "the lower end must come first");
  }
  if (unknown.logarithmic && !(unknown.low > 0.0)) {
    table.refuse("scale", "a logarithmic scale needs a range above 0");
  }
  return unknown;
}

std::vector<UnknownParameter> read_unknowns(const TomlTable& top,
                                            const std::vector<CalibrationSite>& sites) {
  std::vector<UnknownParameter> unknowns;
  for (const DeclaredTable& table : find_tables(top, unknown_keys())) {
    UnknownParameter unknown = read_unknown(table);
    const TomlNode& name = *table.find("parameter");
    for (const UnknownParameter& other : unknowns) {
      if (other.parameter == unknown.parameter) {
        table.refuse("parameter", name, "is an unknown already");
      }
    }
    if (std::none_of(sites.begin(), sites.end(), [&](const CalibrationSite& site) {
          return has_parameter(site.campaign, unknown.parameter);
        })) {
      table.refuse("parameter", name, explain_missing_parameter(unknown.parameter));
    }
    unknowns.push_back(std::move(unknown));
  }
  if (unknowns.empty()) {
    throw InputError(top.file() +
                     ": no unknown: write a table [[unknown]] with parameter and range for each");
  }
  if (unknowns.size() > kMaxSobolDimensions) {
    throw InputError(top.file() + ": has " + std::to_string(unknowns.size()) +
                     " unknowns; at most " + std::to_string(kMaxSobolDimensions) +
                     " can be calibrated at once");
  }
  return unknowns;
}

/// Parameters that a campaign knows only as a distribution would vary from run to run unseen.
void check_certain(const CalibrationStudy& study) {
  for (CalibrationSite site : study.sites) {
    for (const UnknownParameter& unknown : study.unknowns) {
      if (has_parameter(site.campaign, unknown.parameter)) {
        set_parameter(site.campaign, unknown.parameter, unknown.low);
      }
    }
    for (const auto& [zone, table] : site.campaign.ground) {
      for (const GroundParameterField& field : ground_parameter_fields()) {
        const std::optional<Distribution>& asked = table.*field.distribution;
        if (!asked || asked->is_fixed()) continue;
        throw InputError(study.file.string() + ": ground." + zone + "." + field.name +
                         " has a distribution in the campaign of site " + site.name +
                         "; make it an [[unknown]], or give it a value there");
      }
    }
  }
}

/// Shares that are unknown leave some to other classes, wherever in their ranges they are.
void check_unknown_shares(const CalibrationStudy& study) {
  for (const CalibrationSite& site : study.sites) {
    std::set<std::string> classes;
    double maximum = 0.0;
    for (const UnknownParameter& unknown : study.unknowns) {
      const std::string name = class_of_fraction_parameter(unknown.parameter);
      if (name.empty() || !has_parameter(site.campaign, unknown.parameter)) continue;
      classes.insert(name);
      maximum += unknown.high;
    }
    if (classes.empty()) continue;
    if (classes.size() == site.campaign.blocks.draw->shares.size()) {
      throw InputError(
          study.file.string() + ": every fraction of site " + site.name +
          " is an unknown, but their sum is 1; leave out one class, which gets the remainder");
    }
    if (maximum > 1.0) {
      throw InputError(study.file.string() + ": the unknown fractions of site " + site.name +
                       " add up to " + format_significant(maximum, 6) +
                       " at the upper ends of their ranges; lower these until it is 1 at most");
    }
  }
}

}  // namespace

const std::vector<KeyTable>& calibration_key_tables() {
  static const std::vector<KeyTable> tables = {design_keys(), site_keys(), unknown_keys(),
                                               observation_keys()};
  return tables;
}

std::vector<std::vector<double>> CalibrationDesign::sobol_points(std::size_t unknown_count) const {
  SobolSequence sequence(unknown_count, seed);
  std::vector<std::vector<double>> all;
  for (std::uint32_t member = 0; member < member_count; ++member)
    all.push_back(sequence.next_point());
  return all;
}

std::vector<double> CalibrationStudy::values(const std::vector<double>& shares) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    all.push_back(unknowns[i].prior_quantile(shares[i]));
  return all;
}

std::size_t CalibrationStudy::statistic_count() const {
  std::size_t count = 0;
  for (const Observation& observation : observations) count += observation.statistics.size();
  return count;
}

std::uint64_t CalibrationStudy::run_count() const {
  return std::uint64_t{sites.size()} * design.member_count * design.releases_per_member;
}

namespace study_detail {

CalibrationStudy read_study_by_parts(const std::filesystem::path& file, const PartReader& read) {
  CalibrationStudy study;
  study.file = file;
  TomlNode root;
  const bool is_toml = read([&] {
    study.text = read_text_file(file);
    study.sha256 = sha256(study.text);
    root = parse_toml(study.text, file.string());
  });
  if (!is_toml) return study;
  const TomlTable top = parse_top_level_table(root, file, calibration_key_tables(), read);
  read([&] { study.design = read_design(top); });
  if (!read([&] { study.sites = read_sites(top); })) return study;
  if (read([&] { study.unknowns = read_unknowns(top, study.sites); })) {
    read([&] { check_certain(study); });
    read([&] { check_unknown_shares(study); });
  }
  read([&] { study.observations = read_observations(top, study.sites); });
  return study;
}

}  // namespace study_detail

CalibrationStudy read_calibration_study(const std::filesystem::path& file) {
  return read_study_by_parts(file, read_without_catching);
}

bool is_calibration_study(const std::filesystem::path& file) {
  try {
    const TomlNode root = parse_toml(read_text_file(file), file.string());
    return root.find("site") || root.find("unknown") || root.find("observation");
  } catch (const Error&) {
    return false;
  }
}

}  // namespace clast
