"""The commands in the pages run, block by block, in a scratch folder with the samples.

In a page, HTML comments, which readers do not see, say what a block needs:

    <!-- prepare: COMMANDS -->   run before the blocks that follow, as if they stood there
    <!-- file: NAME -->          the block below is written to this file
    <!-- not run: REASON -->     the block below can't run here

The folder `inputs` holds what readers bring: scans in millimetres, a raster, a table of stops, ...
"""

import os
import re
import shutil
import struct
import subprocess
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
PAGES = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted((SOURCE / "docs").rglob("*.md")),
         *sorted((SOURCE / "samples").rglob("*.md"))]  # fmt: skip
# Blocks that are not run: raised only with a good reason.
NOT_RUN = 21
STEP = re.compile(r"^<!-- *(prepare|file|not run): *(.*?) *-->$|^```(\w*)\n(.*?)^```$", re.S | re.M)


def steps(page):
    """What is done for a page, in order: ("run", code), ("file", (name, text)), ("not run", (reason, code))."""
    found, mark = [], None
    for kind, said, language, code in STEP.findall(page.read_text(encoding="utf-8")):
        if kind == "prepare":
            found.append(("run", said))
        elif kind:
            assert mark is None, f"{page}: a block must follow {mark}"
            mark = (kind, said)
        elif mark and mark[0] == "file":
            found.append(("file", (mark[1], code)))
            mark = None
        elif mark:
            found.append(("not run", (mark[1], code)))
            mark = None
        elif language in ("sh", "bash", "console"):
            found.append(("run", code))
    assert mark is None, f"{page}: a block must follow {mark}"
    return found


def name_of(page):
    return page.relative_to(SOURCE).as_posix()


def run(code, folder, environment):
    return subprocess.run(["bash", "-euo", "pipefail", "-c", code], cwd=folder, env=environment,
                          capture_output=True, text=True)  # fmt: skip


@pytest.fixture(scope="session")
def environment(tmp_path_factory):
    program = os.environ.get("CLAST_PROGRAM")
    if not program:
        pytest.skip("CLAST_PROGRAM names no program")
    return {"PATH": f"{Path(program).parent}:/usr/bin:/bin", "LC_ALL": "C.UTF-8",
            "HOME": str(tmp_path_factory.mktemp("home")), "TMPDIR": str(tmp_path_factory.mktemp("tmp"))}  # fmt: skip


