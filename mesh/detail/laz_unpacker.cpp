#include "mesh/detail/laz_unpacker.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <streambuf>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/files/child_process.hpp"
#include "core/files/process_output.hpp"
#include "mesh/detail/assets.hpp"

namespace clast::mesh_detail {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr double kSilenceLimit = 600.0;  // s; pdal may read all points before it writes
constexpr int kNoLazPerf = 3;            // exit code of unpack_laz.js

}  // namespace

/// Program that unpacks LAZ files.
struct LazProgram {
  const char* program;
  Words (*arguments)(const std::string& path);
  ProcessOutput::Target target = ProcessOutput::Target::kPipe;
  const char* name = program;
};

/// Buffer of a stream whose bytes `read` gives, none at the end.
class SourceBuffer : public std::streambuf {
 public:
  using Read = std::function<std::size_t(char* bytes, std::size_t count)>;
  explicit SourceBuffer(Read read) : read_(std::move(read)), bytes_(1 << 18, '\0') {}

 private:
  int_type underflow() override {
    const std::size_t got = read_(bytes_.data(), bytes_.size());
    setg(bytes_.data(), bytes_.data(), bytes_.data() + got);
    return got == 0 ? traits_type::eof() : traits_type::to_int_type(bytes_[0]);
  }

  Read read_;
  std::string bytes_;
};

namespace {

Words lastools_arguments(const std::string& path) { return {"-i", path, "-stdout", "-olas"}; }

Words node_arguments(const std::string& path) {
  return {"-e", std::string(assets::unpack_laz_js), "--", path};
}

/// Without `forward`, pdal rounds coordinates to centimetres.
Words pdal_arguments(const std::string& path) {
  return {"translate", "--reader",    "readers.las",
          "--writer",  "writers.las", "--writers.las.forward=all",
          path,        "/dev/stdout"};
}

const std::array<LazProgram, 5> kPrograms = {
    {{.program = "laszip", .arguments = lastools_arguments},
     {.program = "laszip64", .arguments = lastools_arguments},
     {.program = "las2las", .arguments = lastools_arguments},
     {.program = "node", .arguments = node_arguments, .name = "node with laz-perf"},
     {.program = "pdal", .arguments = pdal_arguments, .target = ProcessOutput::Target::kFile}}};

/// Adds bytes to the copy, or gives it up.
void append_to_copy(LasCopy& copy, std::string_view bytes) {
  while (copy.file && !bytes.empty()) {
    const ssize_t done = ::write(copy.file->descriptor(), bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) {
      copy.file.reset();
      return;
    }
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

Words command_of(const LazProgram& way, const fs::path& program, const fs::path& path) {
  Words command = {program.string()};
  for (std::string& word : way.arguments(fs::absolute(path).string()))
    command.push_back(std::move(word));
  return command;
}

}  // namespace

struct LazUnpacker::Attempt {
  Attempt(const LazProgram& used, const fs::path& program, const fs::path& path, LasCopy* kept)
      : way(used), output(command_of(used, program, path), used.target, kSilenceLimit), copy(kept) {
    stream.exceptions(std::ios::badbit);  // passes on what `read` throws
    if (copy) copy->file = make_copy();
  }

  static std::unique_ptr<UnnamedFile> make_copy() {
    try {
      return std::make_unique<UnnamedFile>();
    } catch (const InputError&) {
      return nullptr;  // the LAZ file is unpacked again instead
    }
  }

  std::string describe_end() {
    const int code = output.wait();
    const std::string words = output.last_words();
    return way.name +
           (code > 128 ? " was ended by signal " + std::to_string(code - 128)
                       : " ended with code " + std::to_string(code)) +
           (words.empty() ? "" : ": " + words);
  }

  const LazProgram& way;
  ProcessOutput output;
  LasCopy* copy;
  SourceBuffer buffer{[this](char* bytes, std::size_t count) {
    const std::size_t got = output.read(bytes, count);
    if (copy) append_to_copy(*copy, {bytes, got});
    return got;
  }};
  std::istream stream{&buffer};
};

LazUnpacker::LazUnpacker(const fs::path& path, const std::function<void(std::istream&)>& read_begin,
                         LasCopy* copy) {
  std::string failures;
  for (const LazProgram& way : kPrograms) {
    const fs::path program = find_executable(way.program);
    if (program.empty()) continue;
    attempt_ = std::make_unique<Attempt>(way, program, path, copy);
    std::string failure;
    try {
      read_begin(attempt_->stream);
      return;
    } catch (const InputError& error) {
      failure = std::string(way.name) + " gave no LAS file of its points: " + error.what();
    }
    const int code = attempt_->output.wait();
    if (&way == &kPrograms[3] && code == kNoLazPerf) continue;
    if (code != 0) failure = attempt_->describe_end();
    failures += (failures.empty() ? "" : "; ") + failure;
  }
  if (failures.empty()) {
    throw InputError(
        "its points are compressed (LAZ), and no program that unpacks them is at hand: install "
        "laszip, laszip64 or las2las (LAStools), node with laz-perf (npm install -g laz-perf), or "
        "pdal, or convert it to LAS elsewhere");
  }
  throw InputError("its points are compressed (LAZ) and could not be unpacked: " + failures);
}

LazUnpacker::~LazUnpacker() = default;

std::istream& LazUnpacker::stream() { return attempt_->stream; }

std::string LazUnpacker::describe_end() { return attempt_->describe_end(); }

void LazUnpacker::finish() {
  if (attempt_->output.wait() != 0) {
    throw InputError("its points are compressed (LAZ) and could not be unpacked: " +
                     attempt_->describe_end());
  }
  if (attempt_->copy) attempt_->copy->complete = attempt_->copy->file != nullptr;
}

void read_las_copy(const LasCopy& copy, const std::function<void(std::istream&)>& read) {
  off_t at = 0;
  SourceBuffer buffer([&](char* bytes, std::size_t count) {
    const ssize_t got = ::pread(copy.file->descriptor(), bytes, count, at);
    if (got < 0) throw InputError("its unpacked points can't be read again");
    at += got;
    return static_cast<std::size_t>(got);
  });
  std::istream stream(&buffer);
  stream.exceptions(std::ios::badbit);
  read(stream);
}

}  // namespace clast::mesh_detail
