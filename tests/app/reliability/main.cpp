/// The reliability trial: damaged scans to blocks, and what became of them (docs/reliability.md).
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <utility>

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "mesh/mesh_io.hpp"
#include "tests/app/reliability/cases.hpp"
#include "tests/app/reliability/table.hpp"
#include "tests/support/run_program.hpp"

namespace clast::reliability {
namespace {

constexpr const char* kProcessorSeconds = "120";
constexpr const char* kWallSeconds = "600";   ///< of a hang that uses no processor
constexpr std::size_t kBetweenReports = 100;  ///< cases; a whole trial takes more than an hour

struct Options {
  std::size_t every = 1;
  std::string only;
  std::string keep;
  unsigned threads = 0;
  bool list = false, levels = false, refusals = false, misses = false;
};

std::filesystem::path write_scan(const std::filesystem::path& folder, const TriangleMesh& surface) {
  if (!surface.triangles.empty()) {
    const std::filesystem::path path = folder / "scan.ply";
    write_mesh(path, surface);
    return path;
  }
  std::string text;
  for (const Vec3& p : surface.vertices) {
    for (int k = 0; k < 3; ++k) text += format_significant(p[k], 8) + (k < 2 ? " " : "\n");
  }
  const std::filesystem::path path = folder / "scan.xyz";
  write_text_file(path, text);
  return path;
}

/// Every vertex of the closed scan is kept and nothing rounded, so that what is off comes from
/// closing it.
ProgramRun reconstruct(const std::filesystem::path& scan, const std::filesystem::path& folder) {
  std::vector<std::string> words = {
      "timeout", kWallSeconds, "sh", "-c",
      "ulimit -t " + std::string(kProcessorSeconds) + "; exec \"$0\" \"$@\""};
  for (const std::string& word :
       clast_words({"reconstruct", scan.string(), "-o", "blocks.h5", "--json", "--any-size",
                    "--vertices", "5000", "--radius-share", "0"})) {
    words.push_back(word);
  }
  return RunningProgram(std::move(words), folder).wait();
}

Verdict judge_case(const Case& one, const Options& options) {
  const ScratchFolder scratch;
  const std::filesystem::path folder =
      options.keep.empty() ? scratch.path() : std::filesystem::path(options.keep);
  const DamagedScan damaged = one.scan();
  const Given given = given_by(reconstruct(write_scan(folder, damaged.surface), scratch.path()));
  return judge(given, damaged.expected);
}

std::vector<Case> chosen(std::vector<Case> cases, const Options& options) {
  std::erase_if(cases, [&](const Case& one) {
    // By its seed, so that every kind, amount and body has its turn.
    return one.seed() % options.every != 0 || one.name().find(options.only) == std::string::npos;
  });
  return cases;
}

/// @returns how many there are
std::size_t print_list(const std::string& title, Outcome outcome,
                       const std::vector<Judged>& judged) {
  std::size_t count = 0;
  for (const Judged& one : judged) {
    if (one.verdict.outcome != outcome) continue;
    std::cout << (count++ == 0 ? "\n" + title + ":\n\n- " : "- ") << one.name << ": "
              << one.verdict.why << (one.verdict.why.ends_with('\n') ? "" : "\n");
  }
  return count;
}

void print_misses(const std::vector<Judged>& judged) {
  std::cout << "\nRanges that miss:\n\n";
  for (const Judged& one : judged) {
    if (!one.verdict.missed.empty())
      std::cout << "- " << one.name << ": " << one.verdict.missed << "\n";
  }
}

int run(const Options& options) {
  const std::vector<Body> bodies = make_bodies();
  const std::vector<Case> cases = chosen(make_cases(bodies), options);
  if (options.list) {
    for (const Case& one : cases) std::cout << one.name() << "\n";
    return 0;
  }
  if (!options.keep.empty()) std::filesystem::create_directories(options.keep);
  std::vector<Judged> judged(cases.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(cases.size(), options.threads, [&](std::size_t i) {
    const Case& one = cases[i];
    judged[i] = {one.kind->name, one.level(), one.name(), judge_case(one, options)};
    const std::lock_guard lock(mutex);
    ++done;
    if (judged[i].verdict.outcome == Outcome::kWrong) {
      std::cerr << done << "/" << cases.size() << " wrong: " << judged[i].name << ": "
                << judged[i].verdict.why << "\n";
    } else if (done % kBetweenReports == 0) {
      std::cerr << done << "/" << cases.size() << "\n";
    }
  });
  std::cout << markdown_table(judged, options.levels);
  if (options.refusals) print_list("Refused", Outcome::kRefused, judged);
  if (options.misses) print_misses(judged);
  const std::size_t wrong = print_list("Silently wrong", Outcome::kWrong, judged);
  return wrong == 0 && !cases.empty() ? 0 : 1;
}

}  // namespace
}  // namespace clast::reliability

int main(int argc, char** argv) {
  clast::reliability::Options options;
  CLI::App app{
      "Damages scans of sound rocks, has clast reconstruct them, and counts what is right, "
      "bracketed, refused and silently wrong; exit 1 where anything is"};
  app.add_option("--every", options.every, "Of all cases about one of so many")
      ->check(CLI::PositiveNumber);
  app.add_option("--only", options.only, "Cases whose names contain this text");
  app.add_option("--keep", options.keep, "Folder where the scan of the last case stays");
  app.add_option("--threads", options.threads, "Cases at the same time; 0: one per core");
  app.add_flag("--levels", options.levels, "A row for each amount of each kind");
  app.add_flag("--refusals", options.refusals, "List what was refused, with the reasons");
  app.add_flag("--misses", options.misses, "List the ranges that do not hold the truth");
  app.add_flag("--list", options.list, "Print the names of the cases and end");
  CLI11_PARSE(app, argc, argv);
  try {
    return clast::reliability::run(options);
  } catch (const std::exception& error) {
    std::cerr << "reliability_trial: " << error.what() << "\n";
    return 1;
  }
}
