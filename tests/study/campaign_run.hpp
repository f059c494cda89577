#pragma once
/// Small campaigns that are prepared and run: a slope, a flat, and two boxes.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "library/make_block.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

inline TriangleMesh centred_box_mesh(const Vec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1 ? 0.5 : -0.5) * size.x(), (i & 2 ? 0.5 : -0.5) * size.y(),
                               (i & 4 ? 0.5 : -0.5) * size.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// An ASCII STL of a plane z = -slope x over x from `left` to `right`, y from -20 to 20, m.
inline std::string plane_stl(double left, double right, double slope) {
  std::string text = "solid plane\n";
  const auto vertex = [&](double x, double y) {
    return "vertex " + std::to_string(x) + " " + std::to_string(y) + " " +
           std::to_string(-slope * x) + "\n";
  };
  const double middle = 0.5 * (left + right);
  for (const auto& [a, b] : {std::pair{left, middle}, std::pair{middle, right}}) {
    text += "facet normal 0 0 1\nouter loop\n" + vertex(a, -20) + vertex(b, -20) + vertex(b, 20) +
            "endloop\nendfacet\n";
    text += "facet normal 0 0 1\nouter loop\n" + vertex(a, -20) + vertex(b, 20) + vertex(a, 20) +
            "endloop\nendfacet\n";
  }
  return text + "endsolid plane\n";
}

inline std::string replaced_once(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) ADD_FAILURE() << "no " << part;
  return text.replace(at, part.size(), by);
}

/// A slope of 0.6 in a zone "slope" that runs out on a level "flat", and two boxes.
class CampaignRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    BlockLibrary library;
    for (const auto& [id, size] :
         {std::pair{"cube", Vec3(0.6, 0.6, 0.6)}, std::pair{"slab", Vec3(1.0, 0.6, 0.3)}}) {
      const TriangleMesh mesh =
          transformed(centred_box_mesh(size),
                      Pose{Vec3(5.0, 1.0, 2.0), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))});
      BlockSource source;
      source.file = "box.stl";
      source.sha256 = std::string(64, '0');
      BlockOptions options;
      options.core = true;
      options.radius = 0.05;
      library.add(make_block(id, mesh, mesh, source, options));
    }
    library.write(*folder_ / "blocks.h5");
    write_text_file(*folder_ / "slope.stl", plane_stl(-20, 0, 0.6));
    write_text_file(*folder_ / "flat.stl", plane_stl(0, 30, 0.0));
    write_text_file(*folder_ / "turns.txt", "1 0 0 0\n0.8 0.6 0 0\n0 0 0.6 0.8\n");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string campaign_text() {
    return R"([blocks]
library = "blocks.h5"
[terrain]
surface = ["slope.stl", "flat.stl"]
zones = ["slope", "flat"]
[ground.slope]
energy_restitution = 0.1
friction = 0.4
rolling_friction = 0.1
[ground.flat]
energy_restitution = 0.1
friction = 0.6
rolling_friction = 0.3
[release]
points = [[-12, -3, 9.5], [-12, 3, 9.5]]
orientations = "turns.txt"
[[barrier]]
name = "foot"
from = [0, -20]
to = [0, 20]
[run]
max_time_s = 6
)";
  }
  static std::string with(const std::string& from, const std::string& to) {
    return replaced_once(campaign_text(), from, to);
  }
  static Campaign campaign(const std::string& text) {
    write_text_file(*folder_ / "campaign.toml", text);
    return read_campaign(*folder_ / "campaign.toml");
  }
  static CampaignPlan prepared(const std::string& text = campaign_text()) {
    return prepare_campaign(campaign(text));
  }
  static std::string refusal(const std::string& text) {
    const Campaign read = campaign(text);
    return clast::refusal<Error>([&] { prepare_campaign(read); });
  }

  /// Runs a campaign in shards, part1.h5 and so on, and joins them to merged.h5.
  static CampaignResults run_in_shards(const CampaignPlan& plan, std::uint32_t count) {
    std::vector<std::filesystem::path> parts;
    for (std::uint32_t i = 1; i <= count; ++i) {
      parts.push_back(*folder_ / ("part" + std::to_string(i) + ".h5"));
      run_campaign(plan, parts.back(), {.shard = {i, count}});
    }
    merge_results(parts, *folder_ / "merged.h5");
    return read_results(*folder_ / "merged.h5");
  }

  inline static ScratchFolder* folder_ = nullptr;
};

}  // namespace clast
