#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "app/commands/batch_printer.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/photo_options.hpp"
#include "app/companion.hpp"
#include "app/interruption.hpp"
#include "app/option_values.hpp"
#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/length_unit.hpp"
#include "core/number_text.hpp"
#include "library/block_ranges.hpp"
#include "pipeline/deposit_edits_file.hpp"
#include "pipeline/picked_pairs_file.hpp"
#include "pipeline/stations_file.hpp"

namespace clast {

namespace {

struct ReconstructArgs {
  std::vector<std::string> scans;  ///< files and folders
  ScanBatchOptions batch;
  bool json = false;
  std::string report;    ///< folder of pages; empty: none are written
  std::string edits;     ///< file; empty: none
  std::string stations;  ///< file; empty: none
  std::string scale_length;
  double scale_factor = 1.0;
  std::string ground = "auto";
  std::string columns;
  std::string scale = "stored";  ///< stored or free
  std::string join;              ///< id of the block that all scans show; empty: each is one block
  bool join_folders = false;     ///< true: the scans of each folder show one block
  std::vector<std::string> poses;
  std::string picked;  ///< file; empty: none
  PhotoArgs photos;
};

/// Two points of a scan, in its own coordinates, and how far apart they are.
struct MeasuredLength {
  std::array<Vec3, 2> points;
  double unit;  ///< metres per unit of the scan
};

/// Parses "x,y,z;x,y,z;metres". Commas, semicolons and blanks are equivalent.
/// @throws CLI::ValidationError  not seven numbers, points that are one, or a length not positive
MeasuredLength measured_length(const std::string& text) {
  std::string commas = text;
  for (const char other : {';', ' '}) std::replace(commas.begin(), commas.end(), other, ',');
  std::vector<double> numbers;
  for (const std::string& item : split_comma_separated(commas)) {
    numbers.push_back(parse_number(item).value_or(std::nan("")));
  }
  const auto refuse = [&](const std::string& what) {
    throw CLI::ValidationError(
        "--scale-length", "\"" + text + "\" " + what +
                              "; expected two points of the scan and the metres between them (" +
                              kBlockLengthRange.describe() +
                              "), such as \"0.2,1.1,0;3.9,1.3,0.4;0.52\"");
  };
  if (numbers.size() != 7)
    refuse("has " + format_count(numbers.size(), "number") + " and not seven");
  for (const double number : numbers) {
    if (!std::isfinite(number)) refuse("holds a word that is not a number");
  }
  const Vec3 a(numbers[0], numbers[1], numbers[2]), b(numbers[3], numbers[4], numbers[5]);
  if (!kBlockLengthRange.contains(numbers[6]))
    refuse("gives a length that is not " + kBlockLengthRange.describe());
  if (a == b) refuse("gives the same point twice");
  const double unit = numbers[6] / (b - a).norm();
  if (!kLengthUnitRange.contains(unit)) {
    refuse("makes a unit of the scan " + format_significant(unit, 6) + " m long, but it must be " +
           kLengthUnitRange.describe());
  }
  return {{a, b}, unit};
}

/// Parses "NAME: x=180,y=0,z=20".
/// @throws CLI::ValidationError  if the text is of another form
NamedPose parse_pose(const std::string& text) {
  const auto refuse = [&](const std::string& what) {
    throw CLI::ValidationError("--pose", "\"" + text + "\" " + what +
                                             "; expected the name of a scan and rotations in "
                                             "degrees, such as \"top: x=180,z=20\"");
  };
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) refuse("names no scan");
  NamedPose pose{text.substr(0, colon), Vec3::Zero()};
  std::string angles = text.substr(colon + 1);
  std::erase(angles, ' ');
  for (const std::string& item : split_comma_separated(angles)) {
    const std::string axes = "xyz";
    const std::size_t axis = item.size() > 2 && item[1] == '=' ? axes.find(item[0]) : 3;
    const std::optional<double> degrees =
        axis < 3 ? parse_number(item.substr(2)) : std::optional<double>();
    if (!degrees || !(std::abs(*degrees) <= 360.0)) refuse("has no rotation \"" + item + "\"");
    pose.angles[static_cast<Eigen::Index>(axis)] = *degrees / kDegreesPerRadian;
  }
  return pose;
}

/// The scans of the command line, joined as asked.
std::vector<ScanFile> scans_of(const ReconstructArgs& args) {
  if (!args.join.empty()) return {list_joined_scans(args.scans, args.join)};
  return args.join_folders ? list_joined_folders(args.scans) : list_scans(args.scans);
}

/// Returns the options of a command line with their values, without those that apply edits.
std::vector<std::string> given_options(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->get_positional() || name == "--edits" || name == "--replace") continue;
    for (const std::string& value : option->results()) {
      words.push_back(name);
      if (option->get_items_expected_max() > 0) words.push_back(value);
    }
  }
  return words;
}

