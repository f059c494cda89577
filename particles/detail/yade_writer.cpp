// Scripts for YADE: a clump of spheres, or a convex polyhedron.
#include <Eigen/Eigenvalues>

#include "particles/detail/writers.hpp"

namespace clast::particles_detail {

namespace {

std::string tuple_text(const Vec3& vector) { return "(" + vector_text(vector, ", ") + ")"; }

/// YADE adds up the masses and inertia tensors of the spheres; `sphere_masses` makes the sum right.
std::string clump_script(const Particle& particle) {
  const SphereMasses masses = sphere_masses(particle);
  const Eigen::SelfAdjointEigenSolver<Mat3> rest(masses.rest);
  Mat3 axes = rest.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
  const Eigen::AngleAxisd turn{Quat(axes)};
  std::string rows;
  for (std::size_t i = 0; i < particle.balls.size(); ++i) {
    rows += "    (" + vector_text(particle.balls[i].centre, ", ") + ", " +
            number_text(particle.balls[i].radius) + ", " + number_text(masses.masses[i]) + "),\n";
  }
  return "# " + particle_comment(particle) +
         "\n\"\"\"A rock as a clump: run this file in YADE, then call add(material).\"\"\"\n"
         "from yade import *\nfrom yade import utils\n\nMASS = " +
         number_text(particle.mass) + "  # kg\nMOMENTS = " + tuple_text(particle.moments) +
         "  # kg m^2\n# x, y, z, radius (m), and a mass (kg): the sums over all spheres are mass, "
         "centre and inertia\n# tensor of the rock, the first sphere has the rest of the tensor.\n"
         "SPHERES = [\n" +
         rows + "]\nREST = " + tuple_text(rest.eigenvalues()) + "\nREST_AXES = (" +
         tuple_text(turn.axis()) + ", " + number_text(turn.angle()) +
         ")\n\n\ndef add(material, position=(0, 0, 0), orientation=Quaternion((1, 0, 0), 0)):\n"
         "    \"\"\"Adds the clump, with its centre of mass at `position`; returns its id.\"\"\"\n"
         "    spheres = []\n    for x, y, z, radius, mass in SPHERES:\n"
         "        body = utils.sphere(Vector3(position) + orientation * Vector3(x, y, z), radius, "
         "material=material)\n        body.state.mass = mass\n"
         "        body.state.inertia = Vector3(0, 0, 0)\n        spheres.append(body)\n"
         "    spheres[0].state.inertia = Vector3(REST)\n"
         "    spheres[0].state.ori = orientation * Quaternion(*REST_AXES)\n"
         "    clump, members = O.bodies.appendClumped(spheres, discretization=0)\n"
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
         "    \"\"\"Adds the polyhedron, with the centre of mass of the rock at `position`; "
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
