#!/usr/bin/env python3
"""Releases of clumps at several errors in LIGGGHTS against clast's own bodies: run-out by form and number of spheres.

    release_study.py BUILD_DIR OUT_DIR [--releases 30] [--figure docs/clumps.svg]

Three forms of one sample block with equal mass (compact, platy, elongated) start in the same random orientations above
a slope of 30 degrees with a level floor. Both use a linear spring and dashpot and Coulomb friction; docs/clumps.md
states what differs. What exists in OUT_DIR is not computed again. Needs LIGGGHTS (Debian package liggghts), and
Matplotlib for the figure.
"""
import argparse
import csv
import math
import random
import statistics
import subprocess
from pathlib import Path

FORMS = {"compact": "0.9,0.8", "platy": "0.9,0.35", "elongated": "0.4,0.35"}  # I/L, S/L
LEVELS = [0.2, 0.1, 0.05, 0.03, 0.02]
SLOPE_HEIGHT, SLOPE_LENGTH, FLOOR_END, HALF_WIDTH = 11.547, 20.0, 90.0, 40.0  # m
START, SPEED = (2.0, 0.0, SLOPE_HEIGHT - 2.0 * math.tan(math.radians(30)) + 1.2), 3.0  # m, m/s
STIFFNESS, RESTITUTION, FRICTION = 2e7, 0.3, 0.5  # N/m
TIME, STEP = 12.0, 2e-4  # s


def surface_triangles():
    a, b = -4.0, SLOPE_HEIGHT + 4.0 * math.tan(math.radians(30))
    rows = [(a, b), (SLOPE_LENGTH, 0.0), (FLOOR_END, 0.0)]
    points = [(x, y, z) for x, z in rows for y in (-HALF_WIDTH, HALF_WIDTH)]
    return points, [(0, 2, 1), (1, 2, 3), (2, 4, 3), (3, 4, 5)]


def write_surface(folder):
    points, triangles = surface_triangles()
    with open(folder / "scene.ply", "w", encoding="utf-8") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
                   f"property double z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\n"
                   "end_header\n")
        file.writelines("%r %r %r\n" % point for point in points)
        file.writelines("3 %d %d %d\n" % triangle for triangle in triangles)
    with open(folder / "scene.stl", "w", encoding="utf-8") as file:
        file.write("solid scene\n")
        for triangle in triangles:
            file.write("facet normal 0 0 1\nouter loop\n")
            file.writelines("vertex %r %r %r\n" % points[corner] for corner in triangle)
            file.write("endloop\nendfacet\n")
        file.write("endsolid scene\n")


def random_rotations(count):
    generator, rotations = random.Random(7), []
    while len(rotations) < count:
        q = [generator.gauss(0.0, 1.0) for _ in range(4)]
        norm = math.sqrt(sum(value * value for value in q))
        rotations.append([value / norm for value in q])
    return rotations