void reconstruct(const ReconstructArgs& args, const CLI::App& command) {
  ScanBatchOptions batch = args.batch;
  ScanToBlockOptions& options = batch.scan;
  options.photos = args.photos.parse();
  options.scale_factor = args.scale_factor;
  double unit = 1.0;
  if (args.scale_length.empty()) {
    check_usage([&] { unit = parse_length_unit(options.units); });
  } else {
    const MeasuredLength length = measured_length(args.scale_length);
    options.scale_points = length.points;
    unit = length.unit;
  }
  options.scan.unit = unit * args.scale_factor;
  if (!args.edits.empty()) options.edits = read_deposit_edits(args.edits);
  if (!args.stations.empty()) options.stations = read_stations(args.stations);
  options.scan.columns = split_comma_separated(args.columns);
  for (const std::string& pose : args.poses) options.join.poses.push_back(parse_pose(pose));
  options.join.free_scale = args.scale == "free";
  if (!args.picked.empty()) options.join.pairs = read_picked_pairs(args.picked);
  const std::vector<ScanFile> scans = scans_of(args);
  check_usage([&] { batch.check(scans.size()); });
  const InterruptionWatch watch(
      "\nclast: interrupted; waiting for the current step of each scan in progress (minutes for "
      "photographs); finished blocks are kept. Press Ctrl-C again to stop at once\n");
  BatchPrinter printer(scans.size(), batch, args.report, args.json, given_options(command));
  const ProgressCallback progress = [&](const ProgressUpdate& step) {
    if (watch.interrupted()) throw Cancelled();
    printer.show(step);
  };
  try {
    printer.finish(reconstruct_scan_batch(scans, batch, printer, progress));
  } catch (const Cancelled&) {
    throw InputError("interrupted; finished blocks are in " + batch.library.string() +
                     ". To continue, repeat the command with `resume`");
  }
}

/// Size, axes and ground of the scans.
void add_scan_options(CLI::App& command, ReconstructArgs& args) {
  command
      .add_option("--units", args.batch.scan.units,
                  "Length unit of the scans: m, cm, mm, km, in, ft, or metres per unit")
      ->type_name("UNIT")
      ->capture_default_str();
  command
      .add_option("--scale-length", args.scale_length,
                  "Scale from a measured length: two points in the coordinates of the scan and "
                  "their distance in metres, as \"x,y,z;x,y,z;metres\"")
      ->excludes("--units")
      ->type_name("A;B;M");
  command
      .add_option("--scale-factor", args.scale_factor,
                  "Factor for all lengths, applied after --units or --scale-length")
      ->check(number_in_range(kScaleFactorRange))
      ->type_name("F")
      ->capture_default_str();
  command
      .add_option("--up", args.batch.scan.scan.up,
                  "Axis of the scans that points up: y or z; default: away from the ground if the "
                  "scan contains ground, else y for glb and gltf files and z for all others")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
  command
      .add_option("--columns", args.columns,
                  "Columns x, y and z of clouds in text, by name or number from 1, such as 2,3,4; "
                  "default: from the heading")
      ->type_name("X,Y,Z");
  command
      .add_option("--ground", args.ground,
                  "auto: remove the ground around a block; none: the scan shows only the block")
      ->check(CLI::IsMember({"auto", "none"}))
      ->type_name("WHICH")
      ->capture_default_str();
  command.add_flag("--split", args.batch.scan.split,
                   "Make all blocks of a deposit, apart or touching, as ID_1, ID_2 ... in order of "
                   "x; default: only the block near the middle");
  command
      .add_option("--smallest", args.batch.scan.smallest_axis,
                  "With --split: smallest intermediate axis I of a block, m, as a sieve opening; "
                  "default: all blocks that the point spacing resolves")
      ->check(number_in_range(kBlockLengthRange))
      ->type_name("M")
      ->needs("--split");
  command
      .add_option("--edits", args.edits,
                  "With --split: corrections of the segmentation, JSON, as the page of the deposit "
                  "saves them: blocks to accept, drop, merge or cut")
      ->type_name("FILE")
      ->needs("--split");
  command
      .add_option("--stations", args.stations,
                  "With --split: positions of the scanner or the cameras in the coordinates of the "
                  "scan, a table of points such as CSV with the columns x, y and z; bodies do not "
                  "reach into the free space before the points seen from there")
      ->type_name("FILE")
      ->needs("--split");
  command
      .add_option("--labelled", args.batch.scan.labelled,
                  "With --split: also write the points as PLY with the integer property block: 0 "
                  "ground and fines, 1, 2, ... the blocks ID_1, ID_2, ...")
      ->type_name("FILE")
      ->needs("--split");
  command.add_flag("--any-size", args.batch.scan.allow_any_size,
                   "Also accept blocks over 20 m, over 10,000 t or under 1 mm");
}

