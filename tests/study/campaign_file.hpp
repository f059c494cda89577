#pragma once
/// A campaign file with every key, in a folder that holds what it names.
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "study/campaign/campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

// Every table, with the lines that the refusals below name.
inline const std::string kCampaign = R"([blocks]
library = "blocks.h5"
select = ["B1", "B2"]

[terrain]
surface = ["blue.stl", "gray.stl"]
zones = ["blue", "gray"]
up = "y"
radius_m = 0.05
resolution_m = 0.5

[ground.blue]
energy_restitution = 0.01
friction = 0.70
rolling_friction = 0.35
[ground.gray]
energy_restitution = 0.04
friction = 0.3
rolling_friction = 0

[release]
points = "points.xyz"
orientations = "turns.txt"
velocity_m_s = [1, 0.5, 0]
angular_velocity_rad_s = [0, 0, 2]
seed = 12

[contact]
law = "spring-dashpot"
weights = "overlap"
stiffness_n_m = 1e8
time_step_s = 2e-5

[[barrier]]
name = "EC11"
from = [25, -400]
to = [25, -340]
[[barrier]]
name = "EC12"
from = [36, -400]
to = [36, -340]

[run]
max_time_s = 30
rest_energy_j_kg = 1e-4
rest_duration_s = 0.25
gravity_m_s2 = 9.8
downslope = [1, 0.1]
trajectory_interval_s = 0
)";

class CampaignFile : public testing::Test {
 protected:
  CampaignFile() {
    for (const char* name : {"blocks.h5", "blue.stl", "gray.stl", "zones.geojson"}) {
      write_text_file(folder_ / name, "stand-in");
    }
    write_text_file(folder_ / "points.xyz", "1 2 3\n4 5 6\n");
    write_text_file(folder_ / "turns.txt", "q0 q1 q2 q3\n1 0 0 0\n0 1 0 0\n");
  }
  Campaign read(const std::string& text) const {
    write_text_file(folder_ / "campaign.toml", text);
    return read_campaign(folder_ / "campaign.toml");
  }
  // The message without the folder; empty when the campaign is accepted.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = folder_.path().string() + "/";
      for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
        message.erase(at, prefix.size());
      }
      return message;
    }
    return "";
  }
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = kCampaign;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) ADD_FAILURE() << "the campaign has no " << from;
    return text.replace(at, from.size(), to);
  }
  ScratchFolder folder_;
};

}  // namespace clast
