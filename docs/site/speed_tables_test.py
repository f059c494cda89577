"""The tables of docs/benchmarks.md are those of the stored measurements."""

import json
import struct
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "benchmarks"))
import speed_measurements  # noqa: E402
import speed_tables  # noqa: E402

RESULTS = json.loads(speed_tables.RESULTS.read_text(encoding="utf-8"))


def test_the_page_states_the_stored_results():
    page = speed_tables.PAGE.read_text(encoding="utf-8")
    assert speed_tables.with_tables(page, RESULTS) == page, "run benchmarks/speed_tables.py"


def test_every_stored_result_is_on_the_page():
    used = set()

    class Recorded(dict):
        def __getitem__(self, name):
            used.add(name)
            return super().__getitem__(name)

        def get(self, name, default=None):
            used.add(name)
            return super().get(name, default)

    results = {**RESULTS, "measurements": Recorded(RESULTS["measurements"])}
    speed_tables.with_tables(speed_tables.PAGE.read_text(encoding="utf-8"), results)
    assert set(RESULTS["measurements"]) == used


def test_a_page_without_one_of_the_tables_is_refused():
    page = speed_tables.PAGE.read_text(encoding="utf-8").replace("<!-- table: boxes -->", "")
    with pytest.raises(ValueError, match="boxes"):
        speed_tables.with_tables(page, RESULTS)


def test_times_have_two_digits_and_a_unit():
    for seconds, text in ((3.26e-6, "3.3 us"), (0.99e-3, "990 us"), (0.0123, "12 ms"), (0.0004, "400 us"), (0.007, "7.0 ms"),
                          (0.25, "0.25 s"), (12.3, "12 s"), (123.4, "120 s"), (2.0, "2.0 s"), (99.6, "100 s"), (1234.0, "1,200 s")):  # fmt: skip
        assert speed_tables.duration(seconds) == text


def test_points_of_a_cloud_lie_at_the_surface_within_the_noise(tmp_path):
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    facets = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    content = b"\0" * 80 + struct.pack("<I", 4)
    for facet in facets:
        content += struct.pack("<12fH", 0, 0, 0, *(value for i in facet for value in corners[i]), 0)
    (tmp_path / "tetrahedron.stl").write_bytes(content)
    speed_measurements.write_noisy_cloud(tmp_path / "tetrahedron.stl", tmp_path / "cloud.xyz", 3000, 0.01)
    lines = (tmp_path / "cloud.xyz").read_text().splitlines()
    assert len(lines) == 3000
    largest = 0.0
    on_slope = 0
    for line in lines:
        x, y, z = map(float, line.split())
        slope = (x + y + z - 1.0) / 3**0.5
        largest = max(largest, min(abs(x), abs(y), abs(z), abs(slope)))
        on_slope += abs(slope) < min(abs(x), abs(y), abs(z))
    assert largest < 0.05
    # The slope has sqrt(3) / (3 + sqrt(3)) of the area.
    assert on_slope / 3000 == pytest.approx(3**0.5 / (3 + 3**0.5), abs=0.04)