/// Several scans of one block.
void add_join_options(CLI::App& command, ReconstructArgs& args) {
  CLI::Option* join =
      command
          .add_option(
              "--join", args.join,
              "Make one block, with this id, of all scans: of both sides of a turned block, "
              "in any poses. Two to eight scans; the first gives the frame")
          ->excludes("--split")
          ->type_name("ID");
  command
      .add_flag("--join-folders", args.join_folders,
                "Make one block of the scans in each folder, with the folder's name as its id")
      ->excludes("--split")
      ->excludes(join);
  command
      .add_flag("--align", args.batch.scan.align,
                "Align strips or passes of one scan that do not fit: those of the point sources "
                "of a LAS file or between pauses of its recording, otherwise parts that show "
                "the same surface at two places")
      ->excludes("--split")
      ->excludes("--join-folders")
      ->excludes(join);
  command
      .add_option("--pose", args.poses,
                  "With --join or --join-folders: rotation, right within 30 degrees, that turns a "
                  "scan to the first one, about x, then y, then z, such as \"top: x=180\"; for "
                  "blocks that fit in several poses; repeatable")
      ->type_name("SCAN:ANGLES")
      ->allow_extra_args(false);
  command
      .add_option("--scale", args.scale,
                  "With --join or --join-folders: stored, if all scans have the given units; free, "
                  "if only the first one has, to estimate the scales of the others")
      ->check(CLI::IsMember({"stored", "free"}))
      ->type_name("WHICH")
      ->capture_default_str();
  command
      .add_option("--picked", args.picked,
                  "With --join or --join-folders: table of three or more places that two scans "
                  "show, with the columns scan_a,x,y,z,scan_b,x,y,z")
      ->type_name("FILE");
}

void add_block_options(CLI::App& command, ScanToBlockOptions& options) {
  command
      .add_option("--vertices", options.vertices,
                  "Largest number of vertices of a block, 4 or more; default: the smallest number "
                  "up to 2000 that meets the tolerance")
      ->check(integer_in_range(4, 1000000))
      ->type_name("N");
  CLI::Option* radius =
      command.add_option("--radius", options.block.radius, "Minkowski radius of the rounding, m")
          ->check(number_in_range(kMinkowskiRadiusRange))
          ->type_name("M");
  command
      .add_option("--radius-share", options.block.radius_fraction,
                  "Minkowski radius as a fraction of S, the shortest side, 0 to 0.25; default: "
                  "0.02, without --vertices halved down to 0.0025 if the tolerance requires it")
      ->check(number_in_range(kRadiusFractionRange))
      ->excludes(radius)
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_flag("--core", options.block.core,
                "The mesh is the core over which the sphere is swept, not the rock's surface; it "
                "is used unchanged")
      ->needs(radius)
      ->excludes("--vertices");
  command
      .add_flag("--convex", options.block.convex,
                "Use the convex hull of each scan, for example to compare with simpler models")
      ->excludes("--core");
  command.add_option("--density", options.block.density, "Density, kg/m3")
      ->check(number_in_range(kBlockDensityRange))
      ->type_name("KG/M3")
      ->capture_default_str();
  command
      .add_option("--mass", options.block.mass,
                  "Weighed mass of the block, kg: sets the density, or checks the volume if "
                  "--density is also given")
      ->check(number_in_range(kBlockMassRange))
      ->type_name("KG");
  command
      .add_option("--accuracy", options.block.accuracy,
                  "Relative accuracy of volume and inertia, 1e-6 to 1e-2")
      ->check(number_in_range(kMassAccuracyRange))
      ->type_name("REL")
      ->capture_default_str();
  command
      .add_option("--tolerance", options.block.tolerance,
                  "Largest Hausdorff distance between a block and its scan, as a fraction of L, "
                  "the longest side; a larger distance gives a warning")
      ->check(number_in_range(kScanToleranceRange))
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_flag("--keep-inner-shells", options.scan.repair.keep_inner_shells,
                "Keep closed shells inside a scan (bubbles) as cavities; default: they are filled "
                "with rock. Their number and volume are reported in both cases")
      ->excludes("--convex");
}

