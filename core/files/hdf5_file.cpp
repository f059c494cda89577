#include "core/files/hdf5_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/files/detail/hdf5_checksum.hpp"
#include "core/files/detail/hdf5_chunks.hpp"
#include "core/files/detail/hdf5_types.hpp"
#include "core/files/input_file.hpp"
#include "core/version.hpp"

namespace clast {

namespace fs = std::filesystem;
using namespace hdf5;

namespace {

/// After a write that failed, as on a full disk, HDF5's own clean-up at exit would write again and
/// crash. Every file is closed by its handle, so nothing is left to it. Counts only before the
/// first use of HDF5, hence here.
[[maybe_unused]] const herr_t kNoCleanUpAtExit = H5dont_atexit();

constexpr std::size_t kSmallest = 4096;  ///< bytes; smaller arrays are stored plain
/// Deflate shrinks at most 1032 times: an array that claims more than this of its bytes on disk is
/// damaged, and is refused before memory is asked for.
constexpr std::size_t kMaxRatio = 1040;

constexpr const char* kDamaged = "; the file is damaged: restore a backup, or make it again";

/// Creation properties of a dataset; no times, so that equal content gives equal bytes.
ScopedId dataset_properties() {
  ScopedId properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  return properties;
}

/// The format of HDF5 1.8: its structures carry checksums, so that damage is found instead of
/// followed, and unlike that of 1.10 it does not lock out readers after a killed writer.
ScopedId access_properties() {
  ScopedId properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(properties, H5F_LIBVER_V18, H5F_LIBVER_V18);
  return properties;
}

}  // namespace

/// An open file or group, with the name it has in messages.
struct Hdf5Group::Handle {
  ScopedId id;
  std::string file;
  std::string path;     ///< inside the file: "" for the root, "/blocks/B017"
  bool checked = true;  ///< the file has checksums; those of the first versions have none

  hid_t get() const {
    silence_hdf5_errors();
    return id;
  }
  std::string where(const std::string& name) const { return file + ": " + path + "/" + name; }

  [[noreturn]] void fail(const std::string& name, const std::string& what) const {
    throw InputError(where(name) + " " + what);
  }
  [[noreturn]] void fail_damaged(const std::string& name) const {
    fail(name, "can't be read" + last_hdf5_error() + kDamaged);
  }
  [[noreturn]] void fail_missing(const std::string& name) const {
    fail(name, std::string("is missing") + kDamaged);
  }
  [[noreturn]] void fail_write(const std::string& name) const {
    fail(name, "can't be written" + last_hdf5_error() + "; is the disk full? Free some space");
  }

  /// An unreadable object is not treated as missing; otherwise damaged optional parts would be
  /// lost.
  bool has(const std::string& name) const {
    const htri_t there = H5Lexists(get(), name.c_str(), H5P_DEFAULT);
    if (there < 0) fail_damaged(name);
    return there > 0;
  }
  bool has_attribute(const std::string& name) const {
    const htri_t there = H5Aexists(get(), name.c_str());
    if (there < 0) fail_damaged("@" + name);
    return there > 0;
  }
  Handle child(ScopedId opened, const std::string& name) const {
    return {std::move(opened), file, path + "/" + name, checked};
  }

  /// Checks the stored checksum of attributes and values.
  void verify(hid_t object, const std::string& name, std::uint64_t values) const {
    if (!checked) return;
    const std::optional<std::uint64_t> attributes = attributes_checksum(object);
    if (!attributes) fail(name, std::string("has attributes that can't be read") + kDamaged);
    if (stored_checksum(object) == (*attributes ^ values)) return;
    fail(name, std::string("does not agree with its checksum") + kDamaged);
  }
  /// Adds to the checksum of an object that was written to.
  void note_change(hid_t object, const std::string& name, std::uint64_t change) const {
    if (checked && !update_checksum(object, change)) fail_write(name);
  }

