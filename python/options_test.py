"""Every option of every command can be given in Python."""

import inspect
import re

import clast
import pytest
from conftest import program

# Of each command what does it in Python. What an option sets is a parameter of its name there, with
# _ for -, or what is named below.
CALLS = {
    "reconstruct": [clast.reconstruct, clast.reconstruct_batch],
    "cut": [clast.cut],
    "show": [clast.Library.report, clast.Library.chosen],
    "classify": [clast.classify, clast.Population.report],
    "export": [clast.Library.export, clast.Library.export_particles, clast.Campaign.export],
    "library-merge": [clast.Library.merge],
    "library-remove": [clast.Library.remove],
    "library-set": [clast.Library.set],
    "terrain": [clast.terrain, clast.Terrain.export, clast.Terrain.picture, clast.Terrain.check_fit],
    "new-campaign": [clast.new_campaign],
    "check": [clast.Campaign, clast.check_calibration],
    "simulate": [type(clast.Campaign().run).__call__, clast.Campaign.dry_run, clast.merge_results],
    "vary": [clast.vary],
    "calibrate": [clast.calibrate, clast.calibrate_shard],
    "import": [clast.import_results],
    "compare": [clast.compare, clast.Comparison.report],
}
# What is no parameter: an object or a method of its own.
ELSEWHERE = {
    "library": clast.Library.__init__,
    "campaign": clast.Campaign.__init__,
    "file": clast.Campaign.__init__,
    ("show", "json"): clast.Block.to_dict,
    ("show", "report"): clast.Library.report,
    ("classify", "json"): clast.Population.to_dict,
    ("reconstruct", "json"): clast.Block.to_dict,
    ("check", "schema"): clast.campaign_schema,
    ("check", "json"): clast.Campaign.plan,
    ("simulate", "json"): clast.Results.summary,
    ("terrain", "json"): clast.Terrain.report,
    ("calibrate", "json"): clast.Calibration.to_dict,
    ("calibrate", "merge"): clast.calibrate,  # parts
    ("import", "json"): clast.Results.summary,
    ("simulate", "merge"): clast.merge_results,
    ("simulate", "dry_run"): clast.Campaign.dry_run,
    ("terrain", "export"): clast.Terrain.export,
    ("terrain", "export_up"): clast.Terrain.export,  # up
    ("terrain", "export_cell"): clast.Terrain.export,  # cell
    ("terrain", "picture"): clast.Terrain.picture,
    ("terrain", "output"): clast.Terrain.write,
    ("terrain", "json"): clast.Terrain,
    ("export", "output"): clast.Library.export,  # folder
    ("compare", "effects"): clast.Comparison.effects_in_words,
    ("compare", "summary"): clast.Comparison.summary,
    ("library-merge", "output"): clast.Library.__init__,
    ("reconstruct", "scans"): clast.reconstruct_batch,
    ("vary", "from"): clast.vary,  # from_
    ("vary", "json"): clast.vary,  # data
    "help": None,  # help(clast)
}


def options(page):
    """Names of the options of a help text."""
    lines = re.findall(r"^  (-\S+)", page, re.M)
    return sorted({name[2:].replace("-", "_") for line in lines for name in line.split(",") if name.startswith("--")})  # fmt: skip


def help_texts(words=()):
    """The help text of a command and of those below it, by their names: "library-set"."""
    text = program("help", *words)
    found = {"-".join(words): text}
    for part in re.findall(r"^  ([a-z]+) ", text.partition("\nSubcommands:")[2].split("\n\n")[0], re.M):
        found |= help_texts((*words, part))
    return found


@pytest.fixture(scope="module")
def pages():
    texts = help_texts()
    del texts[""]
    return texts


def test_every_command_has_its_calls(pages):
    known = set(CALLS) | {"help", "library", "new"}
    assert set(pages) == known


@pytest.mark.parametrize("command", sorted(CALLS))
def test_every_option_is_a_parameter(pages, command):
    given = {name for call in CALLS[command] for name in inspect.signature(call).parameters}
    found = options(pages[command])
    assert len(found) >= 1
    missing = [
        name
        for name in found
        if name not in given and name not in ELSEWHERE and (command, name) not in ELSEWHERE
    ]
    assert not missing
