#include "report/text/effects_text.hpp"

#include "core/number_text.hpp"
#include "report/text/capital.hpp"

namespace clast {
namespace {

using namespace report_detail;

std::string whole_percent(double share) { return format_decimals(100.0 * share, 0); }

constexpr double kWideInterval = 0.5;  ///< its middle says nothing

std::string share_text(const VarianceFraction& share) {
  if (share.interval.high - share.interval.low > kWideInterval) {
    return "between " + whole_percent(share.interval.low) + " and " +
           whole_percent(share.interval.high) + " % (too few data for a narrower range)";
  }
  return whole_percent(share.estimate) + " % (" + whole_percent(share.interval.low) + " to " +
         whole_percent(share.interval.high) + ")";
}

std::string name_in_text(const std::string& factor) {
  if (factor == "orientation") return "the orientation at release";
  return factor == "release point" || factor == "ground" ? "the " + factor : factor;
}

std::string outcome_sentence(const DesignEffects& effects, const OutcomeEffects& outcome) {
  const std::string variance = outcome.unit.empty()
                                   ? "the variance of " + outcome.outcome  // "passing NAME"
                                   : "the " + outcome.outcome + "'s variance";
  std::string text;
  for (std::size_t f = 0; f < effects.factors.size(); ++f) {
    const VarianceFraction& share = outcome.shares.factors[f];
    text += (f == 0 ? "" : ", ") + name_in_text(effects.factors[f].name);
    text += f == 0 ? " explains " + share_text(share) + " of " + variance : " " + share_text(share);
  }
  if (effects.factors.size() > 1) {
    text += "; " + share_text(outcome.shares.interactions) + " is due to their interaction";
  }
  return text + ".";
}

}  // namespace

std::vector<std::string> describe_effects(const std::vector<DesignEffects>& effects) {
  std::vector<std::string> sentences;
  for (const DesignEffects& file : effects) {
    const std::string where =
        effects.size() > 1 ? "file " + std::to_string(file.file + 1) + ": " : "";
    if (!file.refusal_reason.empty()) {
      sentences.push_back(capitalized(where + "the variance cannot be divided among the factors: " +
                                      file.refusal_reason + "."));
    }
    if (!file.estimated.empty()) {
      sentences.push_back(capitalized(
          where + "the fractions are estimated with a mixed model with random factors: " +
          file.estimated + "."));
    }
    for (const OutcomeEffects& outcome : file.outcomes) {
      sentences.push_back(capitalized(where + outcome_sentence(file, outcome)));
    }
  }
  return sentences;
}

}  // namespace clast
