#include "report/calibration_report.hpp"

#include "core/error.hpp"
#include "core/file_kind.hpp"
#include "core/output_file.hpp"
#include "report/pages/calibration_page.hpp"

namespace clast {

std::filesystem::path calibration_page_file(const std::filesystem::path& target) {
  if (target.extension() == ".html") {
    throw InputError(target.string() +
                     ": is the name of the page beside it; give the posterior the extension .h5");
  }
  std::filesystem::path page = target;
  return page.replace_extension(".html");
}

Calibration calibrate_with_page(const CalibrationStudy& study, const std::filesystem::path& target,
                                const CalibrateOptions& options) {
  const std::filesystem::path page = calibration_page_file(target);
  const bool replace = options.replace || options.resume;
  check_output(target, {.kind = kPosteriorFormat, .replace = replace});
  const OutputRules rules = check_output(page, {.kind = kind_by_name(page), .replace = replace});
  Calibration calibration = calibrate(study, target, options);
  write_output(page, calibration_page(calibration), rules);
  return calibration;
}

}  // namespace clast
