#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "library/block_ranges.hpp"
#include "library/library_update.hpp"
#include "library/unscaled.hpp"

namespace clast {

namespace {

struct MergeArgs {
  std::string output;
  std::vector<std::string> inputs;
  bool replace = false;
};

std::function<void()> say_waiting(const std::string& library) {
  return [library] {
    std::cerr << "clast: " << library << ": another program is writing to it; waiting\n";
  };
}

void add_part(BlockLibrary& library, const BlockLibrary& part, const std::string& name,
              bool replace) {
  for (const Block& block : part.blocks()) {
    with_error_context(name, [&] { library.add(block, replace); });
  }
}

void merge(const MergeArgs& args) {
  std::vector<BlockLibrary> parts;
  for (const std::string& input : args.inputs) parts.push_back(BlockLibrary::read(input));
  const BlockLibrary joined =
      update_library(args.output, {.create_if_missing = true, .on_wait = say_waiting(args.output)},
                     [&](BlockLibrary& library) {
                       for (std::size_t i = 0; i < parts.size(); ++i) {
                         add_part(library, parts[i], args.inputs[i], args.replace);
                       }
                     });
  std::cout << escape_nonprintable(args.output) << ": "
            << format_count(joined.blocks().size(), "block") << "\n";
}

void add_merge(CLI::App& app) {
  const auto args = std::make_shared<MergeArgs>();
  CLI::App* command = app.add_subcommand("merge", "Join libraries into one");
  command->add_option("output", args->output, "Library to write; existing blocks are kept")
      ->required()
      ->type_name("OUT");
  command->add_option("inputs", args->inputs, "Libraries whose blocks are added")
      ->required()
      ->type_name("IN");
  command->add_flag("--replace", args->replace,
                    "If an id already exists, replace that block with the later one");
  command->footer("Example:\n  clast library merge all.h5 quarry.h5 talus.h5");
  command->callback([args] { merge(*args); });
}

struct RemoveArgs {
  std::string library;
  std::vector<std::string> ids;
};

void remove_blocks(const RemoveArgs& args) {
  const BlockLibrary library = update_library(
      args.library, {.on_wait = say_waiting(args.library)}, [&](BlockLibrary& changed) {
        for (const std::string& id : args.ids)
          changed.find_block(id);  // all are there, or none is removed
        for (const std::string& id : args.ids) changed.remove(id);
      });
  std::cout << escape_nonprintable(args.library) << ": " << format_count(args.ids.size(), "block")
            << " removed, " << library.blocks().size() << " left\n";
}

void add_remove(CLI::App& app) {
  const auto args = std::make_shared<RemoveArgs>();
  CLI::App* command = app.add_subcommand("remove", "Remove blocks from a library");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to remove")->required()->type_name("ID");
  command->footer("Example:\n  clast library remove blocks.h5 B017");
  command->callback([args] { remove_blocks(*args); });
}

struct SetArgs {
  std::string library;
  std::string id;
  std::optional<std::string> site;
  std::optional<std::string> note;
  std::optional<std::string> taped;
  std::optional<double> weighed;
};

/// "weighed 350 kg, 2.3 % more than the block's 342 kg".
std::string against(const std::string& what, double field, double block, const std::string& unit) {
  const double gap = 100.0 * (field / block - 1.0);
  return what + " " + format_rounded(field) + " " + unit + ", " + format_rounded(std::abs(gap), 2) +
         " % " + (gap >= 0.0 ? "more" : "less") + " than the block's " + format_rounded(block) +
         " " + unit + "\n";
}

/// Describes the unit, in m, that the taped axes imply for an unscaled block.
std::string scales_by_tape(const Axes& taped, const Axes& units) {
  std::string text = "the block is unscaled; by the taped axes one of its units is";
  const auto add = [&](const char* name, double tape, double block) {
    text += " " + format_rounded(tape / block) + " m (" + name + ")";
  };
  add("L", taped.L, units.L);
  add("I", taped.I, units.I);
  add("S", taped.S, units.S);
  return text +
         "; to make the block again in metres, give one of these to clast reconstruct as "
         "--scale-factor\n";
}

/// "L,I,S" in metres, in any order.
/// @throws CLI::ValidationError  not three numbers in `kBlockLengthRange`
Axes axes_from(const std::string& text) {
  const std::vector<std::string> items = split_comma_separated(text);
  std::vector<double> lengths;
  for (const std::string& item : items) {
    const std::optional<double> length = parse_number(item);
    if (length && kBlockLengthRange.contains(*length)) lengths.push_back(*length);
  }
  if (items.size() == 3 && lengths.size() == 3) {
    return Axes::sorted(lengths[0], lengths[1], lengths[2]);
  }
  throw CLI::ValidationError("--taped", "\"" + text + "\" is not three lengths " +
                                            kBlockLengthRange.describe() +
                                            ", such as 0.65,0.53,0.38");
}

void set_field_notes(const SetArgs& args) {
  if (!args.site && !args.note && !args.taped && !args.weighed) {
    throw CLI::ValidationError("nothing to set; give --site, --note, --taped or --weighed");
  }
  const std::optional<Axes> taped =
      args.taped ? std::optional<Axes>(axes_from(*args.taped)) : std::nullopt;
  const BlockLibrary library = update_library(
      args.library, {.on_wait = say_waiting(args.library)}, [&](BlockLibrary& changed) {
        FieldNotes& field = changed.find_block(args.id).field;
        if (args.site) field.site = to_utf8(*args.site);
        if (args.note) field.note = to_utf8(*args.note);
        if (taped) field.taped_axes = taped;
        if (args.weighed) field.weighed_mass = args.weighed;
      });
  const Block& block = library.find_block(args.id);

  std::cout << escape_nonprintable(args.library) << ": field notes of block "
            << escape_nonprintable(args.id) << " stored\n";
  if (is_unscaled(block)) {
    if (taped) std::cout << scales_by_tape(*taped, block.axes());
    if (args.weighed) {
      std::cout << "block " << escape_nonprintable(args.id)
                << " is unscaled and has no mass to compare with\n";
    }
    return;
  }
  if (args.weighed) std::cout << against("weighed", *args.weighed, block.mass.mass, "kg");
  if (!taped) return;
  const Axes box = block.axes();
  std::cout << against("taped L", taped->L, box.L, "m") << against("taped I", taped->I, box.I, "m")
            << against("taped S", taped->S, box.S, "m");
}

void add_set(CLI::App& app) {
  const auto args = std::make_shared<SetArgs>();
  CLI::App* command = app.add_subcommand("set", "Attach field notes to a block");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("id", args->id, "Block")->required()->type_name("ID");
  command->add_option("--site", args->site, "Place where the block lies or came from")
      ->type_name("TEXT");
  command->add_option("--note", args->note, "Anything else")->type_name("TEXT");
  command->add_option("--taped", args->taped, "Axes measured by tape, m")->type_name("L,I,S");
  command->add_option("--weighed", args->weighed, "Weighed mass, kg")
      ->check(number_in_range(kBlockMassRange))
      ->type_name("KG");
  command->footer(
      "Field notes are stored beside the computed values and do not change them.\n"
      "Example:\n  clast library set blocks.h5 SP1A --site \"Authume, north face\" "
      "--taped 0.65,0.53,0.38 --weighed 342");
  command->callback([args] { set_field_notes(*args); });
}

}  // namespace

void add_library_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("library", "Join libraries, remove blocks, attach field notes");
  command->require_subcommand(1);
  add_merge(*command);
  add_remove(*command);
  add_set(*command);
}

}  // namespace clast
