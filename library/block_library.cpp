#include "library/block_library.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "library/body_record.hpp"
#include "library/detail/block_checks.hpp"
#include "library/detail/hdf5_records.hpp"

namespace clast {

using namespace library_detail;

namespace {

constexpr int kSchema = 1;

void write_field_notes(Hdf5Group group, const FieldNotes& field) {
  group.set_attribute("site", field.site);
  group.set_attribute("note", field.note);
  if (field.weighed_mass) group.set_attribute("weighed_mass_kg", *field.weighed_mass);
  if (field.taped_axes) {
    const Vec3 taped(field.taped_axes->L, field.taped_axes->I, field.taped_axes->S);
    write_matrix(group, "taped_axes", taped, "m");
  }
}

FieldNotes read_field_notes(const Hdf5Group& group, const std::string& where) {
  FieldNotes field;
  field.site = group.read_attribute<std::string>("site");
  field.note = group.read_attribute<std::string>("note");
  if (group.has_attribute("weighed_mass_kg")) {
    field.weighed_mass = read_scalar(group, "weighed_mass_kg", 0.0, where);
  }
  if (group.contains("taped_axes")) {
    const Vec3 taped = read_vector(group, "taped_axes", where);
    check_stored_value(taped.minCoeff() > 0.0, where, "taped_axes are not positive");
    field.taped_axes = Axes{taped[0], taped[1], taped[2]};
  }
  return field;
}

void write_unseen(Hdf5Group group, const VolumeBracket& unseen) {
  group.set_attribute("volume_lower_m3", unseen.lower_volume);
  group.set_attribute("volume_best_m3", unseen.estimated_volume);
  if (unseen.upper_volume) group.set_attribute("volume_upper_m3", *unseen.upper_volume);
  group.set_attribute("invented_share", unseen.filled_fraction);
  group.set_attribute("assumption", unseen.assumption);
  if (unseen.intervals) {
    group.set_attribute("volume_lower90_m3", unseen.intervals->lower_volume);
    group.set_attribute("volume_upper90_m3", unseen.intervals->upper_volume);
    write_matrix(group, "axes_lower90", unseen.intervals->sides.lower, "m");
    write_matrix(group, "axes_upper90", unseen.intervals->sides.upper, "m");
  }
  if (!unseen.sides) return;
  write_matrix(group, "axes_lower", unseen.sides->lower, "m");
  write_matrix(group, "axes_upper", unseen.sides->upper, "m");
}

VolumeBracket read_unseen(const Hdf5Group& group, const std::string& where) {
  constexpr double kPositive = 1e-300;
  VolumeBracket unseen;
  unseen.lower_volume = read_scalar(group, "volume_lower_m3", kPositive, where);
  unseen.estimated_volume = read_scalar(group, "volume_best_m3", unseen.lower_volume, where);
  if (group.has_attribute("volume_upper_m3")) {
    unseen.upper_volume = read_scalar(group, "volume_upper_m3", unseen.estimated_volume, where);
  }
  unseen.filled_fraction = read_scalar(group, "invented_share", 0.0, where);
  check_stored_value(unseen.filled_fraction <= 1.0, where, "invented_share is more than 1");
  const auto lengths = [&](const std::string& name) {
    const Vec3 read = read_vector(group, name, where);
    check_stored_value(read.minCoeff() > 0.0, where, name + " is not positive");
    return read;
  };
  if (group.has_attribute("assumption")) {
    unseen.assumption = group.read_attribute<std::string>("assumption");
  }
  const auto side_bounds = [&](const std::string& lower, const std::string& upper) {
    const BoxSideBounds sides{lengths(lower), lengths(upper)};
    check_stored_value((sides.lower.array() <= sides.upper.array()).all(), where,
                       lower + " is above " + upper);
    return sides;
  };
  if (group.has_attribute("volume_lower90_m3")) {
    SizeIntervals intervals;
    intervals.lower_volume = read_scalar(group, "volume_lower90_m3", kPositive, where);
    intervals.upper_volume = read_scalar(group, "volume_upper90_m3", intervals.lower_volume, where);
    intervals.sides = side_bounds("axes_lower90", "axes_upper90");
    unseen.intervals = intervals;
  }
  if (group.contains("axes_lower")) {
    unseen.sides = side_bounds("axes_lower", "axes_upper");
  } else if (group.contains(
                 "box_lower")) {  // files of clast 0.x: boxes of a small and a large shape
    const Vec3 small = lengths("box_lower"), large = lengths("box_upper");
    unseen.sides = BoxSideBounds{small.cwiseMin(large), small.cwiseMax(large)};
  }
  return unseen;
}

void write_deposit_record(Hdf5Group group, const DepositRecord& deposit) {
  group.set_attribute("points", static_cast<std::int64_t>(deposit.points));
  group.set_attribute("blocks", static_cast<std::int64_t>(deposit.blocks));
  group.set_attribute("spacing_m", deposit.spacing);
  group.set_attribute("visible_fraction", deposit.visible_fraction);
  group.set_attribute("confidence", deposit.confidence);
  group.write<std::string>("contacts", deposit.contacts);
  group.set_unit("contacts", "1");
}

DepositRecord read_deposit_record(const Hdf5Group& group, const std::string& where) {
  DepositRecord deposit;
  const auto count = [&](const std::string& name) {
    const auto number = group.read_attribute<std::int64_t>(name);
    check_stored_value(number > 0, where, name + " is not positive");
    return static_cast<std::size_t>(number);
  };
  deposit.points = count("points");
  deposit.blocks = count("blocks");
  deposit.spacing = read_scalar(group, "spacing_m", 0.0, where);
  deposit.visible_fraction = read_scalar(group, "visible_fraction", 0.0, where);
  deposit.confidence = read_scalar(group, "confidence", 0.0, where);
  check_stored_value(deposit.visible_fraction <= 1.0 && deposit.confidence <= 1.0, where,
                     "visible_fraction or confidence is more than 1");
  deposit.contacts = group.read<std::string>("contacts");
  return deposit;
}

void write_block(Hdf5Group group, const Block& block) {
  group.set_attribute("source_file", block.source.file);
  group.set_attribute("source_sha256", block.source.sha256);
  group.set_attribute("options", block.source.options);
  group.set_attribute("program_version", block.source.program_version);
  if (block.source.unscaled) group.set_attribute<std::int64_t>("unscaled", 1);
  group.set_attribute<std::int64_t>("from_core", block.from_core ? 1 : 0);

  Hdf5Group surface = group.create_group("surface");
  write_points(surface, "vertices", block.surface.vertices);
  write_indices<3>(surface, "triangles", block.surface.triangles);
  write_body(group.create_group("core"), block.body);

  group.set_attribute("density_kg_m3", block.density);
  group.set_attribute("volume_m3", block.mass.volume);
  group.set_attribute("mass_kg", block.mass.mass);
  group.set_attribute("area_m2", block.area);
  group.set_attribute("mass_relative_error", block.mass.relative_error);
  write_matrix(group, "centre", block.mass.centre, "m");
  write_matrix(group, "inertia", block.mass.inertia, "kg m^2");
  write_matrix(group, "principal_moments", block.principal.moments, "kg m^2");
  const Quat& q = block.principal.rotation;
  write_matrix(group, "source_from_body", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()), "1");
  group.set_attribute<std::int64_t>("nearly_equal_moments",
                                    block.principal.has_near_equal_moments ? 1 : 0);

