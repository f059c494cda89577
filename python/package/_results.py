"""Results of campaigns, and their comparison."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from clast import _core
from clast._tables import Table, made

if TYPE_CHECKING:
    from collections.abc import Iterable

    from clast._blocks import PathLike, Progress


class _Tables:
    """The tables of `clast compare`, made when they are first asked for."""

    def _comparison(self) -> Any:
        raise NotImplementedError

    def table(self, name: str) -> Table:
        """A table by the name of its file, without ".csv"."""
        kept = self.__dict__.setdefault("_tables", {})
        if name not in kept:
            kept[name] = made(self._comparison().table(name))
        return kept[name]

    @property
    def runs(self) -> Table:
        """A row per run: runs.csv."""
        return self.table("runs")

    @property
    def crossings(self) -> Table:
        """A row per crossing of a barrier: crossings.csv."""
        return self.table("crossings")

    @property
    def impacts(self) -> Table:
        """A row per impact: impacts.csv."""
        return self.table("impacts")

    @property
    def barriers(self) -> Table:
        """A row per barrier and group: barriers.csv."""
        return self.table("barriers")

    @property
    def deposits(self) -> Table:
        """A row per group: deposits.csv."""
        return self.table("deposits")

    @property
    def differences(self) -> Table:
        """A row per pair of groups and quantity: differences.csv."""
        return self.table("differences")

    @property
    def profiles(self) -> Table:
        """A row per group and distance: profiles.csv."""
        return self.table("profiles")

    @property
    def ground_sets(self) -> Table:
        """A row per ground set and zone: ground_sets.csv."""
        return self.table("ground_sets")

    @property
    def effects(self) -> Table:
        """A row per outcome and factor with its fraction of the variance: effects.csv."""
        return self.table("effects")

    @property
    def responses(self) -> Table:
        """A row per outcome and form with mean and standard deviation: responses.csv."""
        return self.table("responses")

    @property
    def trends(self) -> Table:
        """A row per outcome and property of the blocks with its trend: trends.csv."""
        return self.table("trends")

    @property
    def ensemble(self) -> Table:
        """A row per outcome and drawn parameter: ensemble.csv."""
        return self.table("ensemble")

    @property
    def stays(self) -> Table:
        """A row per run with persistent blocks: stays.csv."""
        return self.table("stays")

    @property
    def realisations(self) -> Table:
        """A row per realisation of persistent blocks: realisations.csv."""
        return self.table("realisations")

    @property
    def realisation_figures(self) -> Table:
        """A row per file and figure of its realisations: realisation_figures.csv."""
        return self.table("realisation_figures")

    @property
    def realisation_differences(self) -> Table:
        """A row per pair of files and figure of their realisations: realisation_differences.csv."""
        return self.table("realisation_differences")

    @property
    def passages(self) -> Table:
        """A row per barrier and realisation of persistent blocks: passages.csv."""
        return self.table("passages")

    @property
    def passage_curves(self) -> Table:
        """A row per passage of a block, with cumulative sums over the realisation: passage_curves.csv."""
        return self.table("passage_curves")

    @property
    def energies(self) -> Table:
        """Energies of persistent blocks against time, with dissipation by mechanism: energies.csv."""
        return self.table("energies")

    @property
    def mobility(self) -> Table:
        """A row per pair of a file with persistent blocks and a file with single runs: mobility.csv."""
        return self.table("mobility")

    @property
    def measured(self) -> Table:
        """A row per group with stops observed in the field: measured.csv."""
        return self.table("measured")

    def _repr_html_(self) -> str:
        return self.deposits._repr_html_()


class Results(_Tables):
    """A results file of one campaign."""

    def __init__(self, path: PathLike) -> None:
        self._data = _core.results_read(os.path.abspath(path))

    def _comparison(self) -> Any:
        if "_compared" not in self.__dict__:
            self._compared = _core.compare([self._data], [], None, None)
        return self._compared

    @property
    def path(self) -> str:
        """Path of the file."""
        return self._data.file

    def __fspath__(self) -> str:
        return self.path

    @property
    def campaign_text(self) -> str:
        """The campaign that was run, as TOML."""
        return self._data.campaign_text

    @property
    def inputs(self) -> list[str]:
        """Path and SHA-256 of library, terrain and release files."""
        return self._data.inputs

    @property
    def program_version(self) -> str:
        """Version of clast that computed the runs."""
        return self._data.program_version

    @property
    def engine(self) -> str:
        """Engine that computed the runs: "clast", or "rockable" for imported results, which have no
        contact data."""
        return self._data.engine or "clast"

    @property
    def zone_names(self) -> list[str]:
        """Names of the ground zones."""
        return self._data.zone_names

    @property
    def warnings(self) -> list[str]:
        """Warnings about the results."""
        return self._data.warnings

    @property
    def planned_runs(self) -> int:
        """Number of planned runs of the whole campaign."""
        return self._data.planned_runs

    def summary(self) -> dict[str, Any]:
        """Stop reasons, crossings and energy errors, as in `clast simulate --json`."""
        return self._data.summary()

    def trajectory(self, run: int) -> dict[str, Any]:
        """States of a run against time: time_s (n,), position_m (n, 3) on the map, orientation (n, 4),
        w x y z, world from principal frame, velocity_m_s and angular_velocity_rad_s (n, 3)."""
        return self._data.trajectory(run)

    def __repr__(self) -> str:
        return f"<clast.Results {self.path}>"


class Comparison(_Tables):
    """Comparison of campaigns by block, by shape class and by requested columns."""

    def __init__(self, data: Any) -> None:
        self._data = data

    def _comparison(self) -> Any:
        return self._data

    @property
    def warnings(self) -> list[str]:
        """Warnings about the comparison."""
        return self._data.warnings

    @property
    def answer(self) -> list[str]:
        """Main results of the comparison, in sentences."""
        return self._data.sentences()

    def effects_in_words(self) -> list[str]:
        """Fractions of the variance that are due to form, mass, orientation and release point, and trends
        with the shape of the blocks, in sentences."""
        return self._data.effects()

    def summary(self) -> list[str]:
        """The first screen of the report as lines of text."""
        return self._data.first_screen()

    def report(
        self,
        output: PathLike = "comparison",
        *,
        replace: bool = False,
        animate: int = 0,
        pdf: bool = False,
    ) -> str:
        """Writes tables, map layers and report.html to a folder, and returns the page.

        Args:
            replace: replace an existing comparison in the folder.
            animate: number of runs in animation/animation.pvd, for ParaView.
            pdf: also write report.pdf, with Chromium or Chrome.
        """
        return self._data.write(output, dict(replace=replace, animate=animate, pdf=pdf))[-1]


def compare(
    results: Results | PathLike | Iterable[Results | PathLike],
    *,
    by: str | Iterable[str] = (),
    measured: PathLike | None = None,
    margin: float | None = None,
) -> Comparison:
    """Compare shapes and classes in the results of one or more campaigns.

    Args:
        results: Results of campaigns, or their files.
        by: columns of runs.csv; runs are also grouped by their values.
        measured: table of stops observed in the field.
        margin: largest negligible difference in runout, m.
    """
    several = [results] if isinstance(results, (Results, str, os.PathLike)) else list(results)
    opened = [one if isinstance(one, Results) else Results(one) for one in several]
    columns = [by] if isinstance(by, str) else list(by)
    return Comparison(_core.compare([one._data for one in opened], columns, measured, margin))


def import_results(
    engine: str,
    scenes: PathLike,
    output: PathLike = "results.h5",
    *,
    campaign: PathLike | None = None,
    replace: bool = False,
    progress: Progress | None = None,
) -> Results:
    """Read the results of another engine for scenes written by `Campaign.export`.

    Quantities that are missing in the results are listed in their `warnings`.

    Args:
        engine: "rockable".
        scenes: folder of the scenes, with the conf files of each run in its folder.
        campaign: the campaign file, if it is no longer in its folder.
        replace: replace existing results.
        progress: called repeatedly with a dict: done, total, before, what.
    """
    options = dict(campaign=campaign, replace=replace)
    _core.import_results(engine, os.path.abspath(scenes), output, options, progress)
    return Results(output)


def merge_results(
    parts: Iterable[PathLike], output: PathLike = "results.h5", *, replace: bool = False
) -> Results:
    """Join the results of all shards of a campaign into one file."""
    _core.merge_results([os.fspath(part) for part in parts], output, replace)
    return Results(output)
