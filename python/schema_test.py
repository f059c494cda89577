"""The schema of campaign files says what the program knows of their keys."""

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


def errors(campaign):
    return [error.message for error in VALIDATOR.iter_errors(campaign)]


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
    assert "campaign" in program("check", code=2)
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
def test_sample_campaigns_are_valid(file):
    campaign = tomllib.loads(file.read_text(encoding="utf-8"))
    if "unknown" in campaign:
        pytest.skip("a study of a calibration, not a campaign")
    assert errors(campaign) == []


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


def planted():
    """(what is wrong, how it gets into a campaign)"""
    def set_in(*path, value):
        def plant(campaign):
            for step in path[:-1]:
                campaign = campaign.setdefault(step, {})
            campaign[path[-1]] = value
        return plant

    def remove(*path):
        def plant(campaign):
            for step in path[:-1]:
                campaign = campaign[step]
            del campaign[path[-1]]
        return plant

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
