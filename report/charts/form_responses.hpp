#pragma once
/// Outcomes of the forms of a campaign, and their pictures over the triangle of Sneed and Folk.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "classify/form.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// What the runs of one form came to.
struct FormOutcome {
  std::string form;  ///< block of the library
  Axes axes;
  bool made = false;  ///< stretched to this form (`clast vary`), not a scanned block
  std::size_t runs = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the runs
};

/// One outcome of a file with six forms or more.
struct OutcomeOfForms {
  std::uint32_t file = 0;
  std::string outcome;  ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;
  std::vector<FormOutcome> forms;  ///< by name
};

/// Over all runs of each form, where they ended; none of files whose blocks stay.
std::vector<OutcomeOfForms> outcomes_of_forms(const Comparison& comparison);

/// A picture of its mean over the triangle, and the file name it is kept by: "response_runout.svg";
/// of several files "response_2_runout.svg". Empty where all forms have the same mean.
struct ResponsePicture {
  std::string file;
  std::string caption;
  std::string svg;
};
std::vector<ResponsePicture> response_pictures(const std::vector<OutcomeOfForms>& outcomes,
                                               bool several_files);

}  // namespace clast::report_detail