  write_matrix(group, "box_centre", block.box.centre, "m");
  write_matrix(group, "box_axes", block.box.axes, "1");
  write_matrix(group, "box_lengths", block.box.lengths, "m");
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
    group.set_attribute(std::string("class_") + scheme, shape_class(scheme, block.axes()));
  }

  group.set_attribute("deviation_hausdorff_m", block.deviation.hausdorff);
  group.set_attribute("deviation_mean_m", block.deviation.mean);
  group.set_attribute("deviation_volume_relative", block.deviation.volume_relative);
  group.set_attribute("deviation_scan_to_body_m", block.deviation.scan_to_body);
  group.set_attribute("deviation_body_to_scan_m", block.deviation.body_to_scan);
  group.set_attribute("deviation_area_relative", block.deviation.area_relative);
  group.set_attribute("deviation_moments_relative", block.deviation.moments_relative);
  group.write<std::string>("warnings", block.warnings);
  group.set_unit("warnings", "1");
  write_field_notes(group.create_group("field"), block.field);
  if (block.volume_bracket) write_unseen(group.create_group("unseen"), *block.volume_bracket);
  if (block.deposit) write_deposit_record(group.create_group("deposit"), *block.deposit);
}

Block read_block(const Hdf5Group& group, const std::string& id, const std::string& where) {
  Block block;
  block.id = id;
  block.source = {
      group.read_attribute<std::string>("source_file"),
      group.read_attribute<std::string>("source_sha256"),
      group.read_attribute<std::string>("options"),
      group.read_attribute<std::string>("program_version"),
      group.has_attribute("unscaled") && group.read_attribute<std::int64_t>("unscaled") != 0};
  block.from_core = group.read_attribute<std::int64_t>("from_core") != 0;

  const Hdf5Group surface = group.open_group("surface");
  block.surface.vertices = read_points(surface, "vertices", where);
  block.surface.triangles =
      read_indices<3>(surface, "triangles", block.surface.vertices.size(), where);
  block.body = read_body(group.open_group("core"), where);

  constexpr double kPositive = 1e-300;
  block.density = read_scalar(group, "density_kg_m3", kPositive, where);
  block.mass.volume = read_scalar(group, "volume_m3", kPositive, where);
  block.mass.mass = read_scalar(group, "mass_kg", kPositive, where);
  block.mass.relative_error = read_scalar(group, "mass_relative_error", 0.0, where);
  block.area = read_scalar(group, "area_m2", 0.0, where);
  block.mass.centre = read_vector(group, "centre", where);
  block.mass.inertia = read_matrix(group, "inertia", where);
  block.principal.moments = read_vector(group, "principal_moments", where);
  const std::vector<double> q = read_array(group, "source_from_body", {4}, where);
  block.principal.rotation = Quat(q[0], q[1], q[2], q[3]);
  check_stored_value(std::abs(block.principal.rotation.norm() - 1.0) < 1e-9, where,
                     "source_from_body is not a rotation");
  block.principal.has_near_equal_moments =
      group.read_attribute<std::int64_t>("nearly_equal_moments") != 0;

  block.box.centre = read_vector(group, "box_centre", where);
  block.box.axes = read_matrix(group, "box_axes", where);
  block.box.lengths = read_vector(group, "box_lengths", where);
  block.deviation.hausdorff = read_scalar(group, "deviation_hausdorff_m", 0.0, where);
  block.deviation.mean = read_scalar(group, "deviation_mean_m", 0.0, where);
  block.deviation.volume_relative = read_scalar(group, "deviation_volume_relative", -1.0, where);
  if (group.has_attribute("deviation_moments_relative")) {  // not in the first libraries
    block.deviation.scan_to_body = read_scalar(group, "deviation_scan_to_body_m", 0.0, where);
    block.deviation.body_to_scan = read_scalar(group, "deviation_body_to_scan_m", 0.0, where);
    block.deviation.area_relative = read_scalar(group, "deviation_area_relative", -1.0, where);
    block.deviation.moments_relative = read_scalar(group, "deviation_moments_relative", 0.0, where);
  }
  block.warnings = group.read<std::string>("warnings");
  block.field = read_field_notes(group.open_group("field"), where);
  if (group.contains("unseen"))
    block.volume_bracket = read_unseen(group.open_group("unseen"), where);
  if (group.contains("deposit")) {
    block.deposit = read_deposit_record(group.open_group("deposit"), where);
  }
  check_block_consistency(block, where);
  return block;
}

