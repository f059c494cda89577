#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/campaign_summary.hpp"
#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "report/json/campaign_json.hpp"
#include "report/json/key_schema.hpp"
#include "study/campaign_check.hpp"

namespace clast {

namespace {

struct CheckArgs {
  std::string campaign;
  bool json = false;
  bool schema = false;
};

void print_json(const CheckArgs& args, const CampaignCheck& check) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const std::string& finding : check.findings) findings.push_back(shown(finding));
  nlohmann::ordered_json report = {{"campaign", printable(args.campaign)},
                                   {"accepted", check.findings.empty()},
                                   {"findings", findings}};
  if (check.prepared) report.update(plan_json(*check.prepared));
  std::cout << report.dump(2) << "\n";
}

void check_one(const CheckArgs& args) {
  if (args.schema) {
    std::cout << campaign_schema().dump(2) << "\n";
    return;
  }
  const CampaignCheck check = check_campaign(args.campaign);
  if (args.json) {
    print_json(args, check);
  } else if (check.prepared) {
    print_plan(*check.prepared);
    std::cout << printable(args.campaign) << ": would run\n";
  } else {
    for (const std::string& finding : check.findings) std::cout << shown(finding) << "\n";
  }
  if (check.findings.empty()) return;
  throw InputError(args.campaign + ": clast simulate would refuse it, with " +
                   counted(check.findings.size(), "finding") +
                   "; correct what is listed, and check again");
}

}  // namespace

void add_check(CLI::App& app) {
  const auto args = std::make_shared<CheckArgs>();
  CLI::App* command = app.add_subcommand(
      "check", "Say everything that clast simulate would refuse in a campaign, without running it");
  CLI::Option* campaign = command->add_option("campaign", args->campaign, "Campaign file (TOML)")
                              ->type_name("CAMPAIGN");
  CLI::Option* json =
      command->add_flag("--json", args->json, "Print findings, or what would run, as JSON");
  command
      ->add_flag("--schema", args->schema,
                 "Print the JSON Schema of campaign files, with which editors complete and explain "
                 "keys, and check nothing")
      ->excludes(campaign)
      ->excludes(json);
  command->footer(
      "Lists what is wrong in each table of the file, in the library, the terrain and the starts; "
      "exit code 0\nwhen the campaign would run, else 1.\n"
      "Example:\n"
      "  clast check campaign.toml\n"
      "  clast check --schema > campaign.schema.json");
  command->callback([args] {
    if (args->campaign.empty() && !args->schema) throw CLI::RequiredError("campaign");
    check_one(*args);
  });
}

}  // namespace clast
