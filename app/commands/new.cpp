#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "core/angle.hpp"
#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/shell_words.hpp"
#include "core/text_table.hpp"
#include "study/proposal/new_campaign.hpp"

namespace clast {

namespace {

struct NewCampaignArgs {
  std::string library;
  std::vector<std::string> terrain;
  std::string output = "campaign.toml";
  bool replace = false;
};

void print_proposal(const CampaignProposal& proposal) {
  const ProposedReleaseAndBarrier& places = proposal.places;
  std::cout << format_count(proposal.blocks.count, "block") << ", "
            << format_count(places.release_points, "release point") << " on ground of "
            << format_decimals(places.release_slope * kDegreesPerRadian, 0) << " degrees, "
            << format_count(proposal.orientations, "orientation") << ": "
            << format_count(proposal.blocks.count * places.release_points * proposal.orientations,
                            "run")
            << "\nbarrier \"" << places.barrier_name << "\" " << format_decimals(places.descent, 0)
            << " m below, " << format_decimals(places.distance, 0) << " m away\n";
  TextTable ground{{"zone", "taken for", "e_n^2", "mu", "mu_R"}, {}};
  for (const ProposedGround& zone : proposal.ground) {
    ground.rows.push_back({zone.zone,
                           zone.type.name + (zone.identified_by_name ? "" : " (a guess)"),
                           format_significant(zone.type.energy_restitution.value, 3),
                           format_significant(zone.type.friction.value, 3),
                           format_significant(zone.type.rolling_friction.value, 3)});
  }
  std::cout << ground.text();
  for (const std::string& doubt : proposal.proposal_warnings) {
    std::cout << "warning: " << format_for_terminal(doubt) << "\n";
  }
}

void write_campaign(const NewCampaignArgs& args) {
  const CampaignProposal proposal =
      write_new_campaign(args.library, {args.terrain.begin(), args.terrain.end()}, args.output,
                         {.replace = args.replace});
  print_proposal(proposal);
  std::cout << escape_nonprintable(args.output) << ": written. Edit it, then: "
            << escape_nonprintable(
                   format_shell_command({"clast", "simulate", args.output, "--dry-run"}))
            << "\n";
}

}  // namespace

void add_new_command(CLI::App& app) {
  const auto args = std::make_shared<NewCampaignArgs>();
  CLI::App* parent = &add_companion_command(app, "new");
  parent->require_subcommand(1);
  CLI::App* command = parent->add_subcommand(
      "campaign", "Write a complete, commented campaign file from a block library and a terrain");
  command->add_option("--library", args->library, "Block library")->required()->type_name("LIB");
  command
      ->add_option("--terrain", args->terrain,
                   "Terrain file of clast terrain, with its ground zones; or meshes, a raster or "
                   "clouds, which form one zone")
      ->required()
      ->type_name("FILE");
  command->add_option("-o,--output", args->output, "Campaign file")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace an existing campaign file");
  command->footer(
      "Release points are proposed on steep ground in the upper part of the terrain.\nA barrier is "
      "proposed across the path at the foot of the slope, or higher if few of 16 trial runs reach "
      "it.\nGround parameters are typical of the ground type in the name of a "
      "zone (docs/parameters.md).\nGround types are rock, talus, scree, soil hard, soil medium and "
      "soil soft; scree is the default.\n"
      "Example:\n"
      "  clast new campaign --library blocks.h5 --terrain slope.h5 -o campaign.toml");
  command->callback([args] { write_campaign(*args); });
}

}  // namespace clast
