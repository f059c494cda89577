#pragma once
/// HDF5 files as groups of typed arrays and attributes, without an HDF5 type in sight. The block
/// library, the terrain file and the results file are all written through this.
///
/// Files are written in the format of HDF5 1.8, which a killed process leaves readable up to the
/// last `flush` and whose structures carry checksums. Every group and dataset has a checksum of its
/// attributes and values besides (docs/formats.md), and every reader verifies it; only files of
/// versions that wrote none, which have none on their root, are read without. Link-time order of
/// children is by name. One thread at a time.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace clast {

/// An open group. Copies share the handle; it closes with the last of them.
///
/// Element types: double, float, std::int64_t, std::int32_t, std::uint32_t, std::uint16_t,
/// std::uint8_t, std::string (UTF-8, stored at the width of the longest). Every reader throws
/// InputError naming file and dataset when something is missing, of another type, truncated, or
/// does not agree with its checksum.
class Hdf5Group {
 public:
  bool contains(const std::string& name) const;
  /// Names of the groups and datasets in here, sorted.
  std::vector<std::string> child_names() const;
  Hdf5Group open_group(const std::string& name) const;
  Hdf5Group create_group(const std::string& name);
  /// Unlinks a child; the space is given back when the file is rewritten.
  void remove(const std::string& name);

  /// Arrays over 4 kB are stored in compressed chunks. An empty shape stands for a list.
  template <class T>
  void write(const std::string& name, std::span<const T> values,
             const std::vector<std::size_t>& shape = {});
  /// Numbers of the stored type must be numbers of T without loss: float is read as double, not the
  /// other way.
  template <class T>
  std::vector<T> read(const std::string& name) const;
  std::vector<std::size_t> shape(const std::string& name) const;

  template <class T>
  void set_attribute(const std::string& name,
                     const T& value);  ///< double, std::int64_t, std::string
  template <class T>
  T read_attribute(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  /// Attribute "unit" of the dataset `name`, for example "kg m^2".
  void set_unit(const std::string& name, const std::string& unit);
  /// Empty when the dataset has none.
  std::string unit(const std::string& name) const;

 private:
  friend class Hdf5File;
  struct Handle;
  explicit Hdf5Group(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {}
  /// A dataset seen as a holder of attributes.
  Hdf5Group open_dataset(const std::string& name) const;
  std::shared_ptr<Handle> handle_;
};

/// An open HDF5 file with a schema: attributes `format` (what the file is, for example
/// "clast block library"), `schema_version` (integer) and `program_version` on its root.
class Hdf5File {
 public:
  /// Makes or empties the file and stamps format, schema and program version.
  static Hdf5File create(const std::filesystem::path& path, const std::string& format,
                         int schema_version);
  /// @throws InputError  missing, not HDF5, truncated, of another format, or of a newer schema;
  ///                     the message names the file and what was found and expected
  static Hdf5File open(const std::filesystem::path& path, const std::string& format,
                       int newest_schema_version, bool writable = false);

  /// What a file says that it is, without a look at the rest of it: "clast terrain". Empty when it
  /// is not HDF5, not clast's, or damaged.
  static std::string read_format(const std::filesystem::path& path);

  Hdf5Group root() const;
  /// Hands everything written so far to the operating system. Call it before a file counts as
  /// written: closing can't report a full disk.
  /// @throws InputError  the disk is full or gone
  void flush();

 private:
  explicit Hdf5File(std::shared_ptr<Hdf5Group::Handle> handle) : handle_(std::move(handle)) {}
  std::shared_ptr<Hdf5Group::Handle> handle_;
};

}  // namespace clast
