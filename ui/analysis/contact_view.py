"""From a contact analysis to maps, a chart and words; no widget."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_result import ContactResult, Direction, FlankContact, FlankPattern
from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.flank import FlankName
from gearstudio.theory.modified import flank_of
from ui.charts.raster import drawn_flat, frame, inside, outline, points_flat, raster
from ui.charts.records import Axis, ChartData, Reference, Series, Table
from ui.formatting import MEMBER_TITLES, fixed, significant
from ui.units import small_text
from ui.words import tr

Floats = NDArray[np.float64]
RASTER = (72, 220)
NO_MATE = 1e9
"""Stands for the gap where the mate has no flank [µm]."""
LEAST_SPAN_ARCSEC = 0.01
"""Less of a transmission error than this is not blown up to the height of the chart."""
LEAST_PLAY_MM = 1e-4
"""Less backlash than this is none."""


@dataclass(frozen=True)
class PatternMap:
    """The gap on a member's flank, brought to a raster; the path of contact as a polyline (n, 2)."""

    title: str
    image: Floats
    extent: tuple[float, ...]
    outline: Floats
    path: Floats


def patterns(pair: PairGeometry, side: FlankContact) -> tuple[PatternMap, PatternMap]:
    """The pattern of one direction on the pinion's and on the wheel's flank."""
    return (
        _pattern(pair, side.pinion, side.path.pinion_points),
        _pattern(pair, side.wheel, side.path.wheel_points),
    )


@lru_cache(maxsize=16)
def flank_edge(member: MemberGeometry, name: FlankName) -> Floats:
    """The border of a flank drawn flat, shape (n, 2)."""
    grid = flank_of(member, name).points(*np.ix_(np.linspace(0, 1, 9), np.linspace(0, 1, 25)))
    return outline(*points_flat(grid, member.pitch_angle))


def pattern_title(pattern: FlankPattern) -> str:
    """Member and flank."""
    return tr("{member}, {flank} flank", member=tr(MEMBER_TITLES[pattern.member]), flank=tr(pattern.flank))


def _pattern(pair: PairGeometry, pattern: FlankPattern, path: Floats) -> PatternMap:
    member = pair.member(pattern.member)
    edge = flank_edge(member, pattern.flank)
    x, y = drawn_flat(pattern.rho, np.radians(pattern.delta_deg), member.pitch_angle)
    gap = np.where(np.isfinite(pattern.gap_um), pattern.gap_um, NO_MATE)
    extent = frame(edge)
    image = np.nan_to_num(raster(x, y, gap, RASTER, extent), nan=NO_MATE)
    return PatternMap(
        pattern_title(pattern),
        np.where(inside(edge, RASTER, extent), image, np.nan),
        extent,
        edge,
        np.stack(points_flat(path, member.pitch_angle), axis=-1),
    )


def error_chart(side: FlankContact) -> ChartData:
    """Transmission error over three pitches."""
    turn, error = side.turn_deg, side.error_arcsec
    middle, half = float(error.max() + error.min()) / 2, LEAST_SPAN_ARCSEC / 2
    pitch = float(np.degrees(side.roll.pitch))
    return ChartData(
        name=f"transmission-error-{side.direction}",
        x=Axis(tr("Turn of the pinion"), "°"),
        y=Axis(tr("Transmission error"), "arcsec"),
        series=(Series(tr("Transmission error"), turn, error, side.direction, width=2.0),),
        references=tuple(Reference(step * pitch, "", "faint", upright=True) for step in (-1, 0, 1)),
        span_y=(middle - half, middle + half),
    )


def pattern_table(side: FlankContact) -> Table:
    """The pattern's numbers on both members."""
    rows = [
        (one.member, one.flank, *values)
        for one in (side.pinion, side.wheel)
        for values in zip(one.rho.ravel(), one.delta_deg.ravel(), one.gap_um.ravel(), strict=True)
    ]
    return Table(("member", "flank", "rho [mm]", "delta [deg]", "gap [µm]"), rows)


def facts(result: ContactResult, direction: Direction) -> tuple[tuple[str, str], ...]:
    """The numbers in a line: name and value."""
    side = result.direction(direction)
    peak = side.peak_to_peak_arcsec
    return (
        (tr("Peak to peak"), f"{significant(peak)}″" if peak >= 1e-4 else "<\u202f10⁻⁴″"),
        (tr("Contact ratio"), fixed(side.contact_ratio, 2)),
        (tr("Pattern"), f"{fixed(100 * side.pattern_share, 0)} %"),
        (tr("Backlash"), _backlash(result.play_mm)),
    )


def _backlash(play_mm: float) -> str:
    if np.isnan(play_mm):
        return "…"
    return small_text(play_mm if abs(play_mm) > LEAST_PLAY_MM else 0.0)
