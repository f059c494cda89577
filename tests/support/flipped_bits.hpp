#pragma once
/// Single bits of a file changed, as a bad disk or cable does.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {

/// Flips `flips` bits of a copy, one at a time, spread evenly with seeded jitter, so that every
/// part of the file has its share. `content` reads the file and gives all it read: each time it
/// must refuse with a message that names the file, or give what it gives of the whole file.
inline void expect_no_flip_unnoticed(
    const std::filesystem::path& file, std::size_t flips,
    const std::function<std::string(const std::filesystem::path&)>& content) {
  const std::string whole = read_text_file(file), expected = content(file);
  const std::filesystem::path damaged = file.parent_path() / "flipped.h5";
  Random random(17);
  std::size_t refused = 0, silent = 0;
  const std::size_t bits = 8 * whole.size();
  for (std::size_t i = 0; i < flips; ++i) {
    const std::size_t from = i * bits / flips, to = (i + 1) * bits / flips;
    const std::size_t bit = from + random.uniform_index(to - from);
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    write_text_file(damaged, bytes);
    try {
      if (content(damaged) == expected) continue;
      ++silent;
      ADD_FAILURE() << "bit " << bit % 8 << " of byte " << bit / 8 << " of " << whole.size();
    } catch (const Error& error) {
      ++refused;
      EXPECT_TRUE(contains(error.what(), "flipped.h5"));
    }
  }
  std::filesystem::remove(damaged);
  testing::Test::RecordProperty("refused", static_cast<int>(refused));
  EXPECT_EQ(silent, 0u) << "of " << flips;
  EXPECT_GT(refused, flips / 3);
}

}  // namespace clast
