"""Figures of the report with lines: deviation along the flank, contact."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearstudio.analysis.contact_result import ContactResult, FlankPattern
from gearstudio.catalogue import METHOD_INFOS, VARIANTS
from gearstudio.report.content import Content
from gearstudio.report.style import COLORS, DIVERGING, PATTERN, SIDES, figure, svg
from gearstudio.theory.flank import FLANKS

PAPER_MEANS_UM = {"rotating_line": 54.6, "profile_sweep": 60.3, "point_cloud": 52.9}
_SERIES = 7
_LEAST_UM = 1e-5


def deviation_series(content: Content) -> bytes:
    """Deviation at 7 x 7 points of either flank, all methods and variants, the paper's means as lines."""
    with figure(2.5, 1, 2, sharey=True) as (drawn, axes):
        for ax, flank in zip(axes[0], FLANKS, strict=True):
            for method in METHOD_INFOS:
                for variant in VARIANTS:
                    result = content.results.get((content.member, method.id, variant))
                    if result is None:
                        continue
                    error = result.flanks[flank].deviation_um
                    rows, columns = (np.linspace(0, n - 1, _SERIES).round().astype(int) for n in error.shape)
                    series = np.maximum(np.abs(error[np.ix_(rows, columns)].T.ravel()), _LEAST_UM)
                    dash = "-" if variant == "optimised" else "--"
                    ax.plot(
                        np.arange(1, series.size + 1), series, dash, color=COLORS[method.id],
                        label=f"{method.title}, {variant}",
                    )  # fmt: skip
                ax.axhline(PAPER_MEANS_UM[method.id], color=COLORS[method.id], lw=0.6, ls=":")
            ax.set_yscale("log")
            ax.set_title(f"{flank.capitalize()} flank")
            ax.set_xlabel("point of the 7 × 7 series, toe to heel")
        axes[0, 0].set_ylabel("deviation [µm]; dotted: the paper's means")
        handles, labels = axes[0, 0].get_legend_handles_labels()
        drawn.legend(handles, labels, loc="outside lower center", ncols=3)
        return svg(drawn)


def convergence(content: Content) -> bytes:
    """Largest deviation against poles and against seconds, all methods, with the tolerance of the design."""
    titles = {method.id: method.title for method in METHOD_INFOS}
    with figure(2.3, 1, 2, sharey=True) as (drawn, axes):
        for ax, effort, label in zip(axes[0], ("poles", "seconds"), ("poles", "seconds for both flanks"), strict=True):
            for study in content.studies:
                effort_of = [getattr(point, effort) for point in study.points]
                worst = [max(point.max_um, _LEAST_UM) for point in study.points]
                ax.plot(effort_of, worst, "o-", ms=2.5, color=COLORS[study.method], label=titles[study.method])
            ax.axhline(content.design.methods.tolerance_um, color="#30343a", lw=0.7, ls="--", label="tolerance")
            ax.set_xscale("log")
            ax.set_yscale("log")
            ax.set_xlabel(label)
        axes[0, 0].set_ylabel("largest deviation [µm]")
        axes[0, 0].legend()
        return svg(drawn)


def patterns(content: Content, contact: ContactResult) -> bytes:
    """Contact pattern on both members, drive and coast: where the gap stays within the marking thickness."""
    with figure(3.0, 2, 2) as (drawn, axes):
        for row, side in zip(axes, (contact.drive, contact.coast), strict=True):
            for ax, pattern in zip(row, (side.pinion, side.wheel), strict=True):
                ax.set_title(f"{side.direction.capitalize()}, {pattern.member}, {pattern.flank}")
                _pattern(drawn, ax, content, pattern, contact.thickness_um)
        for ax in axes[-1]:
            ax.set_xlabel("from toe to heel [mm]")
        for ax in axes[:, 0]:
            ax.set_ylabel("above pitch cone [mm]")
        return svg(drawn)


def transmission_error(contact: ContactResult) -> bytes:
    """Transmission error over three pitches."""
    with figure(1.9) as (drawn, axes):
        ax = axes[0, 0]
        for side in (contact.drive, contact.coast):
            label = f"{side.direction}, {side.peak_to_peak_arcsec:.3g}″ peak to peak"
            ax.plot(side.turn_deg, side.error_arcsec, color=SIDES[side.direction], label=label)
        low, high = ax.get_ylim()
        if high - low < 1e-3:
            ax.set_ylim(-0.5, 0.5)
        ax.set_xlabel("turn of the pinion [°]")
        ax.set_ylabel("lag of the wheel [″]")
        ax.legend(loc="upper right", ncols=2)
        return svg(drawn)


def ease_off_maps(content: Content, contact: ContactResult) -> bytes:
    """Ease-off over the pinion's flanks [µm], with the lines of contact."""
    with figure(1.8, 1, 2, sharey=True) as (drawn, axes):
        for ax, side in zip(axes[0], (contact.drive, contact.coast), strict=True):
            x, y = _flat(content, side.pinion)
            height = np.asarray(side.ease_off_um)
            limit = max(float(np.nanmax(np.abs(height))), 1e-3)
            shown = ax.pcolormesh(
                x, y, height, cmap=DIVERGING, vmin=-limit, vmax=limit, shading="gouraud", rasterized=True
            )
            ax.contour(x, y, np.asarray(side.roll_deg), 9, colors="#30343a", linewidths=0.4)
            ax.set_title(f"{side.direction.capitalize()}: ease-off and lines of contact")
            ax.set_xlabel("from toe to heel [mm]")
            ax.grid(False)
            bar = drawn.colorbar(shown, ax=ax, pad=0.02, fraction=0.08, aspect=14)
            bar.ax.set_title("µm", fontsize=6, loc="left")
        axes[0, 0].set_ylabel("above pitch cone [mm]")
        return svg(drawn)


def _pattern(drawn: Any, ax: Any, content: Content, pattern: FlankPattern, thickness_um: float) -> None:
    x, y = _flat(content, pattern)
    gap = np.where(np.isfinite(pattern.gap_um), pattern.gap_um, 10 * thickness_um)
    shown = ax.contourf(x, y, gap, np.linspace(0.0, thickness_um, 9), cmap=PATTERN, extend="min")
    ax.plot(np.r_[x[0], x[:, -1], x[-1, ::-1], x[::-1, 0]], np.r_[y[0], y[:, -1], y[-1, ::-1], y[::-1, 0]], "k", lw=0.6)
    bar = drawn.colorbar(shown, ax=ax, pad=0.02, fraction=0.08, aspect=14)
    bar.ax.set_title("gap µm", fontsize=6, loc="left")
    bar.ax.tick_params(labelsize=6)
    ax.grid(False)


def _flat(content: Content, pattern: FlankPattern) -> tuple[Any, Any]:
    member = content.pair.member(pattern.member)
    delta = np.radians(pattern.delta_deg)
    return pattern.rho - member.inner_cone_distance, pattern.rho * (delta - member.pitch_angle)
