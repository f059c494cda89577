import json

import clast
import numpy as np
import pytest
from conftest import program

STUDY = """
[design]
members = 8
releases = 8
draws = 200

[[site]]
name = "quarry"
campaign = "steep.toml"

[[unknown]]
parameter = "ground.blue.friction"
range = [0.4, 0.9]

[[unknown]]
parameter = "ground.red.rolling_length_m"
range = [0.01, 1.0]
scale = "log"

[[observation]]
name = "stops"
use = "fit"
stops = "stops.csv"
figures = "mean"
"""


@pytest.fixture(scope="module")
def study(made):
    (made / "study.toml").write_text(STUDY)
    text = (made / "campaign.toml").read_text()
    text = text.replace("[ground.red]", "[ground.red]\nrolling_length_m = 0.2")
    (made / "steep.toml").write_text(text.replace("random = 3", "random = 4"))
    (made / "stops.csv").write_text("x,y\n20,80\n24,82\n26,79\n31,84\n")
    return made / "study.toml"


@pytest.fixture(scope="module")
def mine(study, tmp_path_factory):
    return clast.calibrate(study, tmp_path_factory.mktemp("mine") / "p.h5", threads=2)


@pytest.fixture(scope="module")
def theirs(study, tmp_path_factory):
    """Of the program: folder, and what it printed as JSON."""
    folder = tmp_path_factory.mktemp("theirs")
    return folder, json.loads(program("calibrate", study, "-o", folder / "p.h5", "--threads", "1", "--json"))


def test_the_posterior_is_the_programs_to_the_bit(mine, theirs, study):
    draws = mine.posterior
    assert list(draws) == ["ground.blue.friction", "ground.red.rolling_length_m", "log_likelihood"]
    assert draws.rows == 200 and draws.units["ground.red.rolling_length_m"] == "m"
    assert 0.4 <= draws["ground.blue.friction"].min() and draws["ground.blue.friction"].max() <= 0.9
    # Both files hold the same draws: campaigns that take theirs at random get the same ground.
    folder, found = theirs
    ours = mine.to_dict()
    assert ours.pop("file") == mine.path
    assert {k: v for k, v in found.items() if k != "file"} == ours
    stored = (folder / "p.h5").read_bytes()
    assert draws["log_likelihood"].tobytes() in stored
    rows = np.column_stack([draws["ground.blue.friction"], draws["ground.red.rolling_length_m"]])
    assert rows.tobytes() in stored


def test_files_are_the_programs_to_the_bit(mine, theirs):
    folder, _ = theirs
    with open(mine.path, "rb") as file:
        assert file.read() == (folder / "p.h5").read_bytes()
    with open(mine.page, encoding="utf-8") as page:
        assert "Ground parameters estimated from observations" in page.read()


def test_what_was_found_is_said(mine):
    assert [one["parameter"] for one in mine.unknowns] == list(mine.posterior)[:2]
    low, high = mine.unknowns[0]["interval_95"]
    draws = mine.posterior["ground.blue.friction"]
    inside = (draws >= low) & (draws <= high)
    assert 0.94 <= inside.mean() <= 0.96
    assert mine.figures[0]["observed"] == pytest.approx((20 + 24 + 26 + 31) / 4 - 2.3, rel=1e-6)
    assert mine.answer and mine.answer in mine._repr_html_() and "[ground.blue]" in mine.ground
    assert all(isinstance(one, str) for one in mine.findings)


def test_refusals_are_the_programs(mine, study, tmp_path):
    with pytest.raises(clast.InputError, match="p.h5"):
        clast.calibrate(study, mine)
    with pytest.raises(clast.InputError, match="extension .h5"):
        clast.calibrate(study, tmp_path / "p.html")
    with pytest.raises(clast.InputError, match="none.toml"):
        clast.calibrate(tmp_path / "none.toml", tmp_path / "p.h5")
    with pytest.raises(TypeError, match="threads"):
        clast.calibrate(study, tmp_path / "p.h5", threads="two")


def test_an_interrupted_calibration_goes_on(mine, study, tmp_path):
    steps = []

    def stop(step):
        steps.append(step)
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        clast.calibrate(study, tmp_path / "p.h5", threads=1, progress=stop)
    assert steps[0]["total"] == 8 and not (tmp_path / "p.h5").exists()
    again = clast.calibrate(study, tmp_path / "p.h5", resume=True)
    assert all(np.array_equal(again.posterior[name], mine.posterior[name]) for name in mine.posterior)


def test_shards_joined_are_the_whole(mine, study, tmp_path):
    parts = [clast.calibrate_shard(study, tmp_path / "p.h5", shard=(i, 2)) for i in (1, 2)]
    assert parts == [str(tmp_path / f"p.{i}of2.h5") for i in (1, 2)]
    whole = clast.calibrate(study, tmp_path / "p.h5", parts=parts)
    for name in mine.posterior:
        assert np.array_equal(whole.posterior[name], mine.posterior[name])
    with pytest.raises(clast.InputError, match="member 2 of 8 is in none of the parts"):
        clast.calibrate(study, tmp_path / "q.h5", parts=parts[:1])
