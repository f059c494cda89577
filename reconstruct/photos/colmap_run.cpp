#include "reconstruct/photos/colmap_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/files/child_process.hpp"
#include "core/files/digest.hpp"
#include "core/files/staging_path.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"
#include "reconstruct/photos/model_files.hpp"
#include "reconstruct/photos/photo_masks.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMinMatchedPhotos = 3;
constexpr std::size_t kToldLines = 3;
/// A second group of this many photos is reported: it is a ring or a side of its own.
constexpr std::size_t kMinGroupSize = 3;
const char* const kAdvice = "take one every 10-15 degrees";

/// Last lines of a log that say something.
std::string last_lines(const fs::path& log) {
  std::vector<std::string> lines;
  std::error_code code;
  if (!fs::exists(log, code)) return "";
  std::istringstream text(read_text_file(log));
  for (std::string line; std::getline(text, line);) {
    if (line.find_first_not_of(" \t\r=") != std::string::npos) lines.push_back(line);
  }
  std::string last;
  for (std::size_t i = lines.size() - std::min(lines.size(), kToldLines); i < lines.size(); ++i) {
    last += (last.empty() ? "" : " | ") + lines[i];
  }
  return last;
}

/// COLMAP's steps in a folder of its own, which is thrown away unless it is kept.
class ColmapJob {
 public:
  /// @param kept  where its result will be
  ColmapJob(fs::path program, const fs::path& photos, const fs::path& kept,
            const ColmapOptions& options, const std::function<void(const std::string&)>& stage)
      : program_(std::move(program)), photos_(photos), options_(options), stage_(stage) {
    std::error_code code;
    fs::create_directories(kept.parent_path(), code);
    if (code) {
      throw InputError(kept.parent_path().string() + ": can't be made (" + code.message() +
                       "); choose another folder with `cache`");
    }
    part_.emplace(kept, StagingPath::Kind::kFolder);
    work_ = part_->path();
    fs::create_directory(work_ / "sparse", code);
  }
  ~ColmapJob() {
    std::error_code code;
    fs::remove_all(work_, code);
  }
  ColmapJob(const ColmapJob&) = delete;
  ColmapJob& operator=(const ColmapJob&) = delete;

