// Scripts for YADE: a clump of spheres, or a convex polyhedron.
#include "particles/detail/writers.hpp"

namespace clast::particles_detail {

namespace {

std::string tuple_text(const Vec3& vector) { return "(" + vector_text(vector, ", ") + ")"; }

/// YADE adds up spheres as if they did not overlap. Masses of `balanced_masses` make it find the
/// right frame, in which the true mass and moments are then set.
std::string clump_script(const Particle& particle) {
  const std::vector<double> masses = balanced_masses(particle);
  std::string rows;
  for (std::size_t i = 0; i < particle.balls.size(); ++i) {
    const Ball& ball = particle.balls[i];
    const double volume = 4.0 / 3.0 * kPi * ball.radius * ball.radius * ball.radius;
    rows += "    (" + vector_text(ball.centre, ", ") + ", " + number_text(ball.radius) + ", " +
            number_text(masses[i] / volume) + "),\n";
  }
  return "# " + particle_comment(particle) +
         "\n\"\"\"A rock as a clump: run this file in YADE, then call add(material).\"\"\"\n"
         "from yade import *\nfrom yade import utils\n\nMASS = " +
         number_text(particle.mass) + "  # kg\nMOMENTS = " + tuple_text(particle.moments) +
         "  # kg m^2, about the axes x, y, z\n# x, y, z, radius (m), and a density with which the "
         "sum over all spheres has its centre and its\n# principal axes where those of the rock "
         "are\nSPHERES = [\n" +
         rows +
         "]\n\n\ndef add(material, position=(0, 0, 0), orientation=Quaternion((1, 0, 0), 0)):\n"
         "    \"\"\"Adds the clump, with its centre of mass at position; returns its id.\"\"\"\n"
         "    spheres = []\n    for x, y, z, radius, density in SPHERES:\n"
         "        body = utils.sphere(Vector3(position) + orientation * Vector3(x, y, z), radius, "
         "material=material)\n        body.mat = type(material)(density=density)\n"
         "        spheres.append(body)\n"
         "    clump, members = O.bodies.appendClumped(spheres, discretization=0)\n"
         "    for member in members:\n        O.bodies[member].mat = material\n"
         "    state = O.bodies[clump].state\n"
         "    # YADE orders the principal axes in its own way.\n"
         "    axes = (orientation.conjugate() * state.ori).toRotationMatrix()\n"
         "    state.mass = MASS\n"
         "    state.inertia = Vector3(*[sum(axes[row, axis] ** 2 * MOMENTS[row] for row in "
         "range(3)) for axis in range(3)])\n"
         "    return clump\n";
}

std::string polyhedron_script(const Particle& particle) {
  std::string rows;
  for (const Vec3& vertex : particle.parts.front().vertices) {
    rows += "    " + tuple_text(vertex) + ",\n";
  }
  return "# " + particle_comment(particle) +
         "\n\"\"\"A rock as a convex polyhedron: run this file in YADE, then call "
         "add(material).\"\"\"\nfrom yade import *\nfrom yade import polyhedra_utils\n\nMASS = " +
         number_text(particle.mass) + "  # kg\nMOMENTS = " + tuple_text(particle.moments) +
         "  # kg m^2\nVERTICES = [\n" + rows +
         "]\n\n\ndef add(material, position=(0, 0, 0), orientation=Quaternion((1, 0, 0), 0)):\n"
         "    \"\"\"Adds the polyhedron, with the centre of mass of the rock at position; "
         "returns "
         "its id.\"\"\"\n    points = [Vector3(position) + orientation * Vector3(v) for v in "
         "VERTICES]\n    body = polyhedra_utils.polyhedra(material, v=points)\n"
         "    body.state.mass = MASS\n    body.state.inertia = Vector3(MOMENTS)\n"
         "    return O.bodies.append(body)\n";
}

}  // namespace

std::vector<ParticleFile> write_yade(const Particle& particle) {
  return {{particle.name + "_yade.py", particle.shape == ParticleShape::kSpheres
                                           ? clump_script(particle)
                                           : polyhedron_script(particle)}};
}

}  // namespace clast::particles_detail
