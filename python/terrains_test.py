import clast
import numpy as np
import pytest
from conftest import SAMPLES, program

TILES = [SAMPLES / "terrain" / f"quarry_{zone}.ply" for zone in ("blue", "gray", "red")]


@pytest.fixture(scope="module")
def quarry():
    return clast.terrain(TILES, zones=["blue", "gray", "red"])


def test_a_terrain_is_that_of_the_program(tmp_path, quarry):
    quarry.write(tmp_path / "py.h5")
    program("terrain", *TILES, "--zones", "blue,gray,red", "-o", tmp_path / "prog.h5")
    mine, other = clast.terrain(tmp_path / "py.h5"), clast.terrain(tmp_path / "prog.h5")
    assert np.array_equal(mine.vertices, other.vertices)
    assert np.array_equal(mine.triangles, other.triangles)
    assert np.array_equal(mine.zones, other.zones)
    assert mine.zone_names == other.zone_names == ["blue", "gray", "red"]
    with pytest.raises(clast.InputError):
        quarry.write(tmp_path / "py.h5")
    quarry.write(tmp_path / "py.h5", replace=True)


def test_the_height_at_a_vertex_is_its_own(quarry):
    place = quarry.vertices[:50] + quarry.origin
    found = quarry.height(place[:, 0], place[:, 1])
    inside = np.isfinite(found)
    assert inside.any()
    assert np.all(found[inside] > place[inside, 2] - 1e-6)  # nothing is above the topmost ground
    assert np.isnan(quarry.height([1e7], [0.0])).all()
    with pytest.raises(clast.InputError, match="one length"):
        quarry.height([0.0, 1.0], [0.0])


def test_views_are_read_only(quarry):
    assert not quarry.vertices.flags.writeable and not quarry.zones.flags.writeable
    assert quarry.vertices.dtype == np.float64 and quarry.zones.dtype == np.uint16
    assert quarry.report["triangles_read"] == len(quarry.triangles)


def test_places_off_the_ground_are_refused(quarry):
    assert quarry.check_fit([[2.3, 80.0, 209.5]]) == []
    assert quarry.check_fit([[2.3, 80.0, 209.5]], border_distance=1e4, block_size=50.0)
    with pytest.raises(clast.InputError, match="release"):
        quarry.check_fit([[1e6, 80.0, 209.5]])
    with pytest.raises(clast.InputError):
        quarry.check_fit([[np.nan, 80.0, 209.5]])
    file = SAMPLES / "terrain" / "positions_P2.xyz"
    assert quarry.check_fit(file) == quarry.check_fit(np.loadtxt(file))


def test_exports_and_pictures_are_files(tmp_path, quarry):
    quarry.export(tmp_path / "ground.vtp")
    quarry.picture(tmp_path / "ground.svg", release=[[2.3, 80.0, 209.5]])
    assert "release point 0" in (tmp_path / "ground.svg").read_text()
    with pytest.raises(clast.InputError, match="ground.png: .* must end in .svg"):
        quarry.picture(tmp_path / "ground.png")
    with pytest.raises(clast.InputError):
        quarry.export(tmp_path / "ground.vtp")
    with pytest.raises(clast.InputError, match="docx"):
        quarry.export(tmp_path / "ground.docx")


@pytest.mark.parametrize(
    ("inputs", "keywords", "error"),
    [
        ("missing.tif", {}, clast.InputError),
        ([], {}, clast.InputError),
        (TILES, {"zones": "blue,gray"}, clast.InputError),
        (TILES, {"up": "x"}, clast.InputError),
        (TILES, {"crack": float("nan")}, clast.InputError),
        (TILES, {"smoothing": "much"}, TypeError),
        (None, {}, (TypeError, clast.InputError)),
        (TILES, {"zone": "blue"}, TypeError),
    ],
)
def test_what_is_no_terrain_is_refused(inputs, keywords, error):
    with pytest.raises(error):
        clast.terrain(inputs, **keywords)
