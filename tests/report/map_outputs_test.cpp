// Rasters, lines and animations of runs whose trajectories are known.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <regex>

#include "core/files/text_file.hpp"
#include "report/gdal/geopackage.hpp"
#include "report/maps/raster_files.hpp"
#include "report/scene/vtk_animation.hpp"
#include "study/compare/path_rasters.hpp"
#include "tests/study/thrown_runs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

using namespace report_detail;

class ThrownRuns : public testing::Test {
 protected:
  ThrownRuns() {
    store_thrown(folder_ / "r.h5");
    CampaignResults results = read_results(folder_ / "r.h5");
    results.frame.crs = results.terrain.frame.crs = "EPSG:2154";
    comparison_ = compared(std::move(results));
  }
  ScratchFolder folder_;
  Comparison comparison_;
};

// The longest way is 20 m, so cells are of the least size, 0.5 m; the runs fly along y = 0 from x =
// 0, over one row of cells, one to 5 m and one to 2.5 m.
TEST_F(ThrownRuns, FillTheCellsTheyPass) {
  const MapRasterSet rasters = compute_path_rasters(comparison_);
  EXPECT_EQ(rasters.cell_size, 0.5);
  EXPECT_EQ(rasters.columns, 11u);
  EXPECT_EQ(rasters.rows, 1u);
  EXPECT_EQ(rasters.corner, Vec2(900000.0, 6500000.0));
  const auto layer = [&](const std::string& name) -> const std::vector<float>& {
    for (const RasterLayer& one : rasters.layers) {
      if (one.name == name) return one.values;
    }
    throw std::runtime_error("no layer " + name);
  };
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(layer("Nr_passages")[i], i <= 5 ? 2.0F : 1.0F) << i;
    EXPECT_EQ(layer("Reach_probability")[i], i <= 5 ? 1.0F : 0.5F) << i;
    // Speed and height grow on the way: the largest is at the far edge, within a step of 0.25 m.
    const double far = std::min(0.5 * static_cast<double>(i) + 0.5, 5.0);
    const auto speed = [](double x) { return std::hypot(10.0, kTestGravity * x / 10.0); };
    EXPECT_LE(layer("V_max")[i], speed(far) + 1e-3) << i;
    EXPECT_GE(layer("V_max")[i], speed(far - 0.25) - 0.02) << i;
    EXPECT_GE(layer("E_max")[i], layer("E_95")[i]);
    EXPECT_GE(layer("E_95")[i], layer("E_mean")[i]);
    const auto height = [](double x) { return 2.0 - 0.5 * kTestGravity * x * x / 100.0 + 0.5 * x; };
    EXPECT_NEAR(layer("Ph_95")[i], height(far), 0.15) << i;
  }
  // m = 300 kg, J_z = 3 kg m^2, 2 rad/s.
  const double v = std::hypot(10.0, kTestGravity * 0.5);
  EXPECT_NEAR(layer("E_max")[10], 150.0 * v * v + 6.0, 1e-2);
}

// A straight way over a grid: of all cells those it has a piece in, however short.
TEST(Rasters, CountCellsThatAreCutAtACorner) {
  const ScratchFolder folder;
  const double slope = 0.71;
  store_thrown(folder / "r.h5", Vec3(1.0, slope, 0.0).normalized());
  const MapRasterSet rasters = compute_path_rasters(compared(read_results(folder / "r.h5")));
  ASSERT_EQ(rasters.layers[1].name, "Nr_passages");
  const double end = 5.0 / std::hypot(1.0, slope);  // x where the longer run stops
  std::size_t cut = 0;
  for (std::size_t i = 0; i < rasters.layers[1].values.size(); ++i) {
    const double x = 0.5 * static_cast<double>(i % rasters.columns);
    const double y = 0.5 * static_cast<double>(rasters.rows - 1 - i / rasters.columns);
    // Where the way enters and leaves the cell.
    const double from = std::max(x, y / slope), to = std::min({x + 0.5, (y + 0.5) / slope, end});
    EXPECT_EQ(std::isnan(rasters.layers[1].values[i]), from >= to) << x << " " << y;
    cut += from < to && to - from < 0.1 ? 1 : 0;
  }
  EXPECT_EQ(cut, 3u) << "the way should cut corners";
}

TEST_F(ThrownRuns, AreGeoTiffsOnTheMap) {
  const MapRasterSet rasters = compute_path_rasters(comparison_);
  const auto files = write_rasters(folder_ / "rasters", rasters, "EPSG:2154");
  ASSERT_EQ(files.size(), 14u) << "each with its style";
  GDALAllRegister();
  GDALDataset* dataset = GDALDataset::Open((folder_ / "rasters/V_max.tif").c_str());
  ASSERT_NE(dataset, nullptr);
  double transform[6];
  ASSERT_EQ(dataset->GetGeoTransform(transform), CE_None);
  EXPECT_EQ(transform[0], 900000.0);
  EXPECT_EQ(transform[1], 0.5);
  EXPECT_EQ(transform[3], 6500000.5);
  EXPECT_EQ(transform[5], -0.5);
  EXPECT_STREQ(dataset->GetSpatialRef()->GetAuthorityCode(nullptr), "2154");
  GDALRasterBand* band = dataset->GetRasterBand(1);
  EXPECT_EQ(band->GetNoDataValue(), -9999.0);
  float cells[11];
  ASSERT_EQ(band->RasterIO(GF_Read, 0, 0, 11, 1, cells, 11, 1, GDT_Float32, 0, 0, nullptr),
            CE_None);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(cells[i], rasters.layers.back().values[i]) << i;
  }
  GDALClose(dataset);
}