std::vector<Block>::const_iterator position(const std::vector<Block>& blocks,
                                            const std::string& id) {
  return std::lower_bound(
      blocks.begin(), blocks.end(), id,
      [](const Block& block, const std::string& key) { return block.id < key; });
}

std::size_t found(const std::vector<Block>& blocks, const std::string& id) {
  const auto at = position(blocks, id);
  if (at != blocks.end() && at->id == id) return static_cast<std::size_t>(at - blocks.begin());
  std::string known;
  for (std::size_t i = 0; i < std::min<std::size_t>(blocks.size(), 20); ++i) {
    known += (i ? ", " : "") + blocks[i].id;
  }
  if (blocks.size() > 20) known += " and " + std::to_string(blocks.size() - 20) + " more";
  throw InputError("no block \"" + id + "\" in the library; " +
                   (blocks.empty() ? "there are none" : "name one of " + known));
}

}  // namespace

void check_block_id(const std::string& id) {
  const bool control = std::any_of(id.begin(), id.end(), [](unsigned char c) { return c < 32; });
  if (control || id.find('/') != std::string::npos ||
      id.find_first_not_of('.') == std::string::npos) {
    throw InputError("\"" + id +
                     "\" can't be the id of a block: it needs a letter or digit, no slash, and no "
                     "line break or other control character; rename the file");
  }
}