  ScopedId dataset(const std::string& name) const {
    if (!has(name)) fail_missing(name);
    ScopedId dataset(H5Dopen2(get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset.valid()) fail(name, "is not a readable dataset" + last_hdf5_error() + kDamaged);
    return dataset;
  }

  std::vector<hsize_t> extent(const ScopedId& dataset, const std::string& name) const {
    const ScopedId space(H5Dget_space(dataset), H5Sclose);
    const int rank = space.valid() ? H5Sget_simple_extent_ndims(space) : -1;
    if (rank < 0) fail_damaged(name);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    return sizes;
  }

  /// @return bytes of one stored value
  template <class T>
  std::size_t check_type(const ScopedId& dataset, const std::string& name) const {
    const ScopedId type(H5Dget_type(dataset), H5Tclose);
    if (!type.valid()) fail_damaged(name);
    if (!is_lossless_conversion<T>(type))
      fail(name, std::string("does not hold ") + type_name<T>() + kDamaged);
    return std::max<std::size_t>(1, H5Tget_size(type));
  }
};

bool Hdf5Group::contains(const std::string& name) const { return handle_->has(name); }

std::vector<std::string> Hdf5Group::child_names() const {
  std::vector<std::string> result;
  hsize_t position = 0;
  const herr_t status = H5Literate(
      handle_->get(), H5_INDEX_NAME, H5_ITER_INC, &position,
      [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
      },
      &result);
  if (status < 0) handle_->fail_damaged("");
  std::sort(result.begin(), result.end());
  return result;
}

Hdf5Group Hdf5Group::open_group(const std::string& name) const {
  if (!contains(name)) handle_->fail_missing(name);
  ScopedId id(H5Gopen2(handle_->get(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id.valid()) handle_->fail(name, "is not a readable group" + last_hdf5_error() + kDamaged);
  handle_->verify(id, name, 0);
  return Hdf5Group(std::make_shared<Handle>(handle_->child(std::move(id), name)));
}

Hdf5Group Hdf5Group::create_group(const std::string& name) {
  if (contains(name)) handle_->fail(name, "exists already");
  const hid_t parent = handle_->get();
  const ScopedId properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties, false);
  ScopedId id(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose);
  if (!id.valid()) handle_->fail_write(name);
  handle_->note_change(id, name, 0);
  return Hdf5Group(std::make_shared<Handle>(handle_->child(std::move(id), name)));
}

void Hdf5Group::remove(const std::string& name) {
  if (!contains(name)) handle_->fail(name, "is missing; there is nothing to remove");
  if (H5Ldelete(handle_->get(), name.c_str(), H5P_DEFAULT) < 0) handle_->fail_write(name);
}

template <class T>
void Hdf5Group::write(const std::string& name, std::span<const T> values,
                      const std::vector<std::size_t>& shape) {
  const hid_t parent = handle_->get();
  if (contains(name)) handle_->fail(name, "exists already");
  std::vector<hsize_t> sizes(shape.begin(), shape.end());
  if (sizes.empty()) sizes = {values.size()};
  std::size_t row = 1;  // elements below the first index
  for (std::size_t i = 1; i < sizes.size(); ++i) row *= sizes[i];
  if (sizes[0] * row != values.size()) {
    handle_->fail(name, "has " + std::to_string(values.size()) + " values for another shape");
  }

  const Hdf5WriteBuffer<T> stored(values);
  const ScopedId space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
                       H5Sclose);
  const ScopedId properties = dataset_properties();
  if (values.size() * stored.element_size > kSmallest) {
    set_chunked_compression(properties, sizes, row * stored.element_size);
  }
  const ScopedId dataset(H5Dcreate2(parent, name.c_str(), stored.file_type, space, H5P_DEFAULT,
                                    properties, H5P_DEFAULT),
                         H5Dclose);
  if (!dataset.valid()) handle_->fail_write(name);
  const std::size_t bytes = values.size() * stored.element_size;
  handle_->note_change(dataset, name, values_checksum(stored.data(), bytes, values.size()));
  if (values.empty()) return;
  if (H5Dwrite(dataset, stored.memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, stored.data()) < 0) {
    handle_->fail_write(name);
  }
}

template <class T>
std::vector<T> Hdf5Group::read(const std::string& name) const {
  const ScopedId dataset = handle_->dataset(name);
  const std::size_t element = handle_->check_type<T>(dataset, name);
  const hsize_t most = (H5Dget_storage_size(dataset) * kMaxRatio + kSmallest) / element;
  const std::vector<hsize_t> extent = handle_->extent(dataset, name);
  hsize_t count = 1;
  for (const hsize_t size : extent) {
    if (count > 0 && size > most / count)
      handle_->fail(name, std::string("has an impossible size") + kDamaged);
    count *= size;
  }
  if (count > 0 && has_damaged_chunks(dataset, extent)) handle_->fail_damaged(name);
  const auto verified = [&](const auto& bytes) {
    handle_->verify(dataset, name,
                    values_checksum(bytes.data(), bytes.size() * sizeof bytes[0], count));
  };
  const auto read_into = [&](hid_t type, void* out) {
    if (count == 0) return;
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out) < 0) handle_->fail_damaged(name);
  };
  try {
    if constexpr (std::is_same_v<T, std::string>) {
      std::string bytes(count * element, '\0');
      read_into(fixed_string_type(element), bytes.data());
      verified(bytes);
      std::vector<T> values;
      values.reserve(count);
      for (hsize_t i = 0; i < count; ++i)
        values.push_back(unpadded_string(bytes, i * element, element));
      return values;
    } else {
      std::vector<T> values(count);
      read_into(hdf5_number_type<T>(false), values.data());
      if (element == sizeof(T)) {
        verified(values);
      } else {  // stored narrower than it is read
        std::string bytes(count * element, '\0');
        read_into(ScopedId(H5Dget_type(dataset), H5Tclose), bytes.data());
        verified(bytes);
      }
      return values;
    }
  } catch (const std::bad_alloc&) {
    handle_->fail(name, "does not fit into memory (" + std::to_string(count) +
                            " values); use a machine with more memory");
  }
}

