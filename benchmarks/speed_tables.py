#!/usr/bin/env python3
"""Measures the speed of clast and writes the tables of docs/benchmarks.md.

    benchmarks/speed_tables.py BUILD_DIR [--data DIR]   measures (15 to 30 minutes), writes results and tables
    benchmarks/speed_tables.py                          writes the tables of the stored results

BUILD_DIR is a Release build with benchmarks (CLAST_BENCHMARKS=ON). DIR is the data folder
(CLAST_DATA); without it, rows that need real scans or the published study are left out.
"""

import argparse
import json
import re
import sys
import textwrap
from datetime import date
from pathlib import Path

import speed_measurements

SOURCE = Path(__file__).resolve().parents[1]
RESULTS = SOURCE / "benchmarks" / "results" / "speed.json"
PAGE = SOURCE / "docs" / "benchmarks.md"
MARKED = re.compile(r"(<!-- table: (\w+) -->\n)(.*?)(<!-- end of table -->)", re.S)


def digits(value, count=2):
    """Formats a positive number with a number of significant digits."""
    text = f"{value:#.{count}g}".rstrip(".")
    return f"{float(text):,.0f}" if "e" in text else text


def duration(seconds):
    """Formats a time with its unit and two significant digits."""
    for limit, factor, unit in ((1e-3, 1e6, "us"), (0.1, 1e3, "ms")):
        if seconds < limit:
            return f"{digits(seconds * factor)} {unit}"
    return f"{digits(seconds)} s"


def table(heading, rows):
    """Formats a table of Markdown."""
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def machine(results):
    facts = results["machine"]
    day = date.fromisoformat(facts["date"])
    others = facts["other_processes"]
    load = ("Nothing else was running." if others < 0.15 else
            f"The machine was busy: {others} other processes were running on average, which lengthens processor "
            "times too.")  # fmt: skip
    text = (f"Measured on {day.day} {day:%B %Y}: {facts['processor']}, {facts['cores']} cores; {facts['system']}; "
            f"{facts['compiler']}; {facts['build']} build. {load}")  # fmt: skip
    return textwrap.fill(text, 120) + "\n"


def commands(results):
    found = results["measurements"]
    return table(["command", "processor time"], [
        [words, duration(found[name]["cpu_s"])]
        for name, words in (
            ("version", "`clast --version`"),
            ("show", "`clast show`, library of the seven sample blocks"),
            ("check", "`clast check`, sample campaign"),
            ("forms", "`clast vary --grid sneed-folk:10`, 66 forms of `B01_compact`"),
            ("draw", "`clast vary --draw 100 --from talus.csv`, of `B07_concave`"),
            ("cut", "`clast cut` of `B01_compact`, three joint sets 12 cm apart"),
            ("split", "`clast reconstruct --split` of the sample slope with 12 blocks"),
            ("campaign", "`clast simulate`, sample campaign"),
            ("mass", "`clast simulate`, sample mass of 60 blocks"),
            ("compare", "`clast compare` of the sample campaign, with its page"),
        )])  # fmt: skip


def releases(results):
    rows = []
    for cells, cuts, pinned in ((70, 2, 0), (70, 5, 0), (224, 5, 0), (2236, 5, 0), (70, 14, 0), (70, 5, 1),
                                (224, 5, 1)):  # fmt: skip
        found = results["measurements"][f"rock_on_a_rough_slope/cells:{cells}/cuts:{cuts}/pinned:{pinned}"]
        rows.append([f"{2 * cells * cells:,}", f"{10 * cuts * cuts + 2:,}", "1e8 N/m, 2e-5 s" if pinned else "auto",
                     duration(found["cpu_s_per_10_s"]), duration(found["s_per_step"])])  # fmt: skip
    return table(["slope, triangles", "vertices", "stiffness and step", "per 10 simulated s", "per step"], rows)


