#include "core/files/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <thread>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "core/version.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

const std::string kFormat = "clast test file";

template <class T>
void expect_roundtrip(const std::vector<T>& values) {
  const ScratchFolder folder;
  {
    Hdf5File file = Hdf5File::create(folder / "a.h5", kFormat, 1);
    file.root().write<T>("values", values);
    file.flush();
  }
  const Hdf5File file = Hdf5File::open(folder / "a.h5", kFormat, 1);
  EXPECT_EQ(file.root().read<T>("values"), values);
}

TEST(Hdf5File, EveryNumberTypeComesBackAsItWas) {
  expect_roundtrip<double>({0.0, -1.0 / 3.0, 1e-308, std::numeric_limits<double>::infinity()});
  expect_roundtrip<float>({0.0f, -1.0f / 3.0f, 1e30f});
  expect_roundtrip<std::int64_t>({std::numeric_limits<std::int64_t>::min(), 0, 1});
  expect_roundtrip<std::int32_t>({std::numeric_limits<std::int32_t>::min(), 0, 1});
  expect_roundtrip<std::uint32_t>({std::numeric_limits<std::uint32_t>::max(), 0});
  expect_roundtrip<std::uint16_t>({65535, 0});
  expect_roundtrip<std::uint8_t>({255, 0});
}

TEST(Hdf5File, LargeArraysComeBackAndAreCompressed) {
  const ScratchFolder folder;
  std::vector<double> values(300000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::floor(0.01 * double(i));
  {
    Hdf5File file = Hdf5File::create(folder / "a.h5", kFormat, 1);
    file.root().write<double>("values", values, {100000, 3});
  }
  EXPECT_LT(std::filesystem::file_size(folder / "a.h5"), values.size() * sizeof(double) / 10);
  const Hdf5File file = Hdf5File::open(folder / "a.h5", kFormat, 1);
  EXPECT_EQ(file.root().read<double>("values"), values);
  EXPECT_EQ(file.root().shape("values"), (std::vector<std::size_t>{100000, 3}));
}

TEST(Hdf5File, TextComesBackAlsoEmptyAndWithAccents) {
  expect_roundtrip<std::string>({"", "Éboulis à Authume", std::string(10000, 'x'), "a b"});
}

TEST(Hdf5File, EmptyArraysStayEmpty) {
  expect_roundtrip<double>({});
  expect_roundtrip<std::string>({});
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5", kFormat, 1);
  file.root().write<double>("none", {}, {0, 3});
  EXPECT_EQ(file.root().shape("none"), (std::vector<std::size_t>{0, 3}));
}

TEST(Hdf5File, AttributesComeBackAndCanBeReplaced) {
  const ScratchFolder folder;
  {
    Hdf5File file = Hdf5File::create(folder / "a.h5", kFormat, 3);
    Hdf5Group group = file.root().create_group("g");
    group.set_attribute<double>("density_kg_m3", 2650.0);
    group.set_attribute<double>("density_kg_m3", 2700.0);
    group.set_attribute<std::int64_t>("seed", -5);
    group.set_attribute<std::string>("text", std::string(200000, 'c'));
    group.set_attribute<std::string>("nothing", "");
    const std::vector<double> one = {1.0};
    group.write<double>("moments", one);
    group.set_unit("moments", "kg m^2");
  }
  const Hdf5File file = Hdf5File::open(folder / "a.h5", kFormat, 3);
  const Hdf5Group group = file.root().open_group("g");
  EXPECT_EQ(group.read_attribute<double>("density_kg_m3"), 2700.0);
  EXPECT_EQ(group.read_attribute<std::int64_t>("seed"), -5);
  EXPECT_EQ(group.read_attribute<std::string>("text"), std::string(200000, 'c'));
  EXPECT_EQ(group.read_attribute<std::string>("nothing"), "");
  EXPECT_EQ(group.unit("moments"), "kg m^2");
  EXPECT_FALSE(group.has_attribute("mass"));
  EXPECT_EQ(file.root().read_attribute<std::string>("program_version"), version());
  EXPECT_TRUE(contains(refusal([&] { group.read_attribute<double>("mass"); }), "/g/@mass"));
  EXPECT_TRUE(contains(refusal([&] { group.read_attribute<double>("text"); }), "/g/@text"));
}

TEST(Hdf5File, ChildrenAreListedSortedAndRemoved) {
  const ScratchFolder folder;
  Hdf5File a = Hdf5File::create(folder / "a.h5", kFormat, 1);
  const std::vector<double> values = {4.0, 5.0};
  for (const char* name : {"SP3A", "B2", "a b", "SP1A"}) {
    a.root().create_group(name).write<double>("values", values);
  }
  EXPECT_EQ(a.root().child_names(), (std::vector<std::string>{"B2", "SP1A", "SP3A", "a b"}));
  a.root().remove("SP3A");
  EXPECT_FALSE(a.root().contains("SP3A"));
  EXPECT_TRUE(contains(refusal([&] { a.root().remove("SP3A"); }), "SP3A"));
  EXPECT_TRUE(contains(refusal([&] { a.root().create_group("B2"); }), "already"));
}

TEST(Hdf5File, MissingAndMistypedDatasetsAreNamed) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5", kFormat, 1);
  Hdf5Group block = file.root().create_group("blocks").create_group("B1");
  const std::vector<double> numbers = {1.0};
  const std::vector<std::int64_t> integers = {1};
  block.write<double>("numbers", numbers);
  block.write<std::int64_t>("integers", integers);
  const std::string missing = refusal([&] { block.read<double>("vertices"); });
  EXPECT_TRUE(contains(missing, "a.h5") && contains(missing, "/blocks/B1/vertices")) << missing;
  EXPECT_TRUE(contains(refusal([&] { block.open_group("faces"); }), "/blocks/B1/faces"));
  EXPECT_TRUE(contains(refusal([&] { block.read<float>("numbers"); }), "numbers"));
  EXPECT_TRUE(contains(refusal([&] { block.read<std::string>("numbers"); }), "text"));
  EXPECT_TRUE(contains(refusal([&] { block.read<double>("integers"); }), "integers"));
  EXPECT_TRUE(contains(refusal([&] { block.read<std::int32_t>("integers"); }), "32-bit integers"));
  EXPECT_TRUE(contains(refusal([&] { block.write<double>("bad", numbers, {2, 3}); }), "shape"));
  EXPECT_TRUE(contains(refusal([&] { file.root().read<double>("blocks"); }), "blocks"));
}

