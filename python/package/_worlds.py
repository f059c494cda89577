"""Custom simulations: blocks that move step by step."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from clast import _core
from clast._terrain import Terrain

if TYPE_CHECKING:
    import numpy as np

    from clast._blocks import Progress
    from clast._core import Block


class World:
    """Blocks on a terrain, or in empty space, that hit the ground and each other.

    Stiffness and time step are chosen at the first step from all blocks that are known then. Blocks
    that are equal to known ones may be added at any time.

    Args:
        terrain: the ground; default: none.
        ground: parameters of each of its zones, as [ground.NAME] of a campaign:
            {"scree": {"energy_restitution": 0.01, "friction": 0.7, "rolling_friction": 0.2}}.
        between_blocks: the same for contacts between blocks, as [contact.blocks].
        law, weights, stiffness_n_m, tangential_stiffness_n_m, rolling_stiffness_n_m_rad,
            time_step_s: as in [contact] of a campaign.
        gravity_m_s2, rest_energy_j_kg, rest_duration_s: as in [run].
        radius_m: raises the surface of the ground.
        fastest_m_s: upper bound of the speeds, for the stiffness; default: from starts and height of fall.
        threads: number of threads, 0: one per core; the result does not depend on it.
    """

    def __init__(
        self,
        terrain: Terrain | None = None,
        *,
        ground: Mapping[str, Mapping[str, float]] | None = None,
        between_blocks: Mapping[str, float] | None = None,
        law: str | None = None,
        weights: str | None = None,
        stiffness_n_m: float | None = None,
        tangential_stiffness_n_m: float | None = None,
        rolling_stiffness_n_m_rad: float | None = None,
        time_step_s: float | None = None,
        gravity_m_s2: float | None = None,
        rest_energy_j_kg: float | None = None,
        rest_duration_s: float | None = None,
        radius_m: float | None = None,
        fastest_m_s: float | None = None,
        threads: int = 1,
    ) -> None:
        if terrain is not None and not isinstance(terrain, Terrain):
            raise TypeError(f"terrain: must be a clast.Terrain, not {type(terrain).__name__}")
        settings = dict(
            ground=None if ground is None else {k: dict(v) for k, v in ground.items()},
            between_blocks=None if between_blocks is None else dict(between_blocks),
            law=law, weights=weights, stiffness_n_m=stiffness_n_m,
            tangential_stiffness_n_m=tangential_stiffness_n_m,
            rolling_stiffness_n_m_rad=rolling_stiffness_n_m_rad, time_step_s=time_step_s,
            gravity_m_s2=gravity_m_s2, rest_energy_j_kg=rest_energy_j_kg,
            rest_duration_s=rest_duration_s, radius_m=radius_m, fastest_m_s=fastest_m_s,
            threads=threads,
        )  # fmt: skip
        self._experiment = _core.Experiment(None if terrain is None else terrain._data, settings)

    def know(self, block: Block) -> None:
        """Declares a block that will be added after the first step."""
        self._experiment.know(block)

    def add(
        self,
        block: Block,
        position: Any,
        orientation: Any = None,
        *,
        velocity_m_s: Any = None,
        angular_velocity_rad_s: Any = None,
        fixed: bool = False,
    ) -> int:
        """Adds a block, and returns its number.

        Args:
            position: position of the centre of mass, m, on the map of the terrain; (3,).
            orientation: rotation of the block from its pose in the scan: (4,), w x y z, or a matrix (3, 3).
            velocity_m_s, angular_velocity_rad_s: (3,), along the axes of the map.
            fixed: the block does not move.
        """
        start = dict(
            orientation=orientation, velocity_m_s=velocity_m_s,
            angular_velocity_rad_s=angular_velocity_rad_s, fixed=fixed,
        )  # fmt: skip
        return self._experiment.add(block, position, start)

    def remove(self, number: int) -> None:
        """Removes a block; it keeps its number and its last state."""
        self._experiment.remove(number)

    def step(self, count: int = 1) -> None:
        """Advances the world by this number of time steps."""
        self._experiment.step(count)

    def run(self, duration_s: float, progress: Progress | None = None) -> str:
        """Advances the world for this time, or until all blocks are at rest or have left the terrain.

        Returns:
            "rest", "left_terrain" (all blocks have left) or "max_time".
        """
        return self._experiment.run(duration_s, progress)

    @property
    def time_s(self) -> float:
        """Time since the start."""
        return self._experiment.time

    def __len__(self) -> int:
        return len(self._experiment)

    def states(self) -> dict[str, np.ndarray]:
        """States of all blocks by number: position_m (n, 3) of the centre on the map, orientation (n, 4),
        w x y z, world from the frame of the scan, velocity_m_s and angular_velocity_rad_s (n, 3),
        and whether each block is resting, asleep or gone (n,)."""
        return self._experiment.states()

    def contacts(self, number: int) -> dict[str, Any]:
        """Contacts of a block: points, overlap_m, force_n (3,), and the numbers of the touching blocks."""
        return self._experiment.contacts(number)

    def energy(self) -> dict[str, float]:
        """The energy balance, J, by the names of the columns of runs.csv."""
        return self._experiment.energy()

    def contact(self) -> dict[str, Any]:
        """Stiffness and time step that were chosen, by the keys of [contact], and warnings."""
        return self._experiment.contact()
