#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/campaign_summary.hpp"
#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "report/json/calibration_json.hpp"
#include "report/json/campaign_json.hpp"
#include "report/json/key_schema.hpp"
#include "report/text/calibration_text.hpp"
#include "study/calibrate/study_check.hpp"
#include "study/simulate/campaign_check.hpp"

namespace clast {

namespace {

constexpr const char* kSchemas[] = {"campaign", "study"};

struct CheckArgs {
  std::string file;
  bool json = false;
  std::string schema;  ///< of which kind of file; empty: none
};

nlohmann::ordered_json findings_json(const char* kind, const CheckArgs& args,
                                     const std::vector<std::string>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& finding : findings) list.push_back(format_for_terminal(finding));
  return {
      {kind, escape_nonprintable(args.file)}, {"accepted", findings.empty()}, {"findings", list}};
}

/// @param command  that would refuse the file
void end_with(const CheckArgs& args, const std::vector<std::string>& findings,
              const std::string& command) {
  if (!args.json) {
    for (const std::string& finding : findings) std::cout << format_for_terminal(finding) << "\n";
    if (findings.empty()) std::cout << escape_nonprintable(args.file) << ": would run\n";
  }
  if (findings.empty()) return;
  throw InputError(args.file + ": clast " + command + " would refuse it, with " +
                   format_count(findings.size(), "finding") +
                   "; correct what is listed, and check again");
}

void check_one_campaign(const CheckArgs& args) {
  const CampaignCheck check = check_campaign(args.file);
  if (args.json) {
    nlohmann::ordered_json report = findings_json("campaign", args, check.findings);
    if (check.prepared) report.update(plan_json(*check.prepared));
    std::cout << report.dump(2) << "\n";
  } else if (check.prepared) {
    print_plan(*check.prepared);
  }
  end_with(args, check.findings, "simulate");
  if (check.prepared && !args.json) print_stiffness(*check.prepared);
}

void check_one_study(const CheckArgs& args) {
  const CalibrationCheck check = check_calibration_study(args.file);
  if (args.json) {
    nlohmann::ordered_json report = findings_json("study", args, check.findings);
    if (check.study) report.update(study_json(*check.study));
    std::cout << report.dump(2) << "\n";
  } else if (check.study) {
    std::cout << format_study_summary(*check.study);
  }
  end_with(args, check.findings, "calibrate");
}

void check_one(const CheckArgs& args) {
  if (!args.schema.empty()) {
    const bool of_study = args.schema == "study";
    std::cout << (of_study ? calibration_schema() : campaign_schema()).dump(2) << "\n";
  } else if (is_calibration_study(args.file)) {
    check_one_study(args);
  } else {
    check_one_campaign(args);
  }
}

}  // namespace

void add_check_command(CLI::App& app) {
  const auto args = std::make_shared<CheckArgs>();
  CLI::App* command = &add_companion_command(app, "check");
  CLI::Option* file =
      command->add_option("file", args->file, "Campaign, or study of a calibration (TOML)")
          ->type_name("FILE");
  CLI::Option* json =
      command->add_flag("--json", args->json, "Print the errors, or the planned runs, as JSON");
  command
      ->add_option("--schema", args->schema,
                   "Only print the JSON Schema of campaigns or of studies, with which editors "
                   "complete and explain keys")
      ->type_name("KIND")
      ->expected(0, 1)
      ->default_str(kSchemas[0])
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(kSchemas), std::end(kSchemas))))
      ->excludes(file)
      ->excludes(json);
  command->footer(
      "Lists the errors in each table of the file, in the library, the terrain and the "
      "starts.\nFor a study, the errors in the campaigns of its sites are listed too.\nThe exit "
      "code is 0 if the file can be run, "
      "else 1.\n"
      "Example:\n"
      "  clast check campaign.toml\n"
      "  clast check study.toml\n"
      "  clast check --schema > campaign.schema.json\n"
      "  clast check --schema study > calibration.schema.json");
  command->callback([args] {
    if (args->file.empty() && args->schema.empty()) throw CLI::RequiredError("file");
    check_one(*args);
  });
}

}  // namespace clast