TEST(Hdf5File, WrongFormatAndNewerSchemaAreRefused) {
  const ScratchFolder folder;
  { Hdf5File::create(folder / "terrain.h5", "clast terrain", 1); }
  { Hdf5File::create(folder / "new.h5", kFormat, 7); }
  const std::string format = refusal([&] { Hdf5File::open(folder / "terrain.h5", kFormat, 1); });
  EXPECT_TRUE(contains(format, "clast terrain") && contains(format, kFormat)) << format;
  const std::string schema = refusal([&] { Hdf5File::open(folder / "new.h5", kFormat, 6); });
  EXPECT_TRUE(contains(schema, "version 7") && contains(schema, "new.h5")) << schema;
  EXPECT_NO_THROW(Hdf5File::open(folder / "new.h5", kFormat, 7));
}

TEST(Hdf5File, WhatIsNotAnHdf5FileIsRefused) {
  const ScratchFolder folder;
  write_text_file(folder / "text.h5", "solid block\nfacet normal 0 0 1\n");
  write_text_file(folder / "empty.h5", "");
  for (const auto& [name, word] : {std::pair{"text.h5", "not an HDF5"},
                                   {"empty.h5", "empty"},
                                   {"none.h5", "no such file"},
                                   {".", "folder"}}) {
    const std::string message = refusal([&] { Hdf5File::open(folder / name, kFormat, 1); });
    EXPECT_TRUE(contains(message, word) && contains(message, name)) << message;
  }
  EXPECT_TRUE(contains(refusal([&] { Hdf5File::create(folder / "no" / "such.h5", kFormat, 1); }),
                       "such.h5"));
}

