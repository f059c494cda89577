import csv
import json

import clast
import pytest
from conftest import SAMPLES, program

TALUS = SAMPLES / "talus.csv"


def same_as_csv(table, file):
    """Is every value of a table the one in a CSV file, to the bit?"""
    with open(file, encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert list(table) == list(rows[0]) if rows else True
    for name, column in table.items():
        assert len(column) == len(rows)
        for value, row in zip(column, rows):
            text = row[name]
            if column.dtype.kind == "U":
                assert value == (text[1:] if text.startswith("'") else text), name
            elif text == "":
                assert value != value, name  # not a number
            else:
                assert value == float(text), name
    return len(rows)


def test_the_tables_are_those_of_the_program(tmp_path, made):
    inputs = [made / "blocks.h5"]
    population = clast.classify(inputs, scheme=["sneed-folk", "garcia"], seed=3)
    program("classify", *inputs, "--scheme", "sneed-folk,garcia", "--seed", "3", "-o", tmp_path / "r")
    for name in ("classes", "shares", "sizes", "tests"):
        assert same_as_csv(getattr(population, name), tmp_path / "r" / f"{name}.csv")


def test_two_populations_are_compared(tmp_path, made):
    population = clast.classify(TALUS, against=made / "blocks.h5")
    assert "kolmogorov-smirnov" in population.tests["test"]
    printed = program("classify", TALUS, "--against", made / "blocks.h5", "--json", "--scheme", "all")
    mine = population.to_dict()
    assert json.loads(printed).keys() == mine.keys()
    page = population.report(tmp_path / "report")
    assert page.endswith("report.html")
    with pytest.raises(clast.InputError):
        population.report(tmp_path / "report")
    population.report(tmp_path / "report", replace=True)


def test_a_table_shows_itself(made):
    shares = clast.classify(made / "blocks.h5", scheme="zingg").shares
    assert shares.rows == 4 and shares.units["mass_kg"] == "kg"
    assert "<table>" in shares._repr_html_() and "4 rows" in repr(shares)


@pytest.mark.parametrize(
    ("keywords", "words"),
    [
        ({"inputs": "missing.csv"}, "missing.csv"),
        ({"inputs": TALUS, "scheme": "round"}, "round"),
        ({"inputs": TALUS, "box": "feret"}, "box"),
        ({"inputs": TALUS, "size": "J"}, "size"),
        ({"inputs": TALUS, "columns": "L=99"}, ""),
        ({"inputs": TALUS, "axis_error": float("nan")}, ""),
        ({"inputs": []}, ""),
    ],
)
def test_what_can_not_be_classified_is_refused(keywords, words):
    with pytest.raises(clast.InputError, match=words):
        clast.classify(**keywords)


def test_wrong_types_are_type_errors():
    with pytest.raises(TypeError, match="inputs"):
        clast.classify(17)
    with pytest.raises(TypeError, match="axis_error"):
        clast.classify(TALUS, axis_error="wide")
    with pytest.raises(TypeError):
        clast.classify(TALUS, schemes="zingg")
