// The exported files in the programs for which they are made, where these are installed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/files/text_file.hpp"
#include "library/make_block.hpp"
#include "particles/particle_export.hpp"
#include "samples/rock_shapes.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class ParticleEnginesTest : public testing::Test {
 protected:
  /// The block is made once for all tests.
  static Block make_rock() {
    const TriangleMesh mesh =
        rock({.name = "R", .lengths = {0.9, 0.6, 0.4}, .facets = 14, .frequency = 5, .seed = 3});
    BlockOptions options;
    options.tolerance = 0.05;
    return make_block("R", mesh, ScanSurface(mesh), {}, options);
  }
  static const Block& rock_block() {
    static const Block kBlock = make_rock();
    return kBlock;
  }

  bool has(const std::string& program) {
    return RunningProgram({"sh", "-c", "command -v " + program}, folder_.path()).wait().exit_code ==
           0;
  }
  void export_for(const std::string& engine) {
    ParticleExportOptions options;
    options.engine = engine;
    if (options.chosen_shape() == ParticleShape::kSpheres) options.clump.balls = 20;
    if (options.chosen_shape() == ParticleShape::kParts) options.max_parts = 4;
    const ParticleExport result = export_particles({&block_}, folder_.path(), options);
    ASSERT_TRUE(result.failures.empty()) << result.failures[0];
  }
  void write(const std::string& name, const std::string& text) {
    write_text_file(folder_ / name, text);
  }
  ProgramRun run(const std::vector<std::string>& words) {
    return RunningProgram(words, folder_.path()).wait();
  }
  /// Runs a program and returns the numbers of the last line of the file dump.txt that it writes.
  std::vector<double> last_dumped(const std::vector<std::string>& words) {
    const ProgramRun result = run(words);
    const std::filesystem::path dump = folder_ / "dump.txt";
    EXPECT_TRUE(std::filesystem::exists(dump)) << result.out << result.err;
    return std::filesystem::exists(dump) ? last_numbers(read_text_file(dump))
                                         : std::vector<double>();
  }
  /// Numbers of the last line of a text.
  static std::vector<double> last_numbers(const std::string& text) {
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) last = line;
    }
    std::istringstream words(last);
    std::vector<double> numbers;
    for (double number = 0.0; words >> number;) numbers.push_back(number);
    return numbers;
  }
  /// Mass and three moments in any order.
  void expect_true_mass(std::vector<double> numbers) {
    ASSERT_GE(numbers.size(), 4u);
    EXPECT_NEAR(numbers[0] / block_.mass.mass, 1.0, 1e-6);
    std::sort(numbers.begin() + 1, numbers.begin() + 4);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(numbers[static_cast<std::size_t>(k) + 1] / block_.principal.moments[k], 1.0,
                  1e-6);
    }
  }

  ScratchFolder folder_;
  const Block& block_ = rock_block();
};

TEST_F(ParticleEnginesTest, LammpsHasTheTrueMassAndMoments) {
  if (!has("lmp")) GTEST_SKIP() << "lammps is not installed";
  export_for("lammps");
  write("in.lmp",
        "units si\natom_style hybrid sphere bond\natom_modify map array\nboundary f f f\n"
        "region box block -2 2 -2 2 -2 2\ncreate_box 1 box\nmolecule R R.molecule\n"
        "pair_style zero 1.2\npair_coeff * *\ncomm_modify vel yes\ntimestep 1e-4\n"
        "fix r all rigid/small molecule mol R reinit no\n"
        "region ins block -0.01 0.01 -0.01 0.01 -0.01 0.01\n"
        "fix d all deposit 1 0 1 12345 region ins mol R rigid r orient 0 0 1\n"
        "compute b all rigid/local r mass inertiax inertiay inertiaz\n"
        "dump 1 all local 1 dump.txt c_b[1] c_b[2] c_b[3] c_b[4]\n"
        "dump_modify 1 format line \"%.12g %.12g %.12g %.12g\"\nthermo_style custom step\nrun 2\n");
  expect_true_mass(last_dumped({"lmp", "-in", "in.lmp"}));
}