TEST(Hdf5File, AFileCutAtAnyLengthIsRefused) {
  const ScratchFolder folder;
  std::vector<double> values(5000);
  Random random(3);
  for (double& value : values) value = random.normal();
  {
    Hdf5File file = Hdf5File::create(folder / "whole.h5", kFormat, 1);
    file.root().create_group("g").write<double>("values", values);
    const std::vector<std::string> words = {"one", "two"};
    file.root().open_group("g").write<std::string>("words", words);
  }
  const std::string whole = read_text_file(folder / "whole.h5");
  const auto read_all = [&](const std::string& name) {
    const Hdf5File file = Hdf5File::open(folder / name, kFormat, 1);
    EXPECT_EQ(file.root().open_group("g").read<double>("values"), values);
    file.root().open_group("g").read<std::string>("words");
  };
  read_all("whole.h5");
  for (std::size_t length = 0; length < whole.size();
       length += length < 3000 ? 61 : whole.size() / 60) {
    write_text_file(folder / "cut.h5", whole.substr(0, length));
    EXPECT_TRUE(contains(refusal([&] { read_all("cut.h5"); }), "cut.h5")) << length << " bytes";
  }
}

TEST(Hdf5File, OverwrittenBytesNeverCrashAReader) {
  const ScratchFolder folder;
  const std::vector<double> values(4000, 1.5);
  {
    Hdf5File file = Hdf5File::create(folder / "whole.h5", kFormat, 1);
    Hdf5Group group = file.root().create_group("g");
    group.write<double>("values", values);
    const std::vector<std::string> words = {"one", "two"};
    group.write<std::string>("words", std::vector<std::string>(2000, "word"));
    group.write<std::string>("few", words);
    group.set_attribute<std::string>("note", "a note");
  }
  const std::string whole = read_text_file(folder / "whole.h5");
  Random random(11);
  int refused = 0;
  for (int round = 0; round < 500; ++round) {
    std::string damaged = whole;
    const std::size_t at = random.uniform_index(whole.size());
    for (std::size_t i = at; i < std::min(at + 8, whole.size()); ++i) {
      damaged[i] = static_cast<char>(random.uniform_index(256));
    }
    write_text_file(folder / "damaged.h5", damaged);
    try {
      const Hdf5File file = Hdf5File::open(folder / "damaged.h5", kFormat, 1);
      const Hdf5Group group = file.root().open_group("g");
      group.read<double>("values");
      group.read<std::string>("words");
      group.read<std::string>("few");
      group.read_attribute<std::string>("note");
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Hdf5File, WhatWasFlushedSurvivesAKill) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "live.h5", kFormat, 1);
  for (int run = 0; run < 20; ++run) {
    const std::string name = "run " + std::to_string(run);
    const std::vector<double> values(700, double(run));
    file.root().write<double>(name, values);
    file.flush();
    // A copy of the open file is what a killed process leaves behind.
    std::filesystem::copy_file(folder / "live.h5", folder / "left.h5",
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(Hdf5File::open(folder / "left.h5", kFormat, 1).root().read<double>(name), values);
  }
}

TEST(Hdf5File, GroupsOutliveTheFileTheyCameFrom) {
  const ScratchFolder folder;
  const std::vector<double> values = {1.0, 2.0};
  Hdf5Group group = Hdf5File::create(folder / "a.h5", kFormat, 1).root().create_group("g");
  group.write<double>("values", values);
  EXPECT_EQ(group.read<double>("values"), values);
}

TEST(Hdf5File, EqualContentGivesEqualBytes) {
  const ScratchFolder folder;
  const std::vector<double> values(3000, 2.5);
  for (const char* name : {"a.h5", "b.h5"}) {
    Hdf5File file = Hdf5File::create(folder / name, kFormat, 1);
    file.root().create_group("g").write<double>("values", values);
  }
  EXPECT_EQ(read_text_file(folder / "a.h5"), read_text_file(folder / "b.h5"));
}

TEST(Hdf5File, FailuresOnAnotherThreadPrintNothing) {
  const ScratchFolder folder;
  Hdf5File::create(folder / "a.h5", kFormat, 1);
  const Hdf5File file = Hdf5File::open(folder / "a.h5", kFormat, 1);
  testing::internal::CaptureStderr();
  std::thread([&] { EXPECT_THROW(file.root().read<double>("missing"), InputError); }).join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace clast
