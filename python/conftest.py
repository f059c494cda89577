"""What the tests of the module share."""

import os
import re
import subprocess
from pathlib import Path

import clast
import pytest

SOURCE = Path(__file__).resolve().parent.parent
SAMPLES = SOURCE / "samples"

# A campaign of three runs a block that ends in a moment.
CAMPAIGN = """
[blocks]
library = "blocks.h5"
select  = ["B01_compact", "B04_elongated"]

[terrain]
surface = ["{terrain}/quarry_blue.ply", "{terrain}/quarry_gray.ply", "{terrain}/quarry_red.ply"]
zones   = ["blue", "gray", "red"]

[ground.red]
energy_restitution = 0.01
friction = 0.70
rolling_friction = 0.18

[ground.blue]
energy_restitution = 0.01
friction = 0.70
rolling_friction = 0.35

[ground.gray]
energy_restitution = 0.01
friction = 0.30
rolling_friction = 0.00

[release]
points = [[2.3, 80.0, 209.5]]
orientations = {{ random = 3, seed = 4 }}

[[barrier]]
name = "EC21"
from = [16.25, 50.0]
to   = [16.25, 110.0]

[run]
max_time_s = 4
downslope = [1.0, 0.0]
"""


def program(*words, cwd=None, code=0):
    """Runs the program clast, and returns what it printed."""
    done = subprocess.run(
        [os.environ["CLAST_PROGRAM"], *map(str, words)], cwd=cwd, capture_output=True, text=True
    )
    assert done.returncode == code, done.stderr
    return done.stdout if code == 0 else done.stderr


def documented_keys(section="## Campaign (TOML)"):
    """Units of the keys of the tables of a file, from docs/formats.md."""
    text = (SOURCE / "docs" / "formats.md").read_text(encoding="utf-8")
    text = text[text.index(section) :]
    text = text[: text.index("\n## ", 5)]
    tables, name = {}, None
    for item in re.split(r"\n(?=- |#)", text):
        heading = re.match(r"#### \[+([a-z_.A-Z]+)\]+", item)
        keys = re.match(r"- (`[^`]+`(?:,\s+`[^`]+`)*)(?:\s+\(([^;)]*))?", item)
        if heading:
            name = heading[1].replace(".NAME", "")
            tables[name] = {}
        elif keys and name:
            unit = (keys[2] or "").strip()
            for key in re.findall(r"`([^`]+)`", keys[1]):
                is_unit = unit and unit != "required" and not unit.startswith("default")
                tables[name][key.split(".")[0]] = unit if is_unit else ""
    return tables


@pytest.fixture(scope="session")
def made(tmp_path_factory):
    """A folder with blocks.h5 of three light blocks, and campaign.toml."""
    folder = tmp_path_factory.mktemp("made")
    names = ["B01_compact", "B02_platy", "B04_elongated"]
    scans = [SAMPLES / "blocks" / f"{name}.ply" for name in names]
    clast.reconstruct_batch(scans, folder / "blocks.h5", vertices=40, density=2650.0)
    text = CAMPAIGN.format(terrain=SAMPLES / "terrain")
    (folder / "campaign.toml").write_text(text)
    return folder


@pytest.fixture(scope="session")
def library(made):
    return clast.Library(made / "blocks.h5")


@pytest.fixture(scope="session")
def block(library):
    return library["B04_elongated"]


def cube(side=1.0):
    """A cube about the origin: (vertices, triangles)."""
    import numpy as np

    h = side / 2
    vertices = np.array([[x, y, z] for x in (-h, h) for y in (-h, h) for z in (-h, h)])
    triangles = np.array(
        [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
         [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    )  # fmt: skip
    return vertices, triangles
