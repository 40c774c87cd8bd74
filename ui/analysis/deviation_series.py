"""From the results of a session to charts of deviations; no widget."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import METHOD_IDS, PAPER_MEANS_UM, PAPER_RANGE_UM, VARIANTS
from ui.charts.records import (
    Axis,
    Band,
    ChartData,
    Entry,
    Reference,
    Series,
    micrometre_tick,
    orders_apart,
    plain,
)
from ui.formatting import METHOD_TITLES, VARIANT_TITLES, shortcoming
from ui.session import Key
from ui.words import inline, tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult

Floats = NDArray[np.float64]


PATHS = (
    ("grid", "Point series", "7 × 7 points inside the flank: root to tip, then on towards the heel"),
    ("face", "Toe – heel", "Along the face, at half the depth of the flank"),
    ("profile", "Root – tip", "Along the profile, at the middle of the face"),
)
STROKES = {"published": "dash", "optimised": "solid"}
LEAST_UM = 1e-5
"""A logarithmic scale ends here; less is rounding."""
GRID = 7
BINS = 40


@dataclass(frozen=True)
class Choice:
    """What the chart is about: member, flank, path, methods and whether the paper's figures are drawn."""

    member: str
    flank: str
    path: str = "grid"
    paper: bool = True
    log: bool | None = None


def along(deviation_um: Floats, path: str) -> tuple[Floats, Floats]:
    """Places and absolute deviations along a path over a map of shape (n_u, n_v)."""
    n_u, n_v = deviation_um.shape
    size = np.abs(deviation_um)
    if path == "face":
        return np.linspace(0.0, 1.0, n_v), size[n_u // 2]
    if path == "profile":
        return np.linspace(0.0, 1.0, n_u), size[:, n_v // 2]
    inside = (np.arange(GRID) + 0.5) / GRID
    rows, columns = (np.rint(inside * (count - 1)).astype(int) for count in (n_u, n_v))
    return np.arange(1.0, GRID**2 + 1), size[np.ix_(rows, columns)].T.ravel()


def deviation_chart(results: Mapping[Key, VariantResult], choice: Choice) -> ChartData:
    """Deviation along a series of points, as the paper's Fig. 12, for every method and variant that is there."""
    found = _found(results, choice)
    curves = {key: along(result.flanks[choice.flank].deviation_um, choice.path) for key, result in found.items()}
    logarithmic = choice.log if choice.log is not None else orders_apart([y for _, y in curves.values()])
    series = tuple(
        Series(
            f"{tr(METHOD_TITLES[key.method])}, {tr(key.variant)}",
            x,
            np.maximum(y, LEAST_UM) if logarithmic else y,
            key.method,
            STROKES[key.variant],
            symbols=choice.path == "grid",
        )
        for key, (x, y) in curves.items()
    )
    title = {"grid": tr("Point"), "face": tr("Place along the face"), "profile": tr("Place along the profile")}[
        choice.path
    ]
    ends = {"face": (tr("toe"), tr("heel")), "profile": (tr("root"), tr("tip"))}.get(choice.path)
    ticks = None if ends is None else [(0, ends[0]), (0.25, "¼"), (0.5, "½"), (0.75, "¾"), (1, ends[1])]
    return ChartData(
        name=f"deviation-{choice.member}-{choice.flank}-{choice.path}",
        x=Axis(title),
        y=_deviation_axis(logarithmic),
        series=series,
        references=_paper_lines() if choice.paper and series else (),
        bands=(Band(*PAPER_RANGE_UM, _paper_words()),) if choice.paper and series else (),
        legend=_legend(found),
        note="" if series else tr("The methods are being built…"),
        ticks=ticks,
        span_y=_room(logarithmic, choice.paper) if series else None,
    )


def histogram_chart(results: Mapping[Key, VariantResult], choice: Choice) -> ChartData:
    """How often which deviation occurs, over the whole flank."""
    found = _found(results, choice)
    maps = {key: result.flanks[choice.flank].deviation_um.ravel() for key, result in found.items()}
    logarithmic = choice.log if choice.log is not None else orders_apart(list(maps.values()))
    if logarithmic:
        maps = {key: np.maximum(np.abs(values), LEAST_UM) for key, values in maps.items()}
    edges = _edges(list(maps.values()), logarithmic)
    series = tuple(
        Series(
            f"{tr(METHOD_TITLES[key.method])}, {tr(key.variant)}",
            edges,
            np.histogram(values, edges)[0] * (100.0 / values.size),
            key.method,
            STROKES[key.variant],
            steps=True,
            filled=True,
        )
        for key, values in maps.items()
    )
    return ChartData(
        name=f"histogram-{choice.member}-{choice.flank}",
        x=Axis(tr("Deviation, absolute"), "", True, micrometre_tick) if logarithmic else Axis(tr("Deviation"), "µm"),
        y=Axis(tr("Share of the points"), "%"),
        series=series,
        references=_paper_lines(upright=True) if choice.paper and series else (),
        legend=_legend(found),
        note="" if series else tr("The methods are being built…"),
    )


def _found(results: Mapping[Key, VariantResult], choice: Choice) -> dict[Key, VariantResult]:
    keys = [Key(choice.member, method, variant) for method in METHOD_IDS for variant in VARIANTS]
    return {key: results[key] for key in keys if key in results and choice.flank in results[key].flanks}


def _deviation_axis(logarithmic: bool) -> Axis:
    title = tr("Deviation, absolute")
    return Axis(title, "", True, micrometre_tick) if logarithmic else Axis(title, "µm")


def _room(logarithmic: bool, paper: bool) -> tuple[float, float]:
    """What must be in sight besides the curves: zero, and the paper's range with its label."""
    low, high = (LEAST_UM * 10, LEAST_UM * 100) if logarithmic else (0.0, 1e-3)
    return (low, PAPER_RANGE_UM[1] * (6.0 if logarithmic else 1.15)) if paper else (low, high)


def _edges(maps: list[Floats], logarithmic: bool) -> Floats:
    if not maps:
        return np.linspace(0.0, 1.0, BINS + 1)
    values = np.concatenate(maps)
    low, high = float(values.min()), float(values.max())
    if logarithmic:
        return np.geomspace(low, max(high, low * 10), 2 * BINS + 1)
    return np.linspace(low, high if high > low else low + 1e-6, BINS + 1)


def _paper_lines(upright: bool = False) -> tuple[Reference, ...]:
    lowest = min(PAPER_MEANS_UM.values())
    return tuple(
        Reference(value, tr("mean {value} µm", value=plain(value)), method, upright, value == lowest)
        for method, value in PAPER_MEANS_UM.items()
    )


def _paper_words() -> str:
    low, high = map(plain, PAPER_RANGE_UM)
    means = " / ".join(map(plain, PAPER_MEANS_UM.values()))
    return tr("the paper's own gear: {low} … {high} µm, means {means} µm", low=low, high=high, means=means)


def _legend(found: Mapping[Key, VariantResult]) -> tuple[Entry, ...]:
    methods = {
        key.method: shortcoming(key.method, result.settings) or tr(METHOD_TITLES[key.method])
        for key, result in found.items()
    }
    variants = [variant for variant in VARIANTS if any(key.variant == variant for key in found)]
    return (
        *(Entry(text, method) for method, text in methods.items()),
        *(Entry(inline(VARIANT_TITLES[variant]), "muted", STROKES[variant]) for variant in variants),
    )