std::vector<std::size_t> Hdf5Group::shape(const std::string& name) const {
  const std::vector<hsize_t> sizes = handle_->extent(handle_->dataset(name), name);
  return {sizes.begin(), sizes.end()};
}

template <class T>
void Hdf5Group::set_attribute(const std::string& name, const T& value) {
  const hid_t parent = handle_->get();
  const Hdf5WriteBuffer<T> stored(std::span<const T>(&value, 1));
  std::uint64_t change = attribute_checksum(name, stored.data(), stored.element_size);
  if (has_attribute(name)) {
    const std::optional<std::uint64_t> before = attribute_checksum(parent, name);
    if (!before || H5Adelete(parent, name.c_str()) < 0) handle_->fail_write("@" + name);
    change ^= *before;
  }
  const ScopedId space(H5Screate(H5S_SCALAR), H5Sclose);
  const ScopedId attribute(
      H5Acreate2(parent, name.c_str(), stored.file_type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute, stored.memory_type, stored.data()) < 0) {
    handle_->fail_write("@" + name);
  }
  handle_->note_change(parent, "@" + name, change);
}

template <class T>
T Hdf5Group::read_attribute(const std::string& name) const {
  if (!has_attribute(name)) {
    handle_->fail_missing("@" + name);
  }
  const ScopedId attribute(H5Aopen(handle_->get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const ScopedId type(H5Aget_type(attribute), H5Tclose);
  const ScopedId space(H5Aget_space(attribute), H5Sclose);
  if (!type.valid() || !space.valid()) handle_->fail_damaged("@" + name);
  if (!is_lossless_conversion<T>(type) || H5Sget_simple_extent_npoints(space) != 1) {
    handle_->fail("@" + name, std::string("is not one of ") + type_name<T>() + kDamaged);
  }
  if constexpr (std::is_same_v<T, std::string>) {
    const std::size_t width = H5Tget_size(type);
    std::string bytes(width, '\0');
    if (H5Aread(attribute, fixed_string_type(width), bytes.data()) < 0)
      handle_->fail_damaged("@" + name);
    return unpadded_string(bytes, 0, width);
  } else {
    T value{};
    if (H5Aread(attribute, hdf5_number_type<T>(false), &value) < 0)
      handle_->fail_damaged("@" + name);
    return value;
  }
}

bool Hdf5Group::has_attribute(const std::string& name) const {
  return handle_->has_attribute(name);
}

Hdf5Group Hdf5Group::open_dataset(const std::string& name) const {
  return Hdf5Group(std::make_shared<Handle>(handle_->child(handle_->dataset(name), name)));
}

void Hdf5Group::set_unit(const std::string& name, const std::string& unit) {
  open_dataset(name).set_attribute("unit", unit);
}

std::string Hdf5Group::unit(const std::string& name) const {
  const Hdf5Group holder = open_dataset(name);
  return holder.has_attribute("unit") ? holder.read_attribute<std::string>("unit") : "";
}

Hdf5File Hdf5File::create(const fs::path& path, const std::string& format, int schema_version) {
  silence_hdf5_errors();
  // Time stamps are off, so that equal content gives equal bytes.
  const ScopedId creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  ScopedId id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access_properties()), H5Fclose);
  if (!id.valid()) {
    throw InputError(path.string() +
                     ": can't be written; check the folder and that no other "
                     "program has the file open" +
                     last_hdf5_error());
  }
  Hdf5File file(
      std::make_shared<Hdf5Group::Handle>(Hdf5Group::Handle{std::move(id), path.string(), ""}));
  Hdf5Group root = file.root();
  root.set_attribute<std::string>("format", format);
  root.set_attribute<std::int64_t>("schema_version", schema_version);
  root.set_attribute<std::string>("program_version", version());
  return file;
}