def clast(build, *words):
    subprocess.run([str(build / "app/clast"), *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def make_bodies(build, out):
    forms = out / "forms.h5"
    if not forms.exists():
        clast(build, "reconstruct", "samples/blocks/B01_compact.ply", "-o", out / "scan.h5", "--replace")
        for ratios in FORMS.values():
            clast(build, "vary", out / "scan.h5", "--to", ratios, "-o", forms)
    clast(build, "export", forms, "--to", "liggghts", "-o", out / "clumps", "--levels",
          ",".join(map(str, LEVELS)))
    with open(out / "clumps/particles.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def form_of(block):
    """Name of the form of a block such as B01_compact_il0.9_sl0.8."""
    ratios = block.split("_il")[1].split("_sl")
    return next(name for name, wanted in FORMS.items() if wanted == ",".join(ratios))


def run_own_bodies(build, out, rotations):
    """Stop of each release of clast's bodies: {form: [x, ...]}."""
    (out / "rotations.txt").write_text("".join("%.15g %.15g %.15g %.15g\n" % tuple(q) for q in rotations))
    (out / "own.toml").write_text(f"""[blocks]
library = "forms.h5"
[terrain]
surface = "scene.ply"
[ground.ground]
energy_restitution = {RESTITUTION ** 2}
friction = {FRICTION}
rolling_friction = 0
[release]
points = [[{START[0]}, {START[1]}, {START[2]}]]
velocity_m_s = [{SPEED}, 0, 0]
orientations = "rotations.txt"
frame = "principal"
[contact]
law = "spring-dashpot"
stiffness_n_m = {STIFFNESS}
[run]
max_time_s = {TIME}
downslope = [1.0, 0.0]
""")
    if not (out / "own.h5").exists():
        clast(build, "simulate", out / "own.toml", "-o", out / "own.h5")
    if not (out / "own/runs.csv").exists():
        clast(build, "compare", out / "own.h5", "-o", out / "own")
    stops = {name: [] for name in FORMS}
    with open(out / "own/runs.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            stops[form_of(row["block"])].append(float(row["stop_x_m"]))
    return stops


def liggghts_stop(out, particle, index, rotation):
    """x of a clump at the end of a release in LIGGGHTS, m."""
    folder = out / "runs" / f"{particle['name']}_{index}"
    result = folder / "end.txt"
    if not result.exists():
        folder.mkdir(parents=True, exist_ok=True)
        name = particle["name"]
        for suffix in (".liggghts", ".spheres"):
            (folder / (name + suffix)).write_text((out / "clumps" / (name + suffix)).read_text())
        mass = float(particle["mass_kg"])
        decay = math.log(1.0 / RESTITUTION)
        damping = 2.0 * math.sqrt(STIFFNESS / mass) * decay / math.hypot(math.pi, decay)  # 1/s
        x, y, z = START
        around = " ".join(f"{c - 0.01} {c + 0.01}" for c in START)
        (folder / "in.liggghts").write_text(f"""atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
region reg block -5 {FLOOR_END + 1} {-HALF_WIDTH - 1} {HALF_WIDTH + 1} -3 20 units box
create_box 1 reg
neighbor 0.1 bin
neigh_modify delay 0 binsize 2.0
fix m1 all property/global kn peratomtypepair 1 {STIFFNESS}
fix m2 all property/global kt peratomtypepair 1 {STIFFNESS}
fix m3 all property/global gamman peratomtypepair 1 {damping}
fix m4 all property/global gammat peratomtypepair 1 {damping}
fix m5 all property/global coefficientFriction peratomtypepair 1 {FRICTION}
pair_style gran model hooke/stiffness tangential history
pair_coeff * *
timestep {STEP}
fix grav all gravity 9.81 vector 0 0 -1
fix scene all mesh/surface file ../../scene.stl type 1
fix walls all wall/gran model hooke/stiffness tangential history mesh n_meshes 1 meshes scene
include {name}.liggghts
fix pdd all particledistribution/discrete 15485867 1 {name} 1.0
region start block {around} volume_limit 1e-9 units box
fix ins all insert/pack seed 32452843 distributiontemplate pdd vel constant {SPEED} 0. 0. insert_every once &
  overlapcheck yes orientation constant {' '.join('%.12g' % c for c in rotation)} all_in no &
  particles_in_region 1 region start
fix ms all multisphere
compute x all multisphere property xcm
thermo 100000
run 1
dump d all local {int(TIME / STEP / 30)} path.txt c_x[1] c_x[2] c_x[3]
dump_modify d format "%.9g %.9g %.9g"
run {int(TIME / STEP)}
""")
        with open(folder / "log.txt", "w", encoding="utf-8") as log:
            subprocess.run(["liggghts", "-in", "in.liggghts"], cwd=folder, stdout=log, stderr=log, check=True)
        rows = [line.split() for line in (folder / "path.txt").read_text().splitlines()]
        path = [row for row in rows if len(row) == 3 and row[0] != "ITEM:"]
        result.write_text(" ".join(path[-1]))
    return float(result.read_text().split()[0])


def mean_and_error(values):
    return statistics.mean(values), statistics.stdev(values) / math.sqrt(len(values))


def draw(table, own, path):
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "clumps"
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7, 4.2))
    colours = {"compact": "#1b6ca8", "platy": "#c7522a", "elongated": "#3f7d4f"}
    for name in FORMS:
        rows = [row for row in table if row["form"] == name]
        axes.errorbar([row["spheres"] for row in rows], [row["runout"] for row in rows],
                      [row["error"] for row in rows], marker="o", capsize=3, color=colours[name],
                      label=f"{name}: clumps")
        mean, error = mean_and_error(own[name])
        axes.axhspan(mean - error, mean + error, color=colours[name], alpha=0.2, linewidth=0)
        axes.axhline(mean, color=colours[name], linestyle="--", linewidth=1, label=f"{name}: body of clast")
    axes.set_xscale("log")
    axes.set_xticks([2, 5, 10, 20, 50, 100], ["2", "5", "10", "20", "50", "100"])
    axes.minorticks_off()
    axes.set_xlabel("number of spheres")
    axes.set_ylabel(f"mean distance after {TIME:.0f} s, m")
    axes.legend(fontsize=8, ncol=2)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--releases", type=int, default=30)
    parser.add_argument("--figure", type=Path)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    write_surface(args.out)
    rotations = random_rotations(args.releases)
    particles = make_bodies(args.build, args.out)
    own = run_own_bodies(args.build, args.out, rotations)
    table = []
    for particle in particles:
        stops = [liggghts_stop(args.out, particle, i, q) for i, q in enumerate(rotations)]
        mean, error = mean_and_error(stops)
        table.append({"form": form_of(particle["block"]), "level": particle["name"].split("_s")[-1],
                      "spheres": int(particle["spheres"]), "surface": float(particle["error_surface"]),
                      "runout": mean, "error": error})
    table.sort(key=lambda row: (list(FORMS).index(row["form"]), row["spheres"]))
    print("| form | spheres | surface error | mean distance, m | standard error, m |\n|---|---|---|---|---|")
    for name in FORMS:
        for row in table:
            if row["form"] == name:
                print(f"| {name} | {row['spheres']} | {100 * row['surface']:.1f} % | {row['runout']:.1f} | "
                      f"{row['error']:.1f} |")
        mean, error = mean_and_error(own[name])
        print(f"| {name} | body of clast | | {mean:.1f} | {error:.1f} |")
    if args.figure:
        draw(table, own, args.figure)


if __name__ == "__main__":
    main()
