import os
import signal
import subprocess
import sys
import time

import clast
import numpy as np
import pytest
from conftest import documented_keys, program


@pytest.fixture
def campaign(made):
    return clast.Campaign(made / "campaign.toml")


def test_every_documented_key_is_an_attribute():
    tables = documented_keys()
    assert len(tables) >= 11
    campaign = clast.Campaign()
    for name, keys in tables.items():
        if name in ("ground", "blocks.vary", "contact.blocks"):
            continue  # below
        table = getattr(campaign, name)
        if name in ("block_group", "mass", "barrier"):
            table = table.add()
        for key in keys:
            getattr(table, key)  # given or not
            assert key in dir(table)
        if name == "contact":
            continue
        assert set(dir(table)) - set(dir(clast.CampaignTable("x", [], {}))) >= keys.keys()
    campaign.ground["scree"] = {}
    for key in tables["ground"]:
        setattr(campaign.ground["scree"], key, 0.5)
    campaign.contact.blocks.friction = 0.3
    assert "[ground.scree]" in campaign.text and "blocks = { friction = 0.3 }" in campaign.text
    for key in tables["blocks.vary"]:
        setattr(campaign.blocks.vary, key, 1)
    with pytest.raises(AttributeError, match="did you mean convexity"):
        campaign.blocks.vary.convexty = 1


def test_keys_read_and_change(campaign):
    assert campaign.ground["red"].friction == 0.70
    assert campaign.run.max_time_s == 4
    assert campaign.run.gravity_m_s2 is None  # the program's default
    assert campaign.barrier[0].name == "EC21" and campaign.barrier[0].from_ == [16.25, 50.0]
    campaign.ground["red"].friction = np.float64(0.55)
    campaign.barrier.add(name="EC22", from_=np.array([42.5, 50.0]), to=(42.5, 110.0))
    campaign.run.max_time_s = None
    again = clast.Campaign()
    for name in ("blocks", "terrain", "ground", "release", "barrier"):
        setattr(again, name, getattr(campaign, name))
    assert "friction = 0.55" in campaign.text and "max_time_s" not in campaign.text
    assert campaign.ground["red"]["friction"] == 0.55
    assert len(campaign.barrier) == 2


def test_a_campaign_that_nobody_changed_is_its_file(campaign, made):
    assert campaign.text == (made / "campaign.toml").read_text()
    before = campaign.run.max_time_s
    campaign.run.max_time_s = 5
    assert campaign.text != (made / "campaign.toml").read_text()
    campaign.run.max_time_s = before
    assert campaign.text == (made / "campaign.toml").read_text()


def test_a_misspelt_name_is_answered_with_its_right_spelling(campaign):
    with pytest.raises(AttributeError, match="did you mean friction"):
        campaign.ground["red"].fricton = 0.5
    with pytest.raises(AttributeError, match="did you mean terrain"):
        campaign.terain
    with pytest.raises(AttributeError, match="did you mean max_time_s"):
        campaign.run = {"max_time": 3}
    with pytest.raises(KeyError):
        campaign.ground["moss"]


def test_refusals_are_the_programs(campaign, made, tmp_path):
    assert campaign.check() == []
    campaign.ground["red"].friction = -1
    findings = campaign.check()
    assert len(findings) == 1 and "[ground.red] friction = -1" in findings[0]
    assert "(changed)" in findings[0]
    with pytest.raises(clast.InputError, match="friction = -1"):
        campaign.run(tmp_path / "r.h5")
    with pytest.raises(clast.InputError, match="friction = -1"):
        campaign.plan()
    campaign.ground["red"].friction = float("nan")
    assert "friction = nan" in campaign.check()[0]
    campaign.ground["red"].friction = "rough"
    assert campaign.check()
    campaign.ground["red"].friction = object()
    with pytest.raises(TypeError, match="ground.red.friction"):
        campaign.check()
    assert not (tmp_path / "r.h5").exists()


