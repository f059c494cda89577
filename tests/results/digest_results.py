#!/usr/bin/env python3
"""Writes a digest of every result of clast, to show that a change of the sources changes none.

    tests/results/digest_results.py PROGRAM FOLDER [--quick]

runs the sample campaigns, scans and terrains with PROGRAM in FOLDER, which must not exist, and
writes FOLDER/digests.txt: a line for each dataset and attribute of HDF5 files, each column of text
tables, each table of GeoPackages, and each raster and mesh. Two of these lists are
compared with `diff`. Pages are left out, and so is what differs from run to run: the version of the
program, dates and paths. --quick takes about two minutes and leaves out the published data, which
is read from CLAST_DATA (default ../shared/data). Needs python3-h5py-serial (Debian).
"""
import argparse
import csv
import hashlib
import json
import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import h5py
import numpy

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("CLAST_DATA", ROOT / "../shared/data")).resolve()
SCANS = ["eesd_S02.stl", "eesd_stone14.stl", "eesd_stone15.stl", "eesd_test_stone.stl",
         "ibois_stone_0.ply", "chrono_curiosity_rock1.obj", "chrono_offroad_rock4.obj",
         "eesd_iphone_lidar.stl"]
# Radii and masses of the published blocks, samples/authume/README.md.
AUTHUME_BLOCKS = {"SP1A": ("0.027", "343.5"), "SP2A": ("0.049", "1472.5"),
                  "SP2B": ("0.006", "1767.5"), "SP3A": ("0.005", "514.0")}
# Attributes and JSON keys that hold versions, dates, paths or digests of them.
VOLATILE = {"program", "program_version", "version", "created", "written", "date", "host", "path",
            "file", "command", "sha256", "digest", "physics_digest", "elapsed_s", "cpu_s",
            "wall_s", "checksum", "source", "commit"}


def short(content):
    return hashlib.sha256(content).hexdigest()[:16]


def is_volatile(name):
    return name in VOLATILE or any(name.endswith("_" + each) for each in VOLATILE)


def bytes_of(value):
    array = numpy.asarray(value)
    if array.dtype.hasobject or array.dtype.kind in "OSU":
        return repr(array.tolist()).encode()
    return str(array.dtype).encode() + array.tobytes()


def digests_of_hdf5(path):
    lines = []

    def visit(name, item):
        if isinstance(item, h5py.Dataset):
            if item.dtype.names:  # one line for each member of a record
                for member in item.dtype.names:
                    lines.append((f"{name}.{member}", short(bytes_of(item[member]))))
            else:
                lines.append((name, short(bytes_of(item[()]))))
        for key, value in sorted(item.attrs.items()):
            if not is_volatile(key):
                lines.append((f"{name}@{key}", short(bytes_of(value))))

    with h5py.File(path, "r") as file:
        visit("/", file)
        file.visititems(visit)
    return lines


def digests_of_table(path):
    rows = list(csv.reader(path.read_text().splitlines()))
    if not rows:
        return [("", short(b""))]
    return [(name, short("\n".join(row[i] if i < len(row) else "" for row in rows[1:]).encode()))
            for i, name in enumerate(rows[0]) if not is_volatile(name)]


def digests_of_geopackage(path):
    lines = []
    with sqlite3.connect(path) as database:
        names = [row[0] for row in database.execute(
            "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")]
        for name in names:
            columns = [row[1] for row in database.execute(f'PRAGMA table_info("{name}")')
                       if row[1] != "last_change"]
            chosen = ", ".join(f'"{column}"' for column in columns)
            rows = database.execute(f'SELECT {chosen} FROM "{name}"').fetchall()
            lines.append((name, short(repr(rows).encode())))
    return lines


def stable(value):
    """JSON without what differs from run to run."""
    if isinstance(value, dict):
        return {key: stable(each) for key, each in value.items() if not is_volatile(key)}
    if isinstance(value, list):
        return [stable(each) for each in value]
    return value


def digests_of_json(path):
    value = stable(json.loads(path.read_text()))
    if not isinstance(value, dict):
        return [("", short(json.dumps(value, sort_keys=True).encode()))]
    return [(key, short(json.dumps(each, sort_keys=True).encode()))
            for key, each in sorted(value.items())]


