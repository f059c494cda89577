/// Program `make_samples FOLDER`: writes the sample scans, the quarry, its release points and a
/// table of taped blocks, always with the same bytes.
#include <filesystem>
#include <iostream>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "samples/dirty_scans.hpp"
#include "samples/float_ply.hpp"
#include "samples/quarry.hpp"
#include "samples/rock_shapes.hpp"
#include "samples/talus.hpp"

namespace {

constexpr double kScanGrid = 1e-5;    // m
constexpr double kQuarryGrid = 1e-3;  // m

void write_samples(const std::filesystem::path& folder) {
  using namespace clast;
  const std::string origin = "made by make_samples of clast, CC0-1.0, lengths in metres";
  for (const RockRecipe& recipe : sample_recipes()) {
    write_float_ply(folder / "blocks" / (recipe.name + ".ply"), rock(recipe), kScanGrid, origin);
  }
  const RockRecipe fine = make_fine_recipe();
  write_float_ply(folder / "shape-effects" / (fine.name + ".ply"), rock(fine), kScanGrid, origin);
  for (const NamedMesh& scan : dirty_scans()) {
    write_float_ply(folder / "dirty" / (scan.name + ".ply"), scan.mesh, kScanGrid, origin);
  }
  for (const QuarryZone& zone : quarry_zones()) {
    write_float_ply(folder / "terrain" / ("quarry_" + zone.name + ".ply"), zone.mesh, kQuarryGrid,
                    origin);
  }
  for (const QuarryLane& lane : list_quarry_lanes()) {
    write_text_file(folder / "terrain" / ("positions_" + lane.name + ".xyz"), release_points(lane));
  }
  write_text_file(folder / "talus.csv", make_talus_table());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_samples FOLDER\n";
    return 2;
  }
  try {
    write_samples(argv[1]);
  } catch (const clast::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
