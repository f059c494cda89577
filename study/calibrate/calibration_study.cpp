#include "study/calibrate/calibration_study.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "core/listed.hpp"
#include "core/number_text.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "study/calibrate/detail/study_reading.hpp"
#include "study/calibrate/observation_reading.hpp"
#include "study/calibrate/study_keys.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

using namespace study_detail;
namespace {

CalibrationDesign read_design(const TomlTable& top) {
  CalibrationDesign design;
  const TomlNode* node = top.find("design");
  if (!node) return design;
  const StudyTable table(*node, top.file(), "design");
  design.members = static_cast<std::uint32_t>(table.count_of("members").value_or(design.members));
  design.releases =
      static_cast<std::uint32_t>(table.count_of("releases").value_or(design.releases));
  design.seed = table.count_of("seed").value_or(design.seed);
  design.draws = table.count_of("draws").value_or(design.draws);
  if (table.choice_of("kernel") == "squared-exponential") {
    design.kernel = Kernel::kSquaredExponential;
  }
  return design;
}

/// What the simulations of a calibration can't do.
void check_site(const TomlTable& table, const TomlNode& node, const Campaign& campaign) {
  const auto refuse = [&](const std::string& why) { table.refuse("campaign", node, why); };
  if (campaign.stay) {
    refuse("its blocks stay where they stop; a calibration needs single releases");
  }
  if (!campaign.downslope) {
    refuse("has no [run] downslope, along which places of stops are counted; add it");
  }
  if (!campaign.groups.empty()) {
    refuse("has block groups with ground of their own; leave [[block_group]] out");
  }
}

std::vector<CalibrationSite> read_sites(const TomlTable& top) {
  std::vector<CalibrationSite> sites;
  for (const TomlNode* node : tables_of(top, "site")) {
    const StudyTable table(*node, top.file(), "site");
    table.required("name", "a text in quotes");
    const TomlNode& file = table.required("campaign", "a campaign file");
    table.text("campaign");
    CalibrationSite site{*table.text("name"), {}};
    for (const CalibrationSite& other : sites) {
      if (other.name == site.name) {
        table.refuse("name", *table.find("name"), "another site has this name");
      }
    }
    site.campaign = read_campaign(input_file(table, "campaign", file));
    check_site(table, file, site.campaign);
    site.campaign.ensemble = {};
    site.campaign.trajectory_interval = 0.0;
    sites.push_back(std::move(site));
  }
  if (sites.empty()) {
    throw InputError(top.file() +
                     ": no site: write a table [[site]] with name and campaign of each place");
  }
  return sites;
}

Unknown read_unknown(const StudyTable& table) {
  Unknown unknown;
  const TomlNode& name = table.required("parameter", "such as \"ground.ZONE.friction\"");
  unknown.parameter = *table.text("parameter");
  NumberRange allowed{0.0, 0.0};
  try {
    allowed = parameter_range(unknown.parameter).allowed;
  } catch (const InputError& error) {
    table.refuse("parameter", name, error.what());
  }
  const TomlNode& range = table.required("range", "two numbers, [low, high]");
  const std::vector<double> ends =
      table.numbers("range", range, 2, 2, "two numbers, [low, high]", allowed);
  unknown.low = ends[0];
  unknown.high = ends[1];
  if (!(unknown.low < unknown.high)) {
    table.refuse("range", range, "the lower end must come first");
  }
  unknown.logarithmic = table.choice_of("scale") == "log";
  if (unknown.logarithmic && !(unknown.low > 0.0)) {
    table.refuse("scale", *table.find("scale"), "a logarithm needs a range above 0");
  }
  return unknown;
}

std::vector<Unknown> read_unknowns(const TomlTable& top,
                                   const std::vector<CalibrationSite>& sites) {
  std::vector<Unknown> unknowns;
  for (const TomlNode* node : tables_of(top, "unknown")) {
    const StudyTable table(*node, top.file(), "unknown");
    Unknown unknown = read_unknown(table);
    const TomlNode& name = *table.find("parameter");
    for (const Unknown& other : unknowns) {
      if (other.parameter == unknown.parameter) {
        table.refuse("parameter", name, "is an unknown already");
      }
    }
    if (std::none_of(sites.begin(), sites.end(), [&](const CalibrationSite& site) {
          return has_parameter(site.campaign, unknown.parameter);
        })) {
      table.refuse("parameter", name, why_no_campaign_has(unknown.parameter));
    }
    unknowns.push_back(std::move(unknown));
  }
  if (unknowns.empty()) {
    throw InputError(top.file() +
                     ": no unknown: write a table [[unknown]] with parameter and range of each");
  }
  if (unknowns.size() > kMostSobolDimensions) {
    throw InputError(top.file() + ": has " + std::to_string(unknowns.size()) +
                     " unknowns; at most " + std::to_string(kMostSobolDimensions) +
                     " can be found at once");
  }
  return unknowns;
}

std::vector<std::string> study_table_names() {
  std::vector<std::string> names;
  for (const KeyTable& table : calibration_tables()) names.push_back(table.name);
  return names;
}

/// Parameters that a campaign knows only as a distribution would vary from run to run unseen.
void check_certain(const CalibrationStudy& study) {
  for (CalibrationSite site : study.sites) {
    for (const Unknown& unknown : study.unknowns) {
      if (has_parameter(site.campaign, unknown.parameter)) {
        set_parameter(site.campaign, unknown.parameter, unknown.low);
      }
    }
    for (const auto& [zone, table] : site.campaign.ground) {
      for (const GroundField& field : ground_fields()) {
        const std::optional<Uncertain>& asked = table.*field.asked;
        if (!asked || asked->fixed()) continue;
        throw InputError(study.file.string() + ": ground." + zone + "." + field.name +
                         " is uncertain in the campaign of site " + site.name +
                         "; make it an [[unknown]], or give it a value there");
      }
    }
  }
}

/// Shares that are unknown leave some to other classes, wherever in their ranges they are.
void check_unknown_shares(const CalibrationStudy& study) {
  for (const CalibrationSite& site : study.sites) {
    std::set<std::string> classes;
    double most = 0.0;
    for (const Unknown& unknown : study.unknowns) {
      const std::string name = share_class(unknown.parameter);
      if (name.empty() || !has_parameter(site.campaign, unknown.parameter)) continue;
      classes.insert(name);
      most += unknown.high;
    }
    if (classes.empty()) continue;
    if (classes.size() == site.campaign.blocks.draw->shares.size()) {
      throw InputError(study.file.string() + ": every share of site " + site.name +
                       " is an unknown, and they add up to 1; leave one class out, which gets "
                       "what the others leave");
    }
    if (most > 1.0) {
      throw InputError(study.file.string() + ": the unknown shares of site " + site.name +
                       " add up to " + with_digits(most, 6) +
                       " at the upper ends of their ranges; lower these until it is 1 at most");
    }
  }
}

}  // namespace

std::vector<std::vector<double>> CalibrationDesign::places(std::size_t unknowns) const {
  SobolSequence sequence(unknowns, seed);
  std::vector<std::vector<double>> all;
  for (std::uint32_t member = 0; member < members; ++member) all.push_back(sequence.next());
  return all;
}

std::vector<double> CalibrationStudy::values(const std::vector<double>& shares) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < unknowns.size(); ++i) all.push_back(unknowns[i].value(shares[i]));
  return all;
}

std::size_t CalibrationStudy::figures() const {
  std::size_t count = 0;
  for (const Observation& observation : observations) count += observation.figures.size();
  return count;
}

std::uint64_t CalibrationStudy::runs() const {
  return std::uint64_t{sites.size()} * design.members * design.releases;
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
  read([&] { TomlTable(root, file.string(), "", study_table_names()); });
  std::vector<std::string> tables = study_table_names();
  for (const auto& [name, table] : root.table) tables.push_back(name);
  const TomlTable top(root, file.string(), "", tables);

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
  return read_study_by_parts(file, [](const std::function<void()>& part) {
    part();
    return true;
  });
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
