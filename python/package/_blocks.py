"""Blocks from scans and rock masses, and block libraries."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Union

from clast import _core
from clast._core import Block, InputError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

PathLike = Union[str, "os.PathLike[str]"]
Progress = Callable[[dict], Any]


def _several(scans: Any) -> list[str]:
    if isinstance(scans, (str, os.PathLike)):
        return [os.fspath(scans)]
    return [os.fspath(scan) for scan in scans]


def reconstruct(
    scan: Any,
    id: str | None = None,  # noqa: A002
    *,
    join: str | None = None,
    pose: dict[str, Sequence[float]] | None = None,
    picked: PathLike | None = None,
    scale: str | None = None,
    align: bool = False,
    units: str | None = None,
    scale_length: tuple[Sequence[float], Sequence[float], float] | None = None,
    scale_factor: float | None = None,
    up: str | None = None,
    columns: Iterable[str] | None = None,
    ground: str | None = None,
    split: bool = False,
    smallest: float | None = None,
    edits: PathLike | None = None,
    stations: PathLike | None = None,
    labelled: PathLike | None = None,
    any_size: bool = False,
    vertices: int | None = None,
    radius: float | None = None,
    radius_share: float | None = None,
    core: bool = False,
    convex: bool = False,
    density: float | None = None,
    mass: float | None = None,
    accuracy: float | None = None,
    tolerance: float | None = None,
    keep_inner_shells: bool = False,
    scale_bar: Sequence[tuple[int, int, float]] | None = None,
    board: PathLike | None = None,
    marker_size: float | None = None,
    markers: str | None = None,
    allow_unscaled: bool = False,
    model: PathLike | None = None,
    masks: PathLike | None = None,
    colmap: str | None = None,
    colmap_minutes: float | None = None,
    photo_cache: PathLike | None = None,
    progress: Progress | None = None,
) -> Any:
    """Make the block of a scan.

    Args:
        scan: a mesh, a cloud, a .shp file, or a folder of photographs; or arrays in memory,
            (vertices (n, 3), triangles (m, 3)), or points (n, 3), which are not copied in Python.
        id: id of the block; default: the name of the file. Required for arrays.
        join: id of the block that several scans show, in any poses; `scan` is then a list of two to
            eight files or folders of photographs, of which the first gives the frame.
        pose: with `join`: rotations about x, y and z in degrees, right within 30 degrees, that turn
            a scan to the first one, by its name; for blocks that fit in several poses.
        picked: with `join`: table of three or more places that two scans show.
        scale: with `join`: "stored" (default), if all scans have the given units; "free", if only the first
            one has, to estimate the scales of the others.
        align: align strips or passes of one scan that do not fit: those of the point sources of a LAS file
            or between pauses of its recording, otherwise parts that show the same surface at two places.
        units: length unit: "m", "cm", "mm", "km", "in", "ft", or metres per unit as text.
        scale_length: in place of units: two points of the scan and their distance in metres.
        scale_factor: factor on all lengths, applied after units or scale_length.
        up: axis of the scan that points up, "y" or "z".
        columns: names or numbers from 1 of the columns x, y and z of a cloud in text.
        ground: "auto": remove the ground around a block; "none": the scan has no ground.
        split: make all blocks of a deposit, apart or touching, as ID_1, ID_2, ...
        smallest: with `split`: smallest intermediate axis I of a block, m.
        edits: with `split`: file of corrections of the segmentation, as the page of the deposit saves it.
        stations: with `split`: table of the positions of the scanner or the cameras, in the coordinates of the scan.
        labelled: with `split`: PLY file to which the points are written with the block of each.
        any_size: also accept blocks over 20 m, over 10,000 t or under 1 mm.
        vertices: largest number of vertices; default: the smallest number within the tolerance.
        radius: Minkowski radius of the rounding, m; `radius_share`: the same as a fraction of S, 0 to 0.25.
        core: the mesh is the core over which the sphere is swept, and is used unchanged.
        convex: use the convex hull.
        density: kg/m^3.
        mass: weighed mass, kg: sets the density, or checks the volume if `density` is also given.
        accuracy: relative accuracy of volume and inertia, 1e-6 to 1e-2.
        tolerance: largest Hausdorff distance to the scan, as a fraction of L.
        keep_inner_shells: keep closed shells inside a scan as cavities.
        scale_bar, board, marker_size, markers, allow_unscaled, model, masks, colmap,
            colmap_minutes, photo_cache: for folders of photographs, as in `clast reconstruct`.
        progress: called repeatedly with a dict: done, total, before, what.

    Returns:
        The Block; with `split` a list of Blocks.

    Raises:
        InputError, GeometryError: the message names the file or id, the value and the remedy.
    """
    options = dict(
        pose=pose, picked=picked, scale=scale, align=align, units=units, scale_length=scale_length,
        scale_factor=scale_factor, up=up,
        columns=columns, ground=ground, split=split, smallest=smallest, edits=edits,
        stations=stations, labelled=labelled, any_size=any_size,
        vertices=vertices, radius=radius,
        radius_share=radius_share, core=core, convex=convex, density=density, mass=mass,
        accuracy=accuracy, tolerance=tolerance, keep_inner_shells=keep_inner_shells,
        scale_bar=scale_bar, board=board, marker_size=marker_size, markers=markers,
        allow_unscaled=allow_unscaled, model=model, masks=masks, colmap=colmap,
        colmap_minutes=colmap_minutes, photo_cache=photo_cache,
    )  # fmt: skip
    from clast import _reconstruct  # PCL and OpenCV: only now

    if join is not None:
        if id is not None:
            raise InputError("id: `join` names the block; leave it out")
        return _reconstruct.of_joined(_several(scan), join, options, progress)
    if pose is not None or picked is not None or scale is not None:
        raise InputError("pose, picked and scale are for joined scans; give `join`")
    if isinstance(scan, (str, os.PathLike)):
        blocks = _reconstruct.of_scan(os.fspath(scan), id, options, progress)
    else:
        if id is None:
            raise InputError("id: give the block of arrays a name")
        points, triangles = scan if isinstance(scan, tuple) else (scan, None)
        blocks = _reconstruct.of_mesh(points, triangles, id, options, progress)
    return blocks if split else blocks[0]


class Reconstruction(NamedTuple):
    """Result of a batch of scans."""

    library: Library
    added: list[str]  #: ids
    skipped: int  #: scans whose block was there already
    failed: list[tuple[str, str]]  #: scan and reason
    notes: list[str]


def reconstruct_batch(
    scans: PathLike | Iterable[PathLike],
    output: PathLike = "blocks.h5",
    *,
    jobs: int = 1,
    replace: bool = False,
    resume: bool = False,
    report: PathLike | None = None,
    join: str | None = None,
    join_folders: bool = False,
    progress: Progress | None = None,
    **options: Any,
) -> Reconstruction:
    """Make blocks from files or folders of scans, and add them to a library.

    A scan that gives no block does not affect the others; it is listed in `failed` of the result.

    Args:
        scans: files and folders, as in `clast reconstruct`.
        output: the library; blocks are added to an existing library.
        jobs: number of scans processed at the same time; 0: one per core.
        replace: replace blocks whose id is in the library already.
        resume: skip scans whose block is in the library, made from the same file with the same options.
        report: folder for a page about each block.
        join: id of the one block that all scans show.
        join_folders: the scans of each folder show one block, with the name of the folder as its id.
        options: arguments of `reconstruct`.
    """
    from clast import _reconstruct

    done = _reconstruct.batch(
        _several(scans),
        output,
        dict(jobs=jobs, replace=replace, resume=resume, report=report, join=join,
             join_folders=join_folders or None),
        options,
        progress,
    )
    return Reconstruction(
        Library(output), done["added"], done["skipped"], done["failed"], done["notes"]
    )


class Cut(NamedTuple):
    """The blocks of a rock mass."""

    blocks: list[Block]
    volume: float  #: of the mass, m^3
    block_volume: float  #: of the blocks, m^3
    failed: list[str]  #: pieces that became no block, and why


def cut(
    mass: PathLike | None = None,
    joints: str | Sequence[str] | None = None,
    output: PathLike | None = None,
    *,
    before: PathLike | Sequence[PathLike] | None = None,
    after: PathLike | Sequence[PathLike] | None = None,
    min_thickness: float | None = None,
    polygon: PathLike | None = None,
    bodies: str | None = None,
    resolution: float | None = None,
    scar: PathLike | None = None,
    replace: bool = False,
    prefix: str = "J",
    seed: int = 1,
    least_volume: float | None = None,
    most_blocks: int | None = None,
    density: float | None = None,
    radius_share: float | None = None,
    units: str | None = None,
    up: str | None = None,
    threads: int = 0,
    progress: Progress | None = None,
) -> Cut:
    """Cut a rock mass into its blocks by joint sets.

    Args:
        mass: closed mesh, such as a scar; or give before and after.
        joints: joint sets, "DIP/DIP_DIRECTION/SPACING" or with "/SCATTER", in degrees and metres. None,
            with scar: the mass is written without cutting it.
        output: library to which the blocks are added; default: no library is written.
        before, after: terrains before and after the failure; the mass is the volume between them.
        min_thickness: smallest vertical difference of the terrains that counts as rock mass, m.
        polygon: file of polygons; only the mass within them is used.
        bodies: "largest", "all", or numbers in the order of volume, "1,3".
        resolution: cell size of grids to which both terrains are converted first, m.
        scar: file to which the mass between the terrains is written as a closed mesh.
        replace: replace blocks of the same id.
        prefix: prefix of the ids, which are numbered.
        seed: random seed of the joint positions.
        least_volume: pieces smaller than this are left out, m^3.
        most_blocks: largest number of blocks; joints that would cut more are refused.
        density: kg/m^3.
        radius_share: Minkowski radius as a fraction of S, 0 to 0.25.
        units, up: length unit and upward axis of the mesh; up also applies to the terrains.
        threads: number of threads, 0: one for each core; the result does not depend on it.
    """
    options = dict(
        mass=mass, joints=joints, output=output, before=before, after=after,
        min_thickness=min_thickness, polygon=polygon, bodies=bodies, resolution=resolution,
        scar=scar, replace=replace, prefix=prefix, seed=seed,
        least_volume=least_volume, most_blocks=most_blocks, density=density,
        radius_share=radius_share, units=units, up=up, threads=threads,
    )  # fmt: skip
    return Cut(*_core.cut(options, progress))


class Series(NamedTuple):
    """Variants and series of blocks."""

    blocks: list[Block]
    failed: list[str]  #: bodies that could not be made, and why
    data: Any  #: what `clast vary --json` prints


def vary(
    library: PathLike,
    ids: str | Sequence[str] | None = None,
    output: PathLike | None = None,
    *,
    replace: bool = False,
    to: Sequence[tuple[float, float]] | None = None,
    grid: tuple[str, int] | None = None,
    least: float = 0.2,
    like: str | Sequence[str] | None = None,
    convexity: Sequence[float] | None = None,
    rounding: Sequence[float] | None = None,
    roundness: Sequence[float] | None = None,
    roundness_edge: float = 0.05,
    vertices: Sequence[int] | None = None,
    detail: Sequence[float] | None = None,
    degree: int = 6,
    reference: str | Sequence[str] | None = None,
    exponent: float = 4.0,
    inertia: str | Sequence[str] | None = None,
    draw: int | None = None,
    from_: PathLike | None = None,
    units: str | None = None,
    seed: int = 1,
    prefix: str = "V",
    keep: str = "mass",
    threads: int = 0,
    progress: Progress | None = None,
) -> Series:
    """Make variants and series of blocks that differ in one property.

    Args:
        library: a block library, or its file.
        ids: blocks to vary; default: all.
        output: library to which the bodies are added; default: no library is written.
        replace: replace blocks of the same id.
        to: stretch to these ratios, (I/L, S/L).
        grid: stretch to forms all over a diagram: ("sneed-folk", steps) or ("zingg", steps).
        least: smallest S/L of the grid (zingg: smallest I/L and S/I).
        like: stretch to the ratios of these blocks.
        convexity: fill hollows until the volume is this fraction of that of the hull.
        rounding: radius of edges and corners as a fraction of S, 0 to 0.4.
        roundness: round edges and corners to this Wadell roundness, measured on a mesh with edges of
            `roundness_edge` times the diameter of the ball of equal volume.
        vertices: simplify the core to this number of vertices.
        detail: factor on the deviation from the coarse form, given by harmonics up to `degree`.
        reference: simple bodies with the block's ratios, such as "ellipsoid"; `exponent`: exponent of the
            superellipsoid.
        inertia: bodies with the block's mass and principal moments, "ellipsoid" or "box".
        draw: number of bodies with sizes and forms distributed like the blocks, or the table `from_`.
        units: length unit of that table; default: from its header, else m.
        seed, prefix: random seed and id prefix of the drawn bodies.
        keep: quantity that is equal for a body and its block: "mass", "volume" or "L".
        threads: number of threads, 0: one for each core; the result does not depend on it.
    """
    options = dict(
        library=library, ids=ids, output=output, replace=replace, to=to, grid=grid, least=least,
        like=like, convexity=convexity, rounding=rounding, roundness=roundness,
        roundness_edge=roundness_edge, vertices=vertices, detail=detail,
        degree=degree, reference=reference, exponent=exponent, inertia=inertia, draw=draw,
        table=from_, units=units, seed=seed, prefix=prefix, keep=keep, threads=threads,
    )  # fmt: skip
    return Series(*_core.vary(options, progress))


class Library:
    """A block library (HDF5 file), in the state of the last reading.

    It is a sequence of blocks in order of their ids: `library["B017"]`, `len(library)`,
    `for block in library`. The first `add` creates a missing file.
    """

    def __init__(self, path: PathLike) -> None:
        self.path = Path(path)
        self._blocks: list[Block] | None = None
        if self.path.exists():
            self.reload()

    def reload(self) -> None:
        """Reads the file again, since other programs may have changed it."""
        self._blocks = _core.library_read(self.path)

    def _read(self) -> list[Block]:
        if self._blocks is None:
            self.reload()  # says that there is no such file
        return self._blocks  # type: ignore[return-value]

    @property
    def ids(self) -> list[str]:
        """Ids of the blocks, ascending."""
        return [block.id for block in self._read()]

    def __len__(self) -> int:
        return len(self._read())

    def __iter__(self) -> Iterator[Block]:
        return iter(self._read())

    def __contains__(self, id: object) -> bool:  # noqa: A002
        return id in self.ids

    def __getitem__(self, id: str) -> Block:  # noqa: A002
        return self.chosen([id])[0]

    def chosen(self, ids: str | Sequence[str] | None = None) -> list[Block]:
        """The blocks with these ids, in this order; default: all blocks."""
        blocks = self._read()
        if ids is None:
            return list(blocks)
        known = {block.id: block for block in blocks}
        chosen = [ids] if isinstance(ids, str) else list(ids)
        for id in chosen:  # noqa: A001
            if id not in known:
                raise InputError(
                    f"{self.path}: there is no block {id}; there are {', '.join(known) or 'none'}"
                )
        return [known[id] for id in chosen]

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    def __repr__(self) -> str:
        count = "not there yet" if self._blocks is None else f"{len(self._blocks)} blocks"
        return f"<clast.Library {self.path}: {count}>"

    def _repr_html_(self) -> str:
        import base64

        cells = "".join(
            "<td style='text-align:center'><img src='data:image/png;base64,"
            f"{base64.b64encode(block.picture(160, 128)).decode()}'/><br/>{block.id}</td>"
            for block in self._read()[:12]
        )
        return f"<table><tr>{cells}</tr></table>{len(self)} blocks"

    def add(
        self,
        block: Block | Iterable[Block],
        id: str | None = None,  # noqa: A002
        *,
        replace: bool = False,
    ) -> None:
        """Adds one or several blocks to the file; other programs may add blocks at the same time.

        Args:
            id: another name for the block.
            replace: replace a block of the same id, which is refused otherwise.
        """
        blocks = [block] if isinstance(block, Block) else list(block)
        if id is not None:
            if len(blocks) != 1:
                raise InputError(f"id = {id!r} is of one block, and there are {len(blocks)}")
            blocks = [_core.renamed(blocks[0], id)]
        self._blocks = _core.library_add(self.path, blocks, replace)

    def merge(self, inputs: PathLike | Iterable[PathLike], *, replace: bool = False) -> None:
        """Adds the blocks of other libraries."""
        for part in _several(inputs):
            self._blocks = _core.library_add(self.path, _core.library_read(part), replace)

    def remove(self, ids: str | Sequence[str]) -> None:
        """Removes blocks from the file; if one of them is missing, none is removed."""
        self._blocks = _core.library_remove(self.path, [ids] if isinstance(ids, str) else list(ids))

    def set(
        self,
        id: str,  # noqa: A002
        *,
        site: str | None = None,
        note: str | None = None,
        taped: Sequence[float] | None = None,
        weighed: float | None = None,
    ) -> None:
        """Attaches field notes to a block; they change none of its values.

        Args:
            site, note: place of the block, and a note.
            taped: three axes measured by tape, m, in any order.
            weighed: weighed mass, kg.
        """
        notes = dict(site=site, note=note, taped=taped, weighed=weighed)
        self._blocks = _core.library_set(self.path, id, notes)

    def export(
        self,
        folder: PathLike = "export",
        ids: str | Sequence[str] | None = None,
        *,
        format: str | Sequence[str] = "shp",  # noqa: A002
        what: str = "skin",
        segments: int | None = None,
        frame: str = "source",
        up: str = "auto",
        replace: bool = False,
    ) -> list[str]:
        """Writes a file for each block and format, and returns their paths.

        Args:
            ids: blocks to export; default: all.
            format: "shp" (Rockable, ExaDEM), "obj", "stl", "ply", "glb", "vtp", or several.
            what: content of mesh files: "skin", "core", "both", "surface".
            segments: segments per quarter circle of the skin, 1 to 64.
            frame: frame of mesh files: "source" or "principal".
            up: upward axis of mesh files: "z", "y" or "auto".
            replace: replace existing files.
        """
        formats = [format] if isinstance(format, str) else list(format)
        options = dict(
            format=formats, what=what, segments=segments, frame=frame, up=up, replace=replace
        )
        return _core.blocks_export(self.chosen(ids), folder, options)[0]

    def export_particles(
        self,
        folder: PathLike,
        ids: str | Sequence[str] | None = None,
        *,
        to: str,
        error: dict[str, float] | None = None,
        shape: str | None = None,
        max_spheres: int = 400,
        equal_spheres: int | None = None,
        levels: Sequence[float] | None = None,
        smallest_sphere: float = 0.02,
        parts: int | None = None,
        part_vertices: int | None = None,
        hull: bool = False,
        report: PathLike | None = None,
        replace: bool = False,
        threads: int = 0,
        progress: Progress | None = None,
    ) -> list[str]:
        """Writes blocks as particles for another engine, with particles.csv and particles.json.

        A repeated call keeps the files of blocks that are finished and have not changed.

        Args:
            ids: blocks to export; default: all.
            to: engine: "yade", "lammps", "liggghts", "pfc", "edem", "kratos", "chrono",
                "dem-engine", "mjcf", "urdf", "ramms".
            error: largest errors of "volume", "inertia" and "surface"; default: 0.01, 0.02, 0.02.
            shape: "spheres", "parts" (convex) or "polyhedron" (hull); default: by engine.
            max_spheres: largest number of spheres for the error.
            equal_spheres: the same number of spheres for all blocks.
            levels: surface errors; each block is written at each.
            smallest_sphere: smallest radius over L.
            parts: largest number of convex parts; default: 32.
            part_vertices: largest number of vertices of a convex part, 16 or more; default: no limit.
            hull: write the hull of concave blocks, also beyond the error.
            report: folder for a page about each particle and a table of all, particles.html.
            replace: replace an export with other options.
            threads: number of threads, 0: one per core.
            progress: called repeatedly with a dict: done, total, before, what.

        Returns:
            A message for each block that could not be written.
        """
        options = dict(
            to=to,
            error=error,
            shape=shape,
            max_spheres=max_spheres,
            equal_spheres=equal_spheres,
            levels=None if levels is None else list(levels),
            smallest_sphere=smallest_sphere,
            parts=parts,
            part_vertices=part_vertices,
            hull=hull,
            report=report,
            replace=replace,
            threads=threads,
        )
        return _core.blocks_export_particles(self.chosen(ids), folder, options, progress)[2]

    def report(
        self,
        folder: PathLike,
        ids: str | Sequence[str] | None = None,
        *,
        replace: bool = False,
    ) -> str:
        """Writes a gallery of the blocks to a folder, and returns its page."""
        title = f"Blocks of {self.path.name}"
        return _core.blocks_report(self.chosen(ids), title, folder, replace)
