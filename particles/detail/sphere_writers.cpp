// Files of engines that take spheres. Their formats are described in docs/howto/other-engines.md.
#include <algorithm>
#include <cmath>

#include "particles/detail/writers.hpp"

namespace clast::particles_detail {

namespace {

std::string sphere_rows(const Particle& particle, const char* separator) {
  std::string rows;
  for (const Ball& ball : particle.balls) {
    rows += vector_text(ball.centre, separator) + separator + number_text(ball.radius) + "\n";
  }
  return rows;
}

/// Masses of spheres in proportion to the cubes of the radii, kg.
std::vector<double> positive_masses(const Particle& particle) {
  double sum = 0.0;
  std::vector<double> masses;
  for (const Ball& ball : particle.balls) sum += std::pow(ball.radius, 3.0);
  for (const Ball& ball : particle.balls) {
    masses.push_back(particle.mass * std::pow(ball.radius, 3.0) / sum);
  }
  return masses;
}

/// Table "x,y,z,r" with mass and moments as comments at its end, where DEM-Engine's own files have
/// them.
std::string clump_table(const Particle& particle) {
  return "x,y,z,r\n" + sphere_rows(particle, ",") + "# " + particle_comment(particle) +
         "\n# mass = " + number_text(particle.mass) +
         "\n# volume = " + number_text(particle.volume) +
         "\n# Ixx, Iyy, Izz = " + vector_text(particle.moments, ", ") + "\n";
}

}  // namespace

std::vector<ParticleFile> write_lammps(const Particle& particle) {
  const std::size_t count = particle.balls.size();
  std::string coordinates, types, diameters, masses;
  const std::vector<double> mass = positive_masses(particle);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string row = std::to_string(i + 1) + " ";
    coordinates += row + vector_text(particle.balls[i].centre) + "\n";
    types += row + "1\n";
    diameters += row + number_text(2.0 * particle.balls[i].radius) + "\n";
    masses += row + number_text(mass[i]) + "\n";
  }
  return {{particle.name + ".molecule",
           particle_comment(particle) + "\n\n" + std::to_string(count) + " atoms\n" +
               number_text(particle.mass) + " mass\n0 0 0 com\n" + vector_text(particle.moments) +
               " 0 0 0 inertia\n\nCoords\n\n" + coordinates + "\nTypes\n\n" + types +
               "\nDiameters\n\n" + diameters + "\nMasses\n\n" + masses}};
}

std::vector<ParticleFile> write_liggghts(const Particle& particle) {
  const std::string spheres = particle.name + ".spheres";
  // A prime number that differs between bodies of different spheres is not needed: nothing is drawn
  // from a distribution of one template.
  const std::string command =
      "# " + particle_comment(particle) + "\nfix " + particle.name +
      " all particletemplate/multisphere 15485863 atom_type 1 density constant " +
      number_text(particle.density) + " nspheres " + std::to_string(particle.balls.size()) +
      " ntry 1000000 spheres file " + spheres + " scale 1.0 type 1 mass " +
      number_text(particle.mass) + " inertia_tensor " + number_text(particle.moments.x()) +
      " 0 0 " + number_text(particle.moments.y()) + " 0 " + number_text(particle.moments.z()) +
      " use_density\n";
  return {{particle.name + ".liggghts", command}, {spheres, sphere_rows(particle, " ")}};
}

std::vector<ParticleFile> write_pfc(const Particle& particle) {
  std::string text = "; " + particle_comment(particle) + "\n; inertia at unit density, density " +
                     number_text(particle.density) + "\nclump template create name '" +
                     particle.name + "' ...\n  volume " + number_text(particle.volume) +
                     " position 0 0 0 ...\n  inertia " +
                     vector_text(particle.moments / particle.density) + " 0 0 0 ...\n  pebbles " +
                     std::to_string(particle.balls.size());
  for (const Ball& ball : particle.balls) {
    text += " ...\n  " + number_text(ball.radius) + " " + vector_text(ball.centre);
  }
  return {{particle.name + ".dat", text + "\n"}};
}

