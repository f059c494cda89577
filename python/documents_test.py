"""Every block of docs/python.md runs."""

import json
import os
import re
import subprocess
from pathlib import Path

import clast
import pytest
from conftest import SOURCE


def blocks(language):
    text = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", text, re.S)


def test_the_python_of_the_document_runs(tmp_path, monkeypatch):
    (tmp_path / "samples").symlink_to(SOURCE / "samples")
    monkeypatch.chdir(tmp_path)
    names = {}
    found = blocks("python")
    assert len(found) >= 5
    for number, code in enumerate(found):
        exec(compile(code, f"docs/python.md, block {number + 1}", "exec"), names)
    assert names["results"].runs.rows == 14  # 7 blocks in 2 orientations
    assert (tmp_path / "report" / "report.html").exists()


def test_the_commands_of_the_document_run(tmp_path):
    build = Path(clast.__file__).resolve().parents[2]
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "release").symlink_to(build)
    environment = {**os.environ, "HOME": str(tmp_path)}
    for code in blocks("sh"):
        done = subprocess.run(
            ["bash", "-euc", code], cwd=tmp_path, env=environment, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        assert done.stdout.strip().endswith(clast.__version__)
    installed = tmp_path / "clast" / "lib" / "python3" / "dist-packages"
    done = subprocess.run(
        ["/usr/bin/python3", "-X", "dev", "-W", "error", "-c", "import clast; print(clast.__file__)"],
        env={**environment, "PYTHONPATH": str(installed)}, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert str(installed) in done.stdout and done.stderr == ""


def test_the_notebook_runs_and_holds_no_outputs(tmp_path, monkeypatch):
    file = SOURCE / "docs" / "notebooks" / "shape_effect.ipynb"
    notebook = json.loads(file.read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in cells)
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setenv("CLAST_SAMPLES", str(SOURCE / "samples"))
    monkeypatch.setenv("CLAST_ORIENTATIONS", "2")
    monkeypatch.chdir(tmp_path)
    names = {}
    for number, cell in enumerate(cells):
        exec(compile("".join(cell["source"]), f"cell {number + 1}", "exec"), names)
    assert (names["folder"] / "shape_effect.pdf").stat().st_size > 1000
    assert set(names["runs"]["shape"]) == {"compact", "elongated"}
