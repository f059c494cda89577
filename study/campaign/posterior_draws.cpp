#include "study/campaign/posterior_draws.hpp"

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "study/campaign/checked_group.hpp"

namespace clast {

using study_detail::CheckedGroup;

PosteriorDraws read_posterior_draws(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, kPosteriorFormat, kPosteriorSchema);
  const Hdf5Group root = file.root();
  PosteriorDraws draws{path, {}, {}};
  draws.parameters = root.open_group("unknowns").read<std::string>("parameter");
  if (!root.contains("posterior")) {
    throw InputError(path.string() +
                     ": is a calibration without draws, because it was interrupted or is one of "
                     "several shards; continue it, or join the shards first");
  }
  const Hdf5Group posterior = root.open_group("posterior");
  const std::vector<double> values = posterior.read<double>("draws");
  const std::size_t each = draws.parameters.size();
  const CheckedGroup group{path.string(), "/posterior", posterior};
  if (each == 0 || values.empty() || values.size() % each != 0) {
    group.throw_damaged("draws", "has a number of draws that is not whole");
  }
  for (std::size_t i = 0; i < values.size(); i += each) {
    draws.draws.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(i),
                             values.begin() + static_cast<std::ptrdiff_t>(i + each));
  }
  return draws;
}

}  // namespace clast
