#include "report/text/contrast_text.hpp"

#include <utility>

#include "core/number_text.hpp"

namespace clast {
namespace {

constexpr int kMaxDecimals = 4;

}  // namespace

QuantityLabel quantity_label(const std::string& quantity) {
  const std::size_t blank = quantity.rfind(' ');
  const std::string barrier = blank == quantity.npos ? "" : " at " + quantity.substr(0, blank);
  const std::string name = blank == quantity.npos ? quantity : quantity.substr(blank + 1);
  if (name == "runout_m") return {"runout", "m"};
  if (name == "lateral_deg") return {"lateral angle", "deg"};
  if (name == "path_length_m") return {"path length", "m"};
  if (name == "max_speed_m_s") return {"largest speed", "m/s"};
  if (name == "speed_m_s") return {"speed" + barrier, "m/s"};
  if (name == "total_energy_j") return {"energy" + barrier, "kJ", 1e-3};
  if (name == "height_m") return {"height" + barrier, "m"};
  return {quantity, ""};
}

std::string describe_difference(const Contrast& contrast, const std::string& unit, double factor) {
  const double gap = factor * contrast.estimate;
  const double sign = gap < 0.0 ? -1.0 : 1.0;
  const std::string way = gap < 0.0 ? " less" : " more";
  const std::string of_unit = unit.empty() ? "" : " " + unit;
  if (!contrast.interval) return format_significant(sign * gap, 3) + of_unit + way;
  double low = sign * (factor * contrast.interval->low);
  double high = sign * (factor * contrast.interval->high);
  if (low > high) std::swap(low, high);
  const int decimals = significant_decimals({low, high}, kMaxDecimals);
  return format_decimals(sign * gap, decimals) + of_unit + way + " (" +
         format_decimals(low, decimals) + " to " + format_decimals(high, decimals) + of_unit + ")";
}

std::string describe_difference(const GroupDifference& difference) {
  const QuantityLabel words = quantity_label(difference.quantity);
  return describe_difference(difference, words.unit, words.factor);
}

std::string describe_difference(const DepositQuantityDifference& difference) {
  return describe_difference(difference, deposit_quantities()[difference.first.quantity].unit);
}

std::string describe_effect(const GroupDifference& difference, const Comparison& comparison) {
  const QuantityLabel words = quantity_label(difference.quantity);
  const auto mean = [&](double value) {
    return format_significant(words.factor * value, 3) + " " + words.unit;
  };
  const std::string means = words.name + ": " + comparison.groups[difference.first].name + " " +
                            mean(difference.first_mean) + " on average, " +
                            comparison.groups[difference.second].name + " " +
                            mean(difference.second_mean) + "; " + describe_difference(difference);
  switch (difference.verdict()) {
    case ContrastVerdict::kUntested:
      return means + "; with one realisation, significance cannot be tested";
    case ContrastVerdict::kSignificant:
      return means;
    case ContrastVerdict::kDistributionDiffers:
      return means + ", which is not significant, but the distributions differ";
    default:
      return means + ", which is not significant" +
             (difference.family_size > 1
                  ? " among " + std::to_string(difference.family_size) + " differences"
                  : "");
  }
}

std::string describe_effect(const DepositQuantityDifference& difference) {
  const DepositQuantity& figure = deposit_quantities()[difference.first.quantity];
  const auto mean = [&](const DepositQuantitySummary& of_file) {
    return "file " + std::to_string(of_file.file + 1) + " " +
           format_decimals(of_file.summary.mean, figure.decimals) +
           (figure.unit.empty() ? "" : " " + figure.unit);
  };
  const std::string text = figure.phrase + ": " + mean(difference.first) + ", " +
                           mean(difference.second) + "; " + describe_difference(difference) +
                           ", from " + std::to_string(difference.first.summary.count) + " and " +
                           format_count(difference.second.summary.count, "realisation");
  switch (difference.verdict()) {
    case ContrastVerdict::kSignificant:
      return text;
    case ContrastVerdict::kInsignificantAfterCorrection:
      return text + "; one of " + std::to_string(difference.family_size) +
             " differences tested can be this large by chance";
    case ContrastVerdict::kUntested:
      break;
    default:
      return text + "; not significant";
  }
  const bool few = difference.first.summary.count < 2 || difference.second.summary.count < 2;
  return text + (few ? "; an interval requires two realisations of each file"
                     : "; no interval, because the realisations do not differ");
}

std::string describe_effect(const DepositMobility& mobility) {
  std::string text = mobility.group + ": " + format_decimals(mobility.together_runout.mean, 1) +
                     " m together, " + format_decimals(mobility.alone_runout.mean, 1) +
                     " m alone; " + describe_difference(mobility.difference, "m");
  if (!mobility.difference.interval) {
    text += ", without an interval";
  } else if (!mobility.difference.excludes_zero()) {
    text += ", not significant";
  }
  if (mobility.start_distance > kMaxSameStartDistance) {
    text +=
        "; their release points are " + format_decimals(mobility.start_distance, 0) + " m apart";
  }
  if (std::abs(mobility.mass_ratio - 1.0) > kMaxSameMassDifference) {
    text += "; the mean mass together is " + format_significant(mobility.mass_ratio, 3) +
            " times that alone";
  }
  return text;
}

}  // namespace clast