TEST_F(ThrownRuns, AreLinesOfTheGeoPackage) {
  write_geopackage(folder_ / "stops.gpkg", comparison_);
  auto* dataset =
      GDALDataset::Open((folder_ / "stops.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY);
  ASSERT_NE(dataset, nullptr);
  OGRLayer* layer = dataset->GetLayerByName("trajectories");
  ASSERT_NE(layer, nullptr);
  ASSERT_EQ(layer->GetFeatureCount(), 2);
  OGRFeature* feature = layer->GetNextFeature();
  const OGRLineString* line = feature->GetGeometryRef()->toLineString();
  ASSERT_EQ(line->getNumPoints(), 3);  // at 0, 0.25 and 0.5 s
  EXPECT_NEAR(line->getX(2), 900005.0, 1e-6);
  EXPECT_NEAR(line->getZ(0), 202.0, 1e-9);
  EXPECT_STREQ(feature->GetFieldAsString("stop_reason"), "rest");
  OGRFeature::DestroyFeature(feature);
  GDALClose(dataset);
}

// The numbers of an array of a .vtp file, found by its name.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name) {
  std::smatch match;
  const std::string head = file.substr(0, file.find("<AppendedData"));
  if (!std::regex_search(head, match, std::regex("Name=\"" + name + "\"[^>]*offset=\"(\\d+)\""))) {
    throw std::runtime_error("no array " + name);
  }
  const std::size_t begin = file.find('_', file.find("<AppendedData")) + 1;
  const char* data = file.data() + begin + std::stoul(match[1]);
  std::uint64_t size = 0;
  std::memcpy(&size, data, sizeof size);
  std::vector<T> values(size / sizeof(T));
  std::memcpy(values.data(), data + sizeof size, size);
  return values;
}

TEST_F(ThrownRuns, MoveAsBlocksInAnAnimation) {
  const auto target = write_animation(folder_ / "animation", comparison_, 2);
  EXPECT_EQ(target, folder_ / "animation/animation.pvd");
  const std::string list = read_text_file(target);
  for (const char* part :
       {"timestep=\"0\"", "timestep=\"0.25\"", "timestep=\"0.5\"", "file=\"frame_0002.vtp\""}) {
    EXPECT_NE(list.find(part), std::string::npos) << part;
  }
  // Twice 0.4 x 0.3 x 0.2 m. A corner moves out by 0.1 m, towards the mean of its triangles.
  const TriangleMesh core = core_mesh(make_sphero_polyhedron(cuboid(0.8, 0.6, 0.4), 0.1));
  for (const int frame : {0, 2}) {
    const std::string file =
        read_text_file(folder_ / ("animation/frame_000" + std::to_string(frame) + ".vtp"));
    const std::vector<double> points = array_of<double>(file, "points");
    ASSERT_EQ(points.size(), 3 * 2 * core.vertices.size());
    const double t = 0.25 * frame;
    // The second run ended after a quarter of a second and stays there.
    for (const double end : {t, std::min(t, 0.25)}) {
      const std::size_t first = end == t ? 0 : 3 * core.vertices.size();
      const Vec3 centre = kMapOrigin + Vec3(10.0 * end, 0.0, 2.0 - 0.5 * kTestGravity * end * end);
      for (std::size_t i = 0; i < core.vertices.size(); ++i) {
        const Vec3 place(points[first + 3 * i], points[first + 3 * i + 1],
                         points[first + 3 * i + 2]);
        const Vec3 out = place - centre - core.vertices[i];
        EXPECT_NEAR(out.norm(), 0.1, 1e-8) << frame << " " << i;
        EXPECT_GT(out.cwiseProduct(core.vertices[i]).minCoeff(), 0.0) << frame << " " << i;
      }
    }
    const auto corners = array_of<std::int32_t>(file, "connectivity");
    const auto ends = array_of<std::int32_t>(file, "offsets");
    const auto runs = array_of<std::int32_t>(file, "run");
    EXPECT_EQ(corners.size(), 3 * 2 * core.triangles.size());
    EXPECT_EQ(ends.back(), static_cast<std::int32_t>(corners.size()));
    EXPECT_EQ(runs.front(), 0);
    EXPECT_EQ(runs.back(), 1);
  }
  const std::string ground = read_text_file(folder_ / "animation/terrain_1.vtp");
  EXPECT_NE(ground.find("NumberOfPolys=\"4\""), std::string::npos);
}

TEST(MapOutputs, WithoutTrajectoriesThereIsNothingToDraw) {
  const ScratchFolder folder;
  const Comparison comparison = compared(hand_made_results());
  EXPECT_TRUE(compute_path_rasters(comparison).layers.empty());
  EXPECT_TRUE(write_rasters(folder / "rasters", compute_path_rasters(comparison), "").empty());
  EXPECT_TRUE(write_animation(folder / "animation", comparison, 3).empty());
}

}  // namespace
}  // namespace clast
