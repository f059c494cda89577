#pragma once
/// Draws from the posterior of a calibration, for campaigns that predict with them.
#include <filesystem>
#include <string>
#include <vector>

namespace clast {

inline constexpr const char* kPosteriorFormat = "clast posterior";
inline constexpr int kPosteriorSchema = 1;

/// Sets of values of the unknowns, each as likely as any other.
struct PosteriorDraws {
  std::filesystem::path file;
  std::vector<std::string> parameters;     ///< "ground.blue.friction"
  std::vector<std::vector<double>> draws;  ///< values in the order of the parameters
};

/// @throws InputError  missing, no posterior, damaged, or of a newer schema; or an interrupted
///                     calibration, without draws
PosteriorDraws read_posterior_draws(const std::filesystem::path& file);

}  // namespace clast