void add_batch_options(CLI::App& command, ReconstructArgs& args) {
  command
      .add_option("-o,--output", args.batch.library,
                  "Block library to write; existing blocks are kept")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_flag("--replace", args.batch.replace,
                   "Replace blocks whose id is in the library already");
  command
      .add_option("--jobs", args.batch.jobs,
                  "Number of scans processed at the same time, 0: one per core; memory use grows "
                  "with the number, the results are the same")
      ->check(integer_in_range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--resume", args.batch.resume,
                   "Skip scans whose block is in the library already, made from the same file with "
                   "the same options");
  command
      .add_option(
          "--report", args.report,
          "Folder for a page about each block (pictures of the scan before and after repair, list "
          "of repairs, deviation map) and a summary, index.html and summary.csv")
      ->type_name("DIR");
  command.add_flag("--json", args.json, "Print the blocks as JSON");
}

}  // namespace

void add_reconstruct_command(CLI::App& app) {
  const auto args = std::make_shared<ReconstructArgs>();
  CLI::App* command = &add_companion_command(app, "reconstruct");
  command
      ->add_option("scans", args->scans,
                   "Mesh files (obj, ply, stl, off, glb, gltf, 3ds, tab), point clouds (ply, pcd, "
                   "las, laz, xyz, txt, csv), Rockable or ExaDEM shapes (shp: cores with their "
                   "radius), or folders of them; a folder of photographs is one block")
      ->required()
      ->type_name("SCAN");
  add_batch_options(*command, *args);
  add_scan_options(*command, *args);
  add_join_options(*command, *args);
  add_block_options(*command, args->batch.scan);
  add_photo_options(*command, args->photos);
  command->footer(
      "Examples:\n"
      "  clast reconstruct scans/ -o blocks.h5 --units mm --density 2650\n"
      "  clast reconstruct scans/ -o blocks.h5 --units mm --jobs 4 --resume --report pages\n"
      "  clast reconstruct rock.ply --scale-length \"0.2,1.1,0;3.9,1.3,0.4;0.52\"\n"
      "  clast reconstruct SP1A.stl -o blocks.h5 --core --radius 0.027 --mass 342\n"
      "  clast reconstruct slope.las -o blocks.h5 --split --report pages\n"
      "  clast reconstruct slope.las -o blocks.h5 --split --report pages --edits edits.json "
      "--replace\n"
      "  clast reconstruct B017_top.ply B017_bottom.ply -o blocks.h5 --join B017\n"
      "  clast reconstruct walk.las -o blocks.h5 --align\n"
      "  clast reconstruct photos/B017 -o blocks.h5 --scale-bar 0,3,1.254 --marker-size 0.2\n"
      "  clast reconstruct shapes.shp -o blocks.h5 --density 2700");
  command->callback([args, command] {
    const auto is_given = [&](const char* option) { return command->count(option) > 0; };
    ScanToBlockOptions& options = args->batch.scan;
    const bool joins = is_given("--join") || is_given("--join-folders");
    for (const char* needing : {"--pose", "--picked", "--scale"}) {
      if (is_given(needing) && !joins) {
        throw CLI::RequiresError(needing, "--join or --join-folders");
      }
    }
    if (is_given("--join") && args->join.empty()) {
      throw CLI::ValidationError("--join", "the id of the block is empty");
    }
    options.up_given = is_given("--up");
    options.find_ground = args->ground == "auto";
    options.radius_given = is_given("--radius") || is_given("--radius-share");
    options.block.density_given = is_given("--density");
    reconstruct(*args, *command);
  });
}

}  // namespace clast
