#pragma once
/// Unpacking of compressed LAS files (LAZ) by other programs.
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>

#include "core/files/unnamed_file.hpp"

namespace clast::mesh_detail {

/// Copy of an unpacked LAS file, for further readings.
struct LasCopy {
  std::unique_ptr<UnnamedFile> file;  ///< none if there is no room for it
  bool complete = false;
};

/// Runs `read` on a copied LAS file.
void read_las_copy(const LasCopy& copy, const std::function<void(std::istream&)>& read);

/// Program that unpacks a LAZ file, and the LAS file that it gives.
class LazUnpacker {
 public:
  /// Starts the first program at hand whose output `read_begin` takes: laszip, laszip64,
  /// las2las, node with laz-perf, pdal. The last one comes last because it writes the whole LAS
  /// file to the folder for temporary files before its points can be read.
  /// @param read_begin  reads the beginning of the LAS file, up to its points; throws InputError
  ///                       if it is not usable
  /// @param copy  what is read is copied to it, unless it is null; must outlive this object
  /// @throws InputError  if no program is at hand, with all that would do, or if none unpacks the
  ///                     file, with the last words of each
  LazUnpacker(const std::filesystem::path& path,
              const std::function<void(std::istream&)>& read_begin, LasCopy* copy);
  ~LazUnpacker();

  /// Returns the rest of the LAS file. Its functions throw InputError if the program falls silent.
  std::istream& stream();
  /// Waits for the program and returns how it ended: "laszip ended with code 1: no memory".
  std::string describe_end();
  /// Waits for the program, after the last point, and completes the copy.
  /// @throws InputError  if the program failed
  void finish();

 private:
  struct Attempt;
  std::unique_ptr<Attempt> attempt_;
};

}  // namespace clast::mesh_detail
