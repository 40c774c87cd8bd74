"""Figures of the report that show a flank drawn flat: deviation, curvature, topography."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.curvature import surface_curvature, theory_curvature
from gearstudio.analysis.deviation import deviation_map
from gearstudio.catalogue import METHOD_INFOS, VARIANTS
from gearstudio.report.content import Content
from gearstudio.report.style import DIVERGING, SIDES, figure, svg
from gearstudio.results import FlankResult
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]

_CURVATURE_GRID = (25, 33)
_FROM_BASE = 0.03
_MEASURING_GRID = (5, 9)


def flat(content: Content, points: Floats) -> tuple[Floats, Floats]:
    """Places of flank points on paper: from the toe [mm] and above the pitch cone [mm], shape (n_u, n_v) each."""
    member = content.pair.member(content.member)
    rho, delta, _ = flank_of(member, "concave").locate(points)
    return rho - member.inner_cone_distance, rho * (delta - member.pitch_angle)


def deviation_maps(content: Content, flank: FlankName) -> bytes:
    """All methods, one row for each variant, each with a scale of its own: signed deviation [µm]."""
    with figure(3.1, len(VARIANTS), len(METHOD_INFOS), sharex=True, sharey=True) as (drawn, axes):
        for row, variant in zip(axes, VARIANTS, strict=True):
            for ax, method in zip(row, METHOD_INFOS, strict=True):
                ax.set_title(f"{method.title}, {variant}")
                result = content.results.get((content.member, method.id, variant))
                if result is None:
                    _absent(ax)
                    continue
                made = result.flanks[flank]
                limit = max(float(np.abs(made.deviation_um).max()), 1e-6)
                _map(drawn, ax, *flat(content, made.points), made.deviation_um, (-limit, limit), "µm", DIVERGING)
        _name_axes(axes)
        return svg(drawn)


def curvature_maps(content: Content, flank_name: FlankName) -> bytes:
    """Gaussian curvature of theory and of the optimised variants, on one scale [1/mm²]."""
    flank = flank_of(content.pair.member(content.member), flank_name)
    u = np.linspace(_FROM_BASE, 1.0, _CURVATURE_GRID[0])
    v = np.linspace(0.0, 1.0, _CURVATURE_GRID[1])
    exact = theory_curvature(flank, u[:, None], v[None, :])
    panels: list[tuple[str, Any]] = [("Theory", exact)]
    for method in METHOD_INFOS:
        result = content.results.get((content.member, method.id, "optimised"))
        if result is not None:
            panels.append((method.title, surface_curvature(result.flanks[flank_name].surface, flank, u, v)))
    limits = float(np.quantile(exact.gaussian, 0.02)), float(np.quantile(exact.gaussian, 0.98))
    with figure(1.75, 1, len(panels), sharex=True, sharey=True) as (drawn, axes):
        for ax, (title, found) in zip(axes[0], panels, strict=True):
            ax.set_title(title)
            _map(drawn, ax, *flat(content, found.points), found.gaussian, limits, "1/mm²", "viridis")
        _name_axes(axes)
        return svg(drawn)


def topography(content: Content, method: str, variant: str) -> bytes:
    """The measuring grid of both flanks drawn flat, a bar at each point as long as its deviation."""
    result = next(r for key, r in content.results.items() if key == (content.member, method, variant))
    measured = {name: _grid(content, name, result.flanks[name]) for name in FLANKS}
    largest = max(float(np.abs(error).max()) for _, error in measured.values()) or 1.0
    with figure(2.3, 1, 2, sharey=True) as (drawn, axes):
        for ax, name in zip(axes[0], FLANKS, strict=True):
            points, error = measured[name]
            x, y = flat(content, points)
            reach = 0.8 * float(np.ptp(y)) / (_MEASURING_GRID[0] - 1)
            for lines in (zip(x, y, strict=True), zip(x.T, y.T, strict=True)):
                for one_x, one_y in lines:
                    ax.plot(one_x, one_y, color="#9aa3ad", lw=0.5)
            tops = y + reach * error / largest
            ax.vlines(x.ravel(), y.ravel(), tops.ravel(), color=SIDES[name], lw=1.4)
            ax.plot(x.ravel(), tops.ravel(), ".", color=SIDES[name], ms=2)
            ax.set_title(f"{name.capitalize()} flank; the longest bar is {largest:.3g} µm")
            ax.grid(False)
        _name_axes(axes)
        return svg(drawn)


def _grid(content: Content, name: FlankName, made: FlankResult) -> tuple[Floats, Floats]:
    flank = flank_of(content.pair.member(content.member), name)
    return deviation_map(flank, made.surface, _MEASURING_GRID)


def _map(
    drawn: Any, ax: Any, x: Floats, y: Floats, values: Floats, limits: tuple[float, float], unit: str, colors: str
) -> None:
    shown = ax.pcolormesh(x, y, values, cmap=colors, vmin=limits[0], vmax=limits[1], shading="gouraud", rasterized=True)
    if np.ptp(values) > 0:
        ax.contour(x, y, values, 6, colors="#30343a", linewidths=0.3, alpha=0.7)
    bar = drawn.colorbar(shown, ax=ax, pad=0.02, fraction=0.08, aspect=14)
    bar.ax.set_title(unit, fontsize=6, loc="left")
    bar.ax.tick_params(labelsize=6)
    bar.formatter.set_powerlimits((-3, 4))
    ax.grid(False)


def _absent(ax: Any) -> None:
    ax.text(0.5, 0.5, "not built", transform=ax.transAxes, ha="center", va="center")


def _name_axes(axes: Any) -> None:
    for ax in axes[-1]:
        ax.set_xlabel("from toe to heel [mm]")
    for ax in axes[:, 0]:
        ax.set_ylabel("above pitch cone [mm]")
    for ax in axes.ravel():
        ax.set_aspect("auto")
