#pragma once
/// Posterior draws of a calibration, used for predictions.
#include <filesystem>
#include <string>
#include <vector>

namespace clast {

inline constexpr const char* kPosteriorFormat = "clast posterior";
inline constexpr int kPosteriorSchema = 1;

/// Equally weighted posterior draws of unknown parameters.
struct PosteriorDraws {
  std::filesystem::path file;
  std::vector<std::string> parameters;  ///< names of the parameters, such as "ground.blue.friction"
  std::vector<std::vector<double>> draws;  ///< draws, each with the values of all parameters
};

/// Reads the draws of a posterior file.
/// @throws InputError  if the file is missing, not a posterior, damaged, of a newer schema, or an
///                     interrupted calibration without draws
PosteriorDraws read_posterior_draws(const std::filesystem::path& file);

}  // namespace clast
