"""Processor times of the benchmarks and of commands of clast: the smallest of three runs."""

import json
import os
import platform
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from datetime import date
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]
RUNS = 3

# Program, filter of its benchmarks, counters that are kept.
BENCHMARKS = [
    ("dem", "rock_on_a_rough_slope", ["cpu_s_per_10_s", "s_per_step"]),
    ("dem", "loading_a_slope/cells:(224|2236)", []),
    ("dem", "blocks_falling_into_a_pile/.*threads:1", ["kB_per_block", "touching_pairs"]),
    ("dem", "layers_falling_onto_a_plane", ["s_per_body_and_step", "touching_pairs_per_body"]),
    ("dem", "block_beside_a_pile_at_rest", ["s_per_step"]),
    ("massprops", "solid_mass_properties_of_a_sphere/(128|256)", []),
    ("massprops", "concave_rock.*digits:4", ["vertices", "stated_error"]),
    ("massprops", "real_scan", ["vertices", "stated_error"]),
    ("shapes", "(smallest|feret|pca)/(256|512|1024|2048|4000)", []),
    ("classify", "every_class_and_index/1000000", []),
    ("classify", "(read_and_classify|whole_report)/1000000", []),
    ("reconstruct", "repair", ["triangles", "peak_MiB"]),
    ("terrain", "lidar_to_surface/18/-1", ["triangles", "peak_MiB"]),
    ("terrain", "terrain_file_to_indexed_surface/2237", ["triangles", "peak_MiB"]),
]
# Scans that are made into blocks: of the samples, and of the data folder.
SAMPLE_SCANS = ["B01_compact.ply", "B04_elongated.ply", "B07_concave.ply"]
DATA_SCANS = ["eesd_stone01.stl", "rockable_rock.stl", "eesd_stone14.stl"]
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# Numbers of processes that computed between measurements, this script left out.
_others = []


def count_other_processes():
    """Samples the number of other processes that compute, between two measurements."""
    running = int(Path("/proc/loadavg").read_text().split()[3].split("/")[0])
    _others.append(running - 1)


def run(command, folder, environment=None):
    """Runs a command and returns its output and processor time in s, with that of its children."""
    count_other_processes()
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=output, stderr=output,
                                   env={**os.environ, **(environment or {})})  # fmt: skip
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read()
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {process.returncode}\n{said}")
    return said, usage.ru_utime + usage.ru_stime


def fastest(command, folder, environment=None):
    """Runs a command several times and returns its output and smallest processor time."""
    runs = [run(command, folder, environment) for _ in range(RUNS)]
    return runs[0][0], min(time for _, time in runs)


def measure_benchmarks(build, data):
    """Returns the fastest repetition of each benchmark, by its name."""
    found = {}
    for program, chosen, counters in BENCHMARKS:
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "out.json"
            run([build / "benchmarks" / program / f"{program}_benchmark", f"--benchmark_filter=^{chosen}",
                 f"--benchmark_repetitions={RUNS}", f"--benchmark_out={output}"],
                folder, {"CLAST_DATA": str(data)} if data else None)  # fmt: skip
            results = json.loads(output.read_text())["benchmarks"]
        for result in results:
            if result.get("run_type") != "iteration" or result.get("error_occurred"):
                continue
            name = re.sub(r"/(iterations:\d+|process_time|real_time|repeats:\d+)", "", result["name"])
            time = result["cpu_time"] * SECONDS[result["time_unit"]]
            if name not in found or time < found[name]["cpu_s"]:
                found[name] = {"cpu_s": time, **{counter: result[counter] for counter in counters if counter in result}}
    return found


def read_stl(path):
    """Returns the corners of the triangles of a binary STL file."""
    content = path.read_bytes()
    count = struct.unpack_from("<I", content, 80)[0]
    numbers = (struct.unpack_from("<9f", content, 84 + 50 * i + 12) for i in range(count))
    return [(values[0:3], values[3:6], values[6:9]) for values in numbers]


def write_noisy_cloud(stl, target, count, noise):
    """Writes points that are drawn evenly on a surface, with normal noise, as text."""
    triangles = read_stl(stl)
    draw = random.Random(14)

    def doubled_area(triangle):
        a, b, c = triangle
        u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        return sum(value * value for value in cross) ** 0.5

    corners = [corner for triangle in triangles for corner in triangle]
    length = max(max(c[k] for c in corners) - min(c[k] for c in corners) for k in range(3))
    chosen = draw.choices(triangles, [doubled_area(triangle) for triangle in triangles], k=count)
    with open(target, "w", encoding="ascii") as file:
        for a, b, c in chosen:
            s, t = draw.random(), draw.random()
            if s + t > 1.0:
                s, t = 1.0 - s, 1.0 - t
            point = [a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]) + draw.gauss(0.0, noise * length)
                     for k in range(3)]  # fmt: skip
            file.write(" ".join(f"{value:.4f}" for value in point) + "\n")


