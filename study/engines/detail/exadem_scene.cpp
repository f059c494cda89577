// Scenes for ExaDEM: shapes, bodies as a Rockable conf file, terrain as STL files, and input file.
#include <cmath>

#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "study/engines/detail/scene.hpp"
#include "study/engines/detail/scene_text.hpp"

namespace clast::study_detail {
namespace {

constexpr double kExademSnapshot = 0.1;  ///< s between pictures, where no trajectory is wanted
constexpr double kCellsPerBlock = 2.0;   ///< cell size over the longest diagonal of a block
constexpr double kMinRadius = 1e-3;      ///< m, of the ground: it wants one

/// The share of critical damping that returns e_n^2 of the energy of a linear spring with dashpot.
double damping_rate(double energy_restitution) {
  const double log = 0.5 * std::log(std::max(energy_restitution, 1e-12));
  return -log / std::sqrt(kPi * kPi + log * log);
}

/// "name: [a, b]"
template <typename Value>
std::string contact_list(const std::string& name, const std::vector<SceneContact>& contacts,
                         const Value& value) {
  std::string text;
  for (const SceneContact& contact : contacts) text += (text.empty() ? "" : ", ") + value(contact);
  return "     " + name + ": [" + text + "]\n";
}

std::string stiffness_lists(const std::vector<SceneContact>& contacts) {
  using Contact = const SceneContact&;
  return contact_list("kn", contacts, [](Contact c) { return format_exact(c.normal); }) +
         contact_list("kt", contacts, [](Contact c) { return format_exact(c.tangential); }) +
         contact_list("kr", contacts, [](Contact c) { return format_exact(c.rolling); }) +
         contact_list("mu", contacts,
                      [](Contact c) { return format_exact(c.parameters.friction); }) +
         contact_list("damprate", contacts, [](Contact c) {
           return format_exact(damping_rate(c.parameters.energy_restitution));
         });
}

/// Zones that have ground, as drivers by number.
std::vector<std::size_t> drivers_of(const SceneContents& set) {
  std::vector<std::size_t> zones;
  for (std::size_t zone = 0; zone < set.zones.size(); ++zone) {
    if (!set.zones[zone].surface.triangles.empty()) zones.push_back(zone);
  }
  return zones;
}

std::string contacts_text(const SceneContents& set, const Scene& scene) {
  const std::vector<std::size_t> drivers = drivers_of(set);
  std::vector<SceneContact> ground, between;
  for (const SceneContact& contact : scene.contacts) {
    if (contact.first < set.shapes.size()) {
      between.push_back(contact);
      continue;
    }
    const std::size_t zone = contact.first - set.shapes.size();
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
      if (drivers[driver] != zone) continue;
      ground.push_back(contact);
      ground.back().first = static_cast<std::uint32_t>(driver);
    }
  }
  // One block meets no other, but every pair of groups needs numbers.
  if (between.empty()) {
    between.push_back(ground.front());
    between.back().first = between.back().second;
  }
  using Contact = const SceneContact&;
  const auto first = [](Contact c) { return std::to_string(c.first); };
  const auto second = [](Contact c) { return std::to_string(c.second); };
  return "  - multimat_contact_params:\n" + contact_list("group1", between, first) +
         contact_list("group2", between, second) + stiffness_lists(between) +
         "  - drivers_contact_params:\n" + contact_list("group", ground, second) +
         contact_list("driver_id", ground, first) + stiffness_lists(ground);
}

std::string bounds_text(const Bounds& box) {
  const auto corner = [](const Vec3& v) {
    return "[" + format_exact(v.x()) + ", " + format_exact(v.y()) + ", " + format_exact(v.z()) +
           "]";
  };
  return "[" + corner(box.low) + ", " + corner(box.high) + "]";
}

/// The ground and the space above it that blocks need.
Bounds domain_of(const CampaignPlan& prepared, const Scene& scene, double cell) {
  Bounds box = bounds(prepared.header.terrain.surface);
  for (const SceneBody& body : scene.bodies) box.include(body.start.position);
  box.low -= cell * Vec3::Ones();
  const Vec3 cells = ((box.high - box.low) / cell).array().ceil() + 1.0;
  box.high = box.low + cell * cells;
  return box;
}

std::string drivers_text(const CampaignPlan& prepared, const SceneContents& set) {
  const double radius = std::max(prepared.campaign.terrain_radius, kMinRadius);
  std::string text = "setup_drivers:\n";
  const std::vector<std::size_t> drivers = drivers_of(set);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    text += "  - register_stl_mesh:\n     id: " + std::to_string(i) + "\n     filename: ../" +
            set.zones[drivers[i]].shape.name + ".stl\n     minkowski: " + format_exact(radius) +
            " m\n     params: { motion_type: STATIONARY }\n     binary: true\n";
  }
  return text;
}