def test_files_that_are_no_campaigns_are_refused(tmp_path):
    with pytest.raises(clast.InputError, match="missing.toml"):
        clast.Campaign(tmp_path / "missing.toml")
    (tmp_path / "bad.toml").write_text("[blocks\n")
    with pytest.raises(clast.InputError, match="bad.toml:1"):
        clast.Campaign(tmp_path / "bad.toml")
    (tmp_path / "odd.toml").write_text("[moss]\nx = 1\n")
    odd = clast.Campaign(tmp_path / "odd.toml")
    assert any("unknown table" in finding for finding in odd.check())
    with pytest.raises(clast.InputError):
        clast.Campaign(tmp_path)
    with pytest.raises(TypeError):
        clast.Campaign(3)
    assert clast.Campaign().check()  # an empty one lacks everything


def test_texts_of_every_kind_pass_through_the_file(tmp_path):
    names = ['a "quoted" name', "tab\tand\\slash", "Gerölle", "line\nend", "'", "\x7f\x01"]
    campaign = clast.Campaign()
    for name in names:
        campaign.barrier.add(name=name, to=[1, 2.5e-7], through=[[1e300, -0.0]])
    campaign.release = [{"name": "a", "orientations": {"random": 3, "fresh": True}}]
    campaign.write(tmp_path / "c.toml")
    again = clast.Campaign(tmp_path / "c.toml")
    assert [barrier.name for barrier in again.barrier] == names
    assert again.barrier[0].to == [1, 2.5e-7] and again.barrier[0].through == [[1e300, -0.0]]
    assert again.release[0].orientations == {"random": 3, "fresh": True}
    with pytest.raises(clast.InputError):
        campaign.write(tmp_path / "c.toml")


def test_results_are_the_programs_to_the_bit(campaign, made, tmp_path):
    mine = campaign.run(tmp_path / "py.h5", threads=2)
    program("simulate", made / "campaign.toml", "-o", tmp_path / "prog.h5", "--threads", "1")
    other = clast.Results(tmp_path / "prog.h5")
    assert mine.campaign_text == other.campaign_text
    assert mine.runs.rows == 6
    for table in ("runs", "crossings", "impacts", "deposits"):
        for name, column in mine.table(table).items():
            assert np.array_equal(column, other.table(table)[name], equal_nan=column.dtype.kind == "f")
    a, b = mine.trajectory(5), other.trajectory(5)
    assert all(np.array_equal(a[name], b[name]) for name in a)


def test_a_campaign_from_nothing_has_the_runs_of_the_file(campaign, made, tmp_path):
    library = clast.Library(made / "blocks.h5")
    new = clast.Campaign()
    new.blocks.library = library
    new.blocks.select = ["B01_compact", "B04_elongated"]
    new.terrain.surface = campaign.terrain.surface
    new.terrain.zones = ["blue", "gray", "red"]
    for zone, rolling in {"red": 0.18, "blue": 0.35, "gray": 0.0}.items():
        friction = 0.3 if zone == "gray" else 0.7
        new.ground[zone] = dict(
            energy_restitution=0.01, friction=friction, rolling_friction=rolling
        )
    new.release.points = np.array([[2.3, 80.0, 209.5]])
    new.release.orientations = {"random": 3, "seed": 4}
    new.barrier.add(name="EC21", from_=[16.25, 50.0], to=[16.25, 110.0])
    new.run.max_time_s = 4
    new.run.downslope = [1.0, 0.0]
    runs = new.run(tmp_path / "new.h5").runs
    expected = campaign.run(tmp_path / "file.h5").runs
    assert all(np.array_equal(runs[name], expected[name]) for name in ("stop_x_m", "stop_qw"))