/// Input of LIGGGHTS with the block at the origin.
/// @param forces  lines with gravity and walls
std::string liggghts_scene(const std::string& forces, const std::string& step,
                           const std::string& motion) {
  return "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
         "communicate single vel yes\nunits si\nregion reg block -2 2 -2 2 -2 2 units box\n"
         "create_box 1 reg\nneighbor 0.05 bin\nneigh_modify delay 0\n"
         "fix m1 all property/global youngsModulus peratomtype 5.e7\n"
         "fix m2 all property/global poissonsRatio peratomtype 0.45\n"
         "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3\n"
         "fix m4 all property/global coefficientFriction peratomtypepair 1 0.5\n"
         "pair_style gran model hertz tangential history\npair_coeff * *\ntimestep " +
         step + "\n" + forces +
         "include R.liggghts\nfix pdd1 all particledistribution/discrete 15485867 1 R 1.0\n"
         "region bc block -0.01 0.01 -0.01 0.01 -0.01 0.01 volume_limit 1e-9 units box\n"
         "fix ins all insert/pack seed 32452843 distributiontemplate pdd1 " +
         motion +
         " insert_every once overlapcheck yes orientation constant 1 0 0 0 all_in no "
         "particles_in_region 1 region bc\nfix ms all multisphere\n";
}

TEST_F(ParticleEnginesTest, LiggghtsHasTheTrueMassMomentsAndCentre) {
  if (!has("liggghts")) GTEST_SKIP() << "liggghts is not installed";
  export_for("liggghts");
  write("in.liggghts",
        liggghts_scene("", "1e-5", "vel constant 0. 0. 0.") +
            "compute m all multisphere property masstotal\n"
            "compute i all multisphere property inertia\ncompute x all multisphere property xcm\n"
            "run 1\ndump d all local 1 dump.txt c_m c_i[1] c_i[2] c_i[3] c_x[1] c_x[2] c_x[3]\n"
            "dump_modify d format \"%.12g %.12g %.12g %.12g %.12g %.12g %.12g\"\n"
            "dump a all custom 1 atoms.txt id x y z\ndump_modify a sort id format \"%d %.12g "
            "%.12g %.12g\"\nrun 0\n");
  const std::vector<double> body = last_dumped({"liggghts", "-in", "in.liggghts"});
  ASSERT_EQ(body.size(), 7u);
  expect_true_mass(body);
  const std::vector<double> last_atom = last_numbers(read_text_file(folder_ / "atoms.txt"));
  const std::vector<double> last_sphere = last_numbers(read_text_file(folder_ / "R.spheres"));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(last_atom[k + 1] - body[k + 4], last_sphere[k], 1e-9);
  }
}

TEST_F(ParticleEnginesTest, FreeSpinInLiggghtsHasTheTruePeriod) {
  if (!has("liggghts")) GTEST_SKIP() << "liggghts is not installed";
  export_for("liggghts");
  const Vec3 spin(2.0, 0.5, 20.0);
  write("in.liggghts",
        liggghts_scene("", "5e-5", "vel constant 0. 0. 0. omega constant 2.0 0.5 20.0") +
            "compute w all multisphere property omega\nrun 1\n"
            "dump d all local 10 dump.txt c_w[1] c_w[2] c_w[3]\n"
            "dump_modify d format \"%.12g %.12g %.12g\"\nrun 40000\n");
  run({"liggghts", "-in", "in.liggghts"});
  std::vector<double> squares;
  std::istringstream lines(read_text_file(folder_ / "dump.txt"));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ITEM: ENTRIES", 0) != 0) continue;
    Vec3 omega = Vec3::Zero();
    lines >> omega.x() >> omega.y() >> omega.z();
    squares.push_back(omega.squaredNorm());
  }
  std::vector<double> minima;
  for (std::size_t i = 1; i + 1 < squares.size(); ++i) {
    if (squares[i] < squares[i - 1] && squares[i] <= squares[i + 1]) {
      minima.push_back(10 * 5e-5 * static_cast<double>(i));
    }
  }
  ASSERT_GE(minima.size(), 3u);
  const double measured =
      2.0 * (minima.back() - minima.front()) / static_cast<double>(minima.size() - 1);
  // Free rotation near the axis of the largest moment (Landau & Lifshitz, Mechanics, 37).
  const Vec3& J = block_.principal.moments;
  const double energy = spin.dot(J.cwiseProduct(spin));
  const double squared = J.cwiseProduct(spin).squaredNorm();
  ASSERT_GT(squared, energy * J[1]);
  const double rate = std::sqrt((J[2] - J[1]) * (squared - energy * J[0]) / (J[0] * J[1] * J[2]));
  const double modulus = std::sqrt((J[1] - J[0]) * (energy * J[2] - squared) /
                                   ((J[2] - J[1]) * (squared - energy * J[0])));
  EXPECT_NEAR(measured / (4.0 * std::comp_ellint_1(modulus) / rate), 1.0, 0.01);
}