READERS = {".h5": digests_of_hdf5, ".csv": digests_of_table, ".gpkg": digests_of_geopackage,
           ".json": digests_of_json}
LEFT_OUT = {".html", ".svg", ".toml", ".qml", ".md", ".log"}


def write_digests(folder):
    lines = []
    for path in sorted(folder.rglob("*")):
        if not path.is_file() or path.suffix in LEFT_OUT or path.name == "digests.txt":
            continue
        read = READERS.get(path.suffix, lambda file: [("", short(file.read_bytes()))])
        for name, digest in read(path):
            lines.append(f"{path.relative_to(folder)} {name} {digest}\n")
    (folder / "digests.txt").write_text("".join(lines))
    return len(lines)


class Runs:
    """Commands of clast that write into one folder."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, *words, output=None):
        done = subprocess.run([self.program, *map(str, words)], cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        if done.returncode != 0:
            sys.exit(f"error: clast {' '.join(map(str, words))}: {done.stderr}")
        if output:
            (self.folder / output).write_text(done.stdout)

    def campaign(self, name, text, edits):
        """Simulates and compares a campaign with replacements in its text."""
        for old, new in edits:
            if old not in text:
                sys.exit(f"error: campaign {name} does not hold {old!r}")
            text = text.replace(old, new)
        (self.folder / f"{name}.toml").write_text(text)
        self.run("simulate", f"{name}.toml", "-o", f"{name}.h5")
        self.run("compare", f"{name}.h5", "-o", name)


def run_samples(runs):
    samples = ROOT / "samples"
    runs.run("reconstruct", *sorted((samples / "blocks").glob("B*.ply")), "-o", "blocks.h5")
    runs.run("show", "blocks.h5", "--json", output="blocks.json")
    runs.run("classify", samples / "talus.csv", "--against", "blocks.h5", "-o", "classes")
    for format_ in ["shp", "obj", "ply", "stl", "glb", "vtp"]:
        runs.run("export", "blocks.h5", "--format", format_, "-o", f"export/{format_}")
    here = [("../out/blocks.h5", "blocks.h5"), ('"terrain/', f'"{samples}/terrain/')]
    runs.campaign("results", (samples / "campaign.toml").read_text(), here)
    runs.campaign("mass", (samples / "mass.toml").read_text(),
                  here + [("max_time_s = 60", "max_time_s = 1")])
    ground = [samples / "terrain" / f"quarry_{zone}.ply" for zone in ["blue", "gray", "red"]]
    runs.run("terrain", *ground, "--zones", "blue,gray,red", "-o", "quarry.h5")


def run_published(runs):
    for scan in SCANS:
        name = Path(scan).stem
        runs.run("reconstruct", DATA / "meshes" / scan, "-o", f"{name}.h5", "--any-size")
        runs.run("show", f"{name}.h5", "--json", output=f"{name}.json")
    for block, (radius, mass) in AUTHUME_BLOCKS.items():
        runs.run("reconstruct", DATA / "authume/blocks" / f"{block}.stl", "-o", "authume.h5",
                 "--core", "--radius", radius, "--mass", mass)
    turns = (DATA / "authume/drop/orientations.txt").read_text().splitlines(keepends=True)
    (runs.folder / "orientations.txt").write_text("".join(turns[:9]))
    for profile in ["p1", "p2"]:
        text = (ROOT / f"samples/authume/campaign-{profile}.toml").read_text()
        runs.campaign(f"authume-{profile}", text,
                      [("../../out/authume.h5", "authume.h5"),
                       ("${CLAST_DATA}/authume/drop/orientations.txt", "orientations.txt"),
                       ("${CLAST_DATA}", str(DATA))])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True)
    runs = Runs(options.program.resolve(), options.folder.resolve())
    run_samples(runs)
    if not options.quick:
        run_published(runs)
    print(f"{write_digests(runs.folder)} digests in {options.folder / 'digests.txt'}")


if __name__ == "__main__":
    main()
