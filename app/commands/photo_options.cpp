#include "app/commands/photo_options.hpp"

#include "app/option_values.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "pipeline/board_file.hpp"

namespace clast {

namespace {

constexpr NumberRange kColmapMinutes{0.01, 1e4, "minutes"};

/// "ID,ID,METRES".
ScaleBar bar_from(const std::string& text) {
  const std::vector<std::string> items = split_comma_separated(text);
  std::vector<double> numbers;
  for (const std::string& item : items) {
    if (const std::optional<double> number = parse_number(item)) numbers.push_back(*number);
  }
  const bool whole = items.size() == 3 && numbers.size() == 3 && numbers[0] >= 0.0 &&
                     numbers[1] >= 0.0 && numbers[0] < 1e5 && numbers[1] < 1e5 &&
                     numbers[0] == static_cast<int>(numbers[0]) &&
                     numbers[1] == static_cast<int>(numbers[1]) && numbers[0] != numbers[1] &&
                     kBarLengthRange.contains(numbers[2]);
  if (!whole) {
    throw CLI::ValidationError(
        "--scale-bar",
        "\"" + text + "\" is not two different markers and the distance between their centres, " +
            kBarLengthRange.describe() + ", such as 0,3,1.254");
  }
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), numbers[2]};
}

constexpr const char* kGroup = "Photographs";  ///< of the options, in the help

/// Cameras, and where the program that finds them is.
void add_camera_options(CLI::App& command, PhotoArgs& args) {
  PhotoScanOptions& options = args.options;
  command
      .add_option("--model", options.model,
                  "Camera poses computed by another program: folder of COLMAP, .xml of Metashape, "
                  ".sfm or .json of AliceVision; default: the one in the folder of the photos, "
                  "else the program colmap is run")
      ->type_name("PATH")
      ->group(kGroup);
  command
      .add_option("--masks", options.dense.masks,
                  "Folder of mask images with the names of the photos; black areas are not used")
      ->type_name("DIR")
      ->group(kGroup);
  command.add_option("--colmap", options.colmap.program, "The program colmap, by name or path")
      ->type_name("PROGRAM")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--colmap-minutes", args.colmap_minutes,
                  "Time limit for each colmap step, minutes")
      ->check(number_in_range(kColmapMinutes))
      ->type_name("MIN")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--photo-cache", options.colmap.cache,
                  "Folder that stores the results of colmap for reuse with the same photos; "
                  "default: clast/photos in the user's cache folder")
      ->type_name("DIR")
      ->group(kGroup);
}

}  // namespace

PhotoScanOptions PhotoArgs::parse() const {
  PhotoScanOptions result = options;
  for (const std::string& bar : bars) result.scale.bars.push_back(bar_from(bar));
  if (!board.empty()) {
    result.scale.board = read_scale_board(board);
    const std::string& kind = result.scale.board->dictionary;
    if (!result.scale.board->charuco && result.markers.dictionary != "auto" &&
        result.markers.dictionary != kind) {
      throw CLI::ValidationError("--markers", result.markers.dictionary + " contradicts " +
                                                  board.string() + ", whose markers are " + kind);
    }
  }
  if (marker_size > 0.0) result.scale.marker_side = marker_size;
  result.colmap.time_limit = 60.0 * colmap_minutes;
  check_usage([&] { result.check(); });
  return result;
}

void add_photo_options(CLI::App& command, PhotoArgs& args) {
  PhotoScanOptions& options = args.options;
  command
      .add_option("--scale-bar", args.bars,
                  "Distance between the centres of two printed markers, m; may be given several "
                  "times")
      ->allow_extra_args(false)
      ->type_name("ID,ID,M")
      ->group(kGroup);
  command
      .add_option("--board", args.board,
                  "A plate with markers at known positions, or a ChArUco board, as a file "
                  "(TOML, see docs/formats.md): all its distances set the scale")
      ->type_name("FILE")
      ->group(kGroup);
  command
      .add_option("--marker-size", args.marker_size,
                  "Side of the black square of every marker, m. It sets the scale, or checks that "
                  "of the scale bars")
      ->check(number_in_range(kMarkerSideRange))
      ->type_name("M")
      ->group(kGroup);
  std::vector<std::string> dictionaries = marker_dictionary_names();
  dictionaries.insert(dictionaries.begin(), {"auto", "none"});
  command.add_option("--markers", options.markers.dictionary, "Kind of the markers")
      ->check(CLI::IsMember(dictionaries))
      ->type_name("KIND")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_flag("--allow-unscaled", options.allow_unscaled,
                "Make blocks without any scale: their shape is usable, but they have no mass")
      ->group(kGroup);
  add_camera_options(command, args);
}

}  // namespace clast
