// The exported files in the programs for which they are made, where these are installed.
#include <gtest/gtest.h>

#include <algorithm>
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
  ParticleEnginesTest() {
    const TriangleMesh mesh =
        rock({.name = "R", .lengths = {0.9, 0.6, 0.4}, .facets = 14, .frequency = 5, .seed = 3});
    BlockOptions options;
    options.tolerance = 0.05;
    block_ = make_block("R", mesh, ScanSurface(mesh), {}, options);
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
  Block block_;
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
  const ProgramRun result = run({"lmp", "-in", "in.lmp"});
  ASSERT_TRUE(std::filesystem::exists(folder_ / "dump.txt")) << result.out << result.err;
  expect_true_mass(last_numbers(read_text_file(folder_ / "dump.txt")));
}

TEST_F(ParticleEnginesTest, LiggghtsHasTheTrueMassMomentsAndCentre) {
  if (!has("liggghts")) GTEST_SKIP() << "liggghts is not installed";
  export_for("liggghts");
  write(
      "in.liggghts",
      "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
      "communicate single vel yes\nunits si\nregion reg block -2 2 -2 2 -2 2 units box\n"
      "create_box 1 reg\nneighbor 0.05 bin\nneigh_modify delay 0\n"
      "fix m1 all property/global youngsModulus peratomtype 5.e6\n"
      "fix m2 all property/global poissonsRatio peratomtype 0.45\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 1 0.5\n"
      "pair_style gran model hertz tangential history\npair_coeff * *\ntimestep 1e-5\n"
      "include R.liggghts\nfix pdd1 all particledistribution/discrete 15485867 1 R 1.0\n"
      "region bc block -0.8 0.8 -0.8 0.8 -0.8 0.8 units box\n"
      "fix ins all insert/pack seed 32452843 distributiontemplate pdd1 vel constant 0. 0. 0. "
      "insert_every once overlapcheck yes orientation constant 1 0 0 0 all_in no "
      "particles_in_region 1 region bc\nfix ms all multisphere\n"
      "compute m all multisphere property masstotal\n"
      "compute i all multisphere property inertia\ncompute x all multisphere property xcm\nrun 1\n"
      "dump d all local 1 dump.txt c_m c_i[1] c_i[2] c_i[3] c_x[1] c_x[2] c_x[3]\n"
      "dump_modify d format \"%.12g %.12g %.12g %.12g %.12g %.12g %.12g\"\n"
      "dump a all custom 1 atoms.txt id x y z\ndump_modify a sort id format \"%d %.12g %.12g "
      "%.12g\"\nrun 0\n");
  const ProgramRun result = run({"liggghts", "-in", "in.liggghts"});
  ASSERT_TRUE(std::filesystem::exists(folder_ / "dump.txt")) << result.out << result.err;
  const std::vector<double> body = last_numbers(read_text_file(folder_ / "dump.txt"));
  expect_true_mass(body);
  const std::vector<double> last_atom = last_numbers(read_text_file(folder_ / "atoms.txt"));
  const std::vector<double> last_sphere = last_numbers(read_text_file(folder_ / "R.spheres"));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(last_atom[k + 1] - body[k + 4], last_sphere[k], 1e-9);
  }
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

TEST_F(ParticleEnginesTest, UrdfIsParsed) {
  if (!has("check_urdf")) GTEST_SKIP() << "liburdfdom-tools is not installed";
  export_for("urdf");
  const ProgramRun result = run({"check_urdf", "R.urdf"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_TRUE(contains(result.out, "Successfully Parsed")) << result.out;
}

}  // namespace
}  // namespace clast