TEST_F(ParticleEnginesTest, RestHeightInLiggghtsIsThatOfTheBlock) {
  if (!has("liggghts")) GTEST_SKIP() << "liggghts is not installed";
  export_for("liggghts");
  write("in.liggghts",
        liggghts_scene("fix grav all gravity 9.81 vector 0 0 -1\n"
                       "fix floor all wall/gran model hertz tangential history primitive type 1 "
                       "zplane -0.5\n",
                       "2e-5", "vel constant 0. 0. 0.") +
            "run 1\nrun 150000\ndump a all custom 1 dump.txt id x y z\n"
            "dump_modify a sort id format \"%d %.12g %.12g %.12g\"\nrun 0\n");
  run({"liggghts", "-in", "in.liggghts"});
  std::istringstream placed(read_text_file(folder_ / "dump.txt"));
  std::istringstream own(read_text_file(folder_ / "R.spheres"));
  for (std::string line; std::getline(placed, line) && line.rfind("ITEM: ATOMS", 0) != 0;) {
  }
  Eigen::Matrix3Xd from(3, 20), to(3, 20);
  for (int i = 0; i < 20; ++i) {
    double id = 0.0, radius = 0.0;
    placed >> id >> to(0, i) >> to(1, i) >> to(2, i);
    own >> from(0, i) >> from(1, i) >> from(2, i) >> radius;
  }
  const Eigen::Matrix4d placed_from_body = Eigen::umeyama(from, to, false);
  const ParticleBody body = make_particle_body(block_);
  double lowest = 1e9;
  for (const Vec3& vertex : body.mesh.vertices) {
    lowest = std::min(lowest, (placed_from_body * vertex.homogeneous())[2] - body.radius);
  }
  const ParticleExportOptions options = {.engine = "liggghts", .clump = {.balls = 20}};
  const double error = make_particles(block_, options)[0].errors.surface * body.length;
  EXPECT_LT(std::abs(lowest + 0.5), error);
}

TEST_F(ParticleEnginesTest, YadeHasTheTrueMassMomentsCentreAndAxes) {
  if (!has("yade")) GTEST_SKIP() << "yade is not installed";
  export_for("yade");
  write("check.py",
        "exec(open('R_yade.py').read())\nturn = Quaternion((0.3, 0.2, 1), 0.5)\nturn.normalize()\n"
        "state = O.bodies[add(FrictMat(density=1), (1, 2, 3), turn)].state\n"
        "axes = (turn.conjugate() * state.ori).toRotationMatrix()\n"
        "wrong = max(min(abs(abs(axes[i, j]) - k) for k in (0, 1)) for i in range(3) for j in "
        "range(3))\n"
        "print('%.12g %.12g %.12g %.12g %.3g %.3g' % (state.mass, *state.inertia, (state.pos - "
        "Vector3(1, 2, 3)).norm(), wrong))\n");
  const ProgramRun result = run({"yade", "-x", "-n", "check.py"});
  const std::vector<double> numbers = last_numbers(result.out);
  ASSERT_EQ(numbers.size(), 6u) << result.out << result.err;
  expect_true_mass(numbers);
  EXPECT_LT(numbers[4], 1e-9);
  EXPECT_LT(numbers[5], 1e-6);
}

#ifdef CLAST_HAS_MUJOCO_JS
TEST_F(ParticleEnginesTest, MujocoHasTheTrueMassAndMoments) {
  export_for("mjcf");
  write("read.mjs",
        "import load from '" CLAST_NPM
        "/mujoco-js/dist/mujoco_wasm.js';\nimport fs from 'fs';\n"
        "const mujoco = await load();\nmujoco.FS.writeFile('/R.xml', fs.readFileSync('R.xml'));\n"
        "const model = mujoco.MjModel.loadFromXML('/R.xml');\n"
        "console.log(model.body_mass[1], ...model.body_inertia.slice(3, 6));\n");
  const ProgramRun result = run({CLAST_NODE, "read.mjs"});
  expect_true_mass(last_numbers(result.out));
}
#endif

TEST_F(ParticleEnginesTest, UrdfIsParsed) {
  if (!has("check_urdf")) GTEST_SKIP() << "liburdfdom-tools is not installed";
  export_for("urdf");
  const ProgramRun result = run({"check_urdf", "R.urdf"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_TRUE(contains(result.out, "Successfully Parsed")) << result.out;
}

}  // namespace
}  // namespace clast
