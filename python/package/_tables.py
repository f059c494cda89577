"""Tables as dicts of NumPy arrays."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np

_MOST_ROWS = 20  # of a table that a notebook shows


class Table(dict):
    """A table: NumPy arrays of one length by the names of their columns, as in the program's CSV.

    `pandas.DataFrame(table)` accepts it directly. `units` and `meanings` describe the columns.
    """

    units: dict[str, str]
    meanings: dict[str, str]

    def __init__(
        self,
        values: Mapping[str, np.ndarray],
        units: Mapping[str, str] | None = None,
        meanings: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(values)
        self.units = dict(units or {})
        self.meanings = dict(meanings or {})

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(next(iter(self.values()), ()))

    def __repr__(self) -> str:
        return f"<clast.Table of {self.rows} rows: {', '.join(self)}>"

    def _repr_html_(self) -> str:
        def cells(tag: str, texts: list[str]) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(t)}</{tag}>" for t in texts) + "</tr>"

        shown = min(self.rows, _MOST_ROWS)
        lines = [cells("th", list(self))]
        for row in range(shown):
            values = [column[row] for column in self.values()]
            lines.append(
                cells("td", [f"{v:.6g}" if hasattr(v, "hex") else str(v) for v in values])
            )
        more = f"<p>{shown} of {self.rows} rows</p>" if shown < self.rows else ""
        return f"<table>{''.join(lines)}</table>{more}"


def made(parts: tuple[dict, dict, dict]) -> Table:
    """Makes a table from the values that the extension returns."""
    return Table(*parts)
