// What real impacts on an alpine meadow say about the ground: the study of docs/prediction.md,
// whose tables it prints.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "report/text/calibration_text.hpp"
#include "study/calibrate/calibrate.hpp"
#include "tests/library/core_library.hpp"
#include "tests/support/chant_sura.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// How a block was turned as it hit is not known: so many attitudes are drawn of each impact.
constexpr int kAttitudes = 64;
/// Not stated by the authors, assumed: of speeds, m/s, spins, rad/s, and depths of scars, m.
constexpr double kSpeedError = 0.3, kSpinError = 0.5, kDepthError = 0.03;

std::string triple(const Vec3& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         "]";
}

std::string block_name(double mass, bool plate) {
  return (plate ? "plate-" : "cube-") + std::to_string(std::lround(mass));
}

class ChantSuraStudy : public testing::Test {
 protected:
  ChantSuraStudy() {
    std::vector<std::pair<std::string, TriangleMesh>> cores;
    std::map<std::string, std::string> releases;
    for (const ThrownImpact& impact : observed_impacts()) {
      if (leads_away(impact)) continue;
      const std::string block = block_name(impact.mass, impact.plate);
      if (!releases.contains(block)) {
        cores.emplace_back(block, eota_mesh(impact.mass, impact.plate));
      }
      const bool known = impact.angular_velocity.allFinite();
      add_release(releases[block], impact.name, impact.place, 0.1, impact.velocity,
                  known ? impact.angular_velocity : Vec3(8.0, 0.0, 0.0));
      observe(block, impact.name,
              "speed_m_s = " + measured(impact.speed, kSpeedError) +
                  (std::isfinite(impact.spin) ? "spin_rad_s = " + measured(impact.spin, kSpinError)
                                              : ""));
    }
    const std::string survey = test_data("chant_sura/terrain_rf16_contact_extended.asc").string() +
                               "\"\nresolution_m = 0.1";
    for (const auto& [block, starts] : releases) add_site(block, block, survey, starts, "[0, -1]");
    std::string starts, block;
    for (const ReferenceRow& scar : chant_sura_rows("chant_sura_esurf_2019_impacts.csv")) {
      const double mass = value(scar, "mass_kg"), along = value(scar, "incoming_tangent_speed_mps");
      block = block_name(mass, true);
      const double rolling = along / (0.5 * std::cbrt(mass / kConcrete));
      const std::string name = "scar " + scar.at("scar_id");
      add_release(starts, name, Vec2::Zero(), 0.001,
                  {along, 0.0, -value(scar, "incoming_normal_speed_mps")},
                  {0.0, 0.5 * rolling, 0.0});
      scars_ += observation(
          "scars", name,
          "depth_m = " + measured(value(scar, "observed_scarring_depth_m"), kDepthError));
    }
    write_obj(folder_ / "plane.obj", plane_mesh(30.0, 6));
    add_site("scars", block, "plane.obj\"", starts, "[1, 0]");
    write_core_library(folder_ / "blocks.h5", cores);
  }

  /// The study with the scars fitted or kept, under a law; members of one law are simulated once.
  Calibration calibrated(const std::string& law, const std::string& unknowns, bool fit_scars) {
    for (const auto& [site, text] : campaigns_) {
      write_text_file(folder_ / (site + ".toml"), text + "[contact]\nlaw = \"" + law + "\"\n");
    }
    std::string scars = scars_;
    for (std::size_t at; !fit_scars && (at = scars.find("\"fit\"")) != std::string::npos;) {
      scars.replace(at, 5, "\"keep\"");
    }
    write_text_file(folder_ / "study.toml", "[design]\nmembers = 48\nreleases = 48\n" + sites_ +
                                                unknowns + impacts_ + scars);
    CalibrationOptions options;
    options.resume = true;
    const Calibration found = run_calibration(read_calibration_study(folder_ / "study.toml"),
                                              folder_ / (law + ".h5"), options);
    std::printf("\n%s, scars %s\n%s\n%s\n", law.c_str(), fit_scars ? "fitted" : "kept",
                describe_calibration_result(found).c_str(), format_unknowns_table(found).c_str());
    for (const std::string& finding : describe_calibration_findings(found)) {
      std::printf("%s\n", finding.c_str());
    }
    return found;
  }

