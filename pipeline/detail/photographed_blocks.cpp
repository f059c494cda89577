#include "pipeline/detail/photographed_blocks.hpp"

#include <utility>

#include "core/error.hpp"
#include "library/unscaled.hpp"

namespace clast::pipeline_detail {

namespace {

/// Photos give points so dense and exact that a finer surface than that of other clouds pays: with
/// the usual cell a sharp end of a block is 0.6 % of L short, with this one 0.14 %.
constexpr double kPhotoCell = 0.003;

}  // namespace

PhotographedBlocks reconstruct_photographs(const std::filesystem::path& folder,
                                           const ScanToBlockOptions& options,
                                           FieldScanOptions reading, BlockSource& source,
                                           const ScanCallbacks& callbacks) {
  PhotoScanOptions photos = options.photos;
  if (options.scale_points || reading.scan.unit != 1.0) photos.metres_per_unit = reading.scan.unit;
  PhotoScan scan = reconstruct_from_photos(
      folder, photos, [&](const std::string& what) { callbacks.begin_step(what, true); });
  if (!scan.metric && options.block.mass) {
    throw InputError(folder.string() +
                     ": `mass` needs a scale, but these photos have none; give `bars` or "
                     "`marker_side`");
  }
  reading.scan.unit = 1.0;
  reading.surface.averaging_cell = kPhotoCell;
  reading.free_space = &scan.cloud.free_space;
  for (const Photo& photo : scan.model.photos) reading.stations.push_back(photo.centre());
  callbacks.begin_step(
      "finding the surface in " + std::to_string(scan.cloud.points.size()) + " points", true);
  FieldScan found;
  try {
    if (reading.split) {
      static_cast<FieldDeposit&>(found) =
          extract_deposit_blocks(scan.cloud.points, folder.string(), reading);
    } else {
      found.blocks = extract_field_blocks(scan.cloud.points, folder.string(), reading);
    }
  } catch (const Error& error) {  // mostly for want of photos, which points don't know
    throw GeometryError(std::string(error.what()) +
                        ". The points come from photos: " + scan.notes.front() +
                        ". Take one every 10 to 15 degrees all round the block, so that "
                        "neighbouring photos overlap widely");
  }
  found.raw.vertices = scan.cloud.points;
  source.options = "photos=" + std::to_string(scan.model.photos.size()) +
                   " cameras=" + scan.model.source + " scale=" + scan.scale_source;
  source.unscaled = !scan.metric;
  for (FieldBlock& block : found.blocks) {
    std::vector<std::string>& notes = block.scan.notes;
    notes.insert(notes.begin(), scan.notes.begin(), scan.notes.end());
    if (!scan.metric) {
      notes.insert(notes.begin(),
                   "UNSCALED; lengths in m in the notes are in units of the model: " +
                       explain_unscaled_block());
    }
  }
  return {std::move(found), std::move(scan)};
}

}  // namespace clast::pipeline_detail
