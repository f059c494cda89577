"""Ground parameters from observations."""

from __future__ import annotations

import copy
import html
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from clast import _core
from clast._tables import Table, made

if TYPE_CHECKING:
    from clast._blocks import PathLike, Progress


class Calibration:
    """Result of `calibrate`."""

    def __init__(self, page: str, draws: Table, found: dict[str, Any]) -> None:
        self._page = page
        self._draws = draws
        self._found = found

    @property
    def path(self) -> str:
        """Path of the posterior file, for [ensemble] posterior of a campaign."""
        return self._found["file"]

    def __fspath__(self) -> str:
        return self.path

    @property
    def page(self) -> str:
        """Path of the HTML page in the same folder."""
        return self._page

    @property
    def posterior(self) -> Table:
        """Draws of equal weight: an array for each unknown, named as in the study, such as
        "ground.scree.friction", in its unit, and log_likelihood."""
        return self._draws

    @property
    def unknowns(self) -> list[dict[str, Any]]:
        """Range, median and 95 % interval of each unknown, and whether it is determined."""
        return copy.deepcopy(self._found["unknowns"])

    @property
    def figures(self) -> list[dict[str, Any]]:
        """Observed and predicted value of each statistic, and its sensitivity to the unknowns."""
        return copy.deepcopy(self._found["figures"])

    @property
    def answer(self) -> str:
        """Which parameters the observations determine, in a sentence."""
        return self._found["answer"]

    @property
    def findings(self) -> list[str]:
        """Results of the checks of fit and prediction, and other findings, in sentences."""
        return list(self._found["findings"])

    @property
    def ground(self) -> str:
        """Tables [ground.NAME] for campaigns, with the medians found."""
        return self._found["ground"]

    def to_dict(self) -> dict[str, Any]:
        """All results except the draws, as `clast calibrate --json` prints it."""
        return copy.deepcopy(self._found)

    def __repr__(self) -> str:
        return f"<clast.Calibration {self.path}: {self.answer}>"

    def _repr_html_(self) -> str:
        return f"<p>{html.escape(self.answer)}</p>{self.posterior._repr_html_()}"


def calibrate(
    study: PathLike,
    output: PathLike = "posterior.h5",
    *,
    threads: int = 0,
    resume: bool = False,
    replace: bool = False,
    parts: Sequence[PathLike] = (),
    progress: Progress | None = None,
) -> Calibration:
    """Estimate ground parameters from field observations, with their uncertainty.

    Ctrl-C stops after the current member; simulated members are kept, and `resume=True` continues.

    Args:
        study: a study file.
        output: posterior file; a page is written beside it, with the extension .html.
        threads: number of threads, 0: one for each core; the result does not depend on it.
        resume: reuse the simulated members of an interrupted calibration, or of one with other
            observations.
        replace: replace an existing posterior.
        parts: files of all shards; their members are used instead of simulating them.
        progress: called repeatedly with a dict: done, total, before, what.
    """
    options = dict(
        threads=threads, resume=resume, replace=replace, parts=[os.fspath(part) for part in parts]
    )
    page, draws, found = _core.calibrate(study, output, options, progress)
    return Calibration(page, made(draws), found)


def calibrate_shard(
    study: PathLike,
    output: PathLike = "posterior.h5",
    *,
    shard: tuple[int, int],
    threads: int = 0,
    resume: bool = False,
    replace: bool = False,
    progress: Progress | None = None,
) -> str:
    """Simulate a part of the members of a calibration, for `calibrate` to join as `parts`.

    Args:
        study, threads, resume, replace, progress: as in `calibrate`.
        output: name of the file, which gets ".2of4" before its extension.
        shard: (i, n): simulate only every n-th member, starting with the i-th.

    Returns:
        The path of the file, which has no posterior.
    """
    options = dict(threads=threads, resume=resume, replace=replace)
    return _core.calibrate_shard(study, output, shard, options, progress)


def check_calibration(study: PathLike) -> list[str]:
    """List of all errors in a study file, as printed by `clast check`; empty without errors."""
    return _core.check_calibration(study)


def calibration_schema() -> dict[str, Any]:
    """The JSON Schema of study files, as `clast check --schema study` prints it."""
    return _core.calibration_schema()
