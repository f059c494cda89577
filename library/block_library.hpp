#pragma once
/// The HDF5 file that holds blocks. Schema: docs/formats.md.
#include <filesystem>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

/// The format name in a library file.
inline constexpr const char* kLibraryFormat = "clast block library";

/// @throws InputError  `id` can't name a block: empty, with a slash or a control character, or only
///                     dots
void check_block_id(const std::string& id);

/// The blocks of a library file, in order of id.
class BlockLibrary {
 public:
  /// An empty library, in memory.
  BlockLibrary() = default;
  /// @throws InputError  missing, not a clast block library, damaged, or of a newer schema
  static BlockLibrary read(const std::filesystem::path& path);
  /// Replaces the file whole. A file that others may write to is changed by `update_library`.
  /// @throws InputError  what is there is no library, or can't be written
  void write(const std::filesystem::path& path) const;

  const std::vector<Block>& blocks() const { return blocks_; }
  bool contains(const std::string& id) const;
  /// @throws InputError  no such id; the message lists those there are
  const Block& find_block(const std::string& id) const;
  Block& find_block(const std::string& id);
  /// The blocks of these ids, in the order given; all where none is.
  /// @throws InputError  as `find_block`
  std::vector<const Block*> select_blocks(const std::vector<std::string>& ids) const;
  /// Text that is not UTF-8 is taken for Windows-1252 and converted.
  /// @throws InputError  the id is there already and `replace` is false, or `check_block_id` throws
  void add(Block block, bool replace = false);
  /// @throws InputError  no such id; the message lists those there are
  void remove(const std::string& id);

 private:
  std::vector<Block> blocks_;
};

}  // namespace clast