def test_existing_results_are_kept(campaign, tmp_path):
    output = tmp_path / "r.h5"
    campaign.run(output)
    before = output.read_bytes()
    with pytest.raises(clast.InputError, match="r.h5"):
        campaign.run(output)
    assert output.read_bytes() == before
    campaign.run(output, resume=True)  # nothing is left to do
    assert output.read_bytes() == before
    campaign.run(output, replace=True)
    (tmp_path / "text.h5").write_text("mine")
    with pytest.raises(clast.InputError):
        campaign.run(tmp_path / "text.h5", replace=True)
    assert (tmp_path / "text.h5").read_text() == "mine"


def test_shards_are_joined_to_the_whole(campaign, tmp_path):
    whole = campaign.run(tmp_path / "whole.h5").runs
    parts = [campaign.run(tmp_path / "s.h5", shard=(i, 2)).path for i in (1, 2)]
    assert parts[0].endswith("s.1of2.h5")
    joined = clast.merge_results(parts, tmp_path / "joined.h5").runs
    assert np.array_equal(joined["stop_x_m"], whole["stop_x_m"])
    for shard in ((0, 2), (3, 2)):
        with pytest.raises(clast.InputError):
            campaign.run(tmp_path / "s.h5", shard=shard)
    with pytest.raises(TypeError, match="shard"):
        campaign.run(tmp_path / "s.h5", shard="2/2")


def test_progress_is_reported_and_what_it_raises_ends_the_runs(campaign, tmp_path):
    steps = []
    campaign.run(tmp_path / "r.h5", progress=steps.append)
    assert steps and steps[-1]["done"] == steps[-1]["total"] == 6
    campaign.run.max_time_s = 60

    def stop(step):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        campaign.run(tmp_path / "stopped.h5", threads=1, progress=stop)
    with pytest.raises(TypeError, match="progress"):
        campaign.run(tmp_path / "never.h5", progress=3)
    assert not (tmp_path / "never.h5").exists()


def test_plans_say_what_would_run(campaign, tmp_path):
    plan = campaign.plan()
    assert plan["runs"] == 6 and plan["blocks"] == ["B01_compact", "B04_elongated"]
    dry = campaign.dry_run(tmp_path / "map.svg", threads=1)
    assert dry["expected_time_s"] > 0 and dry["threads"] == 1
    assert (tmp_path / "map.svg").read_text().startswith("<")


def test_blocks_are_varied_before_the_runs(campaign, made, tmp_path):
    campaign.blocks.select = ["B01_compact"]
    campaign.blocks.vary = {"to": [[0.8, 0.5]], "reference": "ellipsoid"}
    plan = campaign.plan()
    assert plan["varied_blocks"] == ["B01_compact"]
    assert plan["blocks"] == ["B01_compact_ellipsoid", "B01_compact_il0.8_sl0.5"]
    varied = campaign.run(tmp_path / "one.h5", threads=1)
    clast.vary(made / "blocks.h5", "B01_compact", tmp_path / "series.h5", to=[(0.8, 0.5)],
               reference="ellipsoid")  # fmt: skip
    del campaign.blocks["vary"], campaign.blocks["select"]
    campaign.blocks.library = str(tmp_path / "series.h5")
    two = campaign.run(tmp_path / "two.h5")
    assert np.array_equal(varied.runs["stop_x_m"], two.runs["stop_x_m"])
    assert set(varied.runs["variation"]) == {"ellipsoid", "stretch to 0.8, 0.5"}
    assert set(varied.runs["parent"]) == {"B01_compact"}


def test_scenes_for_other_engines_are_the_programs(campaign, made, tmp_path):
    folders, notes = campaign.export(tmp_path / "py", to="rockable", runs=[0, 4])
    program("export", made / "campaign.toml", "--to", "rockable", "--runs", "0,4",
            "-o", tmp_path / "prog")  # fmt: skip
    assert len(folders) == 2 and notes
    files = [file for file in (tmp_path / "prog").rglob("*") if file.is_file()]
    assert len(files) > 4
    for file in files:
        mine = tmp_path / "py" / file.relative_to(tmp_path / "prog")
        assert mine.read_bytes() == file.read_bytes()
    with pytest.raises(clast.InputError):
        campaign.export(tmp_path / "py")
    with pytest.raises(clast.InputError, match="gravel"):
        campaign.export(tmp_path / "new", to="gravel")
    with pytest.raises(clast.InputError):
        campaign.export(tmp_path / "new", runs=[600])


