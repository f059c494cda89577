// A world of blocks: 27 rounded boxes fall on a plane, hit each other and come to rest.
#include <iostream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/contact/stiffness.hpp"
#include "dem/motion/box_body.hpp"
#include "dem/simulation/world.hpp"

int main() {
  try {
    // The ground: two triangles with their normals up, one ground zone.
    clast::TriangleMesh plane;
    plane.vertices = {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}};
    plane.triangles = {{0, 1, 2}, {0, 2, 3}};
    const clast::TerrainSurface terrain(plane, {0, 0});
    clast::GroundParameters ground;
    ground.energy_restitution = 0.1;  // e_n^2
    ground.friction = 0.6;
    ground.rolling_friction = 0.2;

    // Boxes of 1.0 m x 0.8 m x 0.6 m (core 0.05 m smaller on all sides), 1,300 kg.
    const clast::RigidBody box = clast::make_box_body({0.9, 0.7, 0.5}, 0.05, 1300.0);

    clast::WorldSettings settings;
    settings.between_bodies = ground;
    clast::StiffnessOptions options;
    options.multi_block = true;
    const double fastest = 12.0;  // m/s, more than a fall of 6 m gives
    settings.stiffness = clast::choose_stiffness(std::vector{box}, std::vector{ground}, fastest,
                                                 settings.gravity, options)
                             .stiffness;
    clast::World world({box}, settings, terrain, {ground});

    clast::Random random(1);
    for (int i = 0; i < 27; ++i) {
      clast::RigidState state;
      state.position = {1.5 * (i % 3), 1.5 * (i / 3 % 3), 1.0 + 1.5 * (i / 9)};
      state.angular_velocity = random.unit_vector();
      world.add_body(0, state);
    }

    world.run_until_rest(30.0);
    const clast::EnergySample energy = world.energy_sample();
    std::cout << "at rest after " << world.time() << " s; dissipated "
              << energy.on_ground.sum() / 1e3 << " kJ on the ground, "
              << energy.between_bodies.sum() / 1e3 << " kJ between blocks\n";
    for (std::size_t i = 0; i < world.body_count(); ++i) {
      std::cout << world.state(i).position.transpose() << "\n";
    }
  } catch (const clast::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
