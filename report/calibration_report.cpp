#include "report/calibration_report.hpp"

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "report/pages/calibration_page.hpp"

namespace clast {

std::filesystem::path calibration_page_file(const std::filesystem::path& target) {
  if (target.extension() == ".html") {
    throw InputError(target.string() +
                     ": has the same name as its HTML page; give the posterior the extension .h5");
  }
  std::filesystem::path page = target;
  return page.replace_extension(".html");
}

namespace {

OverwritePolicy page_rules(const std::filesystem::path& target, const CalibrationOptions& options) {
  const std::filesystem::path page = calibration_page_file(target);
  const bool replace = options.replace || options.resume;
  const OverwritePolicy rules{.kind = file_kind_by_extension(page), .replace = replace};
  check_output_target(target, {.kind = kPosteriorFormat, .replace = replace});
  check_output_target(page, rules);
  return rules;
}

}  // namespace

void check_calibration_output(const std::filesystem::path& target,
                              const CalibrationOptions& options) {
  page_rules(target, options);
}

Calibration calibrate_and_report(const CalibrationStudy& study, const std::filesystem::path& target,
                                 const CalibrationOptions& options) {
  const OverwritePolicy rules = page_rules(target, options);
  Calibration calibration = run_calibration(study, target, options);
  write_output(calibration_page_file(target), make_calibration_page(calibration), rules);
  return calibration;
}

}  // namespace clast
