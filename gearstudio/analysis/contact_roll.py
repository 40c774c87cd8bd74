"""The roll of one pair of teeth: at every turn of the pinion the place where the flanks touch first (theory 8)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import Akima1DInterpolator

from gearstudio.analysis.contact_grid import PinionGrid, bounded_lag, closer
from gearstudio.analysis.contact_placing import FlankMesh
from gearstudio.errors import GeometryError

Floats = NDArray[np.float64]

_MARGIN = 0.25
_LEAST_PER_PITCH = 4


@dataclass(frozen=True)
class Roll:
    """One pair of teeth rolling through the mesh alone, other teeth away.

    Attributes
    ----------
    turn : ndarray, shape (n,)
        phi_1 [rad], whole multiples of the step.
    lag : ndarray, shape (n,)
        Of the wheel [rad]; infinite where nothing faces anything.
    u, v : ndarray, shape (n,)
        Where they touch on the pinion's flank.
    per_pitch : int
        Steps in one pitch of the pinion.
    pitch : float
        Of the pinion [rad].
    remedy : str
        What to do where no tooth touches.
    """

    turn: Floats
    lag: Floats
    u: Floats
    v: Floats
    per_pitch: int
    pitch: float
    remedy: str

    @property
    def first(self) -> int:
        """Number of the first step."""
        return round(float(self.turn[0] / self.pitch * self.per_pitch))

    def shared_lag(self) -> Floats:
        """Lag with all teeth in mesh, over the steps of the pitch that begins at turn 0, shape (per_pitch,).

        Raises
        ------
        GeometryError
            At some turn no tooth touches.
        """
        lag = np.full(self.per_pitch, np.inf)
        np.minimum.at(lag, (self.first + np.arange(len(self.lag))) % self.per_pitch, self.lag)
        if not np.all(np.isfinite(lag)):
            raise GeometryError(
                f"no contact: at some turn no tooth of the pinion faces a flank of the wheel; {self.remedy}"
            )
        return lag

    def lag_at(self, turn: ArrayLike) -> Floats:
        """Lag of this pair alone between the steps [rad]; infinite outside, shape (...)."""
        finite = np.flatnonzero(np.isfinite(self.lag))
        turn = np.asarray(turn, dtype=np.float64)
        if len(finite) < 2:
            return np.full_like(turn, np.inf)
        curve = Akima1DInterpolator(self.turn[finite], self.lag[finite])
        return np.asarray(np.nan_to_num(np.asarray(curve(turn)), nan=np.inf, posinf=np.inf))

    def shared_lag_at(self, turn: ArrayLike) -> Floats:
        """Lag with all teeth in mesh between the steps [rad], shape (...)."""
        turn = np.asarray(turn, dtype=np.float64)
        low = np.floor((self.turn[0] - turn.max()) / self.pitch)
        high = np.ceil((self.turn[-1] - turn.min()) / self.pitch)
        teeth = np.arange(low, high + 1) * self.pitch
        return np.asarray(self.lag_at(turn[..., None] + teeth).min(axis=-1))


def roll(grid: PinionGrid, positions: int) -> Roll:
    """Roll a pair of teeth through the mesh.

    Parameters
    ----------
    grid : PinionGrid
    positions : int
        About how many turns to look at; their step divides the pitch.
    """
    mesh = grid.mesh
    pitch = mesh.pair.pinion.pitch
    low, high = _window(mesh)
    low, high = low - _MARGIN * pitch, high + _MARGIN * pitch
    per_pitch = max(_LEAST_PER_PITCH, int((positions - 1) * pitch / (high - low)))
    turn = np.arange(np.floor(low / pitch * per_pitch), np.ceil(high / pitch * per_pitch) + 1) * (pitch / per_pitch)
    points = np.ascontiguousarray(grid.nodes.reshape(-1, 3).T).T
    best = np.array([_first_touch(mesh, points, one) for one in turn])
    touched = best >= 0
    row, column = np.divmod(np.maximum(best, 0), len(grid.v))
    u, v, lag = grid.u[row, column], grid.v[column], np.full(len(turn), np.inf)
    u[touched], v[touched], lag[touched] = closer(grid, u[touched], v[touched], turn[touched])
    remedy = "take less misalignment" if mesh.misaligned else "give the pair deeper teeth or a larger overlap"
    return Roll(turn, lag, u, v, per_pitch, pitch, remedy)


def _window(mesh: FlankMesh) -> tuple[float, float]:
    """Turns between which the perfect pair of teeth is in contact [rad]; one pitch wide at least."""
    v = np.linspace(0.0, 1.0, 9)
    start = mesh.start_of_contact(v)
    edges = mesh.pinion_flank.coordinates(np.stack([start, np.ones_like(start)]), v)
    turn = mesh.contact_turn(*edges)
    middle, half = (turn.max() + turn.min()) / 2, max(float(np.ptp(turn)), mesh.pair.pinion.pitch) / 2
    return float(middle - half), float(middle + half)


def _first_touch(mesh: FlankMesh, points: Floats, turn: float) -> int:
    """Index of the point with the least lag at one turn; -1 where the wheel has no flank for any."""
    lag = bounded_lag(mesh, mesh.meet(points, turn))
    index = int(np.argmin(lag))
    return index if np.isfinite(lag[index]) else -1
