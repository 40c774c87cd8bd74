"""Figures of the report that show a flank drawn flat: deviation, curvature, topography."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.curvature import CurvatureMap, surface_curvature, theory_curvature
from gearstudio.analysis.deviation import deviation_map
from gearstudio.catalogue import METHOD_INFOS, VARIANTS
from gearstudio.report.content import Content
from gearstudio.report.language import VARIANTS_SAID, number, tr
from gearstudio.report.style import DIVERGING, SEQUENTIAL, SIDES, Frame, figure, length_unit, rounded_up, scale, svg
from gearstudio.results import FlankResult
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.modified import flank_of
from gearstudio.words import noted

Floats = NDArray[np.float64]

_CURVATURE_GRID = (25, 33)
_FROM_BASE = 0.03
_MEASURING_GRID = (5, 9)
_FEW = 2
_LEAST_BAR = 0.15
_LEAST_UM = 1e-6
_LEAST_CURVATURE = 1e-9
_MOST_OF_LINES = 900
_THEORY = noted("Theory")


def flat(content: Content, points: Floats) -> tuple[Floats, Floats]:
    """Places of flank points on paper: from the toe [mm] and above the pitch cone [mm], shape (n_u, n_v) each."""
    member = content.pair.member(content.member)
    rho, delta, _ = flank_of(member, "concave").locate(points)
    return rho - member.inner_cone_distance, rho * (delta - member.pitch_angle)


def deviation_maps(content: Content, flank: FlankName) -> bytes:
    """All methods, one row for each variant, each with a scale of its own: signed deviation."""
    with figure(Frame(2.75, len(VARIANTS), len(METHOD_INFOS), "each")) as (drawn, axes):
        for row, variant in zip(axes, VARIANTS, strict=True):
            for ax, method in zip(row, METHOD_INFOS, strict=True):
                ax.set_title(f"{tr(method.title)}, {tr(variant)}")
                result = content.results.get((content.member, method.id, variant))
                if result is None:
                    absent(ax, tr("not built"))
                    continue
                made = result.flanks[flank]
                limit = rounded_up(max(float(np.abs(made.deviation_um).max()), _LEAST_UM))
                unit, factor = length_unit(limit)
                end = limit * factor
                values = made.deviation_um * factor
                shown = colored(ax, *flat(content, made.points), values, (-end, end), DIVERGING)
                scale(drawn, ax, shown, unit, (-end, -end / 2, 0.0, end / 2, end))
        name_axes(axes)
        return svg(drawn)


def curvature_maps(content: Content) -> bytes:
    """Gaussian curvature of theory and of the optimised variants, a row for each flank with one scale."""
    titles = [_THEORY, *(method.title for method in METHOD_INFOS)]
    with figure(Frame(2.5, len(FLANKS), len(titles), "row")) as (drawn, axes):
        for row, name in zip(axes, FLANKS, strict=True):
            found = _curvatures(content, name)
            low, high = (float(np.quantile(found[_THEORY].gaussian, share)) for share in (0.02, 0.98))
            size = max(abs(low), abs(high), _LEAST_CURVATURE)
            power = int(np.floor(np.log10(size)))
            if high - low < 1e-3 * size:
                low, high = low - 0.5 * size, high + 0.5 * size
            unit = f"$10^{{{power}}}$/mm²"
            limits = low / 10.0**power, high / 10.0**power
            for ax, title in zip(row, titles, strict=True):
                ax.set_title(f"{tr(title)}, {tr(name)}" if title == _THEORY else tr(title))
                if title not in found:
                    absent(ax, tr("not built"))
                    continue
                one = found[title]
                shown = colored(ax, *flat(content, one.points), one.gaussian / 10.0**power, limits, SEQUENTIAL)
            scale(drawn, row[-1], shown, unit, round_ticks(*limits))
        name_axes(axes)
        return svg(drawn)


def _curvatures(content: Content, name: FlankName) -> dict[str, CurvatureMap]:
    flank = flank_of(content.pair.member(content.member), name)
    u = np.linspace(_FROM_BASE, 1.0, _CURVATURE_GRID[0])
    v = np.linspace(0.0, 1.0, _CURVATURE_GRID[1])
    found = {_THEORY: theory_curvature(flank, u[:, None], v[None, :])}
    for method in METHOD_INFOS:
        result = content.results.get((content.member, method.id, "optimised"))
        if result is not None:
            found[method.title] = surface_curvature(result.flanks[name].surface, flank, u, v)
    return found


def topography(content: Content, method: str) -> bytes:
    """The measuring grid of both flanks drawn flat, a row for each variant, a bar as long as the deviation."""
    with figure(Frame(2.7, len(VARIANTS), len(FLANKS))) as (drawn, axes):
        for row, variant in zip(axes, VARIANTS, strict=True):
            result = content.results.get((content.member, method, variant))
            if result is None:
                for ax in row:
                    ax.set_title(tr(VARIANTS_SAID[variant]))
                    absent(ax, tr("not built"))
                continue
            measured = {name: _grid(content, name, result.flanks[name]) for name in FLANKS}
            largest = max(float(np.abs(error).max()) for _, error in measured.values())
            for ax, name in zip(row, FLANKS, strict=True):
                points, error = measured[name]
                bars(ax, *flat(content, points), error / (largest or 1.0), SIDES[name])
                ax.set_title(f"{tr(VARIANTS_SAID[variant])}, {tr(name)}: {longest_bar(largest)}")
        name_axes(axes)
        return svg(drawn)


def _grid(content: Content, name: FlankName, made: FlankResult) -> tuple[Floats, Floats]:
    flank = flank_of(content.pair.member(content.member), name)
    return deviation_map(flank, made.surface, _MEASURING_GRID)


def bars(ax: Any, x: Floats, y: Floats, share: Floats, color: str) -> None:
    """A net of points, shape (n, m), and on each a bar as a share of the longest; nothing where it is NaN."""
    from matplotlib.collections import LineCollection

    longest = max(0.8 / max(len(y) - 1, 1), _LEAST_BAR) * float(np.nanmax(y) - np.nanmin(y))
    tops = y + longest * share
    grid = [np.column_stack(line) for a, b in ((x, y), (x.T, y.T)) for line in zip(a, b, strict=True)]
    ax.add_collection(LineCollection(grid, colors="#9aa3ad", linewidths=0.5))
    strokes = np.stack((np.column_stack((x.ravel(), y.ravel())), np.column_stack((x.ravel(), tops.ravel()))), axis=1)
    ax.add_collection(LineCollection(list(strokes), colors=color, linewidths=1.4))
    ax.plot(x.ravel(), tops.ravel(), ".", color=color, ms=2)
    ax.autoscale_view()
    ax.grid(False)


def longest_bar(value_um: float) -> str:
    """How long the longest bar of a topography is, in words."""
    if value_um < _LEAST_UM:
        return tr("no deviation here")
    unit, factor = length_unit(value_um)
    return tr("longest bar {length} {unit}", length=number(value_um * factor, ".3g"), unit=unit)


def colored(ax: Any, x: Floats, y: Floats, values: Floats, limits: tuple[float, float], colors: str) -> Any:
    """Values over a net as colours with some contours; what was drawn, for its scale."""
    low, high = limits
    shown = ax.pcolormesh(x, y, values, cmap=colors, vmin=low, vmax=high, shading="gouraud", rasterized=True)
    if np.ptp(values) > 1e-3 * (high - low):
        lines = ax.contour(x, y, values, np.linspace(low, high, 7)[1:-1], colors="#30343a", linewidths=0.3, alpha=0.7)
        if sum(len(line) for level in lines.allsegs for line in level) > _MOST_OF_LINES:
            lines.remove()
    ax.grid(False)
    return shown


def round_ticks(low: float, high: float) -> list[float]:
    """Some round numbers between two ends."""
    from matplotlib.ticker import MaxNLocator

    return [float(f"{tick:.6g}") for tick in MaxNLocator(5).tick_values(low, high) if low <= tick <= high]


def absent(ax: Any, reason: str) -> None:
    """Say that there is nothing to show."""
    ax.text(0.5, 0.5, reason, transform=ax.transAxes, ha="center", va="center", color="#60666e")
    ax.grid(False)


def name_axes(axes: Any) -> None:
    """What the axes of flanks drawn flat mean: below each column while there are few, else once for all."""
    along, above = tr("from toe to heel [mm]"), tr("above pitch cone [mm]")
    first, last = axes[0, 0].get_position(), axes[-1, -1].get_position()
    drawn = axes[0, 0].figure
    if axes.shape[1] > _FEW:
        drawn.text(
            (first.x0 + last.x1) / 2, 0.02 / drawn.get_figheight(), along, ha="center", va="bottom", size="medium"
        )
    else:
        for ax in axes[-1]:
            ax.set_xlabel(along)
    drawn.text(0.004, (first.y1 + last.y0) / 2, above, rotation=90, ha="left", va="center", size="medium")