std::vector<ParticleFile> write_edem(const Particle& particle) {
  std::string rows =
      "Physical Radius (m),Contact Radius (m),Position X (m),Position Y (m),"
      "Position Z (m)\n";
  for (const Ball& ball : particle.balls) {
    const std::string radius = number_text(ball.radius);
    rows += radius + "," + radius + "," + vector_text(ball.centre, ",") + "\n";
  }
  return {{particle.name + ".csv", rows}};
}

std::vector<ParticleFile> write_kratos(const Particle& particle) {
  const std::string diameter = number_text(2.0 * bounding_radius(particle));
  const Vec3 unit = particle.moments / particle.mass;
  return {
      {particle.name + ".clu", "// " + particle_comment(particle) + "\n\nName\n" + particle.name +
                                   "\n\nBegin centers_and_radii\n" + sphere_rows(particle, " ") +
                                   "End centers_and_radii\n\nParticle_center_and_diameter\n0 0 0 " +
                                   diameter + "\n\nSize\n" + number_text(particle.lengths[0]) +
                                   "\n\nVolume\n" + number_text(particle.volume) +
                                   "\n\nInertia per unit mass\n" + vector_text(unit, "\n") + "\n"}};
}

std::vector<ParticleFile> write_dem_engine(const Particle& particle) {
  return {{particle.name + ".csv", clump_table(particle)}};
}

std::vector<ParticleFile> write_chrono(const Particle& particle) {
  std::vector<ParticleFile> files;
  if (particle.shape == ParticleShape::kSpheres) {
    files.push_back({particle.name + ".csv", clump_table(particle)});
  }
  for (std::size_t i = 0; i < particle.parts.size(); ++i) {
    const std::string part = particle.name + "_part" + std::to_string(i + 1);
    files.push_back({part + ".obj", obj_text(particle.parts[i], part)});
  }
  // A function of PyChrono, which makes the body.
  std::string text =
      "# " + particle_comment(particle) +
      "\nimport os\nimport pychrono as chrono\n\nHERE = "
      "os.path.dirname(os.path.abspath(__file__))\n\n\ndef make_body(material):\n"
      "    \"\"\"Body with mass and inertia of the rock, and its collision shape.\"\"\"\n"
      "    body = chrono.ChBody()\n    body.SetMass(" +
      number_text(particle.mass) + ")\n    body.SetInertiaXX(chrono.ChVector3d(" +
      vector_text(particle.moments, ", ") + "))\n";
  if (particle.shape == ParticleShape::kSpheres) {
    text +=
        "    with open(os.path.join(HERE, \"" + particle.name +
        ".csv\")) as table:\n        rows = [row.split(\",\") for row in table if row[0] not in "
        "\"x#\"]\n    for x, y, z, r in [map(float, row) for row in rows]:\n        shape = "
        "chrono.ChCollisionShapeSphere(material, r)\n        body.AddCollisionShape(shape, "
        "chrono.ChFramed(chrono.ChVector3d(x, y, z), chrono.QUNIT))\n";
  } else {
    text += "    for part in range(1, " + std::to_string(particle.parts.size() + 1) +
            "):\n        points = chrono.vector_ChVector3d()\n        with open(os.path.join(HERE, "
            "f\"" +
            particle.name +
            "_part{part}.obj\")) as mesh:\n            for row in mesh:\n                if "
            "row.startswith(\"v \"):\n                    "
            "points.append(chrono.ChVector3d(*map(float, row.split()[1:])))\n        shape = "
            "chrono.ChCollisionShapeConvexHull(material, points)\n        "
            "body.AddCollisionShape(shape)\n";
  }
  text += "    body.EnableCollision(True)\n    return body\n";
  files.push_back({particle.name + "_chrono.py", text});
  return files;
}

}  // namespace clast::particles_detail
