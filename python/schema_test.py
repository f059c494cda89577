"""The schemas of campaigns and studies say what the program knows of their keys."""

import copy
import json
import tomllib

import clast
import jsonschema
import pytest
from clast import _core
from conftest import CAMPAIGN, SAMPLES, documented_keys, program

SCHEMA = clast.campaign_schema()
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


STUDY_SCHEMA = clast.calibration_schema()
STUDY_VALIDATOR = jsonschema.Draft7Validator(STUDY_SCHEMA)


def errors(campaign):
    return [error.message for error in VALIDATOR.iter_errors(campaign)]


def study_errors(study):
    return [error.message for error in STUDY_VALIDATOR.iter_errors(study)]


def table(name):
    """The schema of one table of that name."""
    if "." in name:
        outer, key = name.split(".")
        return SCHEMA["properties"][outer]["properties"][key]
    found = SCHEMA["properties"][name]
    if name == "ground":
        return found["additionalProperties"]
    if "anyOf" in found:
        return found["anyOf"][0]
    return found.get("items", found)


def good():
    return tomllib.loads(CAMPAIGN.format(terrain="terrain"))


def test_it_is_a_schema_and_the_programs():
    VALIDATOR.check_schema(SCHEMA)
    assert json.loads(program("check", "--schema")) == SCHEMA
    assert "file is required" in program("check", code=2)
    assert program("check", "--schema", "--json", code=2)


def test_every_key_of_the_tables_is_in_it_with_type_and_meaning():
    assert len(_core.campaign_tables) >= 11
    for name, keys in _core.campaign_tables.items():
        properties = table(name)["properties"]
        assert list(properties) == keys
        for key, said in properties.items():
            assert len(said["description"]) > 5, key
            assert said.keys() & {"type", "enum", "anyOf"}, key
    assert set(SCHEMA["properties"]) == {name for name in _core.campaign_tables if "." not in name}


def test_units_are_those_of_the_documents():
    documented = documented_keys()
    compared = 0
    for name, keys in _core.campaign_tables.items():
        for key in keys:
            if key not in documented.get(name, {}):
                continue
            said = table(name)["properties"][key]
            assert said.get("unit", "") == documented[name][key], key
            assert said["description"].endswith(f", {said['unit']}") if "unit" in said else True
            compared += 1
    assert compared >= 60


def test_names_that_end_with_a_unit_have_it():
    units = {"_m": "m", "_s": "s", "_m_s": "m/s", "_rad_s": "rad/s", "_n_m": "N/m", "_kg": "kg",
             "_kg_m3": "kg/m^3", "_m_s2": "m/s^2", "_j_kg": "J/kg"}  # fmt: skip
    checked = 0
    for name in _core.campaign_tables:
        for key, said in table(name)["properties"].items():
            ends = [end for end in units if key.endswith(end)]
            if ends and "_per_" not in key:
                assert said["unit"] == units[max(ends, key=len)], key
                checked += 1
    assert checked >= 15


@pytest.mark.parametrize("file", sorted(SAMPLES.rglob("*.toml")), ids=lambda file: file.name)
def test_samples_are_valid(file):
    campaign = tomllib.loads(file.read_text(encoding="utf-8"))
    wrong, right = (errors, study_errors) if "unknown" in campaign else (study_errors, errors)
    assert right(campaign) == []
    assert wrong(campaign)


def test_what_campaigns_may_hold_is_valid():
    campaign = good()
    assert errors(campaign) == []
    campaign["blocks"] |= {
        "select": {"scheme": "zingg", "class": "disc"},
        "draw": {"count": 5, "shares": {"disc": 1.0}, "mass_kg": {"log_normal": [100.0, 0.5]}},
    }
    campaign["ground"]["red"]["friction"] = {"uniform": [0.5, 0.8]}
    campaign["ground"]["gray"]["rolling_length_m"] = 0.2
    campaign["ensemble"] = {"members": 4, "design": "sobol"}
    campaign["release"] = [{"name": "a", "points": "p.txt", "orientations": "grid-45"},
                           {"name": "b", "height_m": 0, "orientations": {"random": 3, "fresh": True},
                            "points": {"polygon": [[0, 0], [1, 0], [1, 1]], "count": 3}}]  # fmt: skip
    campaign["contact"] = {"law": "elastoplastic", "stiffness": "auto"}
    assert errors(campaign) == []
    del campaign["release"]
    campaign["mass"] = {"polygon": [[0, 0], [1, 0], [1, 1]]}
    campaign["contact"]["blocks"] = {"energy_restitution": 0.1, "friction": 0.5, "rolling_friction": 0}
    assert errors(campaign) == []


