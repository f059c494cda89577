"""The extension that needs PCL and OpenCV; clast.reconstruct loads it."""

from __future__ import annotations

from os import PathLike
from typing import Any, Callable, Sequence

from clast._core import Block

Progress = Callable[[dict[str, Any]], Any] | None

def of_scan(
    scan: str, id: str | None, options: dict[str, Any], progress: Progress
) -> list[Block]: ...
def of_joined(
    scans: Sequence[str], id: str, options: dict[str, Any], progress: Progress
) -> Block: ...
def of_mesh(
    vertices: Any, triangles: Any, id: str, options: dict[str, Any], progress: Progress
) -> list[Block]: ...
def batch(
    scans: Sequence[str],
    output: str | PathLike[str],
    batch: dict[str, Any],
    options: dict[str, Any],
    progress: Progress,
) -> dict[str, Any]: ...
