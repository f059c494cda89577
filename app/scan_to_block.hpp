#pragma once
/// The whole way from a scan file to a block.
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "library/make_block.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "reconstruct/simplify.hpp"

namespace clast {

/// Options of every step.
struct ScanToBlockOptions {
  ScanOptions scan;
  std::string unit_name = "m";  ///< as the user wrote it, for messages and the record
  /// The two points whose distance gave the unit, in the scan's own units and axes.
  std::optional<std::array<Vec3, 2>> scale_points;
  double scale_factor = 1.0;  ///< what `scan.unit` holds beside the unit itself
  /// Vertices a block has at most, not used for a core. None: the fewest of 8 to 2000, to about a
  /// tenth, with which the block is within the tolerance; the radius is halved where none will do.
  std::optional<std::size_t> vertices;
  BlockOptions block;
  bool radius_given = false;  ///< the radius, or its share of S, is the user's and stays
  bool any_size = false;      ///< take blocks beyond the usual sizes
  bool up_given = false;      ///< `scan.up` is the user's and holds whatever the ground says
  bool find_ground = true;
  bool split = false;       ///< every block that stands on the ground of a scan
  PhotoScanOptions photos;  ///< of folders of photographs

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScanToBlockOptions& options, Visit&& visit) {
  const auto& [scan, unit_name, scale_points, scale_factor, vertices, block, radius_given, any_size,
               up_given, find_ground, split, photos] = options;
  visit("scan", scan);
  visit("unit_name", unit_name);
  visit("scale_points", scale_points);
  visit("scale_factor", scale_factor);
  visit("vertices", vertices);
  visit("block", block);
  visit("radius_given", radius_given);
  visit("any_size", NoInfluence{any_size});
  visit("up_given", up_given);
  visit("find_ground", find_ground);
  visit("split", split);
  visit("photos", photos);
}

/// Refuses a size that no rock block has (over 50 m or under 1 mm), which is a wrong unit most of
/// the time. `box` is in metres.
/// @throws InputError  naming the unit that is probably meant
void check_size(const Bounds& box, const std::string& id, const ScanToBlockOptions& options);

/// How a scan got its size, as "key=value" for the record.
std::string scale_text(const ScanToBlockOptions& options);

/// Adds a warning where the surface passes through itself.
void warn_of_crossings(Block& block, const TriangleMesh& surface);

/// Called with a block and what it was made from, while that is there.
/// @param raw    as read, in the file's units and axes; of a cloud the points alone
/// @param found  the closed scan, in the frame of the block
/// @param photos  of a folder of photos, else null
using BlockWitness = std::function<void(const Block& block, const TriangleMesh& raw,
                                        const FieldBlock& found, const PhotoScan* photos)>;

/// Called with the id of a block that could not be made of a scan that is split, and the reason.
using BlockLoss = std::function<void(const std::string& id, const std::string& reason)>;

/// Digest of a file, or of the photos in a folder.
/// @throws InputError  it can't be read
std::string digest_of_scan(const std::filesystem::path& path);

/// Reads, mends, thins and measures one scan. With `split` its blocks are `id`_1, `id`_2, ...,
/// in order of x, then y, of the file; else there is one, `id`.
/// @param stage  called with the name of each step before it starts
/// @param lost   with it one bad block of a split scan does not cost the others
/// @throws InputError, GeometryError  with the file or the id in the message; also what
///         `check_size` throws
std::vector<Block> blocks_from_scan(const std::filesystem::path& path, const std::string& id,
                                    const ScanToBlockOptions& options,
                                    const std::function<void(const std::string&)>& stage = {},
                                    const BlockWitness& witness = {}, const BlockLoss& lost = {});

}  // namespace clast
