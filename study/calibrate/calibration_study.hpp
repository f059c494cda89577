#pragma once
/// Calibration study: contents of a study file.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/statistics/gaussian_process.hpp"
#include "study/calibrate/observation.hpp"
#include "study/campaign/calibratable_parameter.hpp"
#include "study/campaign/campaign.hpp"
#include "study/campaign/key_table.hpp"

namespace clast {

/// Site with observed releases, and the campaign that simulates it.
struct CalibrationSite {
  std::string name;
  Campaign campaign;
};

struct CalibrationDesign {
  std::uint32_t member_count = 64;         ///< number of simulated parameter sets
  std::uint32_t releases_per_member = 64;  ///< number of simulated releases per member and site
  std::uint64_t seed = 1;                  ///< seed of all random numbers
  std::size_t draw_count = 2000;           ///< number of posterior draws
  Kernel kernel = Kernel::kMatern52;

  /// Returns the points of a Sobol sequence, one per member. The coordinates are cumulative prior
  /// probabilities of the unknowns, in [0, 1].
  std::vector<std::vector<double>> sobol_points(std::size_t unknown_count) const;
};

/// Calibration study: sites, unknowns, observations and design.
struct CalibrationStudy {
  std::filesystem::path file;
  std::string text;  ///< contents of the file, byte for byte
  std::string sha256;
  std::vector<CalibrationSite> sites;
  std::vector<UnknownParameter> unknowns;
  std::vector<Observation> observations;
  CalibrationDesign design;

  /// Converts cumulative prior probabilities, in [0, 1], to values of the unknown parameters.
  std::vector<double> values(const std::vector<double>& shares) const;
  /// Returns the number of statistics of all observations.
  std::size_t statistic_count() const;
  /// Returns the number of runs of all members at all sites.
  std::uint64_t run_count() const;
};

/// Reads and checks a study file. Paths are resolved as in campaigns, against the file's folder.
/// @throws InputError  if a key or value is invalid, a file cannot be read, or no site has a
///                     parameter; names file, line, key, value and expectation
CalibrationStudy read_calibration_study(const std::filesystem::path& file);

/// Returns the declarations of all tables and keys of a study file, in the order of
/// docs/formats.md.
const std::vector<KeyTable>& calibration_key_tables();

/// True if a file is a calibration study; false if it is a campaign or cannot be read.
bool is_calibration_study(const std::filesystem::path& file);

}  // namespace clast