def study(results):
    rows = []
    for name, words in (("campaign-p1", "all four blocks, P1"), ("campaign-p2", "all four blocks, P2"),
                        ("flat-p2", "SP3A, P2")):  # fmt: skip
        found = results["measurements"].get(f"study/{name}")
        if found:
            rows.append([words, found["releases"], duration(found["cpu_s"]),
                         duration(found["cpu_s"] / found["releases"])])  # fmt: skip
    return table(["blocks and lane", "releases", "processor time", "per release"], rows)


def indexing(results):
    return table(["terrain, triangles", "processor time"], [
        [f"{2 * cells * cells:,}", duration(results["measurements"][f"loading_a_slope/cells:{cells}"]["cpu_s"])]
        for cells in (224, 2236)])  # fmt: skip


def terrain(results):
    rows = []
    for name, words in (("lidar_to_surface/18/-1", "18 million points"),
                        ("terrain_file_to_indexed_surface/2237", "terrain file")):  # fmt: skip
        found = results["measurements"][name]
        rows.append([words, f"{found['triangles']:,.0f}", duration(found["cpu_s"]),
                     f"{digits(found['peak_MiB'] / 1024.0)} GiB"])  # fmt: skip
    return table(["input", "triangles", "processor time", "peak memory"], rows)


def pile(results):
    rows = []
    for cuts in (1, 2, 5):
        found = results["measurements"][f"blocks_falling_into_a_pile/blocks:500/cuts:{cuts}/threads:1"]
        rows.append([10 * cuts * cuts + 2, duration(found["cpu_s"]), f"{found['touching_pairs']:.0f}",
                     f"{digits(found['kB_per_block'])} kB"])  # fmt: skip
    return table(["vertices", "25 simulated ms", "touching pairs", "memory per block"], rows)


def layers(results):
    rows = []
    for blocks in (500, 4000):
        found = results["measurements"][f"layers_falling_onto_a_plane/blocks:{blocks}"]
        rows.append([f"{blocks:,}", duration(found["s_per_body_and_step"]),
                     digits(found["touching_pairs_per_body"], 3),
                     duration(found["s_per_body_and_step"] / found["touching_pairs_per_body"])])  # fmt: skip
    return table(["blocks", "per body and step", "touching pairs per body", "per touching pair and step"], rows)


def beside(results):
    found = results["measurements"]
    return table(["what moves", "per step"], [
        ["one block alone",
         duration(found["block_beside_a_pile_at_rest/blocks:0"]["s_per_step"])],
        ["one block beside a pile of 500 at rest",
         duration(found["block_beside_a_pile_at_rest/blocks:500"]["s_per_step"])],
    ])  # fmt: skip


def solids(results):
    return table(["triangles", "processor time"], [
        [f"{2 * n * (n - 1):,}", duration(results["measurements"][f"solid_mass_properties_of_a_sphere/{n}"]["cpu_s"])]
        for n in (128, 256)])  # fmt: skip


def rounded(results):
    rows = []
    for cuts, grain, radius in ((5, 0, 40), (5, 20, 40), (5, 20, 100), (16, 10, 40), (35, 0, 40), (35, 10, 20),
                                (35, 10, 40), (35, 10, 100), (35, 30, 40)):  # fmt: skip
        found = results["measurements"][f"concave_rock/cuts:{cuts}/grain:{grain}/radius:{radius}/digits:4"]
        rows.append([f"rock, grain {grain} %", f"{found['vertices']:,.0f}", f"{0.3 * radius:g} mm",
                     duration(found["cpu_s"]), f"{found['stated_error']:.1e}"])  # fmt: skip
    for name, words, radius in (("stone14_2_percent", "eesd_stone14", 2), ("stone15_2_percent", "eesd_stone15", 2),
                                ("stone15_5_percent", "eesd_stone15", 5), ("rock_s02_2_percent", "eesd_S02", 2)):  # fmt: skip
        found = results["measurements"].get(f"real_scan/{name}")
        if found:
            rows.append([f"scan {words}", f"{found['vertices']:,.0f}", f"{radius} % of S", duration(found["cpu_s"]),
                         f"{found['stated_error']:.1e}"])  # fmt: skip
    return table(["core", "vertices", "radius", "processor time", "stated error"], rows)


