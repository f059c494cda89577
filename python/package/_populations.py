"""Populations of blocks and their shape classes."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

from clast import _core
from clast._tables import Table, made

if TYPE_CHECKING:
    from collections.abc import Iterable

    from clast._blocks import PathLike


class Population:
    """Result of `classify`: tables, sentences and a report."""

    def __init__(self, data: Any) -> None:
        self._data = data

    @property
    def classes(self) -> Table:
        """A row per block: axes, classes and indices."""
        return made(self._data.table("classes"))

    @property
    def shares(self) -> Table:
        """A row per scheme and class: fractions with their 95 % intervals."""
        return made(self._data.table("shares"))

    @property
    def sizes(self) -> Table:
        """A row per quantity of the size distributions."""
        return made(self._data.table("sizes"))

    @property
    def tests(self) -> Table:
        """A row per statistical test, with a sentence to quote."""
        return made(self._data.table("tests"))

    @property
    def words(self) -> str:
        """The summary that the program prints below the table of blocks."""
        return self._data.words()

    @property
    def notes(self) -> list[str]:
        """Notes on the inputs."""
        return self._data.notes()

    def to_dict(self) -> dict[str, Any]:
        """All results, as printed by `clast classify --json`."""
        return json.loads(self._data.json())

    def report(self, output: PathLike, *, replace: bool = False) -> str:
        """Writes report.html, tables (csv) and diagrams (svg) to a folder; returns the page."""
        self._data.write(output, replace)
        return os.path.join(output, "report.html")

    def _repr_html_(self) -> str:
        return self.shares._repr_html_()


def classify(
    inputs: PathLike | Iterable[PathLike],
    against: PathLike | Iterable[PathLike] | None = None,
    *,
    scheme: str | Iterable[str] | None = None,
    box: str | None = None,
    axis_error: float | None = None,
    thirds: bool = False,
    erdogan_limit: float | None = None,
    roundness: float | None = None,
    columns: str | None = None,
    units: str | None = None,
    against_columns: str | None = None,
    against_units: str | None = None,
    size: str = "I",
    seed: int = 1,
) -> Population:
    """Determine the shape classes of blocks, from libraries or tables of L, I, S.

    Args:
        inputs: libraries, or text tables of tape-measured axes; several inputs form one population.
        against: a second population to compare with.
        scheme: names from `clast.schemes`; default: all.
        box: box whose sides are L, I, S: "smallest", "inertia", "feret", "pca".
        axis_error: error of the axes, m.
        thirds: use the limits 1/3 and 2/3 of Sneed & Folk instead of 0.33 and 0.67.
        erdogan_limit: ratio at which two axes count as different (scheme erdogan).
        roundness: edge length of the triangles, m: also computes Wadell's roundness, see `to_dict`.
        columns: columns of a table, "L=..,I=..,S=..", by name or number from 1; also mass=.. and name=..
        units: length unit of a table.
        against_columns, against_units: the same for the second population; default: as for the first.
        size: "I", the sieve axis, or "mean", (L I S)^(1/3).
        seed: seed of the random samples for p-values.
    """
    return Population(
        _core.classify(
            dict(
                inputs=inputs, against=against, scheme=scheme, box=box, axis_error=axis_error,
                thirds=thirds, erdogan_limit=erdogan_limit, roundness=roundness, columns=columns,
                units=units, against_columns=against_columns, against_units=against_units,
                size=size, seed=seed,
            )  # fmt: skip
        )
    )