  void find_features(const std::vector<fs::path>& files) {
    // One camera for all photos of a size: what a phone gives. Others get one each.
    std::set<std::pair<int, int>> sizes;
    for (const fs::path& file : files) {
      const photos_detail::PhotoSize size = photos_detail::photo_size(file);
      sizes.insert({size.width, size.height});
    }
    std::string list;
    for (const fs::path& file : files) list += fs::relative(file, photos_).string() + "\n";
    write_text_file(work_ / "list.txt", list);
    std::vector<std::string> words = {"--image_path",
                                      photos_.string(),
                                      "--image_list_path",
                                      (work_ / "list.txt").string(),
                                      "--ImageReader.camera_model",
                                      "SIMPLE_RADIAL",
                                      "--ImageReader.single_camera",
                                      sizes.size() == 1 ? "1" : "0",
                                      "--SiftExtraction.use_gpu",
                                      "0",
                                      "--SiftExtraction.first_octave",
                                      "0",
                                      "--SiftExtraction.max_num_features",
                                      std::to_string(options_.features),
                                      "--SiftExtraction.max_image_size",
                                      std::to_string(options_.max_image_side)};
    if (!options_.masks.empty()) {
      words.insert(words.end(), {"--ImageReader.mask_path", plain_masks(files).string()});
    }
    step("COLMAP: finding features in " + std::to_string(files.size()) + " photos",
         "feature_extractor", words);
  }
  void match(bool exhaustive, std::size_t count) {
    const std::string what = "COLMAP: matching " + std::to_string(count) + " photos";
    const std::vector<std::string> plain = {"--SiftMatching.use_gpu", "0"};
    if (exhaustive) return step(what, "exhaustive_matcher", plain);
    std::vector<std::string> words = plain;
    words.insert(words.end(), {"--SequentialMatching.overlap", "12"});
    step(what, "sequential_matcher", words);
  }
  /// Groups of photos that hang together, the largest first.
  std::vector<PhotoModel> solve_poses(std::size_t count) {
    const bool placed =
        try_step("COLMAP: placing " + std::to_string(count) + " cameras", "mapper",
                 {"--image_path", photos_.string(), "--output_path", (work_ / "sparse").string(),
                  "--Mapper.ba_refine_principal_point", "0"});
    std::vector<PhotoModel> groups;
    for (const auto& entry : fs::directory_iterator(work_ / "sparse")) {
      if (!contains_photo_model(entry.path())) continue;
      groups.push_back(read_photo_model(entry.path()));
      folders_.push_back(entry.path());
    }
    if (groups.empty() && !placed) {
      const std::string log = read_text_file(work_ / "mapper.log");
      const bool apart = log.find("initial image pair") != std::string::npos ||
                         log.find("failed to create sparse model") != std::string::npos;
      if (!apart) fail("mapper");
    }
    std::vector<std::size_t> order(groups.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const std::size_t na = groups[a].photos.size(), nb = groups[b].photos.size();
      return na > nb || (na == nb && folders_[a] < folders_[b]);
    });
    std::vector<PhotoModel> sorted;
    std::vector<fs::path> folders;
    for (const std::size_t i : order) {
      sorted.push_back(std::move(groups[i]));
      folders.push_back(folders_[i]);
    }
    folders_ = folders;
    return sorted;
  }
  /// Puts the largest group into the cache, whole or not at all.
  void keep(const fs::path& target) const {
    std::error_code code;
    fs::remove_all(target, code);
    fs::rename(folders_.front(), target, code);
  }

 private:
  /// Masks by the names that COLMAP looks for: a.jpg.png of a.jpg.
  fs::path plain_masks(const std::vector<fs::path>& files) const {
    const std::vector<fs::path> masks = find_masks(files, options_.masks);
    for (std::size_t i = 0; i < files.size(); ++i) {
      const fs::path target = work_ / "masks" / (fs::relative(files[i], photos_).string() + ".png");
      fs::create_directories(target.parent_path());
      photos_detail::write_binary_mask(masks[i], target);
    }
    return work_ / "masks";
  }
  std::vector<std::string> words(const std::string& command,
                                 const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {program_.string(), command};
    if (command != "help") {
      all.insert(all.end(), {"--database_path", (work_ / "features.db").string()});
    }
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
  }
  bool try_step(const std::string& what, const std::string& command,
                const std::vector<std::string>& arguments) {
    if (stage_) stage_(what);
    const ProcessResult end =
        run_child_process(words(command, arguments), {{"QT_QPA_PLATFORM", "offscreen"}},
                          work_ / (command + ".log"), options_.time_limit);
    if (end.timed_out) {
      throw InputError(
          "colmap " + command + " was stopped after " +
          format_significant(options_.time_limit / 60.0, 3) +
          " minutes: use fewer or smaller photos, or raise the time limit with `seconds`");
    }
    return end.exit_code == 0;
  }
  void step(const std::string& what, const std::string& command,
            const std::vector<std::string>& arguments) {
    if (!try_step(what, command, arguments)) fail(command);
  }
  [[noreturn]] void fail(const std::string& command) const {
    throw InputError("colmap " + command +
                     " failed; it said: " + last_lines(work_ / (command + ".log")));
  }

  fs::path program_, photos_, work_;
  std::optional<StagingPath> part_;  ///< of `work_`
  const ColmapOptions& options_;
  const std::function<void(const std::string&)>& stage_;
  std::vector<fs::path> folders_;
};

/// "31 of 47 photos" must be enough, and in one group.
void judge(const std::vector<PhotoModel>& groups, std::size_t count, const ColmapOptions& options) {
  const std::string all = std::to_string(count) + " photos";
  if (groups.empty()) {
    throw InputError("0 of " + all +
                     " could be placed: no two photos share enough matching points. The photos are "
                     "probably too far apart, blurred, or of a block without texture: " +
                     kAdvice + ", all round the block");
  }
  const std::size_t placed = groups.front().photos.size();
  const double fraction = static_cast<double>(placed) / static_cast<double>(count);
  std::size_t large = 0;
  std::string sizes;
  for (const PhotoModel& group : groups) {
    if (group.photos.size() < kMinGroupSize) continue;
    ++large;
    sizes += (sizes.empty() ? "" : " and ") + std::to_string(group.photos.size());
  }
  if (fraction >= options.min_posed_fraction) return;
  if (large > 1) {
    throw InputError("the " + all + " fall into " + std::to_string(large) + " separate groups (" +
                     sizes +
                     " photos) that share no view: add photos between them, or give one "
                     "group alone; " +
                     kAdvice);
  }
  throw InputError(std::to_string(placed) + " of " + all +
                   " could be placed: the others share too few matching points with them, so a "
                   "side of the block would be missing. Add photos between; " +
                   kAdvice + ", sharp and in even light");
}

