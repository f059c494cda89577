// Mass properties and shape class of a closed mesh: mass_properties MESH DENSITY
#include <cstdlib>
#include <iostream>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "massprops/principal_frame.hpp"
#include "massprops/solid.hpp"
#include "mesh/mesh_io.hpp"
#include "shapes/oriented_box.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const clast::TriangleMesh mesh = clast::read_mesh(argv[1]);  // closed, in metres
    const clast::MassProperties solid = clast::solid_mass_properties(mesh, std::atof(argv[2]));
    const clast::PrincipalFrame frame = clast::principal_frame(solid);
    const clast::OrientedBox box = clast::smallest_box(mesh.vertices);
    const clast::Axes axes{box.lengths[0], box.lengths[1], box.lengths[2]};

    std::cout << "volume   " << solid.volume << " m3\n"
              << "mass     " << solid.mass << " kg\n"
              << "centre   " << solid.centre.transpose() << " m\n"
              << "moments  " << frame.moments.transpose() << " kg m2\n"
              << "L, I, S  " << axes.L << " " << axes.I << " " << axes.S << " m\n"
              << "class    " << clast::shape_class("sneed-folk", axes) << "\n";
  } catch (const clast::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
