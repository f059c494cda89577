// Files of simulators of robots, and of RAMMS.
#include "particles/detail/writers.hpp"

namespace clast::particles_detail {

namespace {

std::string xml_comment(const Particle& particle) {
  std::string text = particle_comment(particle);
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) {
    text.replace(at, 2, "- ");  // ends a comment in XML
  }
  return "<!-- " + text + " -->\n";
}

}  // namespace

std::vector<ParticleFile> write_mjcf(const Particle& particle) {
  std::string assets, geometries;
  for (std::size_t i = 0; i < particle.parts.size(); ++i) {
    const std::string part = particle.name + "_part" + std::to_string(i + 1);
    std::string points;
    for (const Vec3& vertex : particle.parts[i].vertices) {
      points += (points.empty() ? "" : "  ") + vector_text(vertex);
    }
    assets += "    <mesh name=\"" + part + "\" vertex=\"" + points + "\"/>\n";
    geometries += "      <geom type=\"mesh\" mesh=\"" + part + "\"/>\n";
  }
  for (const Ball& ball : particle.balls) {
    geometries += "      <geom type=\"sphere\" size=\"" + number_text(ball.radius) + "\" pos=\"" +
                  vector_text(ball.centre) + "\"/>\n";
  }
  return {{particle.name + ".xml",
           xml_comment(particle) + "<mujoco model=\"" + particle.name + "\">\n" +
               (assets.empty() ? "" : "  <asset>\n" + assets + "  </asset>\n") +
               "  <worldbody>\n    <body name=\"" + particle.name +
               "\">\n      <freejoint/>\n      <inertial pos=\"0 0 0\" mass=\"" +
               number_text(particle.mass) + "\" diaginertia=\"" + vector_text(particle.moments) +
               "\"/>\n" + geometries + "    </body>\n  </worldbody>\n</mujoco>\n"}};
}

std::vector<ParticleFile> write_urdf(const Particle& particle) {
  std::vector<ParticleFile> files;
  std::string shapes;
  const auto add_shape = [&](const std::string& geometry, const Vec3& place) {
    for (const char* kind : {"visual", "collision"}) {
      shapes += std::string("    <") + kind + "><origin xyz=\"" + vector_text(place) +
                "\" rpy=\"0 0 0\"/><geometry>" + geometry + "</geometry></" + kind + ">\n";
    }
  };
  for (const Ball& ball : particle.balls) {
    add_shape("<sphere radius=\"" + number_text(ball.radius) + "\"/>", ball.centre);
  }
  for (std::size_t i = 0; i < particle.parts.size(); ++i) {
    const std::string part = particle.name + "_part" + std::to_string(i + 1);
    files.push_back({part + ".obj", obj_text(particle.parts[i], part)});
    add_shape("<mesh filename=\"" + part + ".obj\"/>", Vec3::Zero());
  }
  const Vec3& moments = particle.moments;
  files.push_back({particle.name + ".urdf",
                   "<?xml version=\"1.0\"?>\n" + xml_comment(particle) + "<robot name=\"" +
                       particle.name + "\">\n  <link name=\"" + particle.name +
                       "\">\n    <inertial>\n      <origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n      "
                       "<mass value=\"" +
                       number_text(particle.mass) + "\"/>\n      <inertia ixx=\"" +
                       number_text(moments.x()) + "\" ixy=\"0\" ixz=\"0\" iyy=\"" +
                       number_text(moments.y()) + "\" iyz=\"0\" izz=\"" + number_text(moments.z()) +
                       "\"/>\n    </inertial>\n" + shapes + "  </link>\n</robot>\n"});
  return files;
}

std::vector<ParticleFile> write_ramms(const Particle& particle) {
  std::string rows;
  for (const Vec3& vertex : particle.parts.front().vertices) rows += vector_text(vertex) + "\n";
  return {{particle.name + ".pts", rows}};
}

}  // namespace clast::particles_detail