Hdf5File Hdf5File::open(const fs::path& path, const std::string& format, int newest_schema_version,
                        bool writable) {
  silence_hdf5_errors();
  std::error_code code;
  const std::string expected = "; expected a \"" + format + "\" file";
  if (!fs::exists(path, code)) throw InputError(path.string() + ": no such file" + expected);
  if (fs::is_directory(path, code)) throw InputError(path.string() + ": is a folder" + expected);
  check_input_file(path);
  if (fs::file_size(path, code) == 0) throw InputError(path.string() + ": is empty" + expected);
  if (H5Fis_hdf5(path.c_str()) == 0) {
    throw InputError(path.string() + ": is not an HDF5 file" + expected);
  }
  ScopedId id(H5Fopen(path.c_str(), writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access_properties()),
              H5Fclose);
  if (!id.valid()) {
    throw InputError(path.string() + ": can't be opened" + last_hdf5_error() +
                     "; it is cut short, damaged, without read permission, or open in another "
                     "program: close that program, allow reading it, or make the file again");
  }
  Hdf5File file(
      std::make_shared<Hdf5Group::Handle>(Hdf5Group::Handle{std::move(id), path.string(), ""}));
  file.handle_->checked = file.handle_->has_attribute(kChecksumAttribute);
  const Hdf5Group root = file.root();
  if (!root.has_attribute("format")) {
    throw InputError(path.string() + ": is an HDF5 file that clast did not write" + expected);
  }
  file.handle_->verify(file.handle_->get(), "", 0);
  const std::string found = root.read_attribute<std::string>("format");
  if (found != format) throw InputError(path.string() + ": is a \"" + found + "\" file" + expected);
  const std::int64_t schema = root.read_attribute<std::int64_t>("schema_version");
  if (schema > newest_schema_version) {
    throw InputError(path.string() + ": has schema version " + std::to_string(schema) +
                     ", written by clast " + root.read_attribute<std::string>("program_version") +
                     "; this is clast " + version() + " and reads up to version " +
                     std::to_string(newest_schema_version) + ": use a newer clast");
  }
  if (schema < 1) {
    throw InputError(path.string() + ": has schema version " + std::to_string(schema) +
                     ", which does not exist" + kDamaged);
  }
  return file;
}

std::string Hdf5File::read_format(const fs::path& path) {
  silence_hdf5_errors();
  ScopedId id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_properties()), H5Fclose);
  if (!id.valid()) return "";
  const Hdf5File file(std::make_shared<Hdf5Group::Handle>(
      Hdf5Group::Handle{std::move(id), path.string(), "", false}));
  try {
    const Hdf5Group root = file.root();
    return root.has_attribute("format") ? root.read_attribute<std::string>("format") : "";
  } catch (const InputError&) {  // damaged, or another program's "format" that is no text
    return "";
  }
}

Hdf5Group Hdf5File::root() const {
  ScopedId id(H5Gopen2(handle_->get(), "/", H5P_DEFAULT), H5Gclose);
  if (!id.valid())
    throw InputError(handle_->file + ": has no root group" + last_hdf5_error() + kDamaged);
  return Hdf5Group(std::make_shared<Hdf5Group::Handle>(
      Hdf5Group::Handle{std::move(id), handle_->file, "", handle_->checked}));
}

void Hdf5File::flush() {
  errno = 0;
  if (H5Fflush(handle_->get(), H5F_SCOPE_GLOBAL) < 0) {
    const std::string why =
        errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : last_hdf5_error();
    throw InputError(handle_->file + ": can't be written" + why +
                     "; free some space on the disk or name another place");
  }
}

#define CLAST_HDF5_ELEMENT(T)                                               \
  template void Hdf5Group::write<T>(const std::string&, std::span<const T>, \
                                    const std::vector<std::size_t>&);       \
  template std::vector<T> Hdf5Group::read<T>(const std::string&) const;
CLAST_HDF5_ELEMENT(double)
CLAST_HDF5_ELEMENT(float)
CLAST_HDF5_ELEMENT(std::int64_t)
CLAST_HDF5_ELEMENT(std::int32_t)
CLAST_HDF5_ELEMENT(std::uint32_t)
CLAST_HDF5_ELEMENT(std::uint16_t)
CLAST_HDF5_ELEMENT(std::uint8_t)
CLAST_HDF5_ELEMENT(std::string)
#undef CLAST_HDF5_ELEMENT

#define CLAST_HDF5_ATTRIBUTE(T)                                            \
  template void Hdf5Group::set_attribute<T>(const std::string&, const T&); \
  template T Hdf5Group::read_attribute<T>(const std::string&) const;
CLAST_HDF5_ATTRIBUTE(double)
CLAST_HDF5_ATTRIBUTE(std::int64_t)
CLAST_HDF5_ATTRIBUTE(std::string)
#undef CLAST_HDF5_ATTRIBUTE

}  // namespace clast
