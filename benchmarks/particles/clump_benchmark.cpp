// Clumps of real stones by clast and by published methods: errors against number of spheres.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>

#include "benchmarks/particles/clump_check.hpp"
#include "benchmarks/particles/published_clumps.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "particles/clump.hpp"
#include "reconstruct/repair/repair.hpp"

namespace {

using namespace clast;
using Clumps = std::vector<std::vector<Ball>>;

const std::vector<std::string> kStones = {"meshes/chrono_curiosity_rock1.obj",
                                          "meshes/chrono_offroad_rock4.obj",
                                          "meshes/eesd_S02.stl",
                                          "meshes/eesd_stone01.stl",
                                          "meshes/eesd_stone14.stl",
                                          "meshes/eesd_stone15.stl",
                                          "meshes/eesd_stone18.stl",
                                          "meshes/eesd_test_stone.stl",
                                          "meshes/eros007790.tab",
                                          "meshes/ibois_stone_0.ply",
                                          "meshes/ryugu_test.obj",
                                          "authume/blocks/SP1A.stl",
                                          "authume/blocks/SP2A.stl",
                                          "authume/blocks/SP2B.stl",
                                          "authume/blocks/SP3A.stl"};
constexpr std::size_t kCounts[] = {5, 10, 20, 50, 100, 200};
constexpr double kSmallestRadii[] = {0.01, 0.03, 0.06};  // relative to L
constexpr double kOverlaps[] = {0.3, 0.5, 0.7, 0.9};
constexpr std::uint64_t kSeed = 1;

/// Stone as a closed mesh, with small holes closed and small components left out.
ParticleBody read_stone(const std::filesystem::path& path) {
  return make_particle_body(repair_mesh(read_mesh(path)).mesh);
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Table whose rows are appended, so that an interrupted run continues.
class Table {
 public:
  explicit Table(const std::string& path) {
    std::ifstream old(path);
    for (std::string line; std::getline(old, line);) {
      keys_.insert(line.substr(0, line.find(',', line.find(',', line.find(',') + 1) + 1)));
    }
    const bool is_new = keys_.empty();
    file_.open(path, std::ios::app);
    if (is_new) {
      file_ << "stone,method,case,spheres,volume,inertia,surface,smallest_radius,cpu_s,"
               "check_volume,check_deviation,check_inertia,check_surface\n";
    }
  }
  bool has(const std::string& key) const { return keys_.contains(key); }
  void add(const std::string& key, const ParticleBody& body, const std::vector<Ball>& balls,
           const ShapeErrors& errors, double seconds, const ClumpCheck* check) {
    const auto cell = [&](double value) { file_ << "," << format_significant(value, 4); };
    file_ << key << "," << balls.size();
    double radius = body.length;
    for (const Ball& ball : balls) radius = std::min(radius, ball.radius);
    for (const double value :
         {errors.volume, errors.inertia, errors.surface, radius / body.length, seconds}) {
      cell(value);
    }
    if (check) {
      cell(check->errors.volume), cell(check->volume_deviation);
      cell(check->errors.inertia), cell(check->errors.surface);
    } else {
      file_ << ",,,,";
    }
    file_ << std::endl;
  }

 private:
  std::set<std::string> keys_;
  std::ofstream file_;
};

/// Fits of one stone. Each row is left out if the table has it.
class StoneRows {
 public:
  StoneRows(Table& table, std::string stone, ParticleBody body)
      : table_(table), stone_(std::move(stone)), body_(std::move(body)), tree_(body_.mesh) {}

  void fit_errors() {
    for (const ShapeErrors& limits :
         {ShapeErrors{0.01, 0.02, 0.02}, ShapeErrors{0.03, 0.05, 0.05}}) {
      add("clast", "error " + format_significant(limits.surface, 3), true,
          [&] { return Clumps{fit_clump(body_, {.error = limits}).balls}; });
    }
  }
  void fit_counts(std::size_t count) {
    add("clast", std::to_string(count), false,
        [&] { return Clumps{fit_clump(body_, {.balls = count}).balls}; });
  }
  void fit_published(std::size_t count) {
    const std::string name = std::to_string(count);
    add("favier", name, false, [&] { return Clumps{favier_clump(body_, tree_, count)}; });
    add("ferellec-mcdowell", name, false, [&] {
      Clumps clumps;
      for (const double radius : kSmallestRadii) {
        clumps.push_back(
            ferellec_mcdowell_clump(body_, tree_, radius * body_.length, count, kSeed));
      }
      return clumps;
    });
    add("euclidean-distance", name, false, [&] {
      Clumps clumps;
      for (const double overlap : kOverlaps) {
        clumps.push_back(euclidean_distance_clump(body_, tree_, count, overlap));
      }
      return clumps;
    });
  }

 private:
  /// Adds the clump with the smallest surface error.
  void add(const std::string& method, const std::string& name, bool checked,
           const std::function<Clumps()>& fit) {
    const std::string key = stone_ + "," + method + "," + name;
    if (table_.has(key)) return;
    const double start = cpu_seconds();
    const Clumps clumps = fit();
    const double seconds = cpu_seconds() - start;
    const std::vector<Ball>* best = nullptr;
    ShapeErrors least = {0.0, 0.0, 1e9};
    for (const std::vector<Ball>& balls : clumps) {
      if (balls.empty()) continue;
      const ShapeErrors errors = measure_clump_errors(body_, balls);
      if (errors.surface < least.surface) least = errors, best = &balls;
    }
    if (!best) return;
    ClumpCheck check;
    if (checked) check = check_clump(body_, tree_, *best, kSeed);
    table_.add(key, body_, *best, least, seconds, checked ? &check : nullptr);
  }

  Table& table_;
  std::string stone_;
  ParticleBody body_;
  TriangleTree tree_;
};

int run(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: clump_benchmark DATA TABLE.csv errors|counts|published [STONE...]\n"
                 "Appends rows to the table; rows that it has are not computed again.\n";
    return 2;
  }
  const std::filesystem::path data = argv[1];
  const std::string part = argv[3];
  const std::set<std::string> wanted(argv + 4, argv + argc);
  Table table(argv[2]);
  for (const std::string& path : kStones) {
    const std::string stone = std::filesystem::path(path).stem().string();
    if (!wanted.empty() && !wanted.contains(stone)) continue;
    StoneRows rows(table, stone, read_stone(data / path));
    if (part == "errors") rows.fit_errors();
    for (const std::size_t count : kCounts) {
      if (part == "counts") rows.fit_counts(count);
      if (part == "published") rows.fit_published(count);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const clast::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
