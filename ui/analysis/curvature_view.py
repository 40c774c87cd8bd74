"""Curvature of the modelled flanks as maps, as the paper's Fig. 11, and its difference to theory; no widget."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.curvature import CurvatureMap, curvature_difference, surface_curvature
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.modified import flank_of
from ui.charts.maps import FlankMap, MapData, Scale
from ui.charts.raster import frame, inside, outline, points_flat, raster
from ui.charts.records import Table
from ui.charts.scales import diverging, sequential
from ui.formatting import METHOD_TITLES, number
from ui.session import Key
from ui.units import per_length
from ui.words import told, tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult

Floats = NDArray[np.float64]

QUANTITIES = (
    ("gaussian", "Gaussian", "1/mm²"),
    ("mean", "Mean", "1/mm"),
    ("largest", "Largest principal", "1/mm"),
    ("smallest", "Smallest principal", "1/mm"),
)
UNITS = {name: unit for name, _, unit in QUANTITIES}
GRID = (33, 61)
INSET = 0.02
"""Part of the profile left out at the root, where a flank that starts on the base cone has infinite curvature."""
RASTER = (64, 180)
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
TYPICAL = (2.0, 98.0)
"""Percentiles that the colours reach from and to."""


@dataclass(frozen=True)
class Wanted:
    """Which curvature of which flank; with ``difference`` that of the model less that of theory."""

    flank: str
    quantity: str = "gaussian"
    difference: bool = False


def curvature_maps(
    results: Mapping[Key, VariantResult], keys: tuple[Key, ...], member: MemberGeometry, wanted: Wanted
) -> tuple[MapData, str]:
    """A map for each result that is there, all coloured alike; and why there is none, if so."""
    flank = flank_of(member, "concave" if wanted.flank == "concave" else "convex")
    found = {key.method: _curvature(results[key], flank, wanted) for key in keys if key in results}
    good = {method: one for method, one in found.items() if isinstance(one, CurvatureMap)}
    name = f"curvature-{member.name}-{wanted.flank}-{wanted.quantity}{'-difference' * wanted.difference}"
    refused = "; ".join(f"{tr(METHOD_TITLES[m])}: {one}" for m, one in found.items() if isinstance(one, str))
    if not good:
        return MapData(name), refused or tr("The methods are being built…")
    values = {method: np.asarray(getattr(one, wanted.quantity)) for method, one in good.items()}
    low, high = np.percentile(np.concatenate([value.ravel() for value in values.values()]), TYPICAL)
    limit = max(abs(low), abs(high))
    unit = UNITS[wanted.quantity]
    shown, factor = per_length(unit)
    maps = tuple(_drawn(member, tr(METHOD_TITLES[m]), good[m].points, values[m] * factor, shown) for m in good)
    low, high, limit = low * factor, high * factor, limit * factor
    data = MapData(
        name,
        maps,
        (lambda image: diverging(image, limit)) if wanted.difference else (lambda image: sequential(image, low, high)),
        across=True,
        scale=Scale(*((-limit, limit) if wanted.difference else (low, high)), _title(wanted), power_of_ten),
        table=lambda: _table(good, values, unit),
    )
    return data, refused


def power_of_ten(value: float) -> str:
    """A small number as people write it: ``−1.47·10⁻⁴``."""
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.2e}".split("e")
    return f"{number(float(mantissa), '.2f')}·10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def _title(wanted: Wanted) -> str:
    title = tr(next(title for name, title, _ in QUANTITIES if name == wanted.quantity))
    unit, _ = per_length(UNITS[wanted.quantity])
    if wanted.difference:
        return tr("{title} curvature less theory [{unit}]", title=title, unit=unit)
    return tr("{title} curvature [{unit}]", title=title, unit=unit)


def _curvature(result: VariantResult, flank: Flank, wanted: Wanted) -> CurvatureMap | str:
    surface = result.flanks[wanted.flank].surface
    u0, u1, v0, v1 = surface.bounds
    u = np.linspace(u0 + INSET * (u1 - u0), u1, GRID[0])
    v = np.linspace(v0, v1, GRID[1])
    try:
        return (curvature_difference if wanted.difference else surface_curvature)(surface, flank, u, v)
    except GeometryError as error:
        return told(error)


def _drawn(member: MemberGeometry, title: str, points: Floats, values: Floats, unit: str) -> FlankMap:
    x, y = points_flat(points, member.pitch_angle)
    edge = outline(x, y)
    extent = frame(edge)
    image = np.where(inside(edge, RASTER, extent), raster(x, y, values, RASTER, extent), np.nan)
    span = f"{power_of_ten(float(values.min()))} … {power_of_ten(float(values.max()))}"
    return FlankMap(f"{title}: {span}", image, extent, edge, describe=lambda value: f"{power_of_ten(value)} {unit}")


def _table(maps: Mapping[str, CurvatureMap], values: Mapping[str, Floats], unit: str) -> Table:
    rows = [
        (method, *point, value)
        for method, one in maps.items()
        for point, value in zip(one.points.reshape(-1, 3), values[method].ravel(), strict=True)
    ]
    return Table(("method", "x [mm]", "y [mm]", "z [mm]", f"curvature [{unit}]"), rows)
