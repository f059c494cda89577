// What HDF5 itself does not check is found all the same.
#include <gtest/gtest.h>

#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "tests/support/flipped_bits.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/without_checksums.hpp"

namespace clast {
namespace {

const std::string kChecksumFormat = "clast test file";

void write_sample(const std::filesystem::path& path) {
  Hdf5File file = Hdf5File::create(path, kChecksumFormat, 1);
  Hdf5Group group = file.root().create_group("g");
  Random random(3);
  std::vector<double> many(20000), few(5);
  for (double& value : many) value = std::floor(random.uniform() * 100.0);
  for (double& value : few) value = random.normal();
  group.write<double>("many", many);
  group.write<double>("few", few);
  group.set_unit("few", "kg m^2");
  group.write<float>("floats", std::vector<float>{1.5f, 2.5f});
  group.write<std::string>("words", std::vector<std::string>{"one", "two"});
  group.write<double>("none", {}, {0, 3});
  for (int i = 0; i < 12; ++i) group.set_attribute<double>("a" + std::to_string(i), i + 0.5);
  group.set_attribute<std::string>("long", std::string(100000, 'c'));  // outside the header
  file.flush();
}

/// All that a reader can ask for.
std::string content(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path, kChecksumFormat, 1);
  const Hdf5Group group = file.root().open_group("g");
  std::string all;
  const auto add = [&](const auto& values) {
    all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]);
  };
  add(group.read<double>("many"));
  add(group.read<double>("few"));
  add(group.read<double>("floats"));
  add(group.read<double>("none"));
  add(group.shape("none"));
  for (const std::string& word : group.read<std::string>("words")) all += word + ",";
  for (const std::string& name : group.child_names()) all += name + group.unit(name) + ",";
  for (int i = 0; i < 12; ++i) {
    all += std::to_string(group.read_attribute<double>("a" + std::to_string(i))) + ",";
  }
  return all + group.read_attribute<std::string>("long");
}

TEST(Hdf5Checksum, NoFlippedBitIsReadAsAnotherNumber) {
  const ScratchFolder folder;
  write_sample(folder / "a.h5");
  expect_no_flip_unnoticed(folder / "a.h5", 1500, content);
}

// The index of chunks has no checksum: a chunk that it does not name any more is read as zeros.
TEST(Hdf5Checksum, NoFlippedBitInTheIndexOfChunksGoesUnnoticed) {
  const ScratchFolder folder;
  write_sample(folder / "a.h5");
  const std::string whole = read_text_file(folder / "a.h5"), expected = content(folder / "a.h5");
  const std::size_t tree = whole.find("TREE");
  ASSERT_NE(tree, std::string::npos);
  int refused = 0;
  for (std::size_t bit = 8 * tree; bit < 8 * (tree + 24 + 6 * 40); ++bit) {
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    write_text_file(folder / "b.h5", bytes);
    std::string found;
    if (!refusal([&] { found = content(folder / "b.h5"); }).empty()) {
      ++refused;
    } else {
      EXPECT_TRUE(found == expected) << bit % 8 << " of byte " << bit / 8 - tree;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(Hdf5Checksum, AFileWithoutAnyIsReadAndWithOnlySomeIsNot) {
  const ScratchFolder folder;
  write_sample(folder / "a.h5");
  const std::string expected = content(folder / "a.h5");
  remove_checksums(folder / "a.h5");
  EXPECT_EQ(content(folder / "a.h5"), expected);
  // Adding to it adds none.
  { Hdf5File::open(folder / "a.h5", kChecksumFormat, 1, true).root().create_group("more"); }
  EXPECT_EQ(refusal([&] {
              Hdf5File::open(folder / "a.h5", kChecksumFormat, 1).root().open_group("more");
            }),
            "");
  write_sample(folder / "b.h5");
  ASSERT_NO_FATAL_FAILURE(remove_checksum(folder / "b.h5", "g/few"));
  EXPECT_TRUE(
      contains(refusal([&] { content(folder / "b.h5"); }),
               "b.h5: /g/few does not agree with its checksum; the file is damaged: restore "
               "a backup, or make it again"));
}

TEST(Hdf5Checksum, FollowsEveryChange) {
  const ScratchFolder folder;
  write_sample(folder / "a.h5");
  {
    Hdf5File file = Hdf5File::open(folder / "a.h5", kChecksumFormat, 1, true);
    Hdf5Group group = file.root().open_group("g");
    group.set_attribute<double>("a3", 7.0);
    group.set_attribute<std::string>("long", "short");
    group.set_unit("few", "m");
    group.remove("many");
    group.write<double>("many", std::vector<double>{1.0});
    file.flush();
  }
  const Hdf5File file = Hdf5File::open(folder / "a.h5", kChecksumFormat, 1);
  const Hdf5Group group = file.root().open_group("g");
  EXPECT_EQ(group.read_attribute<double>("a3"), 7.0);
  EXPECT_EQ(group.read_attribute<std::string>("long"), "short");
  EXPECT_EQ(group.unit("few"), "m");
  EXPECT_EQ(group.read<double>("many"), std::vector<double>{1.0});
  EXPECT_EQ(group.read<double>("few").size(), 5u);
}

}  // namespace
}  // namespace clast