std::string exadem_input(const CampaignPlan& prepared, const SceneContents& set,
                         const Scene& scene) {
  const Campaign& campaign = prepared.campaign;
  double size = 0.0;
  for (const SceneBody& body : scene.bodies) {
    size = std::max(size, 2.0 * body.scale * set.shapes[body.shape].shape.box.lengths.norm());
  }
  const double cell = kCellsPerBlock * size;
  const Bounds box = domain_of(prepared, scene, cell);
  const auto steps = [&](double time) {
    return std::to_string(static_cast<long long>(std::ceil(time / scene.time_step)));
  };
  const double interval =
      campaign.trajectory_interval > 0.0 ? campaign.trajectory_interval : kExademSnapshot;
  const Vec3 cells = ((box.high - box.low) / cell).array().round();
  return "# written by clast; see ../SCENE.txt\ngrid_flavor: grid_flavor_dem\n\nincludes:\n  - "
         "config_polyhedra.msp\n\nio_tree:\n  - io_config:\n     dir_name: \"output\"\n\n"
         "input_data:\n  - read_conf_rockable:\n     filename: bodies.conf\n     bounds_mode: "
         "DOMAIN_BOUNDS\n" +
         contacts_text(set, scene) + "\n" + drivers_text(prepared, set) +
         "\ncompute_force:\n  - gravity_force:\n     gravity: [0, 0, " +
         format_exact(-campaign.gravity) +
         "]\n  - contact_multimat_polyhedron\n\nparticle_write_paraview_generic:\n  - "
         "write_paraview_polyhedra\n  - write_conf_rockable\n\ndomain:\n  cell_size: " +
         format_exact(cell) + " m\n  periodic: [false, false, false]\n  grid_dims: [" +
         format_decimals(cells.x(), 0) + ", " + format_decimals(cells.y(), 0) + ", " +
         format_decimals(cells.z(), 0) + "]\n  bounds: " + bounds_text(box) +
         "\n  expandable: true\n\nglobal:\n  simulation_dump_frequency: -1\n  "
         "simulation_end_iteration: " +
         steps(campaign.max_time) + "\n  simulation_log_frequency: " + steps(interval) +
         "\n  simulation_paraview_frequency: " + steps(interval) +
         "\n  dt: " + format_exact(scene.time_step) +
         " s\n  rcut_inc: " + format_exact(scene.search_margin) + " m\n";
}

std::string conf_text(const SceneContents& set, const Scene& scene) {
  std::string text = "Rockable 29-11-2018\nt 0\ndt " + format_exact(scene.time_step) + "\n";
  for (std::size_t i = 0; i < set.shapes.size(); ++i) {
    text += "density " + std::to_string(i) + " " + format_exact(set.shapes[i].density) + "\n";
  }
  text +=
      "nDriven 0\nshapeFile ../shapes.shp\nParticles " + std::to_string(scene.bodies.size()) + "\n";
  for (const SceneBody& body : scene.bodies) {
    text += format_conf_line(set.shapes[body.shape].shape.name, body.shape, body.scale, body.start);
  }
  return text;
}

}  // namespace

void write_exadem_scene(const CampaignPlan& prepared, const SceneContents& set, const Scene& scene,
                        const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / scene.name);
  write_output(folder / scene.name / "input.msp", exadem_input(prepared, set, scene), {});
  write_output(folder / scene.name / "bodies.conf", conf_text(set, scene), {});
  for (const std::size_t zone : drivers_of(set)) {
    const std::filesystem::path file = folder / (set.zones[zone].shape.name + ".stl");
    if (!std::filesystem::exists(file)) write_mesh(file, set.zones[zone].surface);
  }
}

std::vector<std::string> check_exadem_limits(const CampaignPlan& prepared) {
  std::vector<std::string> notes = {
      "Not run here: the input follows the keys of ExaDEM 1.2.2 as read in its sources.",
      "In ExaDEM the normal force is a spring with a dashpot: the damping rate -ln e_n / sqrt(pi^2 "
      "+ "
      "ln^2 "
      "e_n) returns e_n^2 of the energy in a contact of one point, while the law of clast and of "
      "Rockable unloads softer than it loads.",
      "Contact stiffness is not shared among the points of a contact: k_n, k_t and k_r act at "
      "each.",
      "In ExaDEM rolling resistance has a stiffness, but no limit mu_R.",
      "Faces of the ground act on both sides; its skin is at least 1 mm thick.",
      "Start the input in the folder of the scene: exaDEM input.msp."};
  if (std::holds_alternative<SpringDashpotLaw>(prepared.campaign.stiffness.law)) notes[1].clear();
  std::erase(notes, "");
  return notes;
}

}  // namespace clast::study_detail
