"""From a contact analysis to the ease-off as maps with contour lines; no widget."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_result import FlankContact, FlankPattern
from gearstudio.theory.cones import PairGeometry
from ui.analysis.contact_view import NO_MATE, RASTER, flank_edge, pattern_title
from ui.charts.contours import contour_pairs, round_step
from ui.charts.maps import FlankMap, Line, MapData, Scale
from ui.charts.raster import drawn_flat, frame, inside, raster
from ui.charts.records import Table
from ui.charts.scales import diverging
from ui.formatting import MINUS, significant
from ui.words import tr

Floats = NDArray[np.float64]
LEAST_UM = 1e-3
"""Less than this is rounding and drawn as flat."""


@dataclass(frozen=True)
class EaseOffMaps:
    """Both members' maps, the height of the colours' ends [µm] and the distance of the contours (0: none)."""

    maps: tuple[FlankMap, FlankMap]
    limit_um: float
    step_um: float


def ease_off_heights(side: FlankContact) -> Floats:
    """Gap between the flanks beyond that at the mean point [µm], shape (n_u, n_v); NaN where the mate has no flank."""
    columns = side.ease_off_um.shape[1]
    facing = np.isfinite(side.pinion.gap_um)
    heights = np.where(facing, side.ease_off_um, np.nan)
    inside_rows = np.flatnonzero(facing[:, columns // 2])
    if not inside_rows.size:
        return heights
    middle = inside_rows[len(inside_rows) // 2]
    return np.asarray(heights - heights[middle, columns // 2])


def ease_off_maps(pair: PairGeometry, side: FlankContact) -> EaseOffMaps:
    """The ease-off drawn flat on the pinion's and on the wheel's flank."""
    heights = ease_off_heights(side)
    low, high = (float(end) for end in (np.nanmin(heights, initial=0.0), np.nanmax(heights, initial=0.0)))
    limit = max(abs(low), abs(high), LEAST_UM)
    step = round_step(high - low) if high - low > LEAST_UM else 0.0
    levels = step * np.arange(np.ceil(low / step), np.floor(high / step) + 1) if step else np.empty(0)
    pinion, wheel = (_map(pair, pattern, heights, levels) for pattern in (side.pinion, side.wheel))
    return EaseOffMaps((pinion, wheel), limit, step)


def ease_off_data(made: EaseOffMaps, side: FlankContact) -> MapData:
    """Both maps in one scale."""
    limit = made.limit_um
    return MapData(
        f"ease-off-{side.direction}",
        made.maps,
        lambda image: diverging(image, limit),
        table=lambda: ease_off_table(side),
        scale=Scale(-limit, limit, tr("Ease-off"), lambda value: f"{significant(value)} µm".replace("-", MINUS)),
    )


def ease_off_table(side: FlankContact) -> Table:
    """The heights on both members."""
    heights = ease_off_heights(side)
    rows = [
        (one.member, one.flank, *values)
        for one in (side.pinion, side.wheel)
        for values in zip(one.rho.ravel(), one.delta_deg.ravel(), heights.ravel(), strict=True)
    ]
    return Table(("member", "flank", "rho [mm]", "delta [deg]", "ease-off [µm]"), rows)


def ease_off_words(made: EaseOffMaps) -> str:
    """What the lines are."""
    if not made.step_um:
        return tr("Flat: the flanks are conjugate")
    return tr("Contours every {step} µm; 0 at the mean point", step=significant(made.step_um))


def ease_off_facts(made: EaseOffMaps) -> tuple[tuple[str, str], ...]:
    """The numbers in a line: name and value."""
    if not made.step_um:
        return ((tr("Ease-off"), tr("flat")),)
    return ((tr("Contours"), f"{significant(made.step_um)} µm"),)


def _map(pair: PairGeometry, pattern: FlankPattern, heights: Floats, levels: Floats) -> FlankMap:
    member = pair.member(pattern.member)
    edge = flank_edge(member, pattern.flank)
    x, y = drawn_flat(pattern.rho, np.radians(pattern.delta_deg), member.pitch_angle)
    extent = frame(edge)
    known = np.isfinite(heights)
    image = raster(x, y, np.where(known, heights, 0.0), RASTER, extent)
    beyond = np.nan_to_num(raster(x, y, np.where(known, 0.0, NO_MATE), RASTER, extent), nan=NO_MATE)
    image = np.where(inside(edge, RASTER, extent) & (beyond < 0.5 * NO_MATE), image, np.nan)
    plain, zero = levels[np.abs(levels) > 1e-12], levels[np.abs(levels) <= 1e-12]
    lines = (
        Line(contour_pairs(x, y, heights, plain), "contour", 0.8, pairs=True),
        Line(contour_pairs(x, y, heights, zero), "contour", 2.0, pairs=True),
    )
    return FlankMap(pattern_title(pattern), image, extent, edge, lines, _describe)


def _describe(value: float) -> str:
    return f"{significant(value)} µm".replace("-", MINUS)
