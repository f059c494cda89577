#include "particles/engines.hpp"

#include <algorithm>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "particles/detail/writers.hpp"

namespace clast {

using namespace particles_detail;

const std::vector<ParticleEngine>& particle_engines() {
  using enum ParticleShape;
  static const std::string kAll = "mass, centre and inertia tensor";
  static const std::vector<ParticleEngine> kEngines = {
      {"yade",
       "YADE",
       {kSpheres, kPolyhedron},
       "~ID_yade.py~",
       kAll + "; of a polyhedron, the centre is that of the hull",
       "~exec(open('ID_yade.py').read()); add(material)~",
       write_yade},
      {"lammps",
       "LAMMPS",
       {kSpheres},
       "~ID.molecule~",
       kAll,
       "~molecule ID ID.molecule~, with ~fix rigid/small ... mol ID reinit no~",
       write_lammps},
      {"liggghts",
       "LIGGGHTS",
       {kSpheres},
       "~ID.liggghts~, ~ID.spheres~",
       kAll,
       "~include ID.liggghts~, then ~fix particledistribution/discrete~",
       write_liggghts},
      {"pfc",
       "PFC3D",
       {kSpheres},
       "~ID.dat~",
       kAll + ", at unit density",
       "~program call 'ID.dat'~, then ~clump replicate name 'ID'~",
       write_pfc},
      {"edem",
       "EDEM",
       {kSpheres},
       "~ID.csv~",
       "none; EDEM computes them: type in the density of the manifest",
       "paste the rows into the table of spheres of a multi-sphere particle",
       write_edem},
      {"kratos",
       "Kratos",
       {kSpheres},
       "~ID.clu~",
       "volume and principal moments per unit mass",
       "as cluster file of an inlet or of ~Cluster3D~ elements",
       write_kratos},
      {"chrono",
       "Project Chrono",
       {kParts, kSpheres, kPolyhedron},
       "~ID_chrono.py~ with ~ID_part1.obj~ ... or ~ID.csv~",
       kAll,
       "~from ID_chrono import make_body~ in PyChrono",
       write_chrono},
      {"dem-engine",
       "DEM-Engine",
       {kSpheres},
       "~ID.csv~",
       "mass and moments as comments, for the arguments of the call",
       "~LoadClumpType(mass, moi, \"ID.csv\", material)~",
       write_dem_engine},
      {"mjcf",
       "MuJoCo",
       {kParts, kSpheres, kPolyhedron},
       "~ID.xml~",
       kAll,
       "~mujoco.MjModel.from_xml_path(\"ID.xml\")~",
       write_mjcf},
      {"urdf",
       "URDF (ROS, Gazebo, Drake, PyBullet)",
       {kParts, kSpheres, kPolyhedron},
       "~ID.urdf~ with ~ID_part1.obj~ ...",
       kAll,
       "as a robot of one link",
       write_urdf},
      {"ramms",
       "RAMMS::ROCKFALL",
       {kPolyhedron},
       "~ID.pts~",
       "none; RAMMS computes them from the hull: type in the density of the manifest",
       "as a rock of its own: rows x y z",
       write_ramms},
  };
  return kEngines;
}

std::vector<std::string> particle_engine_names() {
  std::vector<std::string> names;
  for (const ParticleEngine& engine : particle_engines()) names.push_back(engine.name);
  return names;
}

const ParticleEngine& find_particle_engine(const std::string& name) {
  for (const ParticleEngine& engine : particle_engines()) {
    if (engine.name == name) return engine;
  }
  throw InputError("`to`: engine \"" + name + "\" is not known; expected " +
                   comma_separated(particle_engine_names()));
}

std::string particle_engine_table() {
  std::string table = "| name | engine | shapes | files |\n|---|---|---|---|\n", list = "\n";
  for (const ParticleEngine& engine : particle_engines()) {
    std::vector<std::string> shapes;
    for (const ParticleShape shape : engine.shapes) shapes.push_back(particle_shape_name(shape));
    table += "| ~" + engine.name + "~ | " + engine.program + " | " + comma_separated(shapes) +
             " | " + engine.files + " |\n";
    list +=
        "- ~" + engine.name + "~ carries " + engine.mass + ".\n  To load: " + engine.loading + "\n";
  }
  std::string text = table + list;
  std::replace(text.begin(), text.end(), '~', '`');
  return text;
}

}  // namespace clast