/// A folder of masks may lie in that of the photos.
std::vector<fs::path> photos_beside_masks(const fs::path& folder, const fs::path& masks) {
  std::vector<fs::path> files = find_photos(folder);
  if (masks.empty()) return files;
  const fs::path apart = fs::weakly_canonical(masks);
  std::erase_if(files, [&](const fs::path& file) {
    const fs::path below = fs::weakly_canonical(file).lexically_relative(apart);
    return !below.empty() && *below.begin() != "..";
  });
  return files;
}

}  // namespace

void ColmapOptions::check() const {
  const auto require = [](bool fine, const char* name, double value) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + format_significant(value, 6) + " is out of range");
  };
  require(time_limit > 0.0 && time_limit <= 1e6, "seconds", time_limit);
  require(features >= 100 && features <= 100000, "features", features);
  require(max_image_side >= 200 && max_image_side <= 20000, "most_pixels", max_image_side);
  require(min_posed_fraction > 0.0 && min_posed_fraction <= 1.0, "least_share", min_posed_fraction);
}

fs::path default_photo_cache() {
  for (const auto& [variable, inner] : {std::pair{"XDG_CACHE_HOME", ""}, {"HOME", ".cache"}}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && *folder != '\0') return fs::path(folder) / inner / "clast" / "photos";
  }
  return fs::temp_directory_path() / "clast-photos";
}

std::string compute_photo_digest(const fs::path& folder) {
  std::string text;
  for (const fs::path& file : find_photos(folder)) {
    text += fs::relative(file, folder).generic_string() + " " + sha256_of_file(file) + "\n";
  }
  return sha256(text);
}

PhotoModel run_colmap(const fs::path& folder, const ColmapOptions& options,
                      const std::function<void(const std::string&)>& stage) {
  options.check();
  const std::vector<fs::path> files = photos_beside_masks(folder, options.masks);
  if (files.size() < kMinMatchedPhotos) {
    throw InputError(folder.string() + ": " + std::to_string(files.size()) +
                     " photos are too few for a block; take 30 to 60 all round it, " +
                     "one every 10-15 degrees");
  }
  const std::string masks = options.masks.empty() ? "" : compute_photo_digest(options.masks);
  const std::string key =
      compute_photo_digest(folder) + masks + " " + std::to_string(options.features) + " " +
      std::to_string(options.max_image_side) + " " + std::to_string(options.max_exhaustive_photos);
  const fs::path cache = options.cache.empty() ? default_photo_cache() : options.cache;
  const fs::path kept = cache / sha256(key).substr(0, 32);
  const auto finished = [&](PhotoModel model) {
    model.photos_without_pose = files.size() - model.photos.size();
    return locate_photo_files(std::move(model), folder);
  };
  if (contains_photo_model(kept)) {
    PhotoModel model = read_photo_model(kept);
    judge({model}, files.size(), options);
    return finished(std::move(model));
  }
  const fs::path program = find_executable(options.program);
  if (program.empty()) {
    throw InputError("cameras of photos are found by the program colmap, and " + options.program +
                     " isn't there: install the package colmap (Debian, Ubuntu: apt-get install "
                     "colmap), or give camera poses of another program with `model`");
  }
  ColmapJob job(program, fs::absolute(folder), kept, options, stage);
  job.find_features(files);
  const bool all_pairs = files.size() <= options.max_exhaustive_photos;
  job.match(all_pairs, files.size());
  std::vector<PhotoModel> groups = job.solve_poses(files.size());
  judge(groups, files.size(), options);
  job.keep(kept);
  return finished(std::move(groups.front()));
}

}  // namespace clast
