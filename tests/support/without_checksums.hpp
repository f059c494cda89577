#pragma once
/// HDF5 files as versions wrote them that knew no checksums.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace clast {

/// Removes the attribute `checksum` of the groups and datasets that `which` chooses, by their path
/// in the file ("." is the root).
inline void remove_checksums_of(const std::filesystem::path& path,
                                const std::function<bool(const std::string&)>& which) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
  ASSERT_GE(file, 0);
  std::vector<std::string> names;
  H5Ovisit(
      file, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t, const char* name, const H5O_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
      },
      &names);
  std::size_t removed = 0;
  for (const std::string& name : names) {
    if (!which(name)) continue;
    EXPECT_GE(H5Adelete_by_name(file, name.c_str(), "checksum", H5P_DEFAULT), 0) << name;
    ++removed;
  }
  EXPECT_GT(removed, 0u);
  H5Fclose(file);
  H5Pclose(access);
}

/// The file as a version without checksums wrote it.
inline void remove_checksums(const std::filesystem::path& path) {
  remove_checksums_of(path, [](const std::string&) { return true; });
}

inline void remove_checksum(const std::filesystem::path& path, const std::string& object) {
  remove_checksums_of(path, [&](const std::string& name) { return name == object; });
}

}  // namespace clast
