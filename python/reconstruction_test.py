import json

import clast
import numpy as np
import pytest
from conftest import SAMPLES, cube, program

SCAN = SAMPLES / "blocks" / "B06_cuboid.ply"


def numbers(block):
    shown = block.to_dict()
    for key in ("id", "source", "provenance"):
        shown.pop(key)
    return shown


def test_a_block_is_that_of_the_program_to_the_bit(tmp_path):
    mine = clast.reconstruct(SCAN, vertices=24, density=2700)
    program("reconstruct", SCAN, "-o", tmp_path / "b.h5", "--vertices", "24", "--density", "2700")
    other = clast.Library(tmp_path / "b.h5")["B06_cuboid"]
    assert numbers(mine) == numbers(other)
    assert np.array_equal(mine.core.vertices, other.core.vertices)


def test_a_mesh_in_memory_gives_the_block_of_its_file(tmp_path):
    vertices, triangles = cube(0.8)
    with open(tmp_path / "cube.off", "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        for x, y, z in vertices:
            file.write(f"{float(x)!r} {float(y)!r} {float(z)!r}\n")
        for a, b, c in triangles:
            file.write(f"3 {a} {b} {c}\n")
    from_file = clast.reconstruct(tmp_path / "cube.off", radius_share=0.02)
    in_memory = clast.reconstruct((vertices, triangles), "cube", radius_share=0.02)
    assert numbers(from_file) == numbers(in_memory)
    assert in_memory.mass == pytest.approx(0.8**3 * 2650.0, rel=0.01)
    scaled = clast.reconstruct((vertices * 1000, triangles), "cube", units="mm", radius_share=0.02)
    assert scaled.mass == pytest.approx(in_memory.mass, rel=1e-9)


def test_lengths_may_come_from_a_measured_one():
    vertices, triangles = cube(2.0)
    block = clast.reconstruct(
        (vertices, triangles), "cube", scale_length=([-1, -1, -1], [1, -1, -1], 0.5)
    )
    assert block.box_lengths == pytest.approx([0.5, 0.5, 0.5], rel=0.02)
    with pytest.raises(clast.InputError, match="scale_length"):
        clast.reconstruct((vertices, triangles), "c", scale_length=([0, 0, 0], [0, 0, 0], 0.5))
    with pytest.raises(clast.InputError, match="scale_length"):
        clast.reconstruct((vertices, triangles), "c", scale_length=([0, 0, 0], [1, 0, 0], -1.0))


def test_bad_scans_cost_a_batch_nothing(tmp_path):
    (tmp_path / "bad.ply").write_text("no mesh")
    steps = []
    made = clast.reconstruct_batch(
        [SCAN, tmp_path / "bad.ply"], tmp_path / "b.h5", vertices=24, report=tmp_path / "pages",
        progress=steps.append,
    )  # fmt: skip
    assert made.added == ["B06_cuboid"] and made.library.ids == ["B06_cuboid"]
    assert len(made.failed) == 1 and made.failed[0][0].endswith("bad.ply")
    assert (tmp_path / "pages" / "index.html").exists()
    assert (tmp_path / "pages" / "blocks" / "B06_cuboid.html").exists()
    again = clast.reconstruct_batch(SCAN, tmp_path / "b.h5", vertices=24, resume=True)
    assert again.added == [] and again.skipped == 1


@pytest.mark.parametrize(
    ("scan", "keywords", "error", "words"),
    [
        ("missing.ply", {}, clast.InputError, "missing.ply"),
        (SCAN, {"density": -1.0}, clast.InputError, "density"),
        (SCAN, {"density": float("nan")}, clast.InputError, "density"),
        (SCAN, {"density": "heavy"}, TypeError, "density"),
        (SCAN, {"units": "furlong"}, clast.InputError, "furlong"),
        (SCAN, {"vertices": 3}, clast.InputError, ""),
        (SCAN, {"ground": "sea"}, clast.InputError, "ground"),
        (SCAN, {"radius": 0.01, "radius_share": 0.1}, clast.InputError, "radius"),
        (SCAN, {"scale_factor": 0.0}, clast.InputError, "scale_factor"),
        (SCAN, {"densty": 2000.0}, TypeError, "densty"),
        ((np.zeros((3, 3)), [[0, 1, 2]]), {}, clast.InputError, "id"),
        ((np.zeros((3, 3)), [[0, 1, 2]]), {"id": "flat"}, clast.Error, ""),
        (np.zeros((2, 3)), {"id": "two"}, clast.Error, ""),
        (SAMPLES / "blocks", {}, clast.InputError, "7 scans"),
        ([SCAN], {"join": "B"}, clast.InputError, "two to eight"),
        ([SCAN, SCAN], {"join": "B"}, clast.InputError, "given twice"),
        ([SCAN, SCAN], {"join": "B", "id": "C"}, clast.InputError, "join"),
        ([SCAN, SCAN], {"join": "B", "split": True}, clast.InputError, ""),
        (SCAN, {"pose": {"top": (180, 0, 0)}}, clast.InputError, "join"),
    ],
)
def test_what_gives_no_block_is_refused(scan, keywords, error, words):
    with pytest.raises(error, match=words):
        clast.reconstruct(scan, **keywords)


def write_balls_on_a_floor(path):
    """Points of two balls with a radius of 0.5 m that lie apart on a floor."""
    noise = np.random.default_rng(1)
    turn = np.pi * (3.0 - np.sqrt(5.0)) * np.arange(1500)
    height = 1.0 - 2.0 * (np.arange(1500) + 0.5) / 1500
    across = np.sqrt(1.0 - height**2)
    ball = 0.5 * np.column_stack([across * np.cos(turn), across * np.sin(turn), height])
    floor = np.stack(np.meshgrid(*2 * [np.arange(-2.0, 2.0, 0.045)]), -1).reshape(-1, 2)
    floor = np.column_stack([floor, np.zeros(len(floor))])
    parts = []
    for x in (-0.9, 0.9):
        moved = ball + [x, 0.0, 0.4]
        parts.append(moved[moved[:, 2] > 0.15])
        floor = floor[np.hypot(floor[:, 0] - x, floor[:, 1]) > 0.4]
    points = np.concatenate([*parts, floor])
    np.savetxt(path, points + 0.002 * noise.standard_normal(points.shape), fmt="%.5f")


def test_edits_correct_the_blocks_of_a_deposit(tmp_path):
    def drop(point):
        edit = {"kind": "drop", "points": [point]}
        text = json.dumps({"format": "clast deposit edits", "edits": [edit]})
        (tmp_path / "edits.json").write_text(text)
        return tmp_path / "edits.json"

    scans = [tmp_path / "balls.xyz"]
    write_balls_on_a_floor(scans[0])
    both = clast.reconstruct_batch(scans, tmp_path / "a.h5", split=True)
    assert both.added == ["balls_1", "balls_2"]
    left = drop([-0.9, 0, 0.9])
    one = clast.reconstruct_batch(scans, tmp_path / "b.h5", split=True, edits=left)
    assert one.added == ["balls_1"]
    assert one.library["balls_1"].centre[0] == pytest.approx(0.9, abs=0.1)
    ground = drop([0, 1.5, 0])
    none = clast.reconstruct_batch(scans, tmp_path / "c.h5", split=True, edits=ground)
    assert none.added == [] and "edit 1 of 1 (drop at (0, 1.5, 0))" in none.failed[0][1]


def test_a_rock_mass_is_cut_into_the_blocks_of_the_program(tmp_path):
    vertices, triangles = cube(3.0)
    mass = tmp_path / "mass.off"
    rows = [" ".join(map(str, v)) for v in vertices] + [f"3 {a} {b} {c}" for a, b, c in triangles]
    mass.write_text(f"OFF\n8 12 0\n" + "\n".join(rows) + "\n")
    joints = ["0/0/1", "90/0/1", "90/90/1"]
    cut = clast.cut(mass, joints, tmp_path / "py.h5", seed=5)
    words = [word for joint in joints for word in ("-j", joint)]
    program("cut", mass, *words, "--seed", "5", "-o", tmp_path / "prog.h5")
    other = clast.Library(tmp_path / "prog.h5")
    assert [block.id for block in cut.blocks] == other.ids == clast.Library(tmp_path / "py.h5").ids
    assert all(a.volume == b.volume for a, b in zip(cut.blocks, other))
    assert cut.block_volume == pytest.approx(27.0, rel=0.05) and cut.volume == pytest.approx(27.0)
    with pytest.raises(clast.InputError):
        clast.cut(mass, "0/0")
    with pytest.raises(clast.InputError, match="missing"):
        clast.cut(tmp_path / "missing.off", joints)


def test_the_mass_between_two_terrains_is_that_of_the_program(tmp_path):
    for name, step in (("before", 2.0), ("after", 0.0)):
        heights = "".join(
            " ".join(str(step if 4 <= i < 8 and 4 <= j < 8 else 0.0) for i in range(12)) + "\n"
            for j in range(12)
        )
        head = "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
        (tmp_path / f"{name}.asc").write_text(head + heights)
    between = {side: tmp_path / f"{side}.asc" for side in ("before", "after")}
    uncut = clast.cut(**between, scar=tmp_path / "scar.ply", min_thickness=0)
    assert uncut.blocks == [] and (tmp_path / "scar.ply").exists()
    cut = clast.cut(joints="90/90/1", **between, min_thickness=0)
    assert cut.volume == pytest.approx(uncut.volume, rel=1e-9)
    words = [word for side, file in between.items() for word in (f"--{side}", file)]
    program("cut", *words, "--min-thickness", "0", "-j", "90/90/1", "-o", tmp_path / "prog.h5")
    other = clast.Library(tmp_path / "prog.h5")
    assert [(a.id, a.volume) for a in cut.blocks] == [(b.id, b.volume) for b in other]
    with pytest.raises(clast.InputError, match="both before and after"):
        clast.cut(joints="90/90/1", before=between["before"])


def test_twins_are_those_of_the_program(made, tmp_path):
    twins = clast.vary(made / "blocks.h5", "B04_elongated", tmp_path / "py.h5", to=[(0.8, 0.5)],
                       reference="ellipsoid")  # fmt: skip
    program("vary", made / "blocks.h5", "B04_elongated", "--to", "0.8,0.5", "--reference",
            "ellipsoid", "-o", tmp_path / "prog.h5")  # fmt: skip
    other = clast.Library(tmp_path / "prog.h5")
    assert clast.Library(tmp_path / "py.h5").ids == other.ids and len(other) == 2
    for twin in twins.blocks:
        assert np.array_equal(twin.core.vertices, other[twin.id].core.vertices)
    length, width, thickness = other["B04_elongated_il0.8_sl0.5"].box_lengths
    assert width / length == pytest.approx(0.8, rel=0.01)
    assert thickness / length == pytest.approx(0.5, rel=0.01)
    assert twins.failed == []
    for wrong in ({}, {"to": [(0.5, 0.8)]}, {"grid": ("round", 3)}, {"reference": "egg"}):
        with pytest.raises(clast.InputError):
            clast.vary(made / "blocks.h5", **wrong)
    with pytest.raises(TypeError, match="convexity"):
        clast.vary(made / "blocks.h5", convexity="much")