def write_box(path, x, y, z):
    """A closed mesh, such as a failed rock mass."""
    corners = [(a, b, c) for a in (0, x) for b in (0, y) for c in (0, z)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    lines = ["ply", "format ascii 1.0", "element vertex 8", "property double x", "property double y",
             "property double z", "element face 6", "property list uchar int vertex_indices", "end_header",
             *(f"{a} {b} {c}" for a, b, c in corners), *("4 " + " ".join(map(str, f)) for f in faces)]  # fmt: skip
    path.write_text("\n".join(lines) + "\n")


def write_sides(scan, top, bottom):
    """Open meshes of the upper and the lower three quarters of a scan, the lower one turned over."""
    head, body = scan.read_bytes().split(b"end_header\n", 1)
    vertices, triangles = (int(line.split()[-1]) for line in head.decode().splitlines()
                           if line.startswith("element"))  # fmt: skip
    points = [struct.unpack_from("<3f", body, 12 * i) for i in range(vertices)]
    faces = [struct.unpack_from("<3I", body, 12 * vertices + 13 * i + 1) for i in range(triangles)]
    low, high = min(p[2] for p in points), max(p[2] for p in points)
    for path, turn, limit in ((top, 1, 0.75 * low + 0.25 * high), (bottom, -1, -0.25 * low - 0.75 * high)):
        kept = [face for face in faces if all(turn * points[v][2] > limit for v in face)]
        lines = ["ply", "format ascii 1.0", f"element vertex {vertices}", "property double x",
                 "property double y", "property double z", f"element face {len(kept)}",
                 "property list uchar int vertex_indices", "end_header",
                 *(f"{x:.9g} {turn * y:.9g} {turn * z:.9g}" for x, y, z in points),
                 *(f"3 {a} {b} {c}" for a, b, c in kept)]  # fmt: skip
        path.write_text("\n".join(lines) + "\n")


def write_slope(path, nose=0.0):
    """A slope of 40 degrees above a flat, with a rounded nose of this height, as an ESRI grid with
    cells of 1 m."""
    rows = [" ".join(f"{max(0.0, 45 - column) * 0.84 + 0.05 * ((row * 7 + column * 3) % 5) + max(0.0, nose * (1 - ((column - 15) ** 2 + (row - 30) ** 2) / 64)):.2f}"
                     for column in range(90)) for row in range(60)]  # fmt: skip
    path.write_text("ncols 90\nnrows 60\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + "\n".join(rows) + "\n")


@pytest.fixture(scope="session")
def inputs(environment, tmp_path_factory):
    """What readers bring."""
    folder = tmp_path_factory.mktemp("inputs")
    (folder / "samples").symlink_to(SOURCE / "samples")
    made = run("""
        clast reconstruct samples/blocks/B0[147]_*.ply -o blocks.h5 --vertices 60 --jobs 2
        clast export blocks.h5 -o shapes --format obj
        clast terrain samples/terrain/quarry_*.ply --zones blue,gray,red -o quarry.h5 --export dem.tif
        """, folder, environment)  # fmt: skip
    assert made.returncode == 0, made.stderr
    (folder / "scans").mkdir()
    for mesh in (folder / "shapes").glob("*.obj"):
        lines = [
            "v " + " ".join(f"{1000 * float(number):.9g}" for number in line.split()[1:4])
            if line.startswith("v ") else line
            for line in mesh.read_text().splitlines()
        ]  # fmt: skip
        (folder / "scans" / mesh.name).write_text("\n".join(lines) + "\n")
    write_box(folder / "scar.ply", 6, 4, 5)
    write_sides(SOURCE / "samples/blocks/B04_elongated.ply", folder / "B017_top.ply", folder / "B017_bottom.ply")
    write_slope(folder / "quarry.asc")
    write_slope(folder / "before.asc", 4.0)
    (folder / "stops.csv").write_text("x,y\n31,80\n38,83\n42,79\n55,84\n47,76\n")
    rings = {"rock": "[[-90,-90],[16,-90],[16,190],[-90,190],[-90,-90]]",
             "scree": "[[16,-90],[190,-90],[190,190],[16,190],[16,-90]]"}  # fmt: skip
    zones = ",".join(f'{{"type":"Feature","properties":{{"zone":"{zone}"}},"geometry":'
                     f'{{"type":"Polygon","coordinates":[{ring}]}}}}' for zone, ring in rings.items())  # fmt: skip
    (folder / "zones.geojson").write_text(f'{{"type":"FeatureCollection","features":[{zones}]}}')
    return folder


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_the_commands_of_a_page_run(page, tmp_path, environment, inputs):
    todo = steps(page)
    if not any(kind == "run" for kind, _ in todo):
        pytest.skip("no commands to run")
    shutil.copytree(SOURCE / "samples", tmp_path / "samples")
    (tmp_path / "inputs").symlink_to(inputs)
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "release").symlink_to(Path(os.environ["CLAST_PROGRAM"]).parents[1])
    for kind, what in todo:
        if kind == "file":
            (tmp_path / what[0]).write_text(what[1], encoding="utf-8")
        elif kind == "run":
            done = run(what, tmp_path, environment)
            assert done.returncode == 0, f"{name_of(page)}:\n{what}\n{done.stdout[-2000:]}{done.stderr[-3000:]}"


def test_blocks_that_are_not_run_are_counted_and_say_why(capsys):
    left_out = [(name_of(page), what) for page in PAGES for kind, what in steps(page) if kind == "not run"]
    with capsys.disabled():
        for page, (reason, code) in left_out:
            print(f"\nnot run: {page}: {code.strip().splitlines()[0]}: {reason}", end="")
    assert all(len(reason) >= 10 for _, (reason, _) in left_out)
    assert len(left_out) == NOT_RUN


def test_a_page_whose_command_fails_is_found(tmp_path, environment):
    page = tmp_path / "page.md"
    page.write_text("```sh\nclast no-such-command\n```\n")
    [(kind, code)] = steps(page)
    assert kind == "run" and run(code, tmp_path, environment).returncode != 0
    page.write_text("<!-- not run: needs a camera -->\n```sh\nfalse\n```\n```toml\na = 1\n```\n")
    assert steps(page) == [("not run", ("needs a camera", "false\n"))]
    page.write_text("<!-- not run: needs a camera -->\n")
    with pytest.raises(AssertionError):
        steps(page)
