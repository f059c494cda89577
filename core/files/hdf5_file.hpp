#pragma once
/// HDF5 files as groups of typed arrays and attributes, without HDF5 types in the interface. Block
/// libraries, terrains and results are such files.
///
/// Files have the format of HDF5 1.8. After a kill, they are readable up to the last `flush`. Each
/// group and dataset has a checksum of its attributes and values (docs/formats.md), which readers
/// verify if it exists. Children are ordered by name. Not thread-safe.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace clast {

/// Open HDF5 group. Copies share a handle, which is closed with the last copy.
///
/// Element types: double, float, std::int64_t, std::int32_t, std::uint32_t, std::uint16_t,
/// std::uint8_t, and std::string (UTF-8, stored at the width of the longest). Readers throw
/// InputError if something is missing, truncated, of another type or has a wrong checksum. The
/// message names file and dataset.
class Hdf5Group {
 public:
  bool contains(const std::string& name) const;
  /// Returns the sorted names of the groups and datasets in this group.
  std::vector<std::string> child_names() const;
  Hdf5Group open_group(const std::string& name) const;
  Hdf5Group create_group(const std::string& name);
  /// Removes a child. Its space in the file is freed only when the file is rewritten.
  void remove(const std::string& name);

  /// Writes an array, in compressed chunks above 4 kB. Without `shape`, it has one dimension.
  template <class T>
  void write(const std::string& name, std::span<const T> values,
             const std::vector<std::size_t>& shape = {});
  /// Reads an array. The conversion to T must be lossless: float to double, but not vice versa.
  template <class T>
  std::vector<T> read(const std::string& name) const;
  std::vector<std::size_t> shape(const std::string& name) const;

  template <class T>
  void set_attribute(const std::string& name,
                     const T& value);  ///< double, std::int64_t, std::string
  template <class T>
  T read_attribute(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  /// Sets the attribute "unit" of a dataset, for example "kg m^2".
  void set_unit(const std::string& name, const std::string& unit);
  /// Returns the unit of a dataset; empty if there is none.
  std::string unit(const std::string& name) const;

 private:
  friend class Hdf5File;
  struct Handle;
  explicit Hdf5Group(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {}
  Hdf5Group open_dataset(const std::string& name) const;
  std::shared_ptr<Handle> handle_;
};

/// Open HDF5 file with a schema. Its root has the attributes `format` (such as "clast block
/// library"), `schema_version` (integer) and `program_version`.
class Hdf5File {
 public:
  /// Creates or truncates the file and writes format, schema and program version.
  static Hdf5File create(const std::filesystem::path& path, const std::string& format,
                         int schema_version);
  /// Opens a file.
  /// @throws InputError  if the file is missing, not HDF5, truncated, of another format or of a
  ///                     newer schema; the message names file, found and expected values
  static Hdf5File open(const std::filesystem::path& path, const std::string& format,
                       int newest_schema_version, bool writable = false);

  /// Reads only the format of a file, for example "clast terrain"; empty if the file is not HDF5,
  /// not written by clast, or damaged.
  static std::string read_format(const std::filesystem::path& path);

  Hdf5Group root() const;
  /// Flushes data to the operating system. Call it before closing, which cannot report a full disk.
  /// @throws InputError  if the disk is full or not available
  void flush();

 private:
  explicit Hdf5File(std::shared_ptr<Hdf5Group::Handle> handle) : handle_(std::move(handle)) {}
  std::shared_ptr<Hdf5Group::Handle> handle_;
};

}  // namespace clast
