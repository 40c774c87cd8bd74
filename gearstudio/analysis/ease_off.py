"""Ease-off of a pinion flank from the wheel's conjugate, and the contact pattern that follows from it (theory 8)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_grid import PinionGrid
from gearstudio.analysis.contact_placing import FlankMesh, Meeting
from gearstudio.analysis.contact_roll import Roll

Floats = NDArray[np.float64]

_PROBE = 2e-3
_STEPS = 2
_LONGEST_STEP = 0.03
_LEAST_BEND = 0.05
_LONGER = 0.01
_BESIDE = 1e-5


@dataclass(frozen=True)
class EaseOff:
    """Every pinion point at the turn at which it comes nearest to the wheel's flank; arrays of one shape.

    Attributes
    ----------
    turn : ndarray
        phi_1 [rad].
    lag : ndarray
        Of the wheel when it touches the point there [rad].
    met : Meeting
    facing : ndarray of bool
        Whether the wheel has a flank there.
    along : ndarray of bool
        The same with a face a little longer: toe and heel of the two members do not end on one surface.
    """

    turn: Floats
    lag: Floats
    met: Meeting
    facing: NDArray[np.bool_]
    along: NDArray[np.bool_]

    def height_um(self, mesh: FlankMesh) -> Floats:
        """Metal missing from the conjugate flank, normal to it [µm]; 0 everywhere for the perfect pair."""
        return np.asarray((self.lag - mesh.play) * mesh.lever(self.met.rho) * 1e3)

    def gap_um(self, mesh: FlankMesh, roll: Roll) -> Floats:
        """Least gap while the pair rolls with all teeth in mesh [µm], as if the wheel's flank had no edges."""
        gap = (self.lag - roll.shared_lag_at(self.turn)) * mesh.lever(self.met.rho) * 1e3
        return np.maximum(gap, 0.0)


def ease_off(grid: PinionGrid) -> EaseOff:
    """The ease-off over a pinion grid; arrays of shape (n_u, n_v)."""
    return ease_off_at(grid.mesh, grid.nodes, grid.contact_turn)


def ease_off_at(mesh: FlankMesh, points: Floats, turn: Floats) -> EaseOff:
    """The ease-off of points.

    Parameters
    ----------
    mesh : FlankMesh
    points : ndarray, shape (..., 3)
        Of the pinion flank, in its frame [mm].
    turn : ndarray, shape (...)
        About where they touch [rad]; in the perfect pair exactly there.

    Notes
    -----
    The lag of a point is a smooth valley over the turn; its bottom is found by parabolas. On the base cone it is
    none, for the flank is singular there: such points stay at the turn given.
    """
    pitch = mesh.pair.pinion.pitch
    probe, longest = _PROBE * pitch, _LONGEST_STEP * pitch
    for _ in range(_STEPS):
        before, here, after = (mesh.meet(points, turn + d).lag for d in (-probe, 0.0, probe))
        bend = before - 2 * here + after
        valley = bend > _LEAST_BEND * np.median(bend)
        turn = turn + np.clip(valley * (before - after) / (2 * np.where(valley, bend, 1.0)) * probe, -longest, longest)
    met = mesh.meet(points, turn)
    margin = mesh.least_margin(met)
    along = mesh.least_margin(met, _LONGER * mesh.pair.wheel.face_width)
    return EaseOff(turn, met.lag, met, margin >= -_BESIDE, along >= -_BESIDE)


def pattern_table(mesh: FlankMesh, roll: Roll, shape: tuple[int, int]) -> tuple[Floats, Floats, Floats]:
    """Least gaps on a rectangle of cone distances and polar angles, inside the part of the pinion that meets the wheel.

    Parameters
    ----------
    mesh : FlankMesh
    roll : Roll
    shape : (int, int)
        Numbers of cone distances and polar angles.

    Returns
    -------
    rho : ndarray, shape (n,)
        From R - B to R [mm].
    polar_angle : ndarray, shape (m,)
        From where the wheel's tip begins to reach to the pinion's tip [rad].
    gap_um : ndarray, shape (n, m)
        While the pair rolls with all teeth in mesh [µm].
    """
    pinion, flank = mesh.pair.pinion, mesh.pinion_flank
    first, last = mesh.reach(np.linspace(0.0, 1.0, shape[0]))
    delta = np.linspace(first.max(), last.min(), shape[1])
    rho = np.linspace(pinion.inner_cone_distance, pinion.outer_cone_distance, shape[0])
    psi, distance = flank.natural_at(*np.broadcast_arrays(rho[:, None], delta))
    eased = ease_off_at(mesh, flank.at(psi, distance), mesh.contact_turn(psi, distance))
    return rho, delta, eased.gap_um(mesh, roll)