def test_what_vary_may_hold_is_valid():
    campaign = good()
    campaign["blocks"]["vary"] = {
        "to": [[0.8, 0.5]], "grid": {"diagram": "zingg", "steps": 3}, "like": "B02_platy",
        "convexity": 1, "rounding": [0, 0.1], "roundness": [0.5], "roundness_edge": 0.05,
        "vertices": [20, 30], "detail": [0, 2.0], "degree": 4, "keep": "volume",
        "reference": ["superellipsoid", "box"], "exponent": 3, "inertia": "ellipsoid",
        "population": {"count": 3, "seed": 2, "table": "taped.csv", "units": "cm", "prefix": "T"},
    }  # fmt: skip
    assert errors(campaign) == []


def set_in(*path, value):
    """Plants a value; numbers of a path are places in lists."""
    def plant(file):
        for step in path[:-1]:
            file = file[step] if isinstance(step, int) else file.setdefault(step, {})
        file[path[-1]] = value
    return plant


def remove(*path):
    def plant(file):
        for step in path[:-1]:
            file = file[step]
        del file[path[-1]]
    return plant


def planted():
    """(what is wrong, how it gets into a campaign)"""
    return {
        "unknown table": set_in("moss", value={}),
        "unknown key": set_in("run", "max_time", value=3),
        "unknown key of a zone": set_in("ground", "red", "fricton", value=0.3),
        "text for a number": set_in("run", "max_time_s", value="long"),
        "number for a text": set_in("blocks", "library", value=3),
        "number for a flag": set_in("blocks", "allow_any_size", value=1),
        "fraction for a count": set_in("ensemble", value={"members": 2.5}),
        "below its range": set_in("ground", "red", "friction", value=-0.1),
        "between 0 and its range": set_in("ground", "red", "friction", value=1e-9),
        "above its range": set_in("run", "gravity_m_s2", value=1e4),
        "zero where it means nothing": set_in("run", "max_time_s", value=0),
        "another law": set_in("contact", "law", value="newton"),
        "another direction": set_in("barrier", value=[{"name": "a", "direction": "back"}]),
        "law of a drawn number": set_in("ground", "red", "friction", value={"beta": [1, 2]}),
        "two laws": set_in("ground", "red", "friction", value={"uniform": [0, 1], "normal": [1, 1]}),
        "three numbers of a law": set_in("ground", "red", "friction", value={"uniform": [0, 1, 2]}),
        "a point of one number": set_in("release", "points", value=[[1.0]]),
        "no number of points": set_in("release", "points", value={"line": [[0, 0], [1, 1]]}),
        "drawn friction between blocks": set_in("contact", "blocks", value={"friction": {"uniform": [0, 1]}}),
        "one barrier as a table": set_in("barrier", value={"name": "a"}),
        "barrier without a name": set_in("barrier", value=[{"from": [0, 0], "to": [1, 1]}]),
        "one ratio": set_in("blocks", "vary", value={"to": [[0.8]]}),
        "another diagram": set_in("blocks", "vary", value={"grid": {"diagram": "folk", "steps": 3}}),
        "too few vertices": set_in("blocks", "vary", value={"vertices": [7]}),
        "another reference body": set_in("blocks", "vary", value={"reference": "cone"}),
        "no library": remove("blocks", "library"),
        "no friction": remove("ground", "blue", "friction"),
        "no terrain": remove("terrain"),
        "no release": remove("release"),
    }  # fmt: skip


@pytest.mark.parametrize("what", sorted(planted()))
def test_planted_errors_are_found(what):
    campaign = copy.deepcopy(good())
    planted()[what](campaign)
    assert errors(campaign)
    # The program refuses it too: the schema marks nothing that would run.
    built = clast.Campaign()
    built.__dict__["_tables"] = campaign
    assert built.check()


STUDY = """
[design]
members = 16
releases = 8
kernel = "matern-5/2"

[[site]]
name = "slope"
campaign = "campaign.toml"

[[unknown]]
parameter = "ground.red.friction"
range = [0.3, 0.9]

[[unknown]]
parameter = "contact.rolling_stiffness_n_m_rad"
range = [1e5, 1e7]
scale = "log"

[[observation]]
name = "stops"
use = "fit"
stops = "stops.csv"
figures = ["mean", "p90"]
beyond_m = [20]

[[observation]]
name = "road"
use = "keep"
barrier = "EC21"
releases = 8
passed = 5
speed_m_s = [8.0, 0.5]
"""


@pytest.fixture
def study_folder(made, tmp_path):
    (tmp_path / "blocks.h5").symlink_to(made / "blocks.h5")
    campaign = (made / "campaign.toml").read_text()
    (tmp_path / "campaign.toml").write_text(campaign.replace("random = 3", "random = 4"))
    (tmp_path / "stops.csv").write_text("x,y\n31,80\n38,83\n42,79\n")
    return tmp_path


