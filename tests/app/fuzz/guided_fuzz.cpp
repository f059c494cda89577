/// Coverage-guided fuzzing of one reader (libFuzzer): whatever a file holds, it is read or refused
/// with a message.
///
///   guided_fuzz                       names the readers, meshes among them
///   guided_fuzz READER [OPTION ...] [CORPUS ...]
///
/// Options are those of libFuzzer, such as -max_total_time=3600; tests/fuzz.sh runs all readers.
/// What fails is written to a file, which `guided_fuzz READER FILE` tries again.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "reconstruct/scan.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/mesh_bytes.hpp"

extern "C" int LLVMFuzzerRunDriver(int* argc, char*** argv,
                                   int (*try_input)(const std::uint8_t* data, std::size_t size));

namespace clast {
namespace {

std::vector<NamedReader> readers_and_meshes() {
  std::vector<NamedReader> all = all_readers();
  for (const MeshFile& file : mesh_files(random_rock(2, 1, 0.05))) {
    all.push_back(reader_of(
        file.name, [=] { return file.bytes; }, [](const auto& path) { read_scan(path); }));
  }
  return all;
}

/// The one that is tried.
std::unique_ptr<TriedReader> tried;

int try_input(const std::uint8_t* data, std::size_t size) {
  const TriedReader::Outcome outcome =
      tried->read(std::string(reinterpret_cast<const char*>(data), size));
  if (!outcome.fault.empty()) {
    std::fprintf(stderr, "%s\n", outcome.fault.c_str());
    std::abort();
  }
  return 0;
}

int fuzz(const NamedReader& reader, std::vector<char*> arguments) {
  tried = std::make_unique<TriedReader>(reader.make());
  tried->read_sound();
  // A check of what was read that fails outside a test ends the program, too.
  GTEST_FLAG_SET(break_on_failure, true);
  const ScratchFolder folder;
  write_text_file(folder / "sound", tried->sound());
  std::string seed = "-seed_inputs=" + (folder / "sound").string();
  arguments.push_back(seed.data());
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  char** begin = arguments.data();
  return LLVMFuzzerRunDriver(&count, &begin, try_input);
}

}  // namespace
}  // namespace clast

int main(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  for (const clast::NamedReader& reader : clast::readers_and_meshes()) {
    if (argc < 2) {
      std::printf("%s\n", reader.name.c_str());
    } else if (reader.name == argv[1]) {
      arguments.erase(arguments.begin() + 1);
      return clast::fuzz(reader, arguments);
    }
  }
  if (argc < 2) return 0;
  std::fprintf(stderr, "no reader is called \"%s\"; without arguments guided_fuzz names them\n",
               argv[1]);
  return 2;
}