def boxes(results):
    rows = []
    for corners in (256, 512, 1024, 2048, 4000):
        times = [results["measurements"][f"{box}/{corners}"]["cpu_s"] for box in ("smallest", "feret", "pca")]
        rows.append([f"{corners:,}", *map(duration, times)])
    return table(["corners of the hull", "`smallest`", "`feret`", "`pca`"], rows)


def classes(results):
    found = results["measurements"]
    report = found["whole_report/1000000"]
    return table(["a million rows of L, I, S", "processor time"], [
        ["every scheme and index, rows in memory", duration(found["every_class_and_index/1000000"]["cpu_s"])],
        ["the same, rows read from a table", duration(found["read_and_classify/1000000"]["cpu_s"])],
        ["`clast classify -o DIR`: statistics, tables, diagrams and page", duration(report["cpu_s"])],
    ])  # fmt: skip


def scans(results):
    rows = []
    for name, words in (("B01_compact.ply", "`B01_compact`, 2,000 triangles"),
                        ("B04_elongated.ply", "`B04_elongated`, 2,000 triangles"),
                        ("B07_concave.ply", "`B07_concave`, 2,000 triangles"),
                        ("eesd_stone14.stl", "eesd_stone14, 30,470 triangles"),
                        ("eesd_stone01.stl", "eesd_stone01, 42,666 triangles, porous"),
                        ("rockable_rock.stl", "rockable_rock, 24,236 triangles"),
                        ("cloud.xyz", "cloud of eesd_stone14, 20,000 points, noise 0.3 % of L")):  # fmt: skip
        found = results["measurements"].get(f"reconstruct/{name}")
        if found:
            rows.append([words, f"{found['vertices']:,}", f"{found['deviation']:.2f} % of L",
                         duration(found["cpu_s"])])  # fmt: skip
    return table(["scan", "vertices", "deviation", "processor time"], rows)


def repair(results):
    rows = []
    for frequency in (35, 70, 158):
        found = results["measurements"][f"repair/{frequency}"]
        rows.append([f"{found['triangles']:,.0f}", duration(found["cpu_s"]), f"{digits(found['peak_MiB'])} MiB"])
    return table(["triangles", "processor time", "peak memory"], rows)


TABLES = {one.__name__: one for one in (machine, commands, releases, study, indexing, terrain, pile, layers, beside,
                                        solids, rounded, boxes, classes, scans, repair)}  # fmt: skip


def with_tables(page, results):
    """Returns the text of a page with the tables of some results between its markers.

    Raises ValueError if the page has a marker without a table, or not every table once."""
    named = [name for _, name, _, _ in MARKED.findall(page)]
    if sorted(named) != sorted(TABLES):
        raise ValueError(f"the page has the tables {sorted(named)}; expected {sorted(TABLES)}, each once")
    return MARKED.sub(lambda found: f"{found[1]}\n{TABLES[found[2]](results)}\n{found[4]}", page)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, nargs="?", help="build folder; if left out, nothing is measured")
    parser.add_argument("--data", type=Path, help="data folder")
    arguments = parser.parse_args()
    if arguments.build:
        build = arguments.build.resolve()
        programs = [build / "app" / "clast", *(build / "benchmarks" / name / f"{name}_benchmark"
                                               for name, _, _ in speed_measurements.BENCHMARKS)]  # fmt: skip
        missing = [str(program) for program in programs if not program.exists()]
        if missing:
            sys.exit(f"{missing[0]}: not found; configure with -DCLAST_BENCHMARKS=ON and build")
        if arguments.data and not (arguments.data / "meshes").is_dir():
            sys.exit(f"{arguments.data / 'meshes'}: no such folder; --data names the data folder")
        results = speed_measurements.measure(build, arguments.data and arguments.data.resolve())
        RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    PAGE.write_text(with_tables(PAGE.read_text(encoding="utf-8"), results), encoding="utf-8")


if __name__ == "__main__":
    main()
