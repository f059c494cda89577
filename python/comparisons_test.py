import clast
import numpy as np
import pytest
from conftest import program
from populations_test import same_as_csv

TABLES = [
    "runs", "barriers", "crossings", "deposits", "impacts", "ground_sets", "effects", "ensemble", "stays",
    "realisations", "realisation_figures", "realisation_differences", "passages",
    "passage_curves", "energies", "mobility", "differences", "profiles",
]  # fmt: skip


@pytest.fixture(scope="module")
def results(made):
    return clast.Campaign(made / "campaign.toml").run(made / "compared.h5", replace=True)


def test_every_table_is_the_programs_to_the_bit(results, tmp_path):
    comparison = clast.compare(results, by="orientation")
    program("compare", results.path, "--by", "orientation", "-o", tmp_path / "report")
    for name in TABLES:
        same_as_csv(getattr(comparison, name), tmp_path / "report" / f"{name}.csv")
    assert same_as_csv(results.runs, tmp_path / "report" / "runs.csv") == 6
    assert comparison.runs.units["stop_x_m"] == "m"
    assert comparison.runs.meanings["run"]


def test_pandas_takes_a_table_as_it_is(results):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(results.runs)
    assert len(frame) == 6 and list(frame.columns) == list(results.runs)


def test_a_report_is_written_as_the_program_writes_it(results, tmp_path):
    page = clast.compare(results, by=["shape"]).report(tmp_path / "py")
    program("compare", results.path, "--by", "shape", "-o", tmp_path / "prog")
    assert page == str(tmp_path / "py" / "report.html")
    for file in sorted((tmp_path / "prog").glob("*.csv")):
        assert (tmp_path / "py" / file.name).read_bytes() == file.read_bytes()
    comparison = clast.compare(results)
    with pytest.raises(clast.InputError):
        comparison.report(tmp_path / "py")
    comparison.report(tmp_path / "py", replace=True, animate=2)
    assert (tmp_path / "py" / "animation" / "animation.pvd").exists()


def test_the_answer_is_what_the_program_prints(results):
    printed = program("compare", results.path, "--summary")
    assert printed.splitlines() == clast.compare(results).summary()
    assert clast.compare(results).answer


def test_results_say_where_they_are_from(results):
    assert results.zone_names == ["blue", "gray", "red"]
    assert results.planned_runs == 6 and results.program_version == clast.__version__
    assert sum(results.summary()["stop_reasons"].values()) == 6
    path = results.trajectory(0)
    assert path["position_m"].shape == (len(path["time_s"]), 3)
    assert np.allclose(np.linalg.norm(path["orientation"], axis=1), 1.0)
    assert path["position_m"][0] == pytest.approx([2.3, 80.0, 209.5])
    with pytest.raises(clast.InputError):
        results.trajectory(600)
    with pytest.raises(TypeError):
        results.trajectory(-1)


def test_what_can_not_be_compared_is_refused(results, tmp_path, made):
    with pytest.raises(clast.InputError, match="colour"):
        clast.compare(results, by="colour")
    with pytest.raises(clast.InputError, match="same runs"):
        clast.compare([results, results.path])
    with pytest.raises(clast.InputError):
        clast.compare([])
    with pytest.raises(clast.InputError, match="missing.h5"):
        clast.compare(tmp_path / "missing.h5")
    with pytest.raises(clast.InputError):
        clast.Results(made / "blocks.h5")
    with pytest.raises(clast.InputError, match="stops.csv"):
        clast.compare(results, measured=tmp_path / "stops.csv")
    with pytest.raises(clast.InputError, match="is no table"):
        results.table("colours")
