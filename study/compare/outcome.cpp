#include "study/compare/outcome.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

StopReasonCounts count_stop_reasons(const CampaignResults& results) {
  StopReasonCounts outcome;
  for (const RunRecord& run : results.runs) {
    const auto reason = std::find(kStopReasons.begin(), kStopReasons.end(), run.result.stop_reason);
    ++outcome.reasons[static_cast<std::size_t>(reason - kStopReasons.begin())];
    if (run.result.below_ground) ++outcome.below_ground;
    if (results.has_contacts()) {
      outcome.largest_energy_error =
          std::max(outcome.largest_energy_error.value_or(0.0), run.result.energy.error);
      const double reassigned = reassigned_energy_fraction(run.result.energy).value_or(0.0);
      if (reassigned > kNotableReassignedFraction) ++outcome.reassigned;
      outcome.largest_reassigned = std::max(outcome.largest_reassigned.value_or(0.0), reassigned);
    }
    if (run.result.stop_reason == StopReason::kError && outcome.first_error.empty()) {
      outcome.first_error = "run " + std::to_string(run.run) + ": " + run.result.message;
    }
  }
  return outcome;
}

std::vector<std::string> describe_failed_runs(const StopReasonCounts& outcome) {
  std::vector<std::string> warnings;
  if (outcome.reassigned > 0) {
    warnings.push_back(format_count(outcome.reassigned, "run loses or gains", "runs lose or gain") +
                       " more than 10 % of the dissipated energy when contacts change (at most " +
                       format_significant(100.0 * outcome.largest_reassigned.value_or(0.0), 2) +
                       " %); clast compare names the worst run and suggests a remedy");
  }
  return warnings;
}

void check_no_failed_runs(const CampaignResults& results, const std::filesystem::path& file) {
  const StopReasonCounts outcome = count_stop_reasons(results);
  if (outcome.errors() == 0) return;
  // A mass that does not settle says itself what to do.
  const std::string advice = outcome.first_error.find(": [mass]") != std::string::npos
                                 ? ""
                                 : ". Try a smaller [contact] time_step_s, or stiffness = "
                                   "\"auto\", and check the ground at the position given";
  throw SimulationError(std::to_string(outcome.errors()) + " of " +
                        format_count(results.runs.size(), "run") +
                        " failed with an error; first error: " + outcome.first_error +
                        ". All runs are in " + file.string() +
                        "; clast compare lists the failed ones and leaves them out of its "
                        "statistics" +
                        advice);
}

}  // namespace clast