def test_a_new_campaign_is_proposed(made, tmp_path):
    campaign, doubts = clast.new_campaign(
        made / "blocks.h5", campaign_surface(made), tmp_path / "c.toml"
    )
    assert campaign.check() == []
    assert len(campaign.barrier) == 1
    assert all(isinstance(doubt, str) for doubt in doubts)
    with pytest.raises(clast.InputError):
        clast.new_campaign(made / "blocks.h5", campaign_surface(made), tmp_path / "c.toml")


def campaign_surface(made):
    return clast.Campaign(made / "campaign.toml").terrain.surface


SLOW = """
import sys, clast
campaign = clast.Campaign(sys.argv[1])
campaign.release.orientations = {"random": 400, "seed": 1}
campaign.run.max_time_s = 60
try:
    campaign.run(sys.argv[2], threads=1, progress=lambda step: print("step", flush=True))
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_ends_a_campaign_in_order(made, tmp_path):
    command = [sys.executable, "-X", "dev", "-W", "error", "-c", SLOW]
    process = subprocess.Popen(
        [*command, str(made / "campaign.toml"), str(tmp_path / "r.h5")],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ,
    )  # fmt: skip
    assert process.stdout.readline() == "step\n"
    process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    out, err = process.communicate(timeout=60)
    assert "interrupted" in out and err == "" and process.returncode == 0
    assert time.monotonic() - begin < 30
    assert (tmp_path / "r.h5.part").exists()  # what was done is kept


def test_results_of_another_engine_come_back(campaign, tmp_path):
    campaign.export(tmp_path / "scenes", runs=[0, 1])
    for number in (0, 1):
        folder = tmp_path / "scenes" / f"run{number:05d}"
        text = (folder / "input.txt").read_text()
        for step in range(11):  # held where it starts
            (folder / f"conf{step}").write_text(text.replace("\nt 0\n", f"\nt {0.1 * step}\n"))
    steps = []
    other = clast.import_results("rockable", tmp_path / "scenes", tmp_path / "r.h5", progress=steps.append)
    assert other.engine == "rockable" and other.runs.rows == 2 and steps
    assert list(other.runs["stop_reason"]) == ["rest", "rest"]
    assert other.runs["duration_s"] == pytest.approx([1.0, 1.0])
    for name in ("impacts", "contact_steps", "max_penetration_m", "energy_normal_j", "energy_error"):
        assert np.isnan(other.runs[name]).all(), name
    assert other.summary()["largest_energy_error"] is None
    program("import", "rockable", tmp_path / "scenes", "-o", tmp_path / "p.h5")
    theirs = clast.Results(tmp_path / "p.h5").runs
    assert np.array_equal(theirs["stop_x_m"], other.runs["stop_x_m"])
    comparison = clast.compare([campaign.run(tmp_path / "own.h5"), other], by="engine")
    with open(comparison.report(tmp_path / "report"), encoding="utf-8") as page:
        text = page.read()
    assert "rockable, read by clast" in text and "do not report energy balance" in text
    with open(tmp_path / "report" / "runs.csv", encoding="utf-8") as table:
        header, *rows = [line.rstrip("\n").split(",") for line in table]
    of_other = [row for row in rows if row[header.index("engine")] == "rockable"]
    assert len(of_other) == 2
    assert all(row[header.index("impacts")] == "" == row[header.index("energy_error")] for row in of_other)
    with pytest.raises(clast.InputError, match="r.h5"):
        clast.import_results("rockable", tmp_path / "scenes", tmp_path / "r.h5")
    with pytest.raises(clast.InputError, match="exadem"):
        clast.import_results("exadem", tmp_path / "scenes", tmp_path / "x.h5")