def toml(value):
    """A table of a study as TOML on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(key)} = {toml(one)}" for key, one in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def found_in(folder, study):
    (folder / "study.toml").write_text("\n".join(f"{key} = {toml(value)}" for key, value in study.items()))
    return clast.check_calibration(folder / "study.toml")


def test_the_schema_of_studies_is_one_and_the_programs():
    STUDY_VALIDATOR.check_schema(STUDY_SCHEMA)
    assert json.loads(program("check", "--schema", "study")) == STUDY_SCHEMA
    assert json.loads(program("check", "--schema", "campaign")) == SCHEMA
    assert "campaign" in program("check", "--schema", "terrain", code=2)
    assert "--schema" in program("check", "study.toml", "--schema", code=2)


def test_keys_of_studies_are_those_of_the_documents():
    documented = documented_keys("## Study (TOML)")
    assert set(documented) == set(_core.calibration_tables) == set(STUDY_SCHEMA["properties"])
    for name, keys in _core.calibration_tables.items():
        said = STUDY_SCHEMA["properties"][name]
        properties = said.get("properties") or said["anyOf"][0]["properties"]
        assert list(properties) == keys
        assert set(documented[name]) >= set(keys)
        assert all(len(key["description"]) > 5 for key in properties.values())


def test_a_good_study_is_valid_and_accepted(study_folder):
    study = tomllib.loads(STUDY)
    assert study_errors(study) == []
    assert found_in(study_folder, study) == []
    said = json.loads(program("check", study_folder / "study.toml", "--json"))
    assert said["accepted"] and said["runs"] == 128 and len(said["figures"]) == 5
    assert "128 runs" in program("check", study_folder / "study.toml")
    study["observation"].append({"name": "scar", "use": "fit", "impact": 1, "depth_m": [0.1, 0.02]})
    study["observation"].append({"name": "paths", "use": "fit", "trajectories": "p.csv", "times_s": [1]})
    assert study_errors(study) == []


def planted_in_a_study():
    """(what is wrong, how it gets into a study)"""
    return {
        "unknown table": set_in("sites", value={}),
        "unknown key": set_in("design", "member", value=16),
        "too few members": set_in("design", "members", value=4),
        "too few releases": set_in("design", "releases", value=7),
        "fraction for a count": set_in("design", "draws", value=200.5),
        "another kernel": set_in("design", "kernel", value="gauss"),
        "text for a number": set_in("design", "seed", value="one"),
        "no site": remove("site"),
        "site without a campaign": remove("site", 0, "campaign"),
        "no unknown": remove("unknown"),
        "misspelt parameter": set_in("unknown", 0, "parameter", value="ground.red.fricton"),
        "parameter of no zone": set_in("unknown", 0, "parameter", value="friction"),
        "one end of a range": set_in("unknown", 0, "range", value=[0.3]),
        "number for a range": set_in("unknown", 0, "range", value=0.3),
        "another scale": set_in("unknown", 0, "scale", value="cubic"),
        "no observation": remove("observation"),
        "neither fitted nor kept": remove("observation", 0, "use"),
        "another use": set_in("observation", 0, "use", value="both"),
        "of nothing": remove("observation", 0, "stops"),
        "of two sources": set_in("observation", 0, "impact", value=1),
        "key of another source": set_in("observation", 1, "depth_m", value=[0.1, 0.1]),
        "another figure": set_in("observation", 0, "figures", value=["median"]),
        "another shape": set_in("observation", 0, "shape", value="round"),
        "value without its error": set_in("observation", 1, "speed_m_s", value=[8.0]),
        "speed below 0": set_in("observation", 1, "speed_m_s", value=[-8.0, 0.5]),
        "no releases": set_in("observation", 1, "releases", value=0),
    }  # fmt: skip


@pytest.mark.parametrize("what", sorted(planted_in_a_study()))
def test_planted_errors_of_studies_are_found(what, study_folder):
    study = tomllib.loads(STUDY)
    planted_in_a_study()[what](study)
    assert study_errors(study)
    # The program refuses it too: the schema marks nothing that would run.
    assert found_in(study_folder, study)


def test_what_no_schema_knows_is_left_to_the_check(study_folder):
    study = tomllib.loads(STUDY)
    study["unknown"][0]["parameter"] = "ground.moss.friction"
    study["observation"][0]["block"] = "B77"
    study["observation"][1]["passed"] = 9
    assert study_errors(study) == []
    found = found_in(study_folder, study)
    assert len(found) == 2  # the first of each table
    assert "no campaign has this zone" in found[0]
    assert "stops" in found[1]
    message = program("check", study_folder / "study.toml", code=1)
    assert "clast calibrate would refuse it, with 2 findings" in message


def test_findings_in_the_campaigns_of_a_study_are_its_own(study_folder):
    (study_folder / "blocks.h5").unlink()
    campaign = study_folder / "campaign.toml"
    found = found_in(study_folder, tomllib.loads(STUDY))
    assert any("campaign.toml" in one and "blocks.h5" in one for one in found)
    campaign.write_text("")
    assert found_in(study_folder, tomllib.loads(STUDY))