  static std::string unknown(const std::string& parameter, const std::string& range,
                             const std::string& scale) {
    return "[[unknown]]\nparameter = \"" + parameter + "\"\nrange = " + range + "\nscale = \"" +
           scale + "\"\n";
  }

 private:
  /// One "impact" leads away from the surveyed ground and is none there.
  static bool leads_away(const ThrownImpact& impact) {
    return impact.name == "RF20e200r1_impact_01";
  }
  static std::string measured(double value, double error) {
    return "[" + std::to_string(value) + ", " + std::to_string(error) + "]\n";
  }
  static std::string observation(const std::string& site, const std::string& name,
                                 const std::string& values) {
    return "[[observation]]\nname = \"" + name + "\"\nuse = \"fit\"\nsite = \"" + site +
           "\"\nrelease = \"" + name + "\"\nimpact = 1\n" + values;
  }
  void observe(const std::string& site, const std::string& name, const std::string& values) {
    impacts_ += observation(site, name, values);
  }
  static void add_release(std::string& text, const std::string& name, const Vec2& place,
                          double height, const Vec3& velocity, const Vec3& spin) {
    text += "[[release]]\nname = \"" + name + "\"\npoints = [[" + std::to_string(place.x()) + ", " +
            std::to_string(place.y()) + "]]\nheight_m = " + std::to_string(height) +
            "\nvelocity_m_s = " + triple(velocity) + "\nangular_velocity_rad_s = " + triple(spin) +
            "\norientations = { random = " + std::to_string(kAttitudes) +
            ", fresh = true, seed = " + std::to_string(text.size()) + " }\n";
  }
  void add_site(const std::string& site, const std::string& block, const std::string& surface,
                const std::string& starts, const std::string& downslope) {
    sites_ += "[[site]]\nname = \"" + site + "\"\ncampaign = \"" + site + ".toml\"\n";
    campaigns_[site] = "[blocks]\nlibrary = \"blocks.h5\"\nselect = [\"" + block +
                       "\"]\nallow_any_size = true\n[terrain]\nsurface = \"" + surface +
                       "\n[ground.ground]\nenergy_restitution = 0.02\nfriction = 0.7\n"
                       "rolling_friction = 0.35\nrolling_length_m = 0.15\n" +
                       starts + "[run]\nmax_time_s = 0.25\ndownslope = " + downslope + "\n";
  }

  ScratchFolder folder_;
  std::map<std::string, std::string> campaigns_;
  std::string sites_, impacts_, scars_;
};

TEST_F(ChantSuraStudy, ImpactsDetermineFrictionAndScarsStiffness) {
  const std::string ground = unknown("ground.ground.energy_restitution", "[0.01, 0.5]", "log") +
                             unknown("ground.ground.friction", "[0.1, 2]", "linear") +
                             unknown("ground.ground.rolling_friction", "[0, 1]", "linear") +
                             unknown("ground.ground.rolling_length_m", "[0.02, 0.5]", "log");
  const std::string stiffness = unknown("contact.stiffness_n_m", "[3e5, 1e7]", "log");
  // Ten impacts, the spins after eight of them, and six scars.
  const CalibrationPosterior bouncing = calibrated("energy-restitution", ground, false).posterior;
  const CalibrationPosterior yielding =
      calibrated("elastoplastic", ground + stiffness, false).posterior;
  const CalibrationPosterior with_scars =
      calibrated("elastoplastic", ground + stiffness, true).posterior;
  for (const CalibrationPosterior* found : {&bouncing, &yielding}) {
    EXPECT_EQ(found->fitted.statistics, 18u);
    EXPECT_EQ(found->held_out.statistics, 6u);
  }
  EXPECT_EQ(with_scars.fitted.statistics, 24u);
  for (const CalibrationPosterior* found : {&bouncing, &yielding, &with_scars}) {
    EXPECT_FALSE(found->marginals[1].is_undetermined()) << "friction";
  }
  EXPECT_TRUE(bouncing.fitted.failed());
  EXPECT_FALSE(yielding.fitted.failed() || yielding.held_out.failed());
  EXPECT_FALSE(with_scars.fitted.failed());
  // How deep a block goes is what the stiffness is about.
  EXPECT_TRUE(yielding.marginals[4].is_undetermined());
  EXPECT_FALSE(with_scars.marginals[4].is_undetermined());
}

}  // namespace
}  // namespace clast