BlockLibrary BlockLibrary::read(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, kLibraryFormat, kSchema);
  const Hdf5Group blocks = file.root().open_group("blocks");
  BlockLibrary library;
  for (const std::string& id : blocks.child_names()) {
    library.add(read_block(blocks.open_group(id), id, path.string() + ": block " + id));
  }
  return library;
}

void BlockLibrary::write(const std::filesystem::path& path) const {
  OutputFile output(path, {.kind = kLibraryFormat});
  {
    Hdf5File file = Hdf5File::create(output.temporary_path(), kLibraryFormat, kSchema);
    Hdf5Group blocks = file.root().create_group("blocks");
    for (const Block& block : blocks_) write_block(blocks.create_group(block.id), block);
    file.flush();
  }
  output.commit();
}

bool BlockLibrary::contains(const std::string& id) const {
  const auto at = position(blocks_, id);
  return at != blocks_.end() && at->id == id;
}

const Block& BlockLibrary::find_block(const std::string& id) const {
  return blocks_[found(blocks_, id)];
}

Block& BlockLibrary::find_block(const std::string& id) { return blocks_[found(blocks_, id)]; }

std::vector<const Block*> BlockLibrary::select_blocks(const std::vector<std::string>& ids) const {
  std::vector<const Block*> chosen;
  for (const std::string& id : ids) chosen.push_back(&find_block(id));
  if (!ids.empty()) return chosen;
  for (const Block& block : blocks_) chosen.push_back(&block);
  return chosen;
}

namespace {

/// A library with bounds that no body has could not be read again.
void check_unseen(const Block& block) {
  if (!block.volume_bracket) return;
  const VolumeBracket& unseen = *block.volume_bracket;
  const auto require = [&](bool fine) {
    if (fine) return;
    throw InputError("block " + block.id + ": the bounds of its unobserved part, volume from " +
                     format_significant(unseen.lower_volume, 4) + " m^3 about " +
                     format_significant(unseen.estimated_volume, 4) +
                     " m^3, are impossible for a body; scan more of the block");
  };
  require(unseen.lower_volume > 0.0 && unseen.estimated_volume >= unseen.lower_volume);
  require(!unseen.upper_volume || *unseen.upper_volume >= unseen.estimated_volume);
  if (!unseen.sides) return;
  require(unseen.sides->lower.minCoeff() > 0.0);
  require((unseen.sides->lower.array() <= unseen.sides->upper.array()).all());
}

}  // namespace

void BlockLibrary::add(Block block, bool replace) {
  for (std::string* text : {&block.id, &block.source.file, &block.source.options, &block.field.site,
                            &block.field.note}) {
    *text = to_utf8(*text);
  }
  for (std::string& warning : block.warnings) warning = to_utf8(warning);
  check_block_id(block.id);
  check_unseen(block);
  if (!contains(block.id)) {
    blocks_.insert(position(blocks_, block.id), std::move(block));
  } else if (replace) {
    this->find_block(block.id) = std::move(block);
  } else {
    throw InputError("block " + block.id +
                     " is in the library already; use `replace` to put the "
                     "new one in its place");
  }
}

void BlockLibrary::remove(const std::string& id) {
  blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(found(blocks_, id)));
}

}  // namespace clast
