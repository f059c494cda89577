"""Terrain: survey files to a checked surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from clast import _core

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np

    from clast._blocks import PathLike


class Terrain:
    """A checked ground surface with zones and its position on the map.

    `vertices` and `triangles` are in a local frame: map = local + `origin`.
    """

    def __init__(self, data: Any) -> None:
        self._data = data

    @property
    def vertices(self) -> np.ndarray:
        """m, local; float64 (n, 3), a view."""
        return self._data.vertices

    @property
    def triangles(self) -> np.ndarray:
        """Indices; uint32 (m, 3), a view."""
        return self._data.triangles

    @property
    def zones(self) -> np.ndarray:
        """Zone of each triangle, as an index into `zone_names`; uint16 (m,), a view."""
        return self._data.zones

    @property
    def zone_names(self) -> list[str]:
        """Names of the ground zones."""
        return self._data.zone_names

    @property
    def origin(self) -> np.ndarray:
        """Origin of the local frame on the map, m; float64 (3,)."""
        return self._data.origin

    @property
    def crs(self) -> str:
        """Coordinate system of the map, "EPSG:2154" or WKT; empty if the input names none."""
        return self._data.crs

    @property
    def sources(self) -> list[str]:
        """Path and SHA-256 of every input file."""
        return self._data.sources

    @property
    def report(self) -> dict[str, Any]:
        """What was found and repaired: counts, and `notes` in words."""
        return self._data.report()

    def height(self, x: Any, y: Any) -> np.ndarray:
        """Heights of the uppermost ground at positions on the map, m; nan outside the ground."""
        return self._data.heights(x, y)

    def check_fit(
        self,
        release: Any = None,
        *,
        border_distance: float | None = None,
        block_size: float | None = None,
        up: str = "z",
    ) -> list[str]:
        """Warnings about release points and about the size of the blocks.

        Args:
            release: release points (n, 3) on the map, or a file; points off the ground are refused.
            border_distance: warn if a release point is nearer than this to the border, m.
            block_size: diameter of the blocks, m.
            up: axis of a file that points up.
        """
        return self._data.check_fit(
            dict(release=release, border_distance=border_distance, block_size=block_size, up=up)
        )

    def write(self, output: PathLike, *, replace: bool = False) -> None:
        """Writes a terrain file (.h5), which a campaign names as its surface."""
        self._data.write(output, replace)

    def export(
        self, path: PathLike, *, up: str = "auto", cell: float = 0.5, replace: bool = False
    ) -> None:
        """Writes the surface for viewing: stl, ply, obj, vtp, glb or tif (with `cell`, m)."""
        self._data.export(path, up, cell, replace)

    def picture(
        self,
        path: PathLike,
        *,
        release: Any = None,
        barriers: PathLike | None = None,
        up: str = "z",
        replace: bool = False,
    ) -> None:
        """Draws a map (svg) with shaded relief, zones, release points and barriers."""
        options = dict(release=release, barriers=barriers, up=up, replace=replace)
        self._data.draw(path, options)

    def __repr__(self) -> str:
        return f"<clast.Terrain of {len(self.triangles)} triangles: {', '.join(self.zone_names)}>"


def terrain(
    inputs: PathLike | Iterable[PathLike],
    *,
    zones: str | Iterable[str] | None = None,
    up: str | None = None,
    columns: Iterable[str] | None = None,
    resolution: float | None = None,
    percentile: float | None = None,
    outliers: float | None = None,
    fill: float | None = None,
    breaklines: PathLike | Iterable[PathLike] | None = None,
    crack: float | None = None,
    spikes: float | None = None,
    smoothing: int | None = None,
    tolerance: float | None = None,
    cut_zones: bool = False,
) -> Terrain:
    """Read and check a surveyed terrain.

    Args:
        inputs: meshes, one raster, clouds, or one terrain file.
        zones: a name for each mesh; a raster of class numbers, "zones.asc:1=blue,2=gray"; a file of
            polygons; or rules, "rock=slope>60,soil=else".
        up: axis that points up: "y", "z" or "auto".
        columns: names or numbers from 1 of the columns x, y and z of clouds in text.
        resolution: cell size for clouds and resampled rasters, m.
        percentile: percentile of the heights in a cell of a cloud; default: their mean.
        outliers: points of a cloud farther than this from the ground are left out, m.
        fill: holes up to this width are filled, m.
        breaklines: files of lines that become edges.
        crack: cracks between tiles up to this width are closed, m; 0: none.
        spikes: vertices that protrude by more than this many times the distance to their neighbours
            are levelled; 0: none.
        smoothing: number of smoothing passes.
        tolerance: vertices are removed as long as the surface stays within this height, m.
        cut_zones: the borders of zone polygons are cut into the triangles.
    """
    return Terrain(
        _core.terrain_read(
            dict(
                inputs=inputs, zones=zones, up=up, columns=columns, resolution=resolution,
                percentile=percentile, outliers=outliers, fill=fill, breaklines=breaklines, crack=crack, spikes=spikes,
                smoothing=smoothing, tolerance=tolerance, cut_zones=cut_zones,
            )  # fmt: skip
        )
    )
