#include "report/text/series_text.hpp"

#include "classify/schemes.hpp"
#include "classify/surface_indices.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"

namespace clast {
namespace {

double convexity_of(const Block& block) { return convexity(block.body, block.mass.volume); }

}  // namespace

TextTable make_series_table(std::span<const Block> blocks) {
  TextTable table;
  table.headings = {"id",        "varied",    "I/L",     "S/L",
                    "convexity", "volume m3", "mass kg", "Sneed and Folk"};
  for (const Block& block : blocks) {
    const BoxRatios ratios = box_ratios(block.box);
    const bool metric = !is_unscaled(block);
    table.rows.push_back(
        {block.id, describe_variation(parse_variation(block).value_or(VariationRecord{})),
         format_decimals(ratios.i_l, 4), format_decimals(ratios.s_l, 4),
         format_decimals(convexity_of(block), 4),
         format_rounded(block.mass.volume) + (metric ? "" : " u"),
         metric ? format_rounded(block.mass.mass) : "", sneed_folk_class(block.axes())});
  }
  return table;
}

std::string describe_copula_fit(const CopulaFit& fit) {
  std::string text =
      "Fit: the distribution functions of the population and of the drawn bodies differ by " +
      format_decimals(fit.max_cdf_difference, 3) +
      " at most; rank correlations of the population and of the drawn bodies:\n";
  for (const RankCorrelation& pair : fit.correlations) {
    text += "  " + pair.first + " and " + pair.second + ": " + format_decimals(pair.population, 2) +
            ", " + format_decimals(pair.sampled, 2) + "\n";
  }
  if (fit.removed_correlation > 0.0) {
    text += "  correlations reduced by " + format_percent(fit.removed_correlation, 0) +
            ", because those of the population do not form a valid correlation matrix\n";
  }
  return text;
}

}  // namespace clast
