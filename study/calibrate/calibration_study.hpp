#pragma once
/// What a calibration asks for: a study file, read and checked.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/statistics/gaussian_process.hpp"
#include "study/calibrate/observation.hpp"
#include "study/campaign/campaign.hpp"
#include "study/campaign/key_table.hpp"
#include "study/campaign/unknown.hpp"

namespace clast {

/// A place where blocks were released, and the campaign that simulates it.
struct CalibrationSite {
  std::string name;
  Campaign campaign;
};

/// How the parameters are sought.
struct CalibrationDesign {
  std::uint32_t members = 64;   ///< sets of parameters that are simulated
  std::uint32_t releases = 64;  ///< of each member at each site
  std::uint64_t seed = 1;       ///< of all that is drawn
  std::size_t draws = 2000;     ///< from the posterior
  Kernel kernel = Kernel::kMatern52;

  /// The unknowns of a member, each as a share of its range: Sobol's sequence.
  std::vector<std::vector<double>> places(std::size_t unknowns) const;
};

struct CalibrationStudy {
  std::filesystem::path file;
  std::string text;  ///< byte for byte
  std::string sha256;
  std::vector<CalibrationSite> sites;
  std::vector<Unknown> unknowns;
  std::vector<Observation> observations;
  CalibrationDesign design;

  /// The values of unknowns from their shares of the ranges.
  std::vector<double> values(const std::vector<double>& shares) const;
  /// Figures of all observations, in order.
  std::size_t figures() const;
  /// Runs of all members at all sites.
  std::uint64_t runs() const;
};

/// Paths are resolved as in campaigns, against the study file's folder.
/// @throws InputError  a key that is unknown, missing, of the wrong type or out of range; a file it
///                     names that can't be read; a parameter that no site has; what is fitted and
///                     kept at once: file, line, key, value and what was expected
CalibrationStudy read_calibration_study(const std::filesystem::path& file);

/// The tables of a study file and their keys, in the order of docs/formats.md: what
/// `read_calibration_study` knows, and nothing else.
const std::vector<KeyTable>& calibration_key_tables();

/// Has it tables that only studies have? False of what can't be read.
bool is_calibration_study(const std::filesystem::path& file);

}  // namespace clast
