import gc
import json
import resource
import sys

import clast
import numpy as np
import pytest
from conftest import cube, program


def test_a_block_has_the_numbers_of_the_program(made, block):
    shown = json.loads(program("show", made / "blocks.h5", "B04_elongated", "--json"))[0]
    assert block.to_dict() == shown
    assert block.mass == shown["mass_kg"]
    assert block.volume == shown["volume_m3"]
    assert block.inertia.tolist() == shown["inertia_kg_m2"]
    assert block.box_lengths.tolist() == shown["box_m"]
    assert block.principal_moments.tolist() == shown["principal_moments_kg_m2"]
    assert block.indices == shown["indices"]
    assert block.classes["sneed_folk"].name == shown["sneed_folk"]


def test_classes_have_the_certainty_of_the_program(made, block):
    printed = json.loads(program("classify", made / "blocks.h5", "--json", "--scheme", "all"))
    shown = next(one for one in printed["blocks"] if one["id"] == "B04_elongated")
    for scheme, found in block.classes.items():
        expected = shown["classes"][scheme.replace("_", "-")]
        assert found.name == expected["class"]
        assert found.survives == expected["survives"]
        assert found.others == expected["others"]
        assert found.limit == expected["nearest_limit"]


def test_the_inertia_turns_to_its_principal_moments(block):
    axes = block.principal_axes
    turned = axes.T @ block.inertia @ axes
    assert np.allclose(turned, np.diag(block.principal_moments), rtol=1e-9, atol=1e-9)


def test_the_core_is_a_view_that_outlives_its_block(library):
    vertices = clast.Library(library.path)["B01_compact"].core.vertices
    faces = clast.Library(library.path)["B01_compact"].core.faces
    gc.collect()
    assert vertices.shape[1] == 3 and vertices.base is not None
    assert not vertices.flags.writeable
    with pytest.raises(ValueError):
        vertices[0, 0] = 1.0
    used = np.unique(np.concatenate(faces))
    assert used.tolist() == list(range(len(vertices)))


def test_the_skin_bounds_the_volume_of_the_block(block):
    vertices, triangles = block.skin(segments=16)
    solid = clast.mass_properties(vertices, triangles, density=block.density)
    assert solid["volume_m3"] == pytest.approx(block.volume, rel=1e-3)
    assert np.allclose(solid["centre_m"], block.centre, atol=1e-3 * block.box_lengths[0])


def test_the_mass_of_a_cube_is_exact_for_every_kind_of_array():
    vertices, triangles = cube(2.0)
    expected = np.eye(3) * 8 * 1000.0 * 4 / 6  # m a^2 / 6
    for index in (np.int32, np.uint32, np.int64, np.uint64, np.uint8):
        for number in (np.float64, np.float32, np.int64):
            for order in ("C", "F"):
                found = clast.mass_properties(
                    np.array(vertices, dtype=number, order=order),
                    np.array(triangles, dtype=index, order=order),
                    density=1000.0,
                )
                assert found["mass_kg"] == pytest.approx(8000.0)
                assert np.allclose(found["inertia_kg_m2"], expected)


def test_a_million_vertices_pass_in_without_a_copy_in_python():
    side = 1000
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(side * side)], axis=1)
    corner = np.arange(side * side).reshape(side, side)
    a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]
    triangles = np.concatenate(
        [np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))]
    ).astype(np.int32)
    import tracemalloc

    tracemalloc.start()
    with pytest.raises(clast.GeometryError, match="bounds no solid"):
        clast.mass_properties(vertices, triangles)  # a sheet, which bounds nothing
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 1e6  # bytes; NumPy reports what it allocates, the arrays have 48 MB


@pytest.mark.parametrize(
    ("vertices", "triangles", "error", "words"),
    [
        (np.zeros((4, 2)), [[0, 1, 2]], clast.InputError, r"vertices: has the shape \(4, 2\)"),
        (np.zeros(3), [[0, 1, 2]], clast.InputError, r"vertices: has the shape \(3,\)"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], clast.InputError, "row 0 is not finite"),
        (np.zeros((3, 3)), [[0, 1, 3]], clast.InputError, "index 3, but there are 3 vertices"),
        (np.zeros((3, 3)), [[0, 1, -1]], clast.InputError, "index -1"),
        (np.zeros((3, 3)), [[0.0, 1.0, 2.0]], TypeError, "whole numbers"),
        ("no array", [[0, 1, 2]], TypeError, "vertices: must be an array of numbers"),
        (None, [[0, 1, 2]], TypeError, "vertices"),
        (np.zeros((3, 3)), np.zeros((0, 3), int), clast.GeometryError, ""),
    ],
)
def test_what_is_no_mesh_is_refused(vertices, triangles, error, words):
    with pytest.raises(error, match=words):
        clast.mass_properties(vertices, triangles)


def test_a_density_that_is_none_is_refused():
    for density in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(clast.InputError, match="density"):
            clast.mass_properties(*cube(), density=density)
    with pytest.raises(TypeError):
        clast.mass_properties(*cube(), density="heavy")


def test_shape_classes_of_axes_are_those_of_their_authors():
    classes = clast.shape_classes(3.0, 2.0, 1.0, axis_error=0.0)
    assert classes["zingg"].name == "blade" or classes["zingg"].name  # 2/3 and 1/2
    assert classes["garcia"].name == "elongated"  # s_c = 0.5 > 0.3
    assert classes["en_933_4"].name == "cubical"  # L/S = 3 is not above 3
    assert clast.shape_classes(1.0, 3.0, 2.0, axis_error=0.0)["garcia"].name == "elongated"
    with pytest.raises(clast.InputError):
        clast.shape_classes(0.0, 1.0, 1.0)
    with pytest.raises(TypeError, match="axis_errors"):
        clast.shape_classes(3.0, 2.0, 1.0, axis_errors=0.0)
    with pytest.raises(TypeError, match="axis_error"):
        clast.shape_classes(3.0, 2.0, 1.0, axis_error="wide")


def test_a_block_classifies_by_other_boxes_and_limits(block):
    assert set(block.classify()) == set(block.classes)
    with pytest.raises(clast.InputError, match="round"):
        block.classify(box="round")
    wide = block.classify(axis_error=0.5 * float(block.box_lengths[2]))
    assert not wide["sneed_folk"].survives


def test_a_block_is_a_picture_in_a_notebook(block):
    png = block._repr_png_()
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert int.from_bytes(png[16:20], "big") == 320
    with pytest.raises(clast.InputError):
        block.picture(width=0)
    assert "B04_elongated" in repr(block)


def rss():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024  # bytes


def calls_without_leak(block, count):
    for _ in range(count // 10):
        block.classes  # noqa: B018
    before = rss()
    for _ in range(count):
        block.classes  # noqa: B018
    return rss() - before


def test_classes_do_not_leak(block):
    count = int(__import__("os").environ.get("CLAST_LEAK_CALLS", "5000"))
    assert calls_without_leak(block, count) < 4e6
    assert sys.getrefcount(block) < 10


def test_roundness_is_that_of_a_block_with_corners(block):
    edge = 0.05 * float(block.box_lengths[0])
    assert 0.0 < block.roundness(edge) < 1.0
    with pytest.raises((clast.InputError, clast.GeometryError)):
        block.roundness(float("nan"))
