"""Tooth contact analysis by the explicit azimuth: transmission error, pattern, path of contact (theory 8)."""

from __future__ import annotations

from dataclasses import astuple

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_grid import PinionGrid, pinion_grid
from gearstudio.analysis.contact_path import contact_path
from gearstudio.analysis.contact_placing import MARKING_THICKNESS_UM, FlankMesh, Misalignment, flank_mesh
from gearstudio.analysis.contact_result import DIRECTIONS, ContactResult, Direction, FlankContact, FlankPattern
from gearstudio.analysis.contact_roll import roll
from gearstudio.analysis.ease_off import EaseOff, ease_off, pattern_table
from gearstudio.errors import GeometryError, Issue
from gearstudio.theory.cones import PairGeometry

Floats = NDArray[np.float64]
DEFAULT_POINTS = (60, 100)
DEFAULT_POSITIONS = 40
_ARCSEC = 180 * 3600 / np.pi
_PITCHES = 3
_FINER = 8
_JAM_MM = 1e-6


def contact_analysis(
    pair: PairGeometry,
    misalignment: Misalignment | None = None,
    *,
    thickness_um: float = MARKING_THICKNESS_UM,
    points: tuple[int, int] = DEFAULT_POINTS,
    positions: int = DEFAULT_POSITIONS,
) -> ContactResult:
    """Analyse the contact of a pair, with the micro-geometry of both members.

    Parameters
    ----------
    pair : PairGeometry
    misalignment : Misalignment, optional
    thickness_um : float
        Of the marking compound.
    points : (int, int)
        Of the grid along the profile and along the face.
    positions : int
        Turns of the pinion looked at for one pair of teeth.

    Raises
    ------
    GeometryError
        No contact: at some turn no tooth of the pinion faces a flank of the wheel.
    """
    placed = misalignment or Misalignment()
    if not np.all(np.isfinite([*astuple(placed), thickness_um])):
        raise GeometryError("a misalignment and the thickness of the marking compound must be finite numbers")
    if thickness_um <= 0:
        raise GeometryError(f"a marking compound {thickness_um:.6g} µm thick leaves no mark; use more than 0")
    drive, coast = (one_direction(pair, name, placed, thickness_um, points, positions) for name in DIRECTIONS)
    play = _play(pair, drive, coast)
    return ContactResult(placed, thickness_um, drive, coast, play, tuple(_warnings(play, drive, coast)))


def one_direction(
    pair: PairGeometry,
    direction: Direction,
    misalignment: Misalignment,
    thickness_um: float = MARKING_THICKNESS_UM,
    points: tuple[int, int] = DEFAULT_POINTS,
    positions: int = DEFAULT_POSITIONS,
) -> FlankContact:
    """One direction of `contact_analysis`."""
    mesh = flank_mesh(pair, "concave" if direction == "drive" else "convex", misalignment)
    grid = pinion_grid(mesh, points)
    rolled = roll(grid, positions)
    shared = rolled.shared_lag()
    steps = np.arange(_PITCHES * rolled.per_pitch + 1) - _PITCHES * rolled.per_pitch // 2
    fine = np.arange(_FINER * rolled.per_pitch) * (rolled.pitch / (_FINER * rolled.per_pitch))
    between = np.concatenate([shared, rolled.shared_lag_at(fine)])
    eased = ease_off(grid)
    boundless = eased.gap_um(mesh, rolled)
    gap = np.where(eased.facing, boundless, np.inf)
    touched = gap <= thickness_um
    turns = eased.turn[eased.along & (boundless <= thickness_um)]
    return FlankContact(
        direction=direction,
        turn_deg=np.degrees(steps * (rolled.pitch / rolled.per_pitch)),
        error_arcsec=(shared[steps % rolled.per_pitch] - mesh.play) * _ARCSEC,
        peak_to_peak_arcsec=float(np.ptp(between) * _ARCSEC),
        roll=rolled,
        pinion=_pinion_pattern(grid, gap),
        wheel=_wheel_pattern(mesh, eased, gap),
        ease_off_um=eased.height_um(mesh),
        roll_deg=np.degrees(eased.turn),
        path=contact_path(grid, rolled, eased),
        contact_ratio=float(np.ptp(turns) / rolled.pitch) if turns.size else 0.0,
        pattern_share=float(touched[eased.facing].mean()) if np.any(eased.facing) else 0.0,
        pattern_centre=_centre(grid, touched),
    )


def contact_table(
    pair: PairGeometry, misalignment: Misalignment, side: FlankContact, shape: tuple[int, int]
) -> tuple[Floats, Floats, Floats]:
    """The pattern of one direction on even cone distances and polar angles of the pinion; see `pattern_table`."""
    return pattern_table(flank_mesh(pair, side.pinion.flank, misalignment), side.roll, shape)


def _pinion_pattern(grid: PinionGrid, gap: Floats) -> FlankPattern:
    rho, delta, _ = grid.flank.locate(grid.nodes)
    return FlankPattern("pinion", grid.flank.name, grid.nodes, rho, np.degrees(delta), gap)


def _wheel_pattern(mesh: FlankMesh, eased: EaseOff, gap: Floats) -> FlankPattern:
    met = eased.met
    return FlankPattern("wheel", mesh.wheel_flank.name, mesh.on_wheel(met), met.rho, np.degrees(met.polar_angle), gap)


def _centre(grid: PinionGrid, touched: NDArray[np.bool_]) -> tuple[float, float]:
    if not np.any(touched):
        return 0.5, 0.5
    v = np.broadcast_to(grid.v, grid.u.shape)
    return float(v[touched].mean()), float(grid.u[touched].mean())


def _play(pair: PairGeometry, drive: FlankContact, coast: FlankContact) -> float:
    """Least transverse backlash at the heel's pitch circle while the pair rolls [mm]."""
    wheel = pair.wheel
    backlash = flank_mesh(pair, "concave").play + flank_mesh(pair, "convex").play
    least = np.min(drive.error_arcsec) + np.min(coast.error_arcsec)
    return float((backlash + least / _ARCSEC) * wheel.outer_cone_distance * np.sin(wheel.pitch_angle))


def edge_warnings(*sides: FlankContact) -> list[Issue]:
    """A warning for each direction in which edges touch instead of the flanks' inside."""
    return [
        Issue(
            "edge_contact",
            "",
            f"{side.direction}: the flanks touch on {' and '.join(side.path.edges)}: edge contact; "
            "less misalignment or more crowning avoids it",
            "warning",
        )
        for side in sides
        if side.path.edges
    ]


def _warnings(play: float, *sides: FlankContact) -> list[Issue]:
    found = edge_warnings(*sides)
    if play < -_JAM_MM:
        found.append(
            Issue(
                "jammed",
                "tooth.backlash",
                f"this misalignment takes {-play:.4g} mm of backlash that the pair does not have: the teeth jam; "
                "give more backlash",
                "warning",
            )
        )
    return found
