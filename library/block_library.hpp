#pragma once
/// Block library (HDF5). Schema: docs/formats.md.
#include <filesystem>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

inline constexpr const char* kLibraryFormat = "clast block library";

/// Checks a block id.
/// @throws InputError  if it is empty, contains a slash or control character, or consists of dots
void check_block_id(const std::string& id);

/// Library of blocks, ordered by id.
class BlockLibrary {
 public:
  /// Makes an empty library in memory.
  BlockLibrary() = default;
  /// Reads a library.
  /// @throws InputError  if the file is missing, not a block library, damaged, or of a newer schema
  static BlockLibrary read(const std::filesystem::path& path);
  /// Writes the whole file. If other processes may write to it, use `update_library`.
  /// @throws InputError  if an existing file is not a library, or the file cannot be written
  void write(const std::filesystem::path& path) const;

  const std::vector<Block>& blocks() const { return blocks_; }
  bool contains(const std::string& id) const;
  /// Finds a block by id.
  /// @throws InputError  if the id does not exist; the message lists all ids
  const Block& find_block(const std::string& id) const;
  Block& find_block(const std::string& id);
  /// Returns the blocks with the given ids, in their order. Without ids, returns all blocks.
  /// @throws InputError  if an id does not exist
  std::vector<const Block*> select_blocks(const std::vector<std::string>& ids) const;
  /// Adds a block. Text that is not UTF-8 is converted from Windows-1252.
  /// @throws InputError  if the id exists and `replace` is false, or if `check_block_id` throws
  void add(Block block, bool replace = false);
  /// Removes a block.
  /// @throws InputError  if the id is unknown; the message lists the known ids
  void remove(const std::string& id);

 private:
  std::vector<Block> blocks_;
};

}  // namespace clast