def measure_scans(clast, folder, data):
    """Makes blocks of the sample scans and of scans of the data folder; states vertices and deviation."""
    scans = {name: SOURCE / "samples" / "blocks" / name for name in SAMPLE_SCANS}
    if data:
        scans |= {name: data / "meshes" / name for name in DATA_SCANS}
        scans["cloud.xyz"] = folder / "cloud.xyz"
        write_noisy_cloud(data / "meshes" / "eesd_stone14.stl", scans["cloud.xyz"], 20_000, 0.003)
    found = {}
    for name, path in scans.items():
        target = folder / "block.h5"
        said, time = fastest([clast, "reconstruct", path, "-o", target, "--any-size", "--replace"], folder)
        vertices = re.search(r"(\d[\d,]*) vertices", said)[1].replace(",", "")
        deviation = re.search(r"\(([\d.]+) % of L\)", said)[1]
        found[f"reconstruct/{name}"] = {"cpu_s": time, "vertices": int(vertices), "deviation": float(deviation)}
    return found


def measure_commands(clast, folder):
    """Times the commands of the samples."""
    samples = folder / "samples"
    shutil.copytree(SOURCE / "samples", samples)
    blocks = folder / "out" / "blocks.h5"
    blocks.parent.mkdir()
    run([clast, "reconstruct", *sorted((samples / "blocks").glob("B*.ply")), "-o", blocks], folder)
    out = folder / "out"
    commands = {
        "version": ["--version"],
        "show": ["show", blocks],
        "check": ["check", samples / "campaign.toml"],
        "forms": ["vary", blocks, "B01_compact", "--grid", "sneed-folk:10", "-o", out / "forms.h5", "--replace"],
        "draw": ["vary", blocks, "B07_concave", "--draw", "100", "--from", samples / "talus.csv", "-o", out / "drawn.h5", "--replace"],
        "cut": ["cut", samples / "blocks" / "B01_compact.ply", "-j", "65/095/0.12/0.03", "-j", "80/190/0.12", "-j",
                "20/310/0.12", "-o", out / "cut.h5", "--replace"],
        "split": ["reconstruct", samples / "deposit" / "slope.ply", "-o", out / "slope.h5", "--split", "--smallest",
                  "0.2", "--replace"],
        "campaign": ["simulate", samples / "campaign.toml", "-o", out / "results.h5", "--replace"],
        "compare": ["compare", out / "results.h5", "-o", out / "report", "--replace"],
        "mass": ["simulate", samples / "mass.toml", "-o", out / "mass.h5", "--replace", "--threads", "1"],
    }  # fmt: skip
    return {name: {"cpu_s": fastest([clast, *command], folder)[1]} for name, command in commands.items()}


def measure_study(clast, folder, data):
    """Times every 16th release of the published study, and every 8th of its flattest block."""
    blocks = folder / "out" / "authume.h5"
    for name, radius, mass in (("SP1A", 0.027, 343.5), ("SP2A", 0.049, 1472.5), ("SP2B", 0.006, 1767.5),
                               ("SP3A", 0.005, 514.0)):  # fmt: skip
        run([clast, "reconstruct", data / "authume" / "blocks" / f"{name}.stl", "-o", blocks, "--core", "--radius",
             radius, "--mass", mass], folder)  # fmt: skip
    campaigns = folder / "samples" / "authume"
    text = (campaigns / "campaign-p2.toml").read_text()
    flat, count = re.subn(r"^select *=.*$", 'select = ["SP3A"]', text, flags=re.M)
    if count != 1:
        sys.exit(f"{campaigns / 'campaign-p2.toml'}: {count} lines select blocks; expected 1")
    (campaigns / "flat-p2.toml").write_text(flat)
    found = {}
    for name, parts in (("campaign-p1", 16), ("campaign-p2", 16), ("flat-p2", 8)):
        said, time = fastest([clast, "simulate", campaigns / f"{name}.toml", "-o", folder / "out" / f"{name}.h5",
                              "--shard", f"1/{parts}", "--replace"], folder, {"CLAST_DATA": str(data)})  # fmt: skip
        found[f"study/{name}"] = {"cpu_s": time, "releases": int(re.search(r"(\d+) runs", said)[1]) // parts}
    return found


def describe_machine(build):
    """Returns what the times depend on: processor, system, compiler and other load."""
    cpu = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())[1]
    release = re.search(r'PRETTY_NAME="?([^"\n]*)', Path("/etc/os-release").read_text())[1]
    cache = (build / "CMakeCache.txt").read_text()
    compiler = re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", cache)[1]
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    return {
        "date": date.today().isoformat(),
        "processor": cpu,
        "cores": os.cpu_count(),
        "system": f"{release}, {platform.machine()}",
        "compiler": version.splitlines()[0],
        "build": re.search(r"CMAKE_BUILD_TYPE:\w+=(.*)", cache)[1],
        "commit": subprocess.run(["git", "describe", "--always", "--dirty"], cwd=SOURCE, capture_output=True, text=True,
                                 check=True).stdout.strip(),
        "other_processes": round(sum(_others) / len(_others), 1),
    }


def measure(build, data):
    """Returns machine and measurements; `data` is the data folder or None."""
    clast = build / "app" / "clast"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        measurements = {**measure_scans(clast, folder, data), **measure_commands(clast, folder)}
        if data:
            measurements |= measure_study(clast, folder, data)
    measurements |= measure_benchmarks(build, data)
    rounded = {name: {key: int(value) if value == int(value) else float(f"{value:.4g}")
                      for key, value in found.items()} for name, found in measurements.items()}  # fmt: skip
    return {"machine": describe_machine(build), "measurements": rounded}
